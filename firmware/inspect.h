/* SPDX-License-Identifier: MIT
 *
 * What measurements ask of the stages: where a vertex comes to lie, on which side of a plane an eye is, which texels a
 * polygon shows, each as frames have it. No firmware needs it; what nobody calls is not linked. */
#ifndef LIM_INSPECT_H
#define LIM_INSPECT_H

#include "scene.h"
#include "stages.h"

LIM_C_BEGIN

struct lim;

/* Where the camera of the last frame puts a vertex of the scene. false: that is left to clipping. */
/* lim_nearest_count_as(), of the methods that draw nearest first or by scan lines. */
void lim_inspect_count_as(struct lim *lim, const struct lim_counted *counted, size_t counted_b);

bool lim_inspect_vertex(struct lim *lim, lim_index vertex, struct lim_point *at);

/* The side of a plane that a camera's eye is on, as WALK decides it: 1 in front, -1 behind, 0 on it. */
int8_t lim_inspect_side(const struct lim_scene *scene, const struct lim_plane_ref *ref,
                        const struct lim_camera *camera);

/* The texel that a pixel shows. */
struct lim_inspected_texel {
    uint32_t place; /* u in the upper half, v in the lower one, either in 2^-16 of the texture's side */
    uint16_t x_px, y_px;
    uint8_t level; /* of detail */
    bool divided;  /* by the perspective's division, not from between two pixels that are */
};
typedef void lim_inspect_texel(void *ctx, const struct lim_inspected_texel *texel); /* program's */

/* Gives `take` each pixel of the screen that a polygon record may cover, with the texel that the last frame's camera
 * would show there, whatever hides it. None without a texture. There if LIM_HAS_TEXTURE. */
void lim_inspect_texels(struct lim *lim, lim_index record, lim_inspect_texel *take, void *ctx);

LIM_C_END

#endif
