/* SPDX-License-Identifier: MIT
 *
 * Ray casting by a bounding-box tree, halved at the median of the longest side. The tree is
 * walked with an explicit stack; its depth is the logarithm of the number of polygons. */
#include "demo_rays.h"

#include <stdlib.h>

enum { LEAF_POLYGONS = 4, STACK = 64 };

struct rays_node {
    double lo[3], hi[3];
    int first, count; /* leaf: order[first .. first + count) */
    int axis, right;  /* inner node (count 0): split along; the lower child is the next node, this the upper */
};

/* A polygon on its way into the tree. */
struct item {
    double middle[3];
    int number;
};

struct ray {
    struct vec3 from, direction;
    double origin[3], inverse[3];
    double reach_m;
};

static void polygon_bounds(const struct polygon *polygon, double lo[3], double hi[3])
{
    for (int i = 0; i < polygon->count; i++) {
        double at[3] = {polygon->corner[i].x, polygon->corner[i].y, polygon->corner[i].z};
        for (int axis = 0; axis < 3; axis++) {
            lo[axis] = i ? fmin(lo[axis], at[axis]) : at[axis];
            hi[axis] = i ? fmax(hi[axis], at[axis]) : at[axis];
        }
    }
}

static int compare_x(const void *a, const void *b)
{
    const struct item *p = a, *q = b;
    if (p->middle[0] != q->middle[0]) return p->middle[0] < q->middle[0] ? -1 : 1;
    return p->number - q->number;
}

static int compare_y(const void *a, const void *b)
{
    const struct item *p = a, *q = b;
    if (p->middle[1] != q->middle[1]) return p->middle[1] < q->middle[1] ? -1 : 1;
    return p->number - q->number;
}

static int compare_z(const void *a, const void *b)
{
    const struct item *p = a, *q = b;
    if (p->middle[2] != q->middle[2]) return p->middle[2] < q->middle[2] ? -1 : 1;
    return p->number - q->number;
}

static int node_bounds(struct rays_node *node, const struct soup *soup, const struct item *items, int count)
{
    int longest = 0;
    for (int i = 0; i < count; i++) {
        double lo[3], hi[3];
        polygon_bounds(&soup->polygons[items[i].number], lo, hi);
        for (int axis = 0; axis < 3; axis++) {
            node->lo[axis] = i ? fmin(node->lo[axis], lo[axis]) : lo[axis];
            node->hi[axis] = i ? fmax(node->hi[axis], hi[axis]) : hi[axis];
        }
    }
    for (int axis = 1; axis < 3; axis++)
        if (node->hi[axis] - node->lo[axis] > node->hi[longest] - node->lo[longest]) longest = axis;
    return longest;
}

/* Recursion only on the host, and only as deep as the tree. */
static void build_node(struct rays *rays, struct item *items, int first, int count)
{
    static int (*const compare[3])(const void *, const void *) = {compare_x, compare_y, compare_z};
    struct rays_node *node = &rays->nodes[rays->node_count++];
    int axis = node_bounds(node, rays->soup, items + first, count);
    *node = (struct rays_node){
        {node->lo[0], node->lo[1], node->lo[2]}, {node->hi[0], node->hi[1], node->hi[2]}, first, count, axis, 0};
    if (count <= LEAF_POLYGONS) return;
    qsort(items + first, (size_t)count, sizeof *items, compare[axis]);
    node->count = 0;
    build_node(rays, items, first, count / 2);
    node->right = rays->node_count;
    build_node(rays, items, first + count / 2, count - count / 2);
}

struct rays rays_build(const struct soup *soup)
{
    struct rays rays = {.soup = soup};
    int count = (int)soup->count;
    struct item *items = demo_realloc(NULL, soup->count * sizeof *items);
    rays.nodes = demo_realloc(NULL, 2 * soup->count * sizeof *rays.nodes);
    rays.order = demo_realloc(NULL, soup->count * sizeof *rays.order);
    for (int i = 0; i < count; i++) {
        double lo[3], hi[3];
        polygon_bounds(&soup->polygons[i], lo, hi);
        items[i].number = i;
        for (int axis = 0; axis < 3; axis++)
            items[i].middle[axis] = (lo[axis] + hi[axis]) / 2;
    }
    build_node(&rays, items, 0, count);
    for (int i = 0; i < count; i++)
        rays.order[i] = items[i].number;
    free(items);
    return rays;
}

void rays_free(struct rays *rays)
{
    free(rays->nodes);
    free(rays->order);
    *rays = (struct rays){0};
}

static bool box_missed(const struct rays_node *node, const struct ray *ray)
{
    double enter = 0, leave = ray->reach_m;
    for (int axis = 0; axis < 3; axis++) {
        double t0 = (node->lo[axis] - ray->origin[axis]) * ray->inverse[axis];
        double t1 = (node->hi[axis] - ray->origin[axis]) * ray->inverse[axis];
        double near = t0 < t1 ? t0 : t1, far = t0 < t1 ? t1 : t0;
        enter = near > enter ? near : enter;
        leave = far < leave ? far : leave;
    }
    /* flat boxes are hit exactly at their plane: leave room for rounding */
    return enter > leave + 1e-9;
}

static bool polygon_hit(const struct polygon *polygon, struct ray *ray)
{
    double slope = vec_dot(polygon->normal, ray->direction);
    if (fabs(slope) < 1e-12) return false;
    double t = vec_dot(polygon->normal, vec_sub(polygon->corner[0], ray->from)) / slope;
    if (t <= 0 || t >= ray->reach_m) return false;
    struct vec3 point = vec_add(ray->from, vec_scale(ray->direction, t));
    for (int i = 0; i < polygon->count; i++) {
        struct vec3 a = polygon->corner[i], b = polygon->corner[i + 1 == polygon->count ? 0 : i + 1];
        if (vec_dot(vec_cross(vec_sub(b, a), vec_sub(point, a)), polygon->normal) < -1e-9) return false;
    }
    ray->reach_m = t;
    return true;
}

static int leaf_hit(const struct rays *rays, const struct rays_node *leaf, struct ray *ray, bool any)
{
    int nearest = NOTHING;
    for (int i = leaf->first; i < leaf->first + leaf->count; i++) {
        const struct polygon *polygon = &rays->soup->polygons[rays->order[i]];
        if (any && materials[polygon->material].emission > 0) continue;
        if (polygon_hit(polygon, ray)) nearest = rays->order[i];
        if (any && nearest != NOTHING) break;
    }
    return nearest;
}

/* any: the first opaque polygon found will do; else the nearest of all. */
static int cast(const struct rays *rays, struct ray *ray, bool any)
{
    int stack[STACK], depth = 0, nearest = NOTHING;
    stack[depth++] = 0;
    while (depth && !(any && nearest != NOTHING)) {
        int at = stack[--depth];
        const struct rays_node *node = &rays->nodes[at];
        if (box_missed(node, ray)) continue;
        if (node->count) {
            int found = leaf_hit(rays, node, ray, any);
            if (found != NOTHING) nearest = found;
        } else {
            bool upwards = ray->inverse[node->axis] > 0;
            stack[depth++] = upwards ? node->right : at + 1;
            stack[depth++] = upwards ? at + 1 : node->right;
        }
    }
    return nearest;
}

static struct ray ray_make(struct vec3 from, struct vec3 direction, double reach_m)
{
    return (struct ray){
        from, direction, {from.x, from.y, from.z}, {1 / direction.x, 1 / direction.y, 1 / direction.z}, reach_m};
}

int rays_first(const struct rays *rays, struct vec3 from, struct vec3 direction)
{
    struct ray ray = ray_make(from, direction, HUGE_VAL);
    return cast(rays, &ray, false);
}

bool rays_blocked(const struct rays *rays, struct vec3 from, struct vec3 direction, double reach_m)
{
    struct ray ray = ray_make(from, direction, reach_m);
    return cast(rays, &ray, true) != NOTHING;
}
