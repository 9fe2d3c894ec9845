/* SPDX-License-Identifier: MIT
 *
 * Faces with common corners are an island: its coordinates can only move together. The first point of each knows how
 * many whole pictures it is away. */
#include "readers/picture_crop.h"

#include "base/grow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { AROUND_PX = 2, LEAST_SIDE_PX = 8, LONGEST = 4 /* times the shorter side */ };
static const double ROUNDING_PX = 1.0 / 64; /* so much beyond a picture's edge is its edge */

struct rectangle {
    double least[2], most[2]; /* pixels, of what is shown; then of what is kept */
};

struct cropping {
    struct model *model;
    uint32_t *islands;  /* of each point: another one of its island, nearer to the first; itself */
    uint32_t *pictures; /* of each point that a face with a picture has: its number; 0: none */
    double (*first)[2]; /* of each first point: the least coordinates of its island */
    bool *stays;        /* of each picture */
    struct rectangle *rectangles;
};

static struct picture *picture_of(const struct cropping *work, const struct model_face *face)
{
    struct picture *picture = face->picture ? &work->model->pictures[face->picture - 1] : NULL;
    return picture && picture->pixels ? picture : NULL;
}

static const uint32_t *corners_of(const struct cropping *work, const struct model_face *face)
{
    return &work->model->corners[face->first];
}

/* Islands -------------------------------------------------------------------------------------- */

static uint32_t island_of(struct cropping *work, uint32_t point)
{
    while (work->islands[point] != point) {
        work->islands[point] = work->islands[work->islands[point]];
        point = work->islands[point];
    }
    return point;
}

/* Points that show two pictures, or nothing that makes sense, keep theirs as they are. */
static void note_point(struct cropping *work, uint32_t point, uint32_t picture)
{
    const double *uv = work->model->uvs[point];
    const uint32_t before = work->pictures[point];
    if (!isfinite(uv[0]) || !isfinite(uv[1])) work->stays[picture - 1] = true;
    if (before && before != picture) work->stays[before - 1] = work->stays[picture - 1] = true;
    work->pictures[point] = picture;
}

static void join(struct cropping *work, const struct model_face *face)
{
    const uint32_t *corners = corners_of(work, face);
    for (uint32_t k = 0; k < face->count; k++) {
        note_point(work, corners[k], face->picture);
        work->islands[island_of(work, corners[k])] = island_of(work, corners[0]);
    }
}

static void find_islands(struct cropping *work)
{
    const struct model *model = work->model;
    for (uint32_t i = 0; i < model->point_count; i++) {
        work->islands[i] = i;
        work->first[i][0] = work->first[i][1] = INFINITY;
    }
    for (size_t i = 0; i < model->face_count; i++)
        if (picture_of(work, &model->faces[i])) join(work, &model->faces[i]);
    for (uint32_t i = 0; i < model->point_count; i++) {
        double *const first = work->first[island_of(work, i)];
        for (int axis = 0; axis < 2 && work->pictures[i]; axis++)
            first[axis] = fmin(first[axis], model->uvs[i][axis]);
    }
}

/* Rectangles ----------------------------------------------------------------------------------- */

static double side_px(const struct picture *picture, int axis)
{
    return axis ? picture->h_px : picture->w_px;
}

/* In pixels of the picture, once its island has moved by whole pictures. */
static double place_px(struct cropping *work, uint32_t point, int axis)
{
    const double side = side_px(&work->model->pictures[work->pictures[point] - 1], axis);
    const double first_px = work->first[island_of(work, point)][axis] * side;
    return work->model->uvs[point][axis] * side - side * floor((first_px + ROUNDING_PX) / side);
}

static void find_rectangles(struct cropping *work)
{
    const struct model *model = work->model;
    for (size_t i = 0; i < model->picture_count; i++)
        work->rectangles[i] = (struct rectangle){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (uint32_t i = 0; i < model->point_count; i++) {
        if (!work->pictures[i] || work->stays[work->pictures[i] - 1]) continue;
        struct rectangle *const shown = &work->rectangles[work->pictures[i] - 1];
        for (int axis = 0; axis < 2; axis++) {
            const double at_px = place_px(work, i, axis);
            shown->least[axis] = fmin(shown->least[axis], at_px);
            shown->most[axis] = fmax(shown->most[axis], at_px);
        }
    }
}

/* Where a stretch of so many pixels begins that holds those from `least` to `most`; below 0: nowhere. */
static double begin_of(double least, double most, double length_px, double side)
{
    for (double parts = 1; parts <= 4; parts *= 2) {
        const double step = length_px / parts, begin = fmin(floor(least / step) * step, side - length_px);
        if (begin >= 0 && begin <= least && most <= begin + length_px) return begin;
    }
    return -1;
}

/* Of at least so many pixels. All of the side, where it repeats, or where less would not be less. */
static void choose_along(const struct picture *picture, int axis, double at_least_px, const struct rectangle *shown,
                         struct rectangle *kept)
{
    const double side = side_px(picture, axis), whole = exp2(floor(log2(side) + 0.5));
    const double least = fmax(0, floor(shown->least[axis]) - AROUND_PX);
    const double most = fmin(side, ceil(shown->most[axis]) + AROUND_PX);
    kept->least[axis] = 0, kept->most[axis] = side;
    if (shown->most[axis] > side + ROUNDING_PX) return;
    for (double length_px = fmax(LEAST_SIDE_PX, at_least_px); length_px < whole && length_px <= side; length_px *= 2) {
        const double begin = begin_of(least, most, length_px, side);
        if (begin < 0) continue;
        kept->least[axis] = begin, kept->most[axis] = begin + length_px;
        return;
    }
}

static double length_px(const struct rectangle *rectangle, int axis)
{
    return rectangle->most[axis] - rectangle->least[axis];
}

static struct rectangle choose(const struct picture *picture, const struct rectangle *shown)
{
    struct rectangle kept;
    for (int axis = 0; axis < 2; axis++)
        choose_along(picture, axis, 1, shown, &kept);
    for (int axis = 0; axis < 2; axis++) {
        const double shortest_px = exp2(floor(log2(length_px(&kept, 1 - axis) / LONGEST)));
        if (length_px(&kept, axis) < shortest_px) choose_along(picture, axis, shortest_px, shown, &kept);
    }
    return kept;
}

/* What is done --------------------------------------------------------------------------------- */

static void move_points(struct cropping *work, uint32_t number, const struct rectangle *kept)
{
    for (uint32_t i = 0; i < work->model->point_count; i++) {
        if (work->pictures[i] != number) continue;
        double moved[2];
        for (int axis = 0; axis < 2; axis++)
            moved[axis] = (place_px(work, i, axis) - kept->least[axis]) / length_px(kept, axis);
        memcpy(work->model->uvs[i], moved, sizeof moved);
    }
}

/* A mask's share of what is clear is that of what is kept of it. */
static void take_transparency(struct model *model, uint32_t number, uint8_t before)
{
    struct picture *picture = &model->pictures[number - 1];
    const uint8_t now = picture_transparency(picture);
    for (size_t i = 0; i < model->face_count; i++)
        if (model->faces[i].picture == number && model->faces[i].transparency == before)
            model->faces[i].transparency = now;
    picture->is_masked = now > 0;
}

static void crop(struct cropping *work, uint32_t number, const struct rectangle *kept)
{
    struct picture *picture = &work->model->pictures[number - 1];
    const uint8_t transparency = picture_transparency(picture);
    const uint32_t w_px = (uint32_t)length_px(kept, 0), h_px = (uint32_t)length_px(kept, 1);
    uint32_t *const pixels = grow_zeroed((size_t)w_px * h_px, sizeof *pixels);
    for (uint32_t y = 0; y < h_px; y++)
        memcpy(&pixels[(size_t)y * w_px],
               &picture->pixels[((size_t)kept->least[1] + y) * picture->w_px + (size_t)kept->least[0]],
               w_px * sizeof *pixels);
    free(picture->pixels);
    picture->pixels = pixels;
    picture->whole_w_px = picture->found_w_px, picture->whole_h_px = picture->found_h_px;
    picture->found_w_px = picture->w_px = w_px;
    picture->found_h_px = picture->h_px = h_px;
    if (picture->is_masked) take_transparency(work->model, number, transparency);
}

static bool crop_one(struct cropping *work, uint32_t number)
{
    const struct picture *picture = &work->model->pictures[number - 1];
    const struct rectangle *shown = &work->rectangles[number - 1];
    if (work->stays[number - 1] || picture->sky.times || !(shown->least[0] <= shown->most[0])) return false;
    const struct rectangle kept = choose(picture, shown);
    if (length_px(&kept, 0) >= picture->w_px && length_px(&kept, 1) >= picture->h_px) return false;
    move_points(work, number, &kept);
    crop(work, number, &kept);
    return true;
}

size_t picture_crop(struct model *model)
{
    size_t count = 0;
    if (!model->uvs || !model->picture_count) return 0;
    struct cropping work = {.model = model,
                            .islands = grow_zeroed(model->point_count, sizeof *work.islands),
                            .pictures = grow_zeroed(model->point_count, sizeof *work.pictures),
                            .first = grow_zeroed(model->point_count, sizeof *work.first),
                            .stays = grow_zeroed(model->picture_count, sizeof *work.stays),
                            .rectangles = grow_zeroed(model->picture_count, sizeof *work.rectangles)};
    find_islands(&work);
    find_rectangles(&work);
    for (uint32_t i = 1; i <= model->picture_count; i++)
        count += crop_one(&work, i);
    free(work.islands);
    free(work.pictures);
    free(work.first);
    free(work.stays);
    free(work.rectangles);
    return count;
}
