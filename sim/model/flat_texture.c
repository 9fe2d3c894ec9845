/* SPDX-License-Identifier: MIT
 *
 * What a face shows lies in the box round its corners' coordinates: where all texels of that box are equal, so are all
 * pixels of the face. */
#include "model/flat_texture.h"

#include "base/rgb888.h"

#include <math.h>

enum { MOST_TEXELS = 1 << 16 }; /* of a box: a larger one counts as no palette's colour */
enum { INVISIBLE = 255 };
static const double FARTHEST = 1e6; /* pictures from the origin */

struct texel_box {
    double least[2], most[2]; /* texels, before they repeat; a corner between two of them adds none */
};

static bool box_of_face(const struct model *model, const struct model_face *face, const struct picture *picture,
                        struct texel_box *box)
{
    const double size_px[2] = {picture->w_px, picture->h_px};
    *box = (struct texel_box){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (uint32_t k = 0; k < face->count; k++)
        for (int i = 0; i < 2; i++) {
            const double at = model->uvs[model->corners[face->first + k]][i];
            if (!(fabs(at) < FARTHEST)) return false;
            box->least[i] = fmin(box->least[i], at * size_px[i]);
            box->most[i] = fmax(box->most[i], at * size_px[i]);
        }
    for (int i = 0; i < 2; i++) {
        box->least[i] = floor(box->least[i]);
        box->most[i] = fmax(box->least[i], ceil(box->most[i]) - 1);
    }
    return (box->most[0] - box->least[0] + 1) * (box->most[1] - box->least[1] + 1) <= MOST_TEXELS;
}

static uint32_t texel_at(const struct picture *picture, double x, double y)
{
    const double w_px = picture->w_px, h_px = picture->h_px;
    const size_t column = (size_t)(x - w_px * floor(x / w_px)), row = (size_t)(y - h_px * floor(y / h_px));
    return picture->pixels[row * picture->w_px + column];
}

static bool is_one_colour(const struct picture *picture, const struct texel_box *box, uint32_t *colour)
{
    *colour = texel_at(picture, box->least[0], box->least[1]);
    for (double y = box->least[1]; y <= box->most[1]; y++)
        for (double x = box->least[0]; x <= box->most[0]; x++)
            if (texel_at(picture, x, y) != *colour) return false;
    return true;
}

size_t flat_texture_find(struct model *model)
{
    size_t count = 0;
    for (size_t i = 0; i < model->face_count && model->uvs; i++) {
        struct model_face *face = &model->faces[i];
        struct picture *picture = face->picture ? &model->pictures[face->picture - 1] : NULL;
        struct texel_box box;
        uint32_t colour;
        if (!picture || !picture->pixels || picture->sky.times || !box_of_face(model, face, picture, &box)) continue;
        if (!is_one_colour(picture, &box, &colour)) continue;
        face->colour = rgb888_times(colour, face->colour);
        if (picture->is_masked) face->transparency = colour & PICTURE_CLEAR ? INVISIBLE : 0;
        face->picture = 0;
        picture->faces--;
        count++;
    }
    return count;
}
