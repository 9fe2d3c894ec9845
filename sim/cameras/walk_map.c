/* SPDX-License-Identifier: MIT
 *
 * A flood over cells of a grid. From each place it is tried to walk to the middles of the eight cells around: who comes
 * near one, and stands, has found a place, unless that cell has one of about that height already. */
#include "cameras/walk_map.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "base/progress.h"

#include <math.h>
#include <stdlib.h>

const double WALK_NEAR_M = 0.125;
static const double CELL_M = 0.5, STRIDE_M = 0.1, FALL_M = 0.02;
enum { FALLS_MAX = 400 };

static double units_q8(const struct walk_map *map, double length_m)
{
    return round(length_m * map->scene->grid.units_per_m * 256.0);
}

static bool set_solid(struct walk_map *map, struct error *err)
{
    const struct lim_scene *scene = &map->scene->scene;
    const size_t mem_b = (scene->limits.depth + 1u) * sizeof *map->stack;
    map->stack = grow_zeroed(1, mem_b);
    if (map->scene->grid.is_long) return error_set(err, "a scene with coordinates of 32 bits stops no walker");
    return !lim_solid_init(&map->solid, scene, map->stack, mem_b) ||
           error_set(err, "a mesh without a tree stops no walker; --tree bsp has one");
}

bool walk_map_init(struct walk_map *map, const struct compiled *scene, const struct walk_body *body, struct error *err)
{
    *map = (struct walk_map){.scene = scene, .body = *body};
    if (!set_solid(map, err)) return false;
    const double widest_q8 = fmax(units_q8(map, body->radius_m), units_q8(map, body->height_m / 2));
    const double least_q8 = fmin(units_q8(map, body->radius_m), units_q8(map, STRIDE_M));
    if (widest_q8 >= LIM_HALF_MAX_Q8)
        return error_set(err, "a walker of %g m is too large for a scene whose grid spans %.3g m", body->height_m,
                         65534.0 / scene->grid.units_per_m);
    return least_q8 >= 2 * LIM_SKIN_Q8 ||
           error_set(err, "a walker of %g m is too small for a scene whose grid spans %.3g m", body->height_m,
                     65534.0 / scene->grid.units_per_m);
}

void walk_map_free(struct walk_map *map)
{
    free(map->stack);
    free(map->places);
    map_free(&map->cells);
}

static double place_m(const struct walk_map *map, const struct lim_walker *walker, int axis)
{
    const struct grid *grid = &map->scene->grid;
    return walker->at_q8[axis] / 256.0 / grid->units_per_m + grid->origin_m[axis];
}

void walk_map_eye(const struct walk_map *map, const struct lim_walker *walker, double eye_m[3])
{
    for (int i = 0; i < 3; i++)
        eye_m[i] = place_m(map, walker, i) + (i == 1 ? map->body.eye_m : 0.0);
}

double walk_map_way_m(const struct walk_map *map, const struct lim_walker *a, const struct lim_walker *b)
{
    return hypot(b->at_q8[0] - a->at_q8[0], b->at_q8[2] - a->at_q8[2]) / 256.0 / map->scene->grid.units_per_m;
}

/* Out of range it stands nowhere. */
static bool falls_to_ground(const struct walk_map *map, struct lim_walker *walker)
{
    for (int i = 0; i < FALLS_MAX && !walker->stands; i++)
        if (lim_walker_move(&map->solid, walker, 0, 0)) return false;
    return walker->stands;
}

bool walk_map_put(const struct walk_map *map, const double eye_m[3], struct lim_walker *walker)
{
    const struct grid *grid = &map->scene->grid;
    const int32_t step_q8 = (int32_t)units_q8(map, map->body.step_m);
    *walker = (struct lim_walker){.radius_q8 = (int32_t)units_q8(map, map->body.radius_m),
                                  .height_q8 = (int32_t)units_q8(map, map->body.height_m),
                                  .step_q8 = step_q8,
                                  .gravity_q8 = (int32_t)fmin(LIM_GRAVITY_MAX_Q8, units_q8(map, FALL_M))};
    for (int i = 0; i < 3; i++) {
        const double at_q8 = units_q8(map, eye_m[i] - grid->origin_m[i] - (i == 1 ? map->body.eye_m : 0.0));
        if (!(fabs(at_q8) < LIM_BODY_MAX_Q8)) return false;
        walker->at_q8[i] = (int32_t)at_q8;
    }
    return falls_to_ground(map, walker);
}

/* As far as a walker moves at once, where units are small. */
static double stride_m(const struct walk_map *map)
{
    return fmin(STRIDE_M, (LIM_WALKER_WAY_MAX_Q8 - 1) / 256.0 / map->scene->grid.units_per_m);
}

/* Straight to a place, so far at most. false: it left the range. */
static bool stride(const struct walk_map *map, struct lim_walker *walker, const struct lim_walker *to, double most_m)
{
    const double x_q8 = to->at_q8[0] - walker->at_q8[0], z_q8 = to->at_q8[2] - walker->at_q8[2];
    const double left_q8 = hypot(x_q8, z_q8), most_q8 = units_q8(map, most_m);
    const double share = left_q8 > most_q8 ? most_q8 / left_q8 : 1.0;
    return !lim_walker_move(&map->solid, walker, (int32_t)(x_q8 * share), (int32_t)(z_q8 * share));
}

bool walk_map_goes(const struct walk_map *map, struct lim_walker *walker, const struct lim_walker *to, double most_m)
{
    const int moves = (int)ceil(most_m / stride_m(map)) + 2;
    for (int i = 0; i < moves && walk_map_way_m(map, walker, to) >= WALK_NEAR_M; i++)
        if (!stride(map, walker, to, stride_m(map)) || !walker->stands) return false;
    return walk_map_way_m(map, walker, to) < WALK_NEAR_M;
}

bool walk_map_steps(const struct walk_map *map, struct lim_walker *walker, const struct lim_walker *to, double way_m)
{
    for (double left_m = way_m; left_m > 0.0; left_m -= stride_m(map)) {
        const struct lim_walker before = *walker;
        if (!stride(map, walker, to, fmin(left_m, stride_m(map)))) return false;
        if (walker->stands) continue;
        *walker = before;
        break;
    }
    return true;
}

bool walk_map_sees(const struct walk_map *map, const struct lim_walker *a, const struct lim_walker *b)
{
    const int32_t eye_q8 = (int32_t)units_q8(map, map->body.eye_m);
    const int32_t from_q8[3] = {a->at_q8[0], a->at_q8[1] + eye_q8, a->at_q8[2]};
    const int32_t to_q8[3] = {b->at_q8[0], b->at_q8[1] + eye_q8, b->at_q8[2]};
    struct lim_hit hit;
    return lim_trace(&map->solid, from_q8, to_q8, 0, &hit) == 0;
}

/* The flood ---------------------------------------------------------------------------------- */

/* Heights are told apart by halves of what a walker takes. */
static uint64_t cell_of(const struct walk_map *map, const struct lim_walker *walker)
{
    const double height_m = map->body.height_m / 2;
    const uint64_t x = (uint64_t)(int64_t)floor(place_m(map, walker, 0) / CELL_M) & 0xFFFFF,
                   y = (uint64_t)(int64_t)floor(place_m(map, walker, 1) / height_m) & 0xFFFFF,
                   z = (uint64_t)(int64_t)floor(place_m(map, walker, 2) / CELL_M) & 0xFFFFF;
    return x << 40 | y << 20 | z;
}

static int32_t add_place(struct walk_map *map, const struct lim_walker *walker)
{
    uint32_t *const known = map_at(&map->cells, cell_of(map, walker), UINT32_MAX);
    if (*known != UINT32_MAX) return (int32_t)*known;
    *known = (uint32_t)map->count;
    map->places = grow(map->places, map->count, &map->capacity, sizeof *map->places);
    map->places[map->count] = (struct walk_place){.walker = *walker};
    for (int i = 0; i < WALK_WAYS; i++)
        map->places[map->count].to[i] = WALK_NOWHERE;
    return (int32_t)map->count++;
}

/* The middle of the next cell. */
static struct lim_walker aim_of(const struct walk_map *map, const struct lim_walker *from, int way)
{
    static const int steps[WALK_WAYS][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
    const struct grid *grid = &map->scene->grid;
    struct lim_walker to = *from;
    for (int i = 0; i < 2; i++) {
        const double middle_m = (floor(place_m(map, from, 2 * i) / CELL_M) + 0.5 + steps[way][i]) * CELL_M;
        to.at_q8[2 * i] = (int32_t)units_q8(map, middle_m - grid->origin_m[2 * i]);
    }
    return to;
}

static void explore_from(struct walk_map *map, size_t place)
{
    for (int way = 0; way < WALK_WAYS && map->count < WALK_PLACES_MAX; way++) {
        struct lim_walker walker = map->places[place].walker;
        const struct lim_walker to = aim_of(map, &walker, way);
        if (!walk_map_goes(map, &walker, &to, 3 * CELL_M)) continue;
        const int32_t found = add_place(map, &walker);
        if (found != (int32_t)place) map->places[place].to[way] = found;
    }
}

bool walk_map_explore(struct walk_map *map, const struct lim_walker *from, struct error *err)
{
    map->count = 0;
    map_free(&map->cells);
    add_place(map, from);
    for (size_t place = 0; place < map->count; place++) {
        if (place % 64 == 0) progress("walk: %zu places found", map->count);
        if (!deadline_check(err, "%zu places found so far", map->count)) return false;
        explore_from(map, place);
    }
    progress_end();
    return true;
}
