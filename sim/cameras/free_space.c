/* SPDX-License-Identifier: MIT
 *
 * Down the tree on the point's side of each plane. Where that ends at a node, the node's polygons face the point
 * (space) or turn their backs on it (matter). A leaf's cell is convex: a ray from the point to one of its polygons
 * meets no others than the leaf's, and the nearest of those tells. A mesh is as one leaf. */
#include "cameras/free_space.h"

#include "base/vec3.h"
#include "cameras/camera_path.h"
#include "eye.h"
#include "scene/plane.h"
#include "scene/records.h"
#include "scene/vertex_units.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* A ray in units, from the point: at + t * way. */
struct ray {
    double at[3], way[3];
};

static void corner_at(const struct lim_scene *scene, const struct record *record, size_t corner, double out[3])
{
    vertex_units(scene, record->corners[corner], out);
}

/* n . x = d; n points to the front. */
struct front_plane {
    double n[3], d;
};

/* Through its corners as they are rounded: exact sums of whole numbers, so both records of a two-sided polygon have
 * the same. */
static struct front_plane plane_of_corners(const struct lim_scene *scene, const struct record *record)
{
    struct front_plane plane = {{0.0, 0.0, 0.0}, 0.0};
    double sum[3] = {0.0, 0.0, 0.0}, before[3], at[3];

    corner_at(scene, record, record->count - 1u, before);
    for (size_t k = 0; k < record->count; k++) {
        corner_at(scene, record, k, at);
        for (int i = 0; i < 3; i++) {
            const int u = (i + 1) % 3, v = (i + 2) % 3;
            plane.n[i] += before[u] * at[v] - before[v] * at[u];
            sum[i] += at[i];
        }
        memcpy(before, at, sizeof before);
    }
    plane.d = vec3_dot(plane.n, sum) / (double)record->count;
    return plane;
}

/* The plane of a record that has one of its own; a triangle's, and that of a mesh leaf's, is that of its corners. */
static struct front_plane own_plane(const struct lim_scene *scene, const struct record *record)
{
    if (!(record->flags & LIM_POLYGON_PLANE)) return plane_of_corners(scene, record);
    const double facing = record->flags & LIM_POLYGON_BACK ? -1.0 : 1.0;
    struct front_plane plane;
    int64_t n[3], d;
    plane_exact(scene, lim_record_plane(record->corners - LIM_POLYGON_HEAD_WORDS), n, &d);
    for (int i = 0; i < 3; i++)
        plane.n[i] = facing * (double)n[i];
    plane.d = facing * (double)d;
    return plane;
}

/* Whether the ray goes through the record at t: even-odd rule, on the corners carried along the ray to the crossing. */
static bool covers(const struct lim_scene *scene, const struct record *record, const struct ray *ray, double t)
{
    int along = 0;
    bool inside = false;

    for (int i = 1; i < 3; i++)
        if (fabs(ray->way[i]) > fabs(ray->way[along])) along = i;
    const int u = (along + 1) % 3, v = (along + 2) % 3;
    const double to_u = ray->at[u] + t * ray->way[u], to_v = ray->at[v] + t * ray->way[v];
    const double to = ray->at[along] + t * ray->way[along];
    for (size_t k = 0, before = record->count - 1; k < record->count; before = k++) {
        double p[2][2];
        for (int end = 0; end < 2; end++) {
            double corner[3];
            corner_at(scene, record, end ? k : before, corner);
            const double back = (corner[along] - to) / ray->way[along];
            p[end][0] = corner[u] - back * ray->way[u];
            p[end][1] = corner[v] - back * ray->way[v];
        }
        if ((p[0][1] > to_v) == (p[1][1] > to_v)) continue;
        const double crossing = p[0][0] + (to_v - p[0][1]) / (p[1][1] - p[0][1]) * (p[1][0] - p[0][0]);
        inside ^= crossing > to_u;
    }
    return inside;
}

/* Towards the middle of a record's corners. */
static struct ray ray_to(const struct lim_scene *scene, const struct record *record, const double at[3])
{
    struct ray ray = {{at[0], at[1], at[2]}, {-at[0], -at[1], -at[2]}};

    for (size_t k = 0; k < record->count; k++) {
        double corner[3];
        corner_at(scene, record, k, corner);
        for (int i = 0; i < 3; i++)
            ray.way[i] += corner[i] / (double)record->count;
    }
    return ray;
}

/* The next word of a run, or of a mesh, where a record begins; false: there is none. */
static bool go_on(const struct lim_scene *scene, const struct record *record, size_t *word)
{
    *word += record->words;
    return !(record->flags & LIM_POLYGON_LAST) && *word < scene->polygon_words;
}

/* What a ray meets first, of the records so far. */
struct meeting {
    double t;
    bool front; /* it faces the ray's beginning */
};

static const struct meeting MEETS_NOTHING = {DBL_MAX, false};

static void meet(const struct lim_scene *scene, const struct record *record, const struct front_plane *plane,
                 const struct ray *ray, struct meeting *meeting)
{
    const double height = vec3_dot(plane->n, ray->at) - plane->d, t = -height / vec3_dot(plane->n, ray->way);

    if (!(t > 0.0 && t <= meeting->t) || !covers(scene, record, ray, t)) return;
    const bool both = t == meeting->t && meeting->front; /* both records of a two-sided polygon are there */
    *meeting = (struct meeting){t, height > 0.0 || both};
}

/* Whether the nearest polygon of the run on the ray faces its beginning. */
static bool meets_a_front(const struct lim_scene *scene, size_t run, const struct ray *ray)
{
    struct meeting meeting = MEETS_NOTHING;
    struct record record;

    do {
        record = record_at(scene, run);
        const struct front_plane plane = own_plane(scene, &record);
        meet(scene, &record, &plane, ray, &meeting);
    } while (go_on(scene, &record, &run));
    return meeting.front;
}

/* Polygons that are edge-on, or rounded to a line, tell nothing. */
static bool is_free_in_run(const struct lim_scene *scene, size_t run, const double at[3])
{
    struct record record;
    size_t word = run;

    do {
        record = record_at(scene, word);
        const struct ray ray = ray_to(scene, &record, at);
        const struct front_plane plane = own_plane(scene, &record);
        const double height = vec3_dot(plane.n, ray.at) - plane.d;
        if (height != 0.0 && covers(scene, &record, &ray, -height / vec3_dot(plane.n, ray.way)))
            return meets_a_front(scene, run, &ray);
    } while (go_on(scene, &record, &word));
    return false;
}

static void units_of(const struct grid *grid, const double at_m[3], double at[3])
{
    for (int i = 0; i < 3; i++)
        at[i] = (at_m[i] - grid->origin_m[i]) * grid->units_per_m;
}

/* Rays that meet a front first, and a back. */
struct views {
    size_t fronts, backs;
};

static struct views views_from(const struct compiled *compiled, const double at_m[3], const double (*targets_m)[3],
                               size_t count)
{
    const struct lim_scene *scene = &compiled->scene;
    struct meeting meetings[FREE_SPACE_RAYS_MAX];
    struct ray rays[FREE_SPACE_RAYS_MAX];
    struct views views = {0};

    for (size_t i = 0; i < count; i++) {
        units_of(&compiled->grid, at_m, rays[i].at);
        units_of(&compiled->grid, targets_m[i], rays[i].way);
        vec3_sub(rays[i].way, rays[i].way, rays[i].at);
        meetings[i] = MEETS_NOTHING;
    }
    for (size_t word = 0; word < scene->polygon_words;) {
        const struct record record = record_at(scene, word);
        const struct front_plane plane = plane_of_corners(scene, &record);
        for (size_t i = 0; i < count; i++)
            meet(scene, &record, &plane, &rays[i], &meetings[i]);
        word += record.words;
    }
    for (size_t i = 0; i < count; i++) {
        views.fronts += meetings[i].front;
        views.backs += !meetings[i].front && meetings[i].t < DBL_MAX;
    }
    return views;
}

bool free_space_shows_fronts(const struct compiled *compiled, const double at_m[3], const double (*targets_m)[3],
                             size_t count)
{
    const struct views views = views_from(compiled, at_m, targets_m, count);
    return views.fronts >= views.backs;
}

bool free_space_is_within(const struct compiled *compiled, const double at_m[3], const double (*targets_m)[3],
                          size_t count)
{
    return 4 * views_from(compiled, at_m, targets_m, count).fronts >= 3 * count;
}

bool free_space_holds(const struct compiled *compiled, const double at_m[3])
{
    const struct lim_scene *scene = &compiled->scene;
    struct lim_camera camera = {.near_q8 = 1};
    struct lim_eye eye;
    double at[3];
    lim_index index = 0;

    units_of(&compiled->grid, at_m, at);
    for (int i = 0; i < 3; i++)
        camera_put(&camera, i, at[i], &compiled->grid);
    if (lim_scene_is_mesh(scene)) return is_free_in_run(scene, 0, at);
    if (!lim_eye_begin(&eye, scene, &camera)) return true; /* so far out that nothing is */
    for (;;) {
        const struct lim_node *node = &scene->nodes[index];
        if (node->split.plane == LIM_NO_INDEX) return is_free_in_run(scene, node->front_run, at);
        const bool in_front = lim_eye_side(&eye, &node->split) > 0;
        const lim_index child = in_front ? node->front : node->back;
        if (child == LIM_NO_INDEX) return (in_front ? node->front_run : node->back_run) != LIM_NO_INDEX;
        index = child;
    }
}
