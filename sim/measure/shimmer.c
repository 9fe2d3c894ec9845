/* SPDX-License-Identifier: MIT
 *
 * The last frames are kept in a ring; whatever changed in the oldest but one has all its following frames then. */
#include "measure/shimmer.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "base/vec3.h"
#include "scene/moving.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void shimmer_add(struct shimmer_count *sum, const uint16_t *const pictures[SHIMMER_SPAN], size_t pixel_count)
{
    for (size_t i = 0; i < pixel_count; i++) {
        const uint16_t before = pictures[0][i];
        bool is_back = false;
        if (pictures[1][i] == before) continue;
        for (int k = 2; k < SHIMMER_SPAN; k++)
            is_back |= pictures[k][i] == before;
        sum->changed++;
        sum->back += is_back;
    }
}

double shimmer_percent(const struct shimmer_count *count)
{
    return count->changed ? 100.0 * (double)count->back / (double)count->changed : 0.0;
}

/* Cameras ------------------------------------------------------------------------------------- */

/* About the vertical through the eye, y up. */
static struct viewpoint turned(const struct viewpoint *from, size_t step)
{
    const double angle_rad = (double)step * SHIMMER_TURN_DEG / 180.0 * acos(-1.0);
    const double x_m = from->target_m[0] - from->eye_m[0], z_m = from->target_m[2] - from->eye_m[2];
    struct viewpoint to = *from;
    to.target_m[0] = from->eye_m[0] + x_m * cos(angle_rad) + z_m * sin(angle_rad);
    to.target_m[2] = from->eye_m[2] - x_m * sin(angle_rad) + z_m * cos(angle_rad);
    return to;
}

static struct viewpoint walked(const struct viewpoint *from, size_t step)
{
    double ahead[3];
    struct viewpoint to = *from;
    vec3_sub(ahead, from->target_m, from->eye_m);
    const double length_m = sqrt(vec3_dot(ahead, ahead));
    for (int i = 0; i < 3; i++) {
        const double by_m = ahead[i] / length_m * (double)step * SHIMMER_WALK_M;
        to.eye_m[i] += by_m;
        to.target_m[i] += by_m;
    }
    return to;
}

/* Frames -------------------------------------------------------------------------------------- */

struct shimmering {
    const struct measure_candidate *candidate;
    const struct measure_views *views;
    struct simulator simulator;
    uint16_t *ring[SHIMMER_SPAN];
};

static bool shimmering_begin(struct shimmering *work, struct error *err)
{
    const struct compiled *scene = work->candidate->scene;
    const struct simulator_setup setup = {work->views->w_px, work->views->h_px, scene->report.draws,
                                          measure_panel(scene), work->candidate->core};
    struct moving *moving = scene->moving;
    if (!simulator_init(&work->simulator, &scene->scene, &setup, err)) return false;
    for (int i = 0; i < SHIMMER_SPAN; i++)
        work->ring[i] = grow_zeroed(simulator_pixel_count(&work->simulator), sizeof *work->ring[i]);
    if (!moving) return true;
    moving_pose(moving, 0.0);
    return simulator_set_movers(&work->simulator, moving->instances, moving->count, &moving->limits, err);
}

static void shimmering_end(struct shimmering *work)
{
    simulator_free(&work->simulator);
    for (int i = 0; i < SHIMMER_SPAN; i++)
        free(work->ring[i]);
}

static bool draw(struct shimmering *work, const struct viewpoint *at, uint16_t *pixels, struct error *err)
{
    struct viewpoint one = *at;
    const struct camera_path path = {"shimmer", &one, 1};
    struct lim_camera camera;
    if (!camera_path_to_camera(&path, 0, work->views->lens, &work->candidate->scene->grid, &camera, err) ||
        !simulator_frame(&work->simulator, &camera, err))
        return false;
    memcpy(pixels, work->simulator.pixels, simulator_pixel_count(&work->simulator) * sizeof *pixels);
    return true;
}

/* From one view on. */
static bool go(struct shimmering *work, const struct viewpoint *from,
               struct viewpoint (*move)(const struct viewpoint *from, size_t step), struct shimmer_count *sum,
               struct error *err)
{
    for (size_t step = 0; step <= SHIMMER_STEPS; step++) {
        const struct viewpoint at = move(from, step);
        const uint16_t *pictures[SHIMMER_SPAN];
        if (!draw(work, &at, work->ring[step % SHIMMER_SPAN], err)) return false;
        if (step + 1 < SHIMMER_SPAN) continue;
        for (size_t k = 0; k < SHIMMER_SPAN; k++)
            pictures[k] = work->ring[(step + 1 + k) % SHIMMER_SPAN];
        shimmer_add(sum, pictures, simulator_pixel_count(&work->simulator));
    }
    return true;
}

static bool go_from_all(struct shimmering *work, struct shimmer *out, struct error *err)
{
    const struct camera_path *path = work->views->path;
    const size_t starts = path->count < SHIMMER_STARTS ? path->count : SHIMMER_STARTS;
    for (size_t i = 0; i < starts && !deadline_passed(); i++) {
        const struct viewpoint *from = &path->frames[i * path->count / starts];
        if (!go(work, from, turned, &out->turn, err) || !go(work, from, walked, &out->walk, err)) return false;
    }
    return true;
}

bool shimmer_measure(const struct measure_candidate *candidate, const struct measure_views *views, struct shimmer *out,
                     struct error *err)
{
    struct shimmering work = {.candidate = candidate, .views = views};
    *out = (struct shimmer){0};
    const bool ok = shimmering_begin(&work, err) && go_from_all(&work, out, err);
    shimmering_end(&work);
    out->known = !deadline_passed();
    return ok;
}
