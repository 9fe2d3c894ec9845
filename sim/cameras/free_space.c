/* SPDX-License-Identifier: MIT
 *
 * Down the tree on the point's side of each plane. Where that ends at a node, the node's polygons face the point
 * (space) or turn their backs on it (matter). A leaf's cell is convex: a ray from the point to one of its polygons
 * meets no others than the leaf's, and the nearest of those tells. */
#include "cameras/free_space.h"

#include "eye.h"
#include "scene/plane.h"

#include <float.h>
#include <math.h>

/* A ray in units, from the point: at + t * way. */
struct ray {
    double at[3], way[3];
};

static double at_corner(const struct lim_scene *scene, const lim_index *record, unsigned corner, int axis)
{
    const struct lim_vertex *vertex = &scene->vertices[record[LIM_POLYGON_HEAD_WORDS + corner]];
    return axis == 0 ? vertex->x : axis == 1 ? vertex->y : vertex->z;
}

/* n . at - d of the record's own plane, positive in front of the record; and n . way. */
static double height_over(const struct lim_scene *scene, const lim_index *record, const struct ray *ray, double *climb)
{
    const double facing = record[0] & LIM_POLYGON_BACK ? -1.0 : 1.0;
    int64_t n[3], d;
    double height;

    plane_exact(scene, lim_record_plane(record), n, &d);
    height = -(double)d;
    *climb = 0.0;
    for (int i = 0; i < 3; i++) {
        height += (double)n[i] * ray->at[i];
        *climb += facing * (double)n[i] * ray->way[i];
    }
    return facing * height;
}

/* Whether the ray goes through the record at t: even-odd rule, on the corners carried along the ray to the crossing. */
static bool covers(const struct lim_scene *scene, const lim_index *record, const struct ray *ray, double t)
{
    const unsigned count = record[0] & LIM_POLYGON_COUNT;
    int along = 0;
    bool inside = false;

    for (int i = 1; i < 3; i++)
        if (fabs(ray->way[i]) > fabs(ray->way[along])) along = i;
    const int u = (along + 1) % 3, v = (along + 2) % 3;
    const double to_u = ray->at[u] + t * ray->way[u], to_v = ray->at[v] + t * ray->way[v];
    const double to = ray->at[along] + t * ray->way[along];
    for (unsigned k = 0, before = count - 1; k < count; before = k++) {
        double p[2][2];
        for (int end = 0; end < 2; end++) {
            const unsigned corner = end ? k : before;
            const double back = (at_corner(scene, record, corner, along) - to) / ray->way[along];
            p[end][0] = at_corner(scene, record, corner, u) - back * ray->way[u];
            p[end][1] = at_corner(scene, record, corner, v) - back * ray->way[v];
        }
        if ((p[0][1] > to_v) == (p[1][1] > to_v)) continue;
        const double crossing = p[0][0] + (to_v - p[0][1]) / (p[1][1] - p[0][1]) * (p[1][0] - p[0][0]);
        inside ^= crossing > to_u;
    }
    return inside;
}

/* Towards the middle of a record's corners. */
static struct ray ray_to(const struct lim_scene *scene, const lim_index *record, const double at[3])
{
    const unsigned count = record[0] & LIM_POLYGON_COUNT;
    struct ray ray = {{at[0], at[1], at[2]}, {-at[0], -at[1], -at[2]}};

    for (int i = 0; i < 3; i++)
        for (unsigned k = 0; k < count; k++)
            ray.way[i] += at_corner(scene, record, k, i) / count;
    return ray;
}

static const lim_index *next_record(const lim_index *record)
{
    return record[0] & LIM_POLYGON_LAST ? NULL : record + lim_record_words(record[0]);
}

/* Whether the nearest polygon of the run on the ray faces its beginning. */
static bool meets_a_front(const struct lim_scene *scene, const lim_index *run, const struct ray *ray)
{
    double nearest = DBL_MAX;
    bool front = false;

    for (const lim_index *record = run; record; record = next_record(record)) {
        double climb;
        const double height = height_over(scene, record, ray, &climb), t = -height / climb;
        if (!(t > 0.0 && t <= nearest) || !covers(scene, record, ray, t)) continue;
        front = height > 0.0 || (t == nearest && front); /* both records of a two-sided polygon are there */
        nearest = t;
    }
    return front;
}

/* Polygons that are edge-on, or rounded to a line, tell nothing. */
static bool is_free_in_leaf(const struct lim_scene *scene, const lim_index *run, const double at[3])
{
    for (const lim_index *record = run; record; record = next_record(record)) {
        const struct ray ray = ray_to(scene, record, at);
        double climb;
        const double height = height_over(scene, record, &ray, &climb);
        if (height != 0.0 && covers(scene, record, &ray, -height / climb)) return meets_a_front(scene, run, &ray);
    }
    return false;
}

bool free_space_holds(const struct compiled *compiled, const double at_m[3])
{
    const struct lim_scene *scene = &compiled->scene;
    struct lim_eye eye;
    double at[3];
    int32_t at_q8[3];
    lim_index index = 0;

    for (int i = 0; i < 3; i++) {
        at[i] = (at_m[i] - compiled->grid.origin_m[i]) * compiled->grid.units_per_m;
        at_q8[i] = (int32_t)lround(at[i] * 256.0);
    }
    lim_eye_set(&eye, scene, at_q8);
    for (;;) {
        const struct lim_node *node = &scene->nodes[index];
        if (node->split.plane == LIM_NO_INDEX) return is_free_in_leaf(scene, scene->polygons + node->front_run, at);
        const bool in_front = lim_eye_side(&eye, &node->split) > 0;
        const lim_index child = in_front ? node->front : node->back;
        if (child == LIM_NO_INDEX) return (in_front ? node->front_run : node->back_run) != LIM_NO_INDEX;
        index = child;
    }
}
