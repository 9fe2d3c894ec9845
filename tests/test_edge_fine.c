/* SPDX-License-Identifier: MIT
 *
 * EDGE is exact, built for profile fine on 340 pixels: 22 fraction bits, of which long edges take more than there are.
 */
#define LIM_PROFILE 2 /* fine */
#define LIM_MAX_SIDE_PX 340

#include "edge.c"

#include "cmocka_ready.h"
#include "edge_rig.h"

#include <stdio.h>

static void edges_are_exact(void **state)
{
    struct random random = {103};
    size_t lines = 0;

    (void)state;
    for (int k = 0; k < 20000; k++)
        lines += edge_rig_check(&random, edge_rig_band(k % 2 ? LIM_MAX_SIDE_PX : 64));
    printf("# %d fraction bits: %zu lines of edges\n", LIM_EDGE_BITS, lines);
    assert_true(lines > 500000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(edges_are_exact)};

    return cmocka_run_group_tests(tests, NULL, NULL);
}
