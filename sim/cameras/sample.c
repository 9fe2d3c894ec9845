/* SPDX-License-Identifier: MIT
 *
 * Points at random, until one lies in free space. */
#include "cameras/sample.h"

#include "base/vec3.h"
#include "cameras/free_space.h"
#include "model/original.h"
#include "model/pose.h"
#include "scene/moving.h"
#include "scene/vertex_units.h"

#include <math.h>

enum { ASKED = 32, ASKED_ALL = 20000 };
enum { TRIES = 200, TRIES_WITHIN = 10000, PATIENCE = 100000, APART_UNITS = 16 /* eye and target */ };

double sampler_unit(struct sampler *sampler)
{
    sampler->state ^= sampler->state >> 12;
    sampler->state ^= sampler->state << 25;
    sampler->state ^= sampler->state >> 27;
    return (double)(sampler->state * UINT64_C(0x2545F4914F6CDD1D) >> 11) / 9007199254740992.0;
}

static void vertex_m(const struct compiled *scene, size_t index, double out_m[3])
{
    double units[3];
    vertex_units(&scene->scene, (lim_index)index, units);
    for (int i = 0; i < 3; i++)
        out_m[i] = scene->grid.origin_m[i] + units[i] / scene->grid.units_per_m;
}

static void set_bounds(struct sampler *sampler, const struct compiled *scene)
{
    for (size_t v = 0; v < scene->scene.vertex_count; v++) {
        double at_m[3];
        vertex_m(scene, v, at_m);
        for (int i = 0; i < 3; i++) {
            if (v == 0 || at_m[i] < sampler->low_m[i]) sampler->low_m[i] = at_m[i];
            if (v == 0 || at_m[i] > sampler->high_m[i]) sampler->high_m[i] = at_m[i];
        }
    }
}

static void point_in_bounds(struct sampler *sampler, double out_m[3])
{
    for (int i = 0; i < 3; i++)
        out_m[i] = sampler->low_m[i] + sampler_unit(sampler) * (sampler->high_m[i] - sampler->low_m[i]);
}

/* Four times as wide as the bounds; an eye in a long scene may not be that far away. */
static double wide_of(const struct grid *grid, double longest_m)
{
    return grid->is_long ? fmin(4.0, 1.9 * LIM_LONG_EYE_END / (longest_m * grid->units_per_m)) : 4.0;
}

double sampler_reach_m(const struct sampler *sampler, double longest_m)
{
    return wide_of(&sampler->scene->grid, longest_m) * longest_m / 2.0;
}

/* Anywhere in the bounds, or in bounds as wide as that, if anything is to be seen from there. */
static void random_point(struct sampler *sampler, double out_m[3])
{
    double longest_m = 0;
    for (int i = 0; i < 3; i++)
        longest_m = fmax(longest_m, sampler->high_m[i] - sampler->low_m[i]);
    const bool is_near = sampler_unit(sampler) < 0.5 || sampler->scene->report.is_interior;
    const double spread = is_near ? 1.0 : wide_of(&sampler->scene->grid, longest_m);
    for (int i = 0; i < 3; i++) {
        const double side_m = spread > 1 ? longest_m * spread : sampler->high_m[i] - sampler->low_m[i];
        out_m[i] = (sampler->low_m[i] + sampler->high_m[i]) / 2 + (sampler_unit(sampler) - 0.5) * side_m;
    }
}

static double distance_m(const struct viewpoint *viewpoint)
{
    const double *e = viewpoint->eye_m, *t = viewpoint->target_m;
    return hypot(hypot(e[0] - t[0], e[1] - t[1]), e[2] - t[2]);
}

/* The i-th number of the Halton sequence of a base: 0..1, evenly spread. */
static double halton(unsigned i, unsigned base)
{
    double part = 1.0, sum = 0.0;

    for (; i > 0; i /= base)
        sum += (part /= base) * (i % base);
    return sum;
}

/* By rays to points of the bounds, which hang on no order of polygons. */
static bool shows_fronts(const struct sampler *sampler, const double eye_m[3])
{
    static const unsigned bases[3] = {2, 3, 5};
    double targets_m[FREE_SPACE_RAYS_MAX][3];

    for (unsigned k = 0; k < FREE_SPACE_RAYS_MAX; k++)
        for (int i = 0; i < 3; i++)
            targets_m[k][i] = sampler->low_m[i] + halton(k + 1, bases[i]) * (sampler->high_m[i] - sampler->low_m[i]);
    return (sampler->scene->report.is_interior ? free_space_is_within : free_space_shows_fronts)(
        sampler->scene, eye_m, (const double(*)[3])targets_m, FREE_SPACE_RAYS_MAX);
}

bool sampler_may_be_at(const struct sampler *sampler, const double eye_m[3])
{
    return free_space_holds(sampler->scene, eye_m) && (!sampler->fronts_only || shows_fronts(sampler, eye_m));
}

struct viewpoint sampler_next(struct sampler *sampler)
{
    const double apart_m = APART_UNITS / sampler->scene->grid.units_per_m;
    struct viewpoint viewpoint = {.line = 1};

    for (int i = 0; i < (sampler->scene->report.is_interior ? TRIES_WITHIN : TRIES); i++) {
        random_point(sampler, viewpoint.eye_m);
        if (sampler_may_be_at(sampler, viewpoint.eye_m)) break;
    }
    const double count = sampler->scene->scene.vertex_count;
    vertex_m(sampler->scene, (size_t)(sampler_unit(sampler) * count), viewpoint.target_m);
    if (distance_m(&viewpoint) < apart_m) viewpoint.target_m[2] += 2 * apart_m;
    return viewpoint;
}

/* Fewer are asked of many polygons, which take longer. */
static bool wants_fronts(const struct sampler *sampler)
{
    struct sampler asked = *sampler;
    const size_t polygons = sampler->scene->scene.polygon_count;
    const int count = polygons > ASKED_ALL ? ASKED / 4 : ASKED;
    int fronts = 0;

    for (int i = 0; i < count; i++) {
        const struct viewpoint viewpoint = sampler_next(&asked);
        fronts += shows_fronts(sampler, viewpoint.eye_m);
    }
    return fronts > 0 && fronts < count * 3 / 4;
}

void sampler_init(struct sampler *sampler, const struct compiled *scene)
{
    *sampler =
        (struct sampler){.scene = scene, .state = 0x9E3779B97F4A7C15, .near_m = lens_default_near_m(&scene->grid)};
    set_bounds(sampler, scene);
    sampler->fronts_only = scene->report.is_interior || wants_fronts(sampler);
}

/* In the unit ball, and not too close to its middle. Returns how far from it. */
static double random_way(struct sampler *sampler, double out[3])
{
    double length;
    do {
        for (int i = 0; i < 3; i++)
            out[i] = 2.0 * sampler_unit(sampler) - 1.0;
        length = hypot(hypot(out[0], out[1]), out[2]);
    } while (length > 1.0 || length < 0.125);
    return length;
}

bool sampler_portrait(struct sampler *sampler, struct viewpoint *out)
{
    const double *low_m = sampler->low_m, *high_m = sampler->high_m;
    const double reach_m = hypot(hypot(high_m[0] - low_m[0], high_m[1] - low_m[1]), high_m[2] - low_m[2]) / 2.0;
    const double away_m = reach_m * (1.0 + sampler_unit(sampler));
    double way[3];

    const double length = random_way(sampler, way);
    *out = (struct viewpoint){.line = 1};
    for (int i = 0; i < 3; i++) {
        out->target_m[i] = (low_m[i] + high_m[i]) / 2.0;
        out->eye_m[i] = out->target_m[i] + way[i] / length * away_m;
    }
    return distance_m(out) * sampler->scene->grid.units_per_m >= APART_UNITS && sampler_may_be_at(sampler, out->eye_m);
}

/* A face whose patch is about as large as one of a random size; among those of one size any. */
static const struct original_face *random_face(struct sampler *sampler, const struct original *original)
{
    const double alike = 1.5;
    const size_t count = original->seen_count;
    const double least_m = original->faces[original->by_size[0]].size_m;
    const double most_m = original->faces[original->by_size[count - 1]].size_m;
    const double wanted_m = least_m * pow(most_m / least_m, sampler_unit(sampler));
    size_t low = 0, high = count - 1;
    while (low < high) { /* the first that is no smaller */
        const size_t middle = (low + high) / 2;
        if (original->faces[original->by_size[middle]].size_m < wanted_m)
            low = middle + 1;
        else
            high = middle;
    }
    const double above_m = original->faces[original->by_size[low]].size_m;
    const double below_m = original->faces[original->by_size[low ? low - 1 : 0]].size_m;
    const double size_m = wanted_m * wanted_m < above_m * below_m ? below_m : above_m;
    size_t first = low, end = low;
    while (first > 0 && original->faces[original->by_size[first - 1]].size_m * alike > size_m)
        first--;
    while (end < count && original->faces[original->by_size[end]].size_m < size_m * alike)
        end++;
    const size_t chosen = first + (size_t)(sampler_unit(sampler) * (double)(end - first));
    return &original->faces[original->by_size[chosen < end ? chosen : first]];
}

/* Whose faces are looked at, and where they are. */
static const struct original *random_thing(struct sampler *sampler, struct model_pose *pose)
{
    const struct moving *moving = sampler->scene->moving;
    *pose = (struct model_pose){.turn = {0, 0, 0, 1}};
    if (!moving || sampler_unit(sampler) < 0.5) return sampler->scene->original;
    const size_t i = (size_t)(sampler_unit(sampler) * (double)moving->count);
    *pose = pose_at(&moving->model, &moving->model.movers[i], sampler->time_s);
    return moving->objects[i].scene.original;
}

bool sampler_near(struct sampler *sampler, struct viewpoint *out)
{
    const struct grid *grid = &sampler->scene->grid;
    const double least_m = fmax(2.0 * sampler->near_m, APART_UNITS / 256.0 / grid->units_per_m);
    for (int i = 0; i < TRIES; i++) {
        struct model_pose pose;
        const struct original *original = random_thing(sampler, &pose);
        if (!original || !original->seen_count) return false;
        const struct original_face *face = random_face(sampler, original);
        const double away_m = fmax(face->size_m * (1.0 + 3.0 * sampler_unit(sampler)), least_m);
        double way[3];
        const double length = random_way(sampler, way), side = vec3_dot(way, face->normal) < 0.0 ? -1.0 : 1.0;
        *out = (struct viewpoint){.line = 1};
        double eye_m[3];
        for (int k = 0; k < 3; k++)
            eye_m[k] = face->centre_m[k] + side * way[k] / length * away_m;
        pose_leave(&pose, face->centre_m, out->target_m);
        pose_leave(&pose, eye_m, out->eye_m);
        if (sampler_may_be_at(sampler, out->eye_m)) return true;
    }
    return false;
}

void sampler_seed(struct sampler *sampler, uint32_t seed)
{
    sampler->state = (seed + UINT64_C(1)) * 0xD1342543DE82EF95; /* odd: no seed gives 0, from which nothing comes */
}

bool sampler_anywhere(struct sampler *sampler, struct viewpoint *out)
{
    const double apart_m = APART_UNITS / sampler->scene->grid.units_per_m;

    for (int i = 0; i < PATIENCE; i++) {
        random_point(sampler, out->eye_m);
        point_in_bounds(sampler, out->target_m);
        if (distance_m(out) >= apart_m && sampler_may_be_at(sampler, out->eye_m)) return true;
    }
    return false;
}
