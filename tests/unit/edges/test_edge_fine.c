/* SPDX-License-Identifier: MIT
 *
 * EDGE is exact, built for profile fine on 340 pixels: 22 fraction bits, of which long edges take more than there are.
 */
#define LIM_PROFILE 2 /* fine */
#define LIM_MAX_SIDE_PX 340

#include "screen/edge.c"
#include "screen/edge_bounds.c"

#include "rigs/cmocka_ready.h"
#include "rigs/edge_rig.h"

static void edges_are_exact(void **state)
{
    (void)state;
    edge_rig_check_many(103);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(edges_are_exact)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
