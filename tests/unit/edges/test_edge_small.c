/* SPDX-License-Identifier: MIT
 *
 * EDGE is exact, built for a screen of 240 pixels: 22 fraction bits, coordinates of 16 bits. */
#define LIM_MAX_SIDE_PX 240

#include "screen/edge.c"
#include "screen/edge_bounds.c"
#include "screen/small.c"

#include "rigs/cmocka_ready.h"
#include "rigs/edge_rig.h"

static void edges_are_exact(void **state)
{
    (void)state;
    edge_rig_check_many(101);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(edges_are_exact)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
