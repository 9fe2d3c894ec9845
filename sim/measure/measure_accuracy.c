/* SPDX-License-Identifier: MIT
 *
 * Frame by frame: the reference draws once, then every renderer; pixels, vertices and sides of planes
 * are compared while both pictures are at hand. */
#include "measure/measurement.h"

#include "accuracy/measure_texels.h"
#include "accuracy/moving_reference.h"
#include "base/deadline.h"
#include "base/progress.h"
#include "base/vec3.h"
#include "core/core.h"
#include "render/ids.h"
#include "scene/mem_parts.h"
#include "scene/moving.h"
#include "scene/plane.h"
#include "scene/records.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A renderer at work. */
struct measured {
    const struct measure_candidate *candidate;
    struct ids ids;
    size_t *record_words;        /* where each polygon's record begins */
    bool *is_done;               /* of each vertex, in this frame */
    struct simulator painted;    /* if the scene has textures: what ids shows without them */
    struct painted_texels coded; /* likewise, textures that say where their texels are */
    struct texel_errors texels;
};

static bool measured_init(struct measured *measured, const struct measure_candidate *candidate,
                          const struct measure_views *views, struct error *err)
{
    const struct lim_scene *scene = &candidate->scene->scene;
    const struct simulator_setup setup = {views->w_px, views->h_px, candidate->scene->report.draws,
                                          measure_panel(candidate->scene), candidate->core};
    measured->candidate = candidate;
    if (!ids_init(&measured->ids, candidate->scene, &setup, err)) return false;
    if (candidate->scene->moving && !ids_set_movers(&measured->ids, candidate->scene->moving, err)) return false;
    if (scene->texture_count && (!simulator_init(&measured->painted, scene, &setup, err) ||
                                 !painted_texels_init(&measured->coded, candidate->scene, &setup, err)))
        return false;
    measured->record_words = calloc(scene->polygon_count, sizeof *measured->record_words);
    measured->is_done = calloc(scene->vertex_count, sizeof *measured->is_done);
    if (!measured->record_words || !measured->is_done) return error_set(err, "accuracy: out of memory");
    for (size_t p = 1; p < scene->polygon_count; p++) {
        const size_t before = measured->record_words[p - 1];
        measured->record_words[p] = before + record_at(scene, before).words;
    }
    return true;
}

static void measured_free(struct measured *measured)
{
    ids_free(&measured->ids);
    simulator_free(&measured->painted);
    painted_texels_free(&measured->coded);
    texel_errors_free(&measured->texels);
    free(measured->record_words);
    free(measured->is_done);
}

/* Vertices ----------------------------------------------------------------------------------- */

/* In pixels, the centre of the first one at 0, as the renderer counts. */
static void project_source(const struct reference_view *view, const double point_m[3], double at_px[2])
{
    double from_eye[3];
    vec3_sub(from_eye, point_m, view->eye_m);
    const double depth_m = vec3_dot(from_eye, view->forward);
    /* right and up have the length of the picture's half-sides at distance 1. */
    const double u = vec3_dot(from_eye, view->right) / vec3_dot(view->right, view->right) / depth_m;
    const double v = vec3_dot(from_eye, view->up) / vec3_dot(view->up, view->up) / depth_m;
    at_px[0] = (u + 1.0) / 2.0 * view->w_px - 0.5;
    at_px[1] = (1.0 - v) / 2.0 * view->h_px - 0.5;
}

static void measure_vertex(struct measured *measured, const struct measure_source *source, lim_index vertex,
                           struct accuracy *out)
{
    const struct measure_candidate *candidate = measured->candidate;
    double point_m[3], drawn_px[2], true_px[2];
    if (!candidate->core->project(measured->ids.simulator.lim, vertex, drawn_px)) return;
    if (!measure_source_point(source, &candidate->scene->scene, vertex, point_m)) {
        out->vertices_without_source++;
        return;
    }
    project_source(&source->reference.view, point_m, true_px);
    const double error_px = hypot(drawn_px[0] - true_px[0], drawn_px[1] - true_px[1]);
    out->vertices++;
    out->vertex_sum2_px += error_px * error_px;
    out->vertex_max_px = fmax(out->vertex_max_px, error_px);
}

static void measure_polygon(struct measured *measured, const struct measure_source *source, size_t polygon,
                            struct accuracy *out)
{
    const struct record record = record_at(&measured->candidate->scene->scene, measured->record_words[polygon]);
    for (size_t k = 0; k < record.count; k++) {
        if (measured->is_done[record.corners[k]]) continue;
        measured->is_done[record.corners[k]] = true;
        measure_vertex(measured, source, record.corners[k], out);
    }
}

/* The pixels of the last frame are the numbers of polygons, from 1. */
static void measure_vertices(struct measured *measured, const struct measure_source *source, struct accuracy *out)
{
    const struct simulator *simulator = &measured->ids.simulator;
    const size_t pixel_count = simulator_pixel_count(simulator);
    memset(measured->is_done, 0, measured->candidate->scene->scene.vertex_count * sizeof *measured->is_done);
    for (size_t i = 0, before = 0; i < pixel_count; i++) {
        const size_t number = measured->ids.numbers[i];
        const bool moves = number > measured->candidate->scene->scene.polygon_count; /* its vertices are elsewhere */
        if (number && number != before && !moves) measure_polygon(measured, source, number - 1, out);
        before = number;
    }
}

/* Planes ------------------------------------------------------------------------------------- */

__extension__ typedef __int128 wide;

static int true_side(const struct lim_scene *scene, const struct lim_plane_ref *ref, const struct lim_camera *camera)
{
    int64_t n[3], d;
    plane_exact(scene, ref, n, &d);
    wide value = -(wide)d * 256;
    for (int i = 0; i < 3; i++)
        value += (wide)n[i] * (camera->origin[i] * INT64_C(256) + camera->eye_q8[i]);
    return (value > 0) - (value < 0);
}

static void measure_side(const struct measure_candidate *candidate, const struct lim_plane_ref *ref,
                         const struct lim_camera *camera, struct accuracy *out)
{
    const struct lim_scene *scene = &candidate->scene->scene;
    out->sides++;
    out->sides_wrong += candidate->core->eye_side(scene, ref, camera) != true_side(scene, ref, camera);
}

static void measure_leaf_sides(const struct measure_candidate *candidate, const lim_index *record,
                               const struct lim_camera *camera, struct accuracy *out)
{
    for (;; record += lim_record_words(*record)) {
        measure_side(candidate, lim_record_plane(record), camera, out);
        if (*record & LIM_POLYGON_LAST) return;
    }
}

static void measure_sides(const struct measure_candidate *candidate, const struct lim_camera *camera,
                          struct accuracy *out)
{
    const struct lim_scene *scene = &candidate->scene->scene;
    for (lim_index i = 0; i < scene->node_count; i++) {
        const struct lim_node *node = &scene->nodes[i];
        if (node->split.plane == LIM_NO_INDEX && lim_is_mesh_leaf(&scene->polygons[node->front_run])) continue;
        if (node->split.plane == LIM_NO_INDEX)
            measure_leaf_sides(candidate, &scene->polygons[node->front_run], camera, out);
        else
            measure_side(candidate, &node->split, camera, out);
    }
}

/* Texels ------------------------------------------------------------------------------------- */

static bool measure_texels(struct measured *measured, const struct measure_source *source,
                           const struct lim_camera *camera, struct error *err)
{
    const struct compiled *scene = measured->candidate->scene;
    const struct texel_frame frame = {measured->candidate->core,
                                      scene,
                                      &measured->ids,
                                      &measured->painted,
                                      &measured->coded,
                                      &source->reference,
                                      source->fine.mapping_count ? &source->fine : &source->mesh,
                                      source->mesh.merged_into,
                                      measured->record_words};
    if (!scene->scene.texture_count) return true;
    return simulator_frame(&measured->painted, camera, err) && painted_texels_frame(&measured->coded, camera, err) &&
           texel_errors_add(&measured->texels, &frame, err);
}

static void sum_up_texels(const struct texel_errors *errors, size_t frames, struct accuracy *out)
{
    if (!errors->painted) return;
    out->texels_painted = errors->painted;
    out->texel_rms = texel_errors_rms(errors);
    out->texel_far_percent = 100.0 * (double)errors->far / (double)errors->painted;
    out->texel_level_percent = 100.0 * (double)errors->other_level / (double)errors->painted;
    out->texel_straight_percent = errors->sum2 > 0 ? 100.0 * errors->straight_sum2 / errors->sum2 : NAN;
    out->divisions = (double)errors->divisions / (double)frames;
    if (!errors->pixels) return;
    out->texel_pixels = errors->pixels;
    out->texel_mean = texel_errors_mean(errors);
    out->texel_p99 = texel_errors_p99(errors);
    out->texel_mean_finest = errors->sum_finest / (double)errors->pixels;
}

/* Frames ------------------------------------------------------------------------------------- */

static bool measure_frame(struct measured *measured, const struct measure_source *source,
                          const struct measure_views *views, size_t frame, struct accuracy *out, struct error *err)
{
    const struct compiled *scene = measured->candidate->scene;
    struct lim_camera camera;
    if (scene->moving)
        moving_pose(scene->moving, camera_path_time_s(views->path, frame, moving_length_s(scene->moving)));
    if (!camera_path_to_camera(views->path, frame, views->lens, &scene->grid, &camera, err) ||
        !ids_frame(&measured->ids, &camera, err))
        return false;
    const struct compare_counts counts = compare_picture(measured->ids.faces, &source->reference,
                                                         source->mesh.merged_into, 1.0 / scene->grid.units_per_m);
    comparison_add(&out->pixels, &counts);
    out->splits += simulator_stats(&measured->ids.simulator)->newell.splits;
    unsettled_add(&out->unsettled, &simulator_stats(&measured->ids.simulator)->newell);
    measure_vertices(measured, source, out);
    measure_sides(measured->candidate, &camera, out);
    return measure_texels(measured, source, &camera, err);
}

/* With all renderers, or from the second frame on those that there is time for. */
static bool measure_all(struct measured *measured, size_t count, struct measure_source *source,
                        const struct measure_views *views, size_t frame, struct accuracy *out, struct error *err)
{
    struct moving *moving = source->still.moving;
    if (moving)
        moving_pose_reference(moving, &source->reference,
                              camera_path_time_s(views->path, frame, moving_length_s(moving)));
    reference_draw(&source->reference, &views->path->frames[frame], views->lens);
    for (size_t i = 0; i < count && !(frame && deadline_passed()); i++)
        if (!measure_frame(&measured[i], source, views, frame, &out[i], err)) return false;
    return true;
}

/* `before`: room for what was known before the last frame. */
static bool measure_frames(struct measured *measured, size_t count, struct measure_source *source,
                           const struct measure_views *views, struct accuracy *before, struct accuracy *out,
                           struct error *err)
{
    for (size_t frame = 0; frame < views->path->count && !(frame && deadline_passed()); frame++) {
        progress_bar(frame, views->path->count, "accuracy, frame %zu of %zu", frame + 1, views->path->count);
        memcpy(before, out, count * sizeof *out);
        if (!measure_all(measured, count, source, views, frame, out, err)) return false;
        if (out[count - 1].pixels.frames > frame) continue;
        memcpy(out, before, count * sizeof *out); /* all of the same frames */
        break;
    }
    if (out->pixels.frames < views->path->count)
        deadline_say("accuracy of %zu of %zu frames", out->pixels.frames, views->path->count);
    return true;
}

bool measure_accuracy(struct measure_source *source, const struct measure_views *views,
                      const struct measure_candidate *candidates, size_t count, struct accuracy *out, struct error *err)
{
    struct measured *measured = calloc(count, sizeof *measured);
    struct accuracy *before = calloc(count, sizeof *before);
    bool ok = (measured && before) || error_set(err, "accuracy: out of memory");
    memset(out, 0, count * sizeof *out);
    for (size_t i = 0; ok && i < count; i++)
        ok = measured_init(&measured[i], &candidates[i], views, err);
    ok = ok && measure_frames(measured, count, source, views, before, out, err);
    for (size_t i = 0; ok && i < count; i++) {
        out[i].textures_b = texture_memory_b(&candidates[i].scene->scene);
        sum_up_texels(&measured[i].texels, out[i].pixels.frames, &out[i]);
    }
    for (size_t i = 0; measured && i < count; i++)
        measured_free(&measured[i]);
    free(before);
    free(measured);
    return ok;
}

double accuracy_vertex_rms_px(const struct accuracy *accuracy)
{
    return accuracy->vertices ? sqrt(accuracy->vertex_sum2_px / (double)accuracy->vertices) : 0.0;
}
