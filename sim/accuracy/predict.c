/* SPDX-License-Identifier: MIT
 *
 * The same samplers as for random cameras, the same comparison as --compare. */
#include "accuracy/predict.h"

#include "accuracy/compare.h"
#include "accuracy/moving_reference.h"
#include "base/deadline.h"
#include "base/grow.h"
#include "base/progress.h"
#include "cameras/grazing.h"
#include "cameras/sample.h"
#include "render/ids.h"
#include "scene/moving.h"

#include <math.h>
#include <stdlib.h>

static const double SHARE = 0.5; /* of the time that is left */
enum { HELD_OUT_SEED = 77 };

/* Grazing views come last: their figure is their own, that of all cameras is of the kinds before them. */
enum view_kind { VIEW_ANYWHERE, VIEW_NEAR, VIEW_PORTRAIT, VIEW_GRAZING, VIEW_KINDS };

/* A scene, and what it shows wrong. */
struct candidate {
    struct ids ids;
    struct comparison sums[VIEW_KINDS];
    uint32_t *wrong_of_face; /* NULL: nobody asks */
};

struct predicting {
    const struct compiled *scene; /* the first one, whose free space is looked from */
    struct candidate candidates[PREDICT_SCENES_MAX];
    size_t count;
    struct reference *reference;
    const uint32_t *groups;
    uint32_t seed; /* 0: those that the compiler tunes on */
    struct lens lens;
    size_t done, all; /* cameras */
};

/* Frame by frame through all of the animation. */
static double pose_movers(struct predicting *predicting)
{
    struct moving *moving = predicting->scene->moving;
    if (!moving) return 0.0;
    const double time_s = moving_time_s(moving, predicting->done % PREDICT_CAMERAS, PREDICT_CAMERAS);
    moving_pose(moving, time_s);
    moving_pose_reference(moving, predicting->reference, time_s);
    return time_s;
}

/* false: there is none any more. */
static bool next_view(struct sampler *sampler, enum view_kind kind, struct viewpoint *out)
{
    switch (kind) {
    case VIEW_NEAR:
        return sampler_near(sampler, out);
    case VIEW_PORTRAIT:
        return sampler_portrait(sampler, out);
    case VIEW_GRAZING:
        return sampler_grazing(sampler, out);
    default:
        return sampler_anywhere(sampler, out);
    }
}

static bool compare_view(struct predicting *predicting, enum view_kind kind, const struct viewpoint *viewpoint,
                         const struct lim_camera *camera, struct error *err)
{
    reference_draw(predicting->reference, viewpoint, &predicting->lens);
    for (size_t i = 0; i < predicting->count; i++) {
        struct candidate *candidate = &predicting->candidates[i];
        if (!ids_frame(&candidate->ids, camera, err)) return false;
        const struct compare_counts counts =
            compare_wrong(candidate->ids.faces, predicting->reference, predicting->groups);
        comparison_add(&candidate->sums[kind], &counts);
        if (candidate->wrong_of_face && kind != VIEW_GRAZING)
            compare_count_faces(candidate->ids.faces, predicting->reference, predicting->groups,
                                candidate->wrong_of_face);
    }
    return true;
}

static bool compare_views(struct predicting *predicting, enum view_kind kind, int count, struct error *err)
{
    struct sampler sampler;
    sampler_init(&sampler, predicting->scene);
    if (predicting->seed) sampler_seed(&sampler, predicting->seed);
    sampler.near_m = predicting->lens.near_m;
    for (int i = 0; i < count && !deadline_passed(); i++) {
        struct viewpoint viewpoint;
        struct lim_camera camera;
        const struct camera_path path = {"sampled cameras", &viewpoint, 1};
        progress_bar(predicting->done++, predicting->all, "comparing with the reference");
        sampler.time_s = pose_movers(predicting);
        if (!next_view(&sampler, kind, &viewpoint)) {
            if (kind == VIEW_PORTRAIT) continue; /* another way may be free */
            return true;
        }
        if (!camera_path_to_camera(&path, 0, &predicting->lens, &predicting->scene->grid, &camera, err)) continue;
        if (!compare_view(predicting, kind, &viewpoint, &camera, err)) return false;
    }
    return true;
}

static struct predicted predicted_of(const struct candidate *candidate)
{
    const struct comparison *sums = candidate->sums;
    struct compare_counts all = {0};
    struct predicted out = {.near_percent = compare_wrong_percent(&sums[VIEW_NEAR].total),
                            .near_cameras = sums[VIEW_NEAR].frames,
                            .portrait_percent = compare_wrong_percent(&sums[VIEW_PORTRAIT].total),
                            .portrait_cameras = sums[VIEW_PORTRAIT].frames,
                            .grazing_percent = compare_wrong_percent(&sums[VIEW_GRAZING].total),
                            .grazing_cameras = sums[VIEW_GRAZING].frames};
    for (int kind = 0; kind < VIEW_GRAZING; kind++) {
        all.pixels += sums[kind].total.pixels;
        all.wrong += sums[kind].total.wrong;
        out.cameras += sums[kind].frames;
    }
    out.percent = deadline_passed() ? NAN : compare_wrong_percent(&all);
    return out;
}

static bool begin(struct predicting *predicting, const struct compiled *const *scenes, size_t count,
                  const struct core *core, struct error *err)
{
    const struct compiled *first = scenes[0];
    if (!lens_for_grid(&predicting->lens, 60, first->report.near_m, &first->grid, PREDICT_SIDE_PX, PREDICT_SIDE_PX,
                       err))
        return false;
    for (; predicting->count < count; predicting->count++) {
        const struct compiled *scene = scenes[predicting->count];
        const struct simulator_setup setup = {PREDICT_SIDE_PX, PREDICT_SIDE_PX, scene->report.draws, SIMULATOR_MEMORY,
                                              core};
        struct ids *ids = &predicting->candidates[predicting->count].ids;
        if (!ids_init(ids, scene, &setup, err)) return false;
        if (scene->moving && !ids_set_movers(ids, scene->moving, err)) {
            ids_free(ids);
            return false;
        }
    }
    return true;
}

static bool predict(struct predicting *predicting, const struct compiled *const *scenes, size_t count,
                    const int counts[VIEW_KINDS], const struct core *core, struct predicted *out, struct error *err)
{
    predicting->scene = scenes[0];
    bool ok = begin(predicting, scenes, count, core, err);
    for (int kind = 0; kind < VIEW_KINDS; kind++)
        predicting->all += (size_t)counts[kind];
    for (int kind = 0; ok && kind < VIEW_KINDS; kind++)
        ok = compare_views(predicting, (enum view_kind)kind, counts[kind], err);
    for (size_t i = 0; ok && i < count; i++)
        out[i] = predicted_of(&predicting->candidates[i]);
    for (size_t i = 0; i < predicting->count; i++)
        ids_free(&predicting->candidates[i].ids);
    return ok;
}

/* A wrong pixel counts for the face that it shows and for the one that it should. */
static void find_worst_face(const uint32_t *wrong_of_face, size_t face_count, size_t wrong, struct predicted *out)
{
    for (size_t i = 1; i <= face_count; i++)
        if (wrong_of_face[i] && (!out->worst_face || wrong_of_face[i] > wrong_of_face[out->worst_face]))
            out->worst_face = (uint32_t)i;
    if (out->worst_face) out->worst_face_percent = 100.0 * wrong_of_face[out->worst_face] / (double)wrong;
}

static size_t wrong_in_all(const struct candidate *candidate)
{
    size_t wrong = 0;
    for (int kind = 0; kind < VIEW_GRAZING; kind++)
        wrong += candidate->sums[kind].total.wrong;
    return wrong;
}

bool predict_wrong(const struct compiled *scene, const struct core *core, struct reference *reference,
                   const uint32_t *groups, size_t face_count, struct predicted *out, struct error *err)
{
    struct predicting predicting = {.reference = reference, .groups = groups};
    uint32_t *wrong_of_face = grow_zeroed(face_count + 1, sizeof *wrong_of_face);
    const int near_count = scene->original ? PREDICT_CAMERAS / 2 : 0;
    const int counts[VIEW_KINDS] = {PREDICT_CAMERAS - near_count, near_count, 0, scene->original ? PREDICT_GRAZING : 0};
    const struct deadline_end whole = deadline_share(SHARE);
    predicting.candidates[0].wrong_of_face = wrong_of_face;
    const bool ok = predict(&predicting, &scene, 1, counts, core, out, err);
    if (ok) find_worst_face(wrong_of_face, face_count, wrong_in_all(&predicting.candidates[0]), out);
    deadline_say("a report without predicted wrong pixels");
    deadline_restore(whole);
    free(wrong_of_face);
    return ok;
}

bool predict_held_out(const struct compiled *const *scenes, size_t count, const struct core *core,
                      struct reference *reference, const uint32_t *groups, struct predicted *out, struct error *err)
{
    return predict_held_out_faces(scenes, count, core, reference, groups, out, NULL, err);
}

bool predict_held_out_faces(const struct compiled *const *scenes, size_t count, const struct core *core,
                            struct reference *reference, const uint32_t *groups, struct predicted *out,
                            uint32_t *const *wrong_of_face, struct error *err)
{
    struct predicting predicting = {.reference = reference, .groups = groups, .seed = HELD_OUT_SEED};
    for (size_t i = 0; wrong_of_face && i < count; i++)
        predicting.candidates[i].wrong_of_face = wrong_of_face[i];
    const int near_count = scenes[0]->original ? PREDICT_CAMERAS / 2 : 0;
    const int counts[VIEW_KINDS] = {PREDICT_CAMERAS - near_count, near_count, PREDICT_CAMERAS / 2, 0};
    return predict(&predicting, scenes, count, counts, core, out, err);
}
