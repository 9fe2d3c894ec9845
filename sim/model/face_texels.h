/* SPDX-License-Identifier: MIT
 *
 * The texels of a picture that a face shows, each with how much of it: the area that the polygon of the face's
 * coordinates has in it. Pictures repeat. */
#ifndef SIM_FACE_TEXELS_H
#define SIM_FACE_TEXELS_H

#include "model/model.h"

/* `texel`: as in picture.pixels; `part`: 0..1 of a texel's area, or of its length where the coordinates are on a line
 * or a point. false: enough. */
typedef bool texel_visitor(uint32_t texel, double part, void *user);

enum face_texels_how {
    TEXELS_ALL,    /* each one of which the face shows more than the rounding of its coordinates explains */
    TEXELS_SAMPLED /* every third, fifth ... across and down, where there are more than 65,536 */
};

/* false: the coordinates make no sense, or TEXELS_ALL would be more than a million. */
bool face_texels_visit(const struct model *model, const struct model_face *face, const struct picture *picture,
                       enum face_texels_how how, texel_visitor *visitor, void *user);

#endif
