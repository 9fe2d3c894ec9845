/* SPDX-License-Identifier: MIT
 *
 * Decided on the integers that the firmware has: |n . v - d| < 3 * 2^45 + 2^48 fits 64 bits. */
#include "scene/convexity.h"

#include "long.h"

#include "scene/plane.h"
#include "scene/records.h"

/* One run of polygons, and everything else behind it. */
static bool link_is_right(const struct lim_scene *scene, lim_index i)
{
    const struct lim_node *node = &scene->nodes[i];
    if (node->split.plane == LIM_NO_INDEX) return false;
    const lim_index after = i + 1 < scene->node_count ? i + 1 : LIM_NO_INDEX;
    if (node->front_run != LIM_NO_INDEX && node->back_run != LIM_NO_INDEX) return false;
    if (node->front_run != LIM_NO_INDEX) return node->front == LIM_NO_INDEX && node->back == after;
    return node->back_run != LIM_NO_INDEX && node->back == LIM_NO_INDEX && node->front == after;
}

/* A vertex off by 1/2 in each coordinate moves n . v by half of |n0| + |n1| + |n2|; half a unit off the
 * plane is less than the other half. */
static bool all_behind(const struct lim_scene *scene, lim_index i)
{
    const int facing = scene->nodes[i].front_run != LIM_NO_INDEX ? 1 : -1;
    int64_t n[3], d, slack = 0;
    plane_exact(scene, &scene->nodes[i].split, n, &d);
    for (int k = 0; k < 3; k++)
        slack += n[k] < 0 ? -n[k] : n[k];
    for (size_t v = 0; v < scene->vertex_count; v++) {
        const struct lim_vertex *at = &scene->vertices[v];
        if (facing * (n[0] * at->x + n[1] * at->y + n[2] * at->z - d) > slack) return false;
    }
    return true;
}

/* Its method paints a solid's faces over its background: they must hide it. */
bool scene_is_convex(const struct lim_scene *scene)
{
    if (lim_scene_is_mesh(scene) || lim_scene_long(scene) || records_with(scene, LIM_POLYGON_ALPHA)) return false;
    for (lim_index i = 0; i < scene->node_count; i++)
        if (!link_is_right(scene, i)) return false;
    for (lim_index i = 0; i < scene->node_count; i++)
        if (!all_behind(scene, i)) return false;
    return true;
}
