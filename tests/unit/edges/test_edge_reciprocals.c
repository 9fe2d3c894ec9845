/* SPDX-License-Identifier: MIT
 *
 * Edges are exact as a mesh begins them where a processor does not divide: by reciprocals from a table, for a screen of
 * 240 pixels. */
#define LIM_DIVIDES 0
#define LIM_MAX_SIDE_PX 240

#include "screen/edge.c"
#include "screen/edge_bounds.c"
#include "screen/small.c"

#include "rigs/cmocka_ready.h"
#include "rigs/edge_rig.h"

static void polygons_are_exact(void **state)
{
    (void)state;
    edge_rig_check_many(105);
}

static void single_edges_are_exact(void **state)
{
    (void)state;
    const struct edge_rig_ways ways = edge_rig_check_singles(106);

    assert_true(ways.fast > 20000 && ways.low > 5000 && ways.medium > 10000 && ways.slow > 100000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(polygons_are_exact), cmocka_unit_test(single_edges_are_exact)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
