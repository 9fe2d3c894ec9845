/* SPDX-License-Identifier: MIT
 *
 * EDGE is exact, built for profile exact: 32 fraction bits. */
#define LIM_PROFILE 3 /* exact */

#include "screen/edge.c"
#include "screen/edge_bounds.c"

#include "rigs/cmocka_ready.h"
#include "rigs/edge_rig.h"

static void edges_are_exact(void **state)
{
    (void)state;
    edge_rig_check_many(102);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(edges_are_exact)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
