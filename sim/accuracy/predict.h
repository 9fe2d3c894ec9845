/* SPDX-License-Identifier: MIT
 *
 * The share of wrong pixels to expect of a scene, found by trying: sampled cameras, drawn by the
 * renderer and by the reference. */
#ifndef SIM_PREDICT_H
#define SIM_PREDICT_H

#include "accuracy/reference.h"
#include "core/core.h"
#include "scene/compiled.h"

/* Half of the cameras look anywhere, half at faces of all sizes, from as near as these are small. */
enum { PREDICT_SIDE_PX = 240, PREDICT_CAMERAS = 48, PREDICT_GRAZING = 48, PREDICT_SCENES_MAX = 4 };

/* `reference` holds the source polygons for pictures of PREDICT_SIDE_PX; `groups` as in compare.h. A scene that does
 * not know its original has all cameras anywhere. What moves in it (scene->moving) is elsewhere in each frame, and half
 * of the latter cameras look at it. Where there is no free space for one kind of camera, there are fewer.
 * PREDICT_GRAZING more look along faces (cameras/grazing.h): out->grazing_percent is of these alone. face_count: of the
 * model's file.
 */
bool predict_wrong(const struct compiled *scene, const struct core *core, struct reference *reference,
                   const uint32_t *groups, size_t face_count, struct predicted *out, struct error *err);

/* The same for several scenes of one model, up to PREDICT_SCENES_MAX, on the same cameras each, which nothing was tuned
 * on; half as many again are portraits. The first scene says where free space is. Out of time: .percent is NaN. */
bool predict_held_out(const struct compiled *const *scenes, size_t count, const struct core *core,
                      struct reference *reference, const uint32_t *groups, struct predicted *out, struct error *err);

/* The same, and of which faces pixels are wrong: adds to wrong_of_face[i] of scene i as compare_count_faces() does. */
bool predict_held_out_faces(const struct compiled *const *scenes, size_t count, const struct core *core,
                            struct reference *reference, const uint32_t *groups, struct predicted *out,
                            uint32_t *const *wrong_of_face, struct error *err);

#endif
