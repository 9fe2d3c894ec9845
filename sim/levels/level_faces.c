/* SPDX-License-Identifier: MIT */
#include "levels/level_faces.h"

#include "base/grow.h"

#include <stdio.h>
#include <string.h>

enum { SKY_ROUND_PX = 1024, SKY_HORIZON_PX = 100, LOOK_USES = 3 };

/* North is -z. */
void level_place(double x, double y, double height, double out_m[3])
{
    out_m[0] = x / LEVEL_UNITS_A_M;
    out_m[1] = height / LEVEL_UNITS_A_M;
    out_m[2] = -y / LEVEL_UNITS_A_M;
}

static uint32_t times(uint32_t colour, uint32_t light)
{
    uint32_t out = 0;
    for (int shift = 16; shift >= 0; shift -= 8)
        out |= ((colour >> shift & 0xFF) * (light >> shift & 0xFF) + 127) / 255 << shift;
    return out;
}

/* 1024 columns go round, from the east to the north: to the left, as the engine counts them. Row 100 is at the horizon.
 * Source: linuxdoom, r_sky.h, r_plane.c. */
static void set_sky(struct picture *picture)
{
    const unsigned times = SKY_ROUND_PX / picture->w_px;
    for (uint32_t y = 0; y < picture->h_px; y++) {
        uint32_t *row = &picture->pixels[(size_t)y * picture->w_px];
        for (uint32_t x = 0; x < picture->w_px / 2; x++) {
            const uint32_t pixel = row[x];
            row[x] = row[picture->w_px - 1 - x];
            row[picture->w_px - 1 - x] = pixel;
        }
    }
    picture->sky = (struct sky_look){.times = times < 1               ? 1
                                              : times > SKY_TIMES_MAX ? SKY_TIMES_MAX
                                                                      : times,
                                     .horizon = (double)SKY_HORIZON_PX / picture->h_px};
}

/* Where it is not masked, what is clear in it has the mean colour. */
static uint32_t add_picture(struct level_faces *faces, const struct level_look *look, bool is_masked, bool is_sky)
{
    struct model *model = faces->model;
    const size_t count = (size_t)look->w_px * look->h_px;
    model->pictures = grow(model->pictures, model->picture_count, &faces->picture_capacity, sizeof *model->pictures);
    struct picture *picture = &model->pictures[model->picture_count++];
    memset(picture, 0, sizeof *picture);
    snprintf(picture->name, sizeof picture->name, "%s", look->name);
    picture->found_w_px = picture->w_px = look->w_px;
    picture->found_h_px = picture->h_px = look->h_px;
    picture->pixels = grow_zeroed(count, sizeof *picture->pixels);
    picture->is_masked = is_masked;
    for (size_t i = 0; i < count; i++)
        picture->pixels[i] = is_masked ? look->pixels[i] : look->pixels[i] & ~PICTURE_CLEAR;
    if (is_sky) set_sky(picture);
    return (uint32_t)model->picture_count;
}

/* 0: the face shows none. */
static uint32_t picture_of(struct level_faces *faces, const struct level_paint *paint)
{
    const struct level_look *look = &faces->textures->looks[paint->look];
    const bool is_masked = paint->transparency > 0;
    const size_t index = LOOK_USES * paint->look + (paint->is_sky ? 2u : is_masked);
    if (!faces->is_textured || paint->is_plain || !look->is_known || look->is_one_colour) return 0;
    while (faces->look_capacity <= index) {
        const size_t before = faces->look_capacity;
        faces->pictures = grow(faces->pictures, before, &faces->look_capacity, sizeof *faces->pictures);
        memset(faces->pictures + before, 0, (faces->look_capacity - before) * sizeof *faces->pictures);
    }
    uint32_t *picture = &faces->pictures[index];
    if (!*picture) *picture = add_picture(faces, look, is_masked, paint->is_sky);
    faces->model->pictures[*picture - 1].faces++;
    return *picture;
}

static void add_corner(struct level_faces *faces, const struct level_corner *corner, const struct level_look *look)
{
    struct model *model = faces->model;
    const size_t i = model->point_count++;
    model->points = grow(model->points, i, &faces->point_capacity, sizeof *model->points);
    level_place(corner->x, corner->y, corner->height, model->points[i]);
    if (faces->is_textured) {
        model->uvs = grow(model->uvs, i, &faces->uv_capacity, sizeof *model->uvs);
        model->uvs[i][0] = look->is_known ? corner->u / look->w_px : 0;
        model->uvs[i][1] = look->is_known ? corner->v / look->h_px : 0;
    }
    model->corners = grow(model->corners, model->corner_count, &faces->corner_capacity, sizeof *model->corners);
    model->corners[model->corner_count++] = (uint32_t)i;
}

void level_face_add(struct level_faces *faces, const struct level_corner *corners, size_t count,
                    const struct level_paint *paint)
{
    struct model *model = faces->model;
    const struct level_look *look = &faces->textures->looks[paint->look];
    const uint32_t picture = picture_of(faces, paint);
    const uint32_t mean = look->is_known ? look->mean : MODEL_DEFAULT_COLOUR;
    model->faces = grow(model->faces, model->face_count, &faces->face_capacity, sizeof *model->faces);
    model->faces[model->face_count++] =
        (struct model_face){.first = (uint32_t)model->corner_count,
                            .count = (uint32_t)count,
                            .colour = picture ? paint->light : times(mean, paint->light),
                            .transparency = paint->transparency,
                            .picture = picture,
                            .mover = faces->mover,
                            .unlit = true};
    for (size_t i = 0; i < count; i++)
        add_corner(faces, &corners[i], look);
}
