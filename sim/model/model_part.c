/* SPDX-License-Identifier: MIT
 *
 * Points are copied for each part as far as its faces use them. */
#include "model/model_part.h"

#include "base/grow.h"
#include "model/mesh.h"
#include "model/mipmap.h"
#include "model/pose.h"

#include <stdlib.h>
#include <string.h>

static void count_part(const struct model *model, size_t mover, struct model *part)
{
    *part = (struct model){0};
    for (size_t i = 0; i < model->face_count; i++) {
        if (model->faces[i].mover != mover) continue;
        part->face_count++;
        part->corner_count += model->faces[i].count;
    }
    part->faces = grow_zeroed(part->face_count, sizeof *part->faces);
    part->corners = grow_zeroed(part->corner_count, sizeof *part->corners);
    part->points = grow_zeroed(part->corner_count, sizeof *part->points);
    if (model->source_points) part->source_points = grow_zeroed(part->corner_count, sizeof *part->source_points);
}

static void copy_pictures(const struct model *model, struct model *part)
{
    part->texture_bits = mesh_texture_bits(model);
    part->picture_count = model->picture_count;
    part->pictures = grow_zeroed(model->picture_count, sizeof *part->pictures);
    for (size_t i = 0; i < model->picture_count; i++) {
        const struct picture *from = &model->pictures[i];
        const size_t count = (size_t)from->w_px * from->h_px;
        struct picture *to = &part->pictures[i];
        *to = *from;
        to->alpha = NULL;
        if (!from->pixels) continue;
        to->faces = 0;
        to->pixels = grow_zeroed(count, sizeof *to->pixels);
        memcpy(to->pixels, from->pixels, count * sizeof *to->pixels);
    }
    if (model->uvs) part->uvs = grow_zeroed(part->corner_count, sizeof *part->uvs);
}

/* The mean of what is not clear of a picture, times the face's own colour. */
static uint32_t flat_colour(const struct picture *picture, uint32_t colour)
{
    const size_t count = (size_t)picture->w_px * picture->h_px;
    size_t shown = 0;
    uint32_t out = 0;
    for (size_t i = 0; i < count; i++)
        shown += !(picture->pixels[i] & PICTURE_CLEAR);
    for (int shift = 16; shift >= 0 && shown; shift -= 8) {
        double sum = 0;
        for (size_t i = 0; i < count; i++)
            sum += picture->pixels[i] & PICTURE_CLEAR ? 0 : picture->pixels[i] >> shift & 0xFF;
        out |= (uint32_t)(sum / (double)shown * (colour >> shift & 0xFF) / 255 + 0.5) << shift;
    }
    return out;
}

/* What is lit in each frame shows no texture. */
static void drop_picture(const struct model *model, struct model_face *face)
{
    const struct picture *picture = face->picture ? &model->pictures[face->picture - 1] : NULL;
    if (picture && picture->pixels) face->colour = flat_colour(picture, face->colour);
    face->picture = 0;
}

/* Those of which only other parts have faces make no textures. */
static void count_picture(struct model *part, const struct model_face *face)
{
    struct picture *picture = face->picture ? &part->pictures[face->picture - 1] : NULL;
    if (picture && picture->pixels) picture->faces++;
}

static void place_point(const struct model *model, size_t mover, const double from[3], double to[3])
{
    if (mover)
        pose_enter(&model->movers[mover - 1].rest, from, to);
    else
        memcpy(to, from, 3 * sizeof *to);
}

static uint32_t add_point(const struct model *model, size_t mover, uint32_t point, struct model *part)
{
    double *to = part->points[part->point_count];
    place_point(model, mover, model->points[point], to);
    if (part->source_points)
        place_point(model, mover, model->source_points[point], part->source_points[part->point_count]);
    if (part->uvs) memcpy(part->uvs[part->point_count], model->uvs[point], sizeof part->uvs[0]);
    return (uint32_t)part->point_count++;
}

void model_part(const struct model *model, size_t mover, bool is_textured, struct model *part, uint32_t **numbers)
{
    uint32_t *places = grow_zeroed(model->point_count, sizeof *places); /* in the part, from 1 */
    count_part(model, mover, part);
    if (is_textured) copy_pictures(model, part);
    part->face_count = part->corner_count = 0;
    part->alpha_clamped = mover ? 0 : model->alpha_clamped;
    part->lattice_m = mover ? 0 : model->lattice_m;
    part->is_interior = !mover && model->is_interior;
    *numbers = grow_zeroed(model->face_count, sizeof **numbers);
    for (size_t i = 0; i < model->face_count; i++) {
        const struct model_face *face = &model->faces[i];
        if (face->mover != mover) continue;
        (*numbers)[part->face_count] = (uint32_t)i + 1;
        part->faces[part->face_count] = *face;
        part->faces[part->face_count].number = model_face_number(model, i);
        part->faces[part->face_count].first = (uint32_t)part->corner_count;
        if (!is_textured)
            drop_picture(model, &part->faces[part->face_count]);
        else
            count_picture(part, face);
        part->face_count++;
        for (uint32_t k = 0; k < face->count; k++) {
            const uint32_t point = model->corners[face->first + k];
            if (!places[point]) places[point] = add_point(model, mover, point, part) + 1;
            part->corners[part->corner_count++] = places[point] - 1;
        }
    }
    free(places);
}
