/* SPDX-License-Identifier: MIT
 *
 * The certificate of a tree: every corner of every piece against every plane above it. Distances
 * in doubles are off by less than SLACK, which is added; where that leaves the side in doubt GMP
 * says whether there is a violation at all. */
#include "trees/bsp.h"

#include <math.h>

#define SLACK_UNITS 0x1p-30
#define LONG_SLACK_UNITS 0x1p-18 /* sums of 2^62, of 53 bits, over a normal of 2^30 */

/* How far the point lies on the wrong side: side 1 = it should be in front, -1 behind, 0 on it. */
static double point_violation(const struct bsp *bsp, uint32_t point, const struct plane *plane, int side)
{
    double distance = plane_distance(plane, bsp->edges.points->approx[point]);
    double wrong = side ? -distance * side : fabs(distance);
    const double slack = bsp->mesh->grid.is_long ? LONG_SLACK_UNITS : SLACK_UNITS;
    if (wrong < -slack) return 0.0;
    if (wrong > slack) return wrong + slack;
    int truth = exact_side(bsp->edges.points, point, plane);
    return truth == 0 || (truth == side) ? 0.0 : slack * 2.0;
}

/* A leaf's pieces lie in planes of their own. */
static double piece_violation(const struct bsp *bsp, const struct bsp_piece *piece, uint32_t node, int side)
{
    const uint32_t group = bsp->nodes[node].group;
    const struct plane *plane = bsp_plane(bsp, group == BSP_NONE ? bsp->coplanar->group[piece->polygon] : group);
    if (side && plane_distance(plane, piece->centre) * side > piece->radius) return 0.0;
    double worst = 0.0;
    for (size_t i = 0; i < piece->count; i++)
        worst = fmax(worst, point_violation(bsp, bsp->corners[piece->first + i].point, plane, side));
    return worst;
}

double bsp_worst_violation(const struct bsp *bsp)
{
    double worst = 0.0;
    for (uint32_t own = 0; own < bsp->node_count; own++)
        for (size_t i = 0; i < bsp->nodes[own].count; i++) {
            const struct bsp_piece *piece = &bsp->pieces[bsp->placed[bsp->nodes[own].first + i]];
            int side = 0;
            for (uint32_t node = own; node != BSP_NONE; node = bsp->nodes[node].parent) {
                worst = fmax(worst, piece_violation(bsp, piece, node, side));
                side = bsp->nodes[node].in_front ? 1 : -1;
            }
        }
    return worst;
}
