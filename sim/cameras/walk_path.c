/* SPDX-License-Identifier: MIT
 *
 * What is seen is crossed off: places within SEEN_M that a ray from the eye reaches. The nearest place that is left, by
 * the way there, is where it goes next; when none is left, it goes to the one that is farthest, and all is to be seen
 * again. It heads for the farthest place of its way that it can walk to straight, turns by TURN_A_FRAME at most, and
 * goes where it looks; but never off an edge. */
#include "cameras/walk_path.h"

#include "base/grow.h"
#include "base/progress.h"
#include "cameras/random_path.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double SEEN_M = 10.0, EYE_PART = 0.35;
enum { AHEAD = 8, STARTS = 12, LOOK_EVERY = 4, STUCK_FRAMES = 8, NEAREST_TRIES = 12 };
static const double FULL_TURN = 6.283185307179586476925, TURN_A_FRAME = 0.16;

struct touring {
    struct walk_map map;
    const struct walk_wish *wish;
    struct lim_walker walker;
    double heading; /* radians, as lim_camera's yaw */
    double eye_y_m; /* follows the walker's, so that steps are no jumps */
    bool *seen;
    bool *ever;
    bool *bad;              /* it was stuck on its way there */
    int32_t *before;        /* of each place, the one on the way there */
    int32_t *queue, *route; /* the route's last place first */
    size_t left;            /* of the route */
    int32_t goal;           /* where it ends; whether it is seen there or not, it is done with then */
    int stuck;
};

/* The way there on the level, and four times the difference in height: places are compared by it, no more. */
static double apart_m(const struct touring *tour, size_t place)
{
    const struct lim_walker *at = &tour->map.places[place].walker;
    const double up_q8 = (double)at->at_q8[1] - tour->walker.at_q8[1];
    return walk_map_way_m(&tour->map, &tour->walker, at) + 4 * fabs(up_q8) / 256.0 / tour->map.scene->grid.units_per_m;
}

/* The nearest of those that are farther than so much. */
static int32_t nearest_beyond(const struct touring *tour, double beyond_m, double *least_m)
{
    int32_t nearest = WALK_NOWHERE;
    *least_m = INFINITY;
    for (size_t k = 0; k < tour->map.count; k++) {
        const double way_m = apart_m(tour, k);
        if (tour->bad[k] || way_m <= beyond_m || way_m >= *least_m) continue;
        *least_m = way_m;
        nearest = (int32_t)k;
    }
    return nearest;
}

/* The nearest place that it can go to straight. */
static int32_t nearest_place(const struct touring *tour)
{
    double way_m;
    const int32_t nearest = nearest_beyond(tour, -1.0, &way_m);
    int32_t place = nearest;
    for (int i = 0; i < NEAREST_TRIES && place != WALK_NOWHERE; i++) {
        struct lim_walker trial = tour->walker;
        if (walk_map_goes(&tour->map, &trial, &tour->map.places[place].walker, way_m)) return place;
        place = nearest_beyond(tour, way_m, &way_m);
    }
    return nearest;
}

/* The way to the nearest place that was not seen; if all were, to the one that is farthest. Whether one is left. */
static bool plan(struct touring *tour)
{
    size_t first = 0, last = 0;
    const int32_t near = nearest_place(tour), start = near == WALK_NOWHERE ? 0 : near;
    memset(tour->before, -1, tour->map.count * sizeof *tour->before);
    tour->before[start] = start;
    tour->queue[last++] = start;
    for (; first < last && tour->seen[tour->queue[first]]; first++)
        for (int way = 0; way < WALK_WAYS; way++) {
            const int32_t next = tour->map.places[tour->queue[first]].to[way];
            if (next == WALK_NOWHERE || tour->bad[next] || tour->before[next] >= 0) continue;
            tour->before[next] = tour->queue[first];
            tour->queue[last++] = next;
        }
    tour->left = 0;
    tour->goal = tour->queue[first < last ? first : last - 1];
    for (int32_t at = tour->goal; at != start; at = tour->before[at])
        tour->route[tour->left++] = at;
    tour->route[tour->left++] = start;
    return first < last;
}

static void look_around(struct touring *tour)
{
    for (size_t k = 0; k < tour->map.count; k++) {
        const struct lim_walker *at = &tour->map.places[k].walker;
        if (tour->seen[k] || walk_map_way_m(&tour->map, &tour->walker, at) > SEEN_M) continue;
        tour->seen[k] = walk_map_sees(&tour->map, &tour->walker, at);
        tour->ever[k] |= tour->seen[k];
    }
}

/* The place to head for, as far ahead as it can be walked to; *go: whether there is one. */
static const struct lim_walker *aim(struct touring *tour)
{
    while (tour->left && walk_map_way_m(&tour->map, &tour->walker,
                                        &tour->map.places[tour->route[tour->left - 1]].walker) < WALK_NEAR_M)
        tour->left--;
    if (!tour->left) return NULL;
    for (size_t ahead = tour->left < AHEAD ? tour->left : AHEAD; ahead > 1; ahead--) {
        struct lim_walker trial = tour->walker;
        const struct lim_walker *to = &tour->map.places[tour->route[tour->left - ahead]].walker;
        if (!walk_map_goes(&tour->map, &trial, to, walk_map_way_m(&tour->map, &trial, to))) continue;
        tour->left -= ahead - 1;
        break;
    }
    return &tour->map.places[tour->route[tour->left - 1]].walker;
}

/* How far to the left that is: -half a turn to half a turn. */
static double turn_to(const struct touring *tour, const struct lim_walker *to)
{
    const double x = (double)to->at_q8[0] - tour->walker.at_q8[0], z = (double)to->at_q8[2] - tour->walker.at_q8[2];
    return remainder(atan2(-x, -z) - tour->heading, FULL_TURN);
}

/* Ahead, less where it still has to turn. */
static bool go_ahead(struct touring *tour, const struct lim_walker *to, double left, struct error *err)
{
    const double stride_m = fabs(left) > FULL_TURN / 6 ? 0.0 : tour->wish->stride_m * cos(left);
    const struct lim_walker before = tour->walker;
    if (!walk_map_steps(&tour->map, &tour->walker, to, stride_m))
        return error_set(err, "the walker left the range of coordinates");
    const double wanted_m = fmin(stride_m, walk_map_way_m(&tour->map, &before, to));
    const bool is_stuck = stride_m > 0 && walk_map_way_m(&tour->map, &before, &tour->walker) < wanted_m / 4;
    tour->stuck = is_stuck ? tour->stuck + 1 : 0;
    return true;
}

/* The goal is done with, whether it is seen from there or not. */
static void next_route(struct touring *tour)
{
    if (tour->goal != WALK_NOWHERE) tour->seen[tour->goal] = tour->ever[tour->goal] = true;
    tour->stuck = 0;
    if (plan(tour)) return;
    memset(tour->seen, 0, tour->map.count * sizeof *tour->seen);
    memset(tour->bad, 0, tour->map.count * sizeof *tour->bad);
    look_around(tour);
}

/* Where it is stuck it goes another way. */
static void give_up(struct touring *tour)
{
    tour->bad[tour->route[tour->left - 1]] = true;
    tour->goal = WALK_NOWHERE;
    next_route(tour);
}

static bool press_buttons(struct touring *tour, struct error *err)
{
    const struct lim_walker *to = aim(tour);
    if (!to) next_route(tour);
    if (to && tour->stuck > STUCK_FRAMES) give_up(tour);
    to = aim(tour);
    const double turn = to ? turn_to(tour, to) : 0.0;
    const double now = fmax(-TURN_A_FRAME, fmin(TURN_A_FRAME, turn));
    tour->heading += now;
    return !to || go_ahead(tour, to, turn - now, err);
}

static void take_frame(struct touring *tour, struct viewpoint *frame, size_t number)
{
    const double yaw = tour->heading;
    walk_map_eye(&tour->map, &tour->walker, frame->eye_m);
    if (!number) tour->eye_y_m = frame->eye_m[1];
    tour->eye_y_m += EYE_PART * (frame->eye_m[1] - tour->eye_y_m);
    frame->eye_m[1] = tour->eye_y_m;
    frame->target_m[0] = frame->eye_m[0] - sin(yaw);
    frame->target_m[1] = frame->eye_m[1];
    frame->target_m[2] = frame->eye_m[2] - cos(yaw);
    frame->line = number + 1;
}

static bool make_frames(struct touring *tour, struct camera_path *out, struct walk_found *found, struct error *err)
{
    struct lim_walker last = tour->walker;
    look_around(tour);
    for (size_t i = 0; i < out->count; i++) {
        progress_bar(i, out->count, "walk");
        take_frame(tour, &out->frames[i], i);
        if (i % LOOK_EVERY == 0) look_around(tour);
        if (!press_buttons(tour, err)) return false;
        found->way_m += walk_map_way_m(&tour->map, &last, &tour->walker);
        last = tour->walker;
    }
    progress_end();
    for (size_t k = 0; k < tour->map.count; k++)
        found->seen += tour->ever[k];
    return true;
}

/* Where it begins ---------------------------------------------------------------------------- */

static bool begin_there(struct touring *tour, struct error *err)
{
    const double *from_m = tour->wish->from_m;
    if (!walk_map_put(&tour->map, from_m, &tour->walker))
        return error_set(err, "--from %g,%g,%g: there is no ground below that can be stood on", from_m[0], from_m[1],
                         from_m[2]);
    tour->heading = tour->wish->heading_deg / 360.0 * FULL_TURN;
    return walk_map_explore(&tour->map, &tour->walker, err);
}

static bool begin_anywhere(struct touring *tour, const char *name, struct error *err)
{
    struct camera_path starts;
    struct lim_walker best = {.stands = false};
    size_t most = 0;
    if (!random_path(tour->map.scene, name, 1, STARTS, &starts, err)) return false;
    bool ok = true;
    for (size_t i = 0; ok && i < STARTS; i++) {
        if (!walk_map_put(&tour->map, starts.frames[i].eye_m, &tour->walker)) continue;
        ok = walk_map_explore(&tour->map, &tour->walker, err);
        if (!ok || tour->map.count <= most) continue;
        most = tour->map.count;
        best = tour->walker;
    }
    camera_path_free(&starts);
    if (ok && !most) return error_set(err, "%s: there is no ground in its free space; --from X,Y,Z says where", name);
    tour->walker = best;
    return ok && walk_map_explore(&tour->map, &best, err);
}

static void prepare(struct touring *tour)
{
    const size_t count = tour->map.count;
    tour->seen = grow_zeroed(count, sizeof *tour->seen);
    tour->ever = grow_zeroed(count, sizeof *tour->ever);
    tour->bad = grow_zeroed(count, sizeof *tour->bad);
    tour->before = grow_zeroed(count, sizeof *tour->before);
    tour->queue = grow_zeroed(count, sizeof *tour->queue);
    tour->route = grow_zeroed(count + 1, sizeof *tour->route);
}

static void end_tour(struct touring *tour)
{
    free(tour->seen);
    free(tour->ever);
    free(tour->bad);
    free(tour->before);
    free(tour->queue);
    free(tour->route);
    walk_map_free(&tour->map);
}

bool walk_path(const struct compiled *scene, const char *name, const struct walk_wish *wish, struct camera_path *out,
               struct walk_found *found, struct error *err)
{
    struct touring tour = {.wish = wish, .goal = WALK_NOWHERE};
    *found = (struct walk_found){0};
    bool ok = walk_map_init(&tour.map, scene, &wish->body, err) &&
              (wish->has_from ? begin_there(&tour, err) : begin_anywhere(&tour, name, err));
    if (ok) {
        prepare(&tour);
        found->places = tour.map.count;
        *out = (struct camera_path){
            .name = strdup(name), .frames = grow_zeroed(wish->frames, sizeof *out->frames), .count = wish->frames};
        ok = (out->name || error_set(err, "%s: out of memory", name)) && make_frames(&tour, out, found, err);
        if (!ok) camera_path_free(out);
    }
    end_tour(&tour);
    return ok;
}
