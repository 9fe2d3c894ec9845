/* SPDX-License-Identifier: MIT
 *
 * What is seen is crossed off: places within SEEN_M that a ray from the eye reaches. The nearest place that is left, by
 * the way there, is where it goes next; when none is left, all but what is in view is to be seen again. It turns as
 * buttons do, by steps of 1/128 of a turn, a few a frame, goes ahead where it looks, and heads for the farthest place
 * of its way that it can walk to straight. */
#include "cameras/walk_path.h"

#include "base/grow.h"
#include "base/progress.h"
#include "cameras/random_path.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double SEEN_M = 10.0, NEAR_M = 0.35, EYE_PART = 0.35;
enum { AHEAD = 8, STARTS = 12, LOOK_EVERY = 4, STUCK_FRAMES = 8 };
static const double FULL_TURN = 6.283185307179586476925, TURN_A_FRAME = 0.16;

struct touring {
    struct walk_map map;
    const struct walk_wish *wish;
    struct lim_walker walker;
    double heading; /* radians, as lim_camera's yaw */
    double eye_y_m; /* follows the walker's, so that steps are no jumps */
    bool *seen;
    bool *ever;
    int32_t *before;        /* of each place, the one on the way there */
    int32_t *queue, *route; /* the route's last place first */
    size_t left;            /* of the route */
    int32_t goal;           /* where it ends; whether it is seen there or not, it is done with then */
    int stuck;
};

static int32_t nearest_place(const struct touring *tour)
{
    int32_t nearest = 0;
    double least_m = INFINITY;
    for (size_t k = 0; k < tour->map.count; k++) {
        const struct lim_walker *at = &tour->map.places[k].walker;
        const double up = (double)at->at_q8[1] - tour->walker.at_q8[1];
        const double way_m =
            walk_map_way_m(&tour->map, &tour->walker, at) + 4 * fabs(up) / 256.0 / tour->map.scene->grid.units_per_m;
        if (way_m >= least_m) continue;
        least_m = way_m;
        nearest = (int32_t)k;
    }
    return nearest;
}

/* The way to the nearest place that was not seen; false: all were. */
static bool plan(struct touring *tour)
{
    size_t first = 0, last = 0;
    const int32_t start = nearest_place(tour);
    memset(tour->before, -1, tour->map.count * sizeof *tour->before);
    tour->before[start] = start;
    tour->queue[last++] = start;
    for (; first < last && tour->seen[tour->queue[first]]; first++)
        for (int way = 0; way < WALK_WAYS; way++) {
            const int32_t next = tour->map.places[tour->queue[first]].to[way];
            if (next == WALK_NOWHERE || tour->before[next] >= 0) continue;
            tour->before[next] = tour->queue[first];
            tour->queue[last++] = next;
        }
    tour->left = 0;
    if (first == last) return false;
    tour->goal = tour->queue[first];
    for (int32_t at = tour->goal; at != start; at = tour->before[at])
        tour->route[tour->left++] = at;
    return tour->left > 0;
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
    while (tour->left &&
           walk_map_way_m(&tour->map, &tour->walker, &tour->map.places[tour->route[tour->left - 1]].walker) < NEAR_M)
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

/* Ahead, less where it still has to turn; and back from an edge that it would fall off. */
static bool go_ahead(struct touring *tour, double left, struct error *err)
{
    const double stride_m = fabs(left) > FULL_TURN / 6 ? 0.0 : tour->wish->stride_m * cos(left);
    const double stride_q8 = stride_m * tour->map.scene->grid.units_per_m * 256.0;
    const struct lim_walker before = tour->walker;
    if (lim_walker_move(&tour->map.solid, &tour->walker, (int32_t)(-sin(tour->heading) * stride_q8),
                        (int32_t)(-cos(tour->heading) * stride_q8)))
        return error_set(err, "the walker left the range of coordinates");
    if (!tour->walker.stands) tour->walker = before;
    const bool is_stuck = stride_m > 0 && walk_map_way_m(&tour->map, &before, &tour->walker) < stride_m / 4;
    tour->stuck = is_stuck ? tour->stuck + 1 : 0;
    return true;
}

static void next_route(struct touring *tour)
{
    if (plan(tour)) return;
    memset(tour->seen, 0, tour->map.count * sizeof *tour->seen); /* once more round */
    look_around(tour);
    plan(tour);
}

static bool press_buttons(struct touring *tour, struct error *err)
{
    const struct lim_walker *to = aim(tour);
    if (!to || tour->stuck > STUCK_FRAMES) {
        if (tour->goal != WALK_NOWHERE) tour->seen[tour->goal] = tour->ever[tour->goal] = true;
        tour->stuck = 0;
        next_route(tour);
        to = aim(tour);
    }
    const double turn = to ? turn_to(tour, to) : 0.0;
    const double now = fmax(-TURN_A_FRAME, fmin(TURN_A_FRAME, turn));
    tour->heading += now;
    return !to || go_ahead(tour, turn - now, err);
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
    tour->before = grow_zeroed(count, sizeof *tour->before);
    tour->queue = grow_zeroed(count, sizeof *tour->queue);
    tour->route = grow_zeroed(count, sizeof *tour->route);
}

static void end_tour(struct touring *tour)
{
    free(tour->seen);
    free(tour->ever);
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
