/* SPDX-License-Identifier: MIT
 *
 * The renderer draws the triangles' numbers from sampled cameras. A depth buffer in double precision, of the same
 * triangles, says which is nearest at each pixel. Where another was painted that is farther there, the two are a
 * conflict, which is right when both have depth. Triangles get it, those first that put most pixels right, until few
 * enough pixels are left. Then all is drawn again, as what has depth meets what has none in other ways; where many need
 * depth in all views, all get it. Views in which the renderer may have to clip are counted apart. Pixels near the
 * nearest one's edges are not looked at: there rounding decides who paints. */
#include "compiler/mesh_order.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "base/map.h"
#include "base/progress.h"
#include "cameras/sample.h"
#include "render/ids.h"
#include "scene/lim_image.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE_PX = 240, FOV_DEG = 60, ROUNDS = 8, MOST_ACTIVE = 30000, ASKS_EVERY = 256 };
enum { CAMERAS_MAX = 192, CAMERAS_MIN = 24, TRIANGLES_DRAWN = 1500000 }; /* of many triangles, fewer cameras */
static const double MARGIN_PX = 0.1;                                     /* what rounding moves an edge by, and more */
static const double TOLERANCE_UNITS = 1;   /* what is so little farther is no nearer either */
static const double ENOUGH_OF_SHARE = 0.5; /* what a round leaves of it, of what it has seen */
static const double MANY_DEEP = 0.25;      /* of the triangles: where more need it in all views, all get it */
static const double SHARE = 0.35;          /* of the wrong pixels that a profile may have, most are of edges */
static const double NEAR_SHARE = 0.15;     /* of that: views from near by differ more from each other */

double mesh_order_share(const struct core *core, double wrong_percent)
{
    static const double percents[] = {
        [LIM_PROFILE_DRAFT] = 0.1, [LIM_PROFILE_FAST] = 0.05, [LIM_PROFILE_FINE] = 0.03, [LIM_PROFILE_EXACT] = 0.01};
    const double percent = wrong_percent > 0 ? wrong_percent : percents[core ? core->profile : LIM_PROFILE_FAST];
    return percent / 100 * SHARE;
}

/* Views are of two kinds, as the renderer tells them: it may have to clip, or not. */
enum view_kind { VIEW_NEAR, VIEW_WHOLE, VIEW_KINDS };

struct pair {
    uint64_t key; /* both triangles, the lower number first */
    uint32_t pixels;
};

struct ordering {
    struct compiled *scene;
    struct ids ids;
    struct sampler sampler;
    struct lens lens;
    struct viewpoint viewpoint;
    struct view_axes axes;
    double (*at)[3];              /* vertices: pixels from the left, from the top, depth in units */
    double *depths;               /* of the nearest triangle at each pixel, units */
    uint32_t *nearest;            /* and its number, from 1; 0: none */
    struct map pairs[VIEW_KINDS]; /* to pixels that are painted in the wrong order */
    double pixels[VIEW_KINDS];    /* of all pictures */
    uint8_t *deep;                /* of each triangle as the scene has them now: enum lim_deep */
};

/* The depth buffer ------------------------------------------------------------------------------------------------ */

/* Right, up and ahead of the eye, in units. */
static void see_from(const struct ordering *work, const double units[3], double at[3])
{
    const struct grid *grid = &work->scene->grid;
    at[0] = at[1] = at[2] = 0;
    for (int i = 0; i < 3; i++) {
        const double from_eye = units[i] - (work->viewpoint.eye_m[i] - grid->origin_m[i]) * grid->units_per_m;
        at[0] += work->axes.right[i] * from_eye;
        at[1] += work->axes.up[i] * from_eye;
        at[2] += work->axes.forward[i] * from_eye;
    }
}

static void project(struct ordering *work)
{
    const struct lim_scene *scene = &work->scene->scene;
    for (size_t v = 0; v < scene->vertex_count; v++) {
        const double units[3] = {scene->vertices[v].x, scene->vertices[v].y, scene->vertices[v].z};
        double at[3];
        see_from(work, units, at);
        work->at[v][0] = (at[0] / (at[2] * work->lens.tan_x) + 1) * SIDE_PX / 2;
        work->at[v][1] = (1 - at[1] / (at[2] * work->lens.tan_y)) * SIDE_PX / 2;
        work->at[v][2] = at[2];
    }
}

/* Twice the area that three points have on the screen, by their first two coordinates. */
static double area_of(const double *a, const double *b, const double *c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

static const double *corner(const struct ordering *work, size_t triangle, int k)
{
    return work->at[work->scene->scene.polygons[triangle * LIM_TRIANGLE_WORDS + (size_t)k]];
}

/* What is linear over the screen: x, y and a constant. */
typedef double linear[3];

static double linear_at(const linear f, const double point[2])
{
    return f[0] * point[0] + f[1] * point[1] + f[2];
}

/* A triangle on the screen: how far inside of each side a point is, in pixels; and 1 / depth by its plane. */
struct seen_triangle {
    linear sides[3], inverse;
};

static void see(const struct ordering *work, size_t triangle, struct seen_triangle *seen)
{
    const double *c[3] = {corner(work, triangle, 0), corner(work, triangle, 1), corner(work, triangle, 2)};
    const double area = area_of(c[0], c[1], c[2]);
    *seen = (struct seen_triangle){0};
    for (int k = 0; k < 3; k++) {
        const double *from = c[(k + 1) % 3], *to = c[(k + 2) % 3];
        const linear part = {from[1] - to[1], to[0] - from[0], from[0] * to[1] - from[1] * to[0]}; /* twice its area */
        const double length = (area < 0 ? -1 : 1) * hypot(part[0], part[1]);
        for (int i = 0; i < 3; i++) {
            seen->sides[k][i] = part[i] / length;
            seen->inverse[i] += part[i] / area / c[k][2];
        }
    }
}

static bool is_inside(const struct seen_triangle *seen, const double point[2], double margin_px)
{
    return !(linear_at(seen->sides[0], point) < margin_px) && !(linear_at(seen->sides[1], point) < margin_px) &&
           !(linear_at(seen->sides[2], point) < margin_px);
}

static double depth_at(const struct seen_triangle *seen, const double point[2])
{
    return 1 / linear_at(seen->inverse, point);
}

static int first_px(double from)
{
    return from < 0.5 ? 0 : from > SIDE_PX ? SIDE_PX : (int)ceil(from - 0.5);
}

/* What reaches before the near plane is left out: what is clipped is not judged. */
static void draw_triangle(struct ordering *work, size_t triangle)
{
    const double *a = corner(work, triangle, 0), *b = corner(work, triangle, 1), *c = corner(work, triangle, 2);
    const double near = work->lens.near_m * work->scene->grid.units_per_m;
    if (a[2] < near || b[2] < near || c[2] < near || area_of(a, b, c) >= 0) return;
    const int x0 = first_px(fmin(a[0], fmin(b[0], c[0]))), x1 = first_px(fmax(a[0], fmax(b[0], c[0])));
    const int y0 = first_px(fmin(a[1], fmin(b[1], c[1]))), y1 = first_px(fmax(a[1], fmax(b[1], c[1])));
    struct seen_triangle seen;
    see(work, triangle, &seen);
    for (int y = y0; y < y1; y++)
        for (int x = x0; x < x1; x++) {
            const size_t pixel = (size_t)y * SIDE_PX + (size_t)x;
            const double point[2] = {x + 0.5, y + 0.5};
            if (!is_inside(&seen, point, 0)) continue;
            const double depth = depth_at(&seen, point);
            if (depth >= work->depths[pixel]) continue;
            work->depths[pixel] = depth;
            work->nearest[pixel] = (uint32_t)triangle + 1;
        }
}

/* false: out of time. */
static bool draw_depths(struct ordering *work)
{
    for (size_t i = 0; i < (size_t)SIDE_PX * SIDE_PX; i++) {
        work->depths[i] = INFINITY;
        work->nearest[i] = 0;
    }
    project(work);
    for (size_t i = 0; i < work->scene->scene.polygon_count; i++) {
        if (i % ASKS_EVERY == ASKS_EVERY - 1 && deadline_passed()) return false;
        draw_triangle(work, i);
    }
    return true;
}

/* Conflicts ------------------------------------------------------------------------------------------------------- */

/* What is painted there is farther than what should be, and it is not rounding that let it through. */
static bool is_wrong(const struct ordering *work, size_t pixel)
{
    const uint32_t painted = work->ids.numbers[pixel], nearest = work->nearest[pixel];
    const double point[2] = {(double)(pixel % SIDE_PX) + 0.5, (double)(pixel / SIDE_PX) + 0.5};
    struct seen_triangle seen;
    if (!painted || !nearest || painted == nearest) return false;
    see(work, nearest - 1, &seen);
    if (!is_inside(&seen, point, MARGIN_PX)) return false;
    see(work, painted - 1, &seen);
    return depth_at(&seen, point) > work->depths[pixel] + TOLERANCE_UNITS;
}

/* Whether the mesh's box reaches behind the near plane or out of the guard band. */
static enum view_kind kind_of(const struct ordering *work)
{
    const struct lim_box *const box = &work->scene->scene.boxes[0];
    for (int k = 0; k < 8; k++) {
        const double units[3] = {box->centre[0] + (k & 1 ? 1.0 : -1.0) * box->half[0],
                                 box->centre[1] + (k & 2 ? 1.0 : -1.0) * box->half[1],
                                 box->centre[2] + (k & 4 ? 1.0 : -1.0) * box->half[2]};
        double at[3];
        see_from(work, units, at);
        if (at[2] < work->lens.near_m * work->scene->grid.units_per_m || fabs(at[0]) > 2 * work->lens.tan_x * at[2] ||
            fabs(at[1]) > 2 * work->lens.tan_y * at[2])
            return VIEW_NEAR;
    }
    return VIEW_WHOLE;
}

static bool look(struct ordering *work, const struct lim_camera *camera, struct error *err)
{
    const enum view_kind kind = kind_of(work);
    if (!ids_frame(&work->ids, camera, err)) return false;
    if (!draw_depths(work)) return true;
    for (size_t pixel = 0; pixel < (size_t)SIDE_PX * SIDE_PX; pixel++) {
        if (!is_wrong(work, pixel)) continue;
        const uint64_t a = work->ids.numbers[pixel] - 1, b = work->nearest[pixel] - 1;
        ++*map_at(&work->pairs[kind], a < b ? a << 32 | b : b << 32 | a, 0);
    }
    work->pixels[kind] += (double)SIDE_PX * SIDE_PX;
    return true;
}

/* Half of them have all in view; the others are from near its faces, or from anywhere, as predict_held_out() judges. */
static bool next_view(struct ordering *work, size_t i)
{
    if (i % 2 == 0) return sampler_portrait(&work->sampler, &work->viewpoint);
    if (i % 4 == 1 && work->scene->original) return sampler_near(&work->sampler, &work->viewpoint);
    return sampler_anywhere(&work->sampler, &work->viewpoint);
}

static size_t cameras_for(size_t triangles)
{
    const size_t cameras = TRIANGLES_DRAWN / (triangles + 1);
    return cameras > CAMERAS_MAX ? CAMERAS_MAX : cameras < CAMERAS_MIN ? CAMERAS_MIN : cameras;
}

static void free_pairs(struct ordering *work)
{
    for (int kind = 0; kind < VIEW_KINDS; kind++) {
        map_free(&work->pairs[kind]);
        work->pixels[kind] = 0;
    }
}

static bool look_around(struct ordering *work, int round, struct error *err)
{
    const size_t cameras = cameras_for(work->scene->scene.polygon_count);
    const struct camera_path path = {"sampled cameras", &work->viewpoint, 1};
    free_pairs(work);
    sampler_init(&work->sampler, work->scene);
    sampler_seed(&work->sampler, (uint32_t)round + 1); /* other views each time: what is left shows */
    work->sampler.near_m = work->lens.near_m;
    for (size_t i = 0; i < cameras && !deadline_passed(); i++) {
        struct lim_camera camera;
        struct error ignored;
        progress_bar(i, cameras, "looking for triangles that distance cannot order");
        if (!next_view(work, i) || !camera_path_to_camera(&path, 0, &work->lens, &work->scene->grid, &camera, &ignored))
            continue;
        viewpoint_axes(&work->viewpoint, &work->axes);
        if (!look(work, &camera, err)) return false;
    }
    return true;
}

static int compare_pairs(const void *left, const void *right)
{
    const struct pair *a = left, *b = right;
    if (a->pixels != b->pixels) return a->pixels < b->pixels ? 1 : -1;
    return a->key < b->key ? -1 : a->key > b->key;
}

/* Which triangles get depth: as few as leave few enough pixels, or nearly. A pair is right when both have it. */
struct choice {
    bool *is_deep; /* of each triangle */
    struct pair *pairs;
    size_t count;
    size_t *first;   /* of each triangle: its pairs are of[first[triangle]] to of[first[triangle + 1] - 1] */
    size_t *of;      /* pairs' places */
    double *gains;   /* of each triangle: pixels of its pairs whose other one has depth */
    size_t *gainers; /* triangles that have gains, or had */
    size_t gainer_count;
    double left; /* pixels of pairs that are not right */
};

static size_t one_of(const struct pair *pair)
{
    return pair->key >> 32;
}

static size_t other_of(const struct pair *pair)
{
    return pair->key & UINT32_MAX;
}

/* The pairs, those of many pixels first, and which are whose. */
static void choice_fill(struct choice *choice, const struct map *pairs, size_t triangles)
{
    choice->pairs = grow_zeroed(pairs->count, sizeof *choice->pairs);
    choice->first = grow_zeroed(triangles + 2, sizeof *choice->first);
    choice->of = grow_zeroed(2 * pairs->count, sizeof *choice->of);
    choice->gains = grow_zeroed(triangles, sizeof *choice->gains);
    choice->gainers = grow_zeroed(triangles, sizeof *choice->gainers);
    for (size_t i = 0; i < pairs->capacity; i++) {
        if (!pairs->entries[i].used) continue;
        choice->pairs[choice->count++] = (struct pair){pairs->entries[i].key, pairs->entries[i].value};
        choice->left += pairs->entries[i].value;
    }
    qsort(choice->pairs, choice->count, sizeof *choice->pairs, compare_pairs);
    size_t *const end = choice->first + 1; /* counts, then beginnings, then ends */
    for (size_t i = 0; i < choice->count; i++) {
        end[one_of(&choice->pairs[i]) + 1]++;
        end[other_of(&choice->pairs[i]) + 1]++;
    }
    for (size_t i = 1; i <= triangles; i++)
        end[i] += end[i - 1];
    for (size_t i = 0; i < choice->count; i++) {
        choice->of[end[one_of(&choice->pairs[i])]++] = i;
        choice->of[end[other_of(&choice->pairs[i])]++] = i;
    }
}

static void choice_free(struct choice *choice)
{
    free(choice->pairs);
    free(choice->first);
    free(choice->of);
    free(choice->gains);
    free(choice->gainers);
}

/* Its pairs with those that have depth are right now; the others of its pairs would gain by it. */
static void give_depth(struct choice *choice, size_t triangle)
{
    for (size_t i = choice->first[triangle]; i < choice->first[triangle + 1]; i++) {
        const struct pair *pair = &choice->pairs[choice->of[i]];
        const size_t other = one_of(pair) == triangle ? other_of(pair) : one_of(pair);
        if (choice->is_deep[other]) {
            choice->left -= pair->pixels;
            continue;
        }
        if (choice->gains[other] == 0) choice->gainers[choice->gainer_count++] = other;
        choice->gains[other] += pair->pixels;
    }
    choice->is_deep[triangle] = true;
}

/* The place among the gainers of the one without depth that gains most; their number: there is none. */
static size_t find_gainer(struct choice *choice)
{
    size_t best = choice->gainer_count;
    for (size_t i = 0; i < choice->gainer_count; i++) {
        while (i < choice->gainer_count && choice->is_deep[choice->gainers[i]])
            choice->gainers[i] = choice->gainers[--choice->gainer_count];
        if (i == choice->gainer_count) break;
        if (best >= i || choice->gains[choice->gainers[i]] > choice->gains[choice->gainers[best]]) best = i;
    }
    return best < choice->gainer_count ? best : choice->gainer_count;
}

/* One triangle, or the two of the next pair, whichever puts more pixels right for each. False: none would. */
static bool give_more(struct choice *choice, size_t *next)
{
    const size_t best = find_gainer(choice);
    const bool is_gain = best < choice->gainer_count;
    while (*next < choice->count && choice->is_deep[one_of(&choice->pairs[*next])] &&
           choice->is_deep[other_of(&choice->pairs[*next])])
        ++*next;
    if (*next == choice->count && !is_gain) return false;
    const struct pair *pair = &choice->pairs[*next < choice->count ? *next : 0];
    if (*next == choice->count || (is_gain && choice->gains[choice->gainers[best]] >= pair->pixels / 2.0)) {
        give_depth(choice, choice->gainers[best]);
        return true;
    }
    if (!choice->is_deep[one_of(pair)]) give_depth(choice, one_of(pair));
    if (!choice->is_deep[other_of(pair)]) give_depth(choice, other_of(pair));
    return true;
}

/* Triangles get depth in views of a kind until few enough of its pixels are left. False: they are. */
static bool flag_worst(struct ordering *work, enum view_kind kind, double share)
{
    const enum lim_deep least = kind == VIEW_NEAR ? LIM_DEEP_NEAR : LIM_DEEP_ALWAYS;
    const double most = (kind == VIEW_NEAR ? share * NEAR_SHARE : share) * work->pixels[kind];
    const size_t triangles = work->scene->scene.polygon_count;
    struct choice choice = {.is_deep = grow_zeroed(triangles, sizeof *choice.is_deep)};
    size_t next = 0;
    choice_fill(&choice, &work->pairs[kind], triangles);
    const bool is_enough = choice.left <= most;
    for (size_t i = 0; i < triangles && !is_enough; i++)
        if (work->deep[i] >= least) give_depth(&choice, i);
    while (!is_enough && choice.left > ENOUGH_OF_SHARE * most && give_more(&choice, &next)) {
    }
    for (size_t i = 0; i < triangles; i++)
        if (choice.is_deep[i] && work->deep[i] < least) work->deep[i] = (uint8_t)least;
    free(choice.is_deep);
    choice_free(&choice);
    return !is_enough;
}

/* Triangles change places, and so do their flags; the renderer's numbers are those of the scene. */
static bool take_flags(struct ordering *work, const struct simulator_setup *setup, struct error *err)
{
    const struct lim_scene *const scene = &work->scene->scene;
    ids_free(&work->ids);
    lim_image_set_deep(work->scene, work->deep);
    for (size_t i = 0; i < scene->polygon_count; i++)
        work->deep[i] = i >= *scene->deep_from        ? LIM_DEEP_ALWAYS
                        : i >= *scene->near_deep_from ? LIM_DEEP_NEAR
                                                      : LIM_DEEP_NEVER;
    return ids_init(&work->ids, work->scene, setup, err);
}

/* Where many triangles have depth, those that have none do harm: in a heap each view shows other conflicts. */
static bool needs_all(const struct ordering *work)
{
    const size_t triangles = work->scene->scene.polygon_count;
    size_t deep = 0;
    for (size_t i = 0; i < triangles; i++)
        deep += work->deep[i] == LIM_DEEP_ALWAYS;
    return (double)deep > MANY_DEEP * (double)triangles;
}

static bool settle(struct ordering *work, const struct simulator_setup *setup, double share, struct error *err)
{
    bool is_settled = false;
    for (int round = 0; round < ROUNDS && !is_settled && !needs_all(work) && !deadline_passed(); round++) {
        if (!look_around(work, round, err)) return false;
        const bool whole = flag_worst(work, VIEW_WHOLE, share), near = flag_worst(work, VIEW_NEAR, share);
        is_settled = !whole && !near;
        if (!is_settled && !take_flags(work, setup, err)) return false;
    }
    if (!needs_all(work)) return true;
    memset(work->deep, LIM_DEEP_ALWAYS, work->scene->scene.polygon_count);
    return take_flags(work, setup, err);
}

/* As many as may cross a line: with less room lines come in parts, and each part looks at all triangles anew. */
static void set_roomy(struct compiled *scene)
{
    struct lim_limits limits = scene->scene.limits;
    limits.active = (uint16_t)(scene->scene.polygon_count < MOST_ACTIVE ? scene->scene.polygon_count : MOST_ACTIVE);
    lim_image_set_limits(scene, &limits);
}

bool mesh_order_settle(struct compiled *scene, const struct core *core, double share, struct error *err)
{
    const struct simulator_setup setup = {SIDE_PX, SIDE_PX, LIM_MESH_DEPTH, SIMULATOR_MEMORY, core};
    struct ordering work = {.scene = scene};
    set_roomy(scene);
    if (!lens_for_grid(&work.lens, FOV_DEG, scene->report.near_m, &scene->grid, SIDE_PX, SIDE_PX, err)) return false;
    if (!ids_init(&work.ids, scene, &setup, err)) return false;
    work.at = grow_zeroed(scene->scene.vertex_count, sizeof *work.at);
    work.depths = grow_zeroed((size_t)SIDE_PX * SIDE_PX, sizeof *work.depths);
    work.nearest = grow_zeroed((size_t)SIDE_PX * SIDE_PX, sizeof *work.nearest);
    work.deep = grow_zeroed(scene->scene.polygon_count, sizeof *work.deep);
    const bool ok = settle(&work, &setup, share, err);
    ids_free(&work.ids);
    free_pairs(&work);
    free(work.at);
    free(work.depths);
    free(work.nearest);
    free(work.deep);
    return ok;
}
