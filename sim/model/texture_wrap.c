/* SPDX-License-Identifier: MIT
 *
 * Coordinates are affine over triangles alone, so a face that is to be cut is cut into triangles first. A corner on an
 * edge that two triangles share is computed from its ends in the same order by both, so that it is the same point. */
#include "model/texture_wrap.h"

#include "base/grow.h"
#include "model/loop.h"
#include "model/triangulate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of a triangle between two lines across and two down 3 + 4; rounded coordinates may make it no more than these. */
enum { CORNERS_MAX = 16 };
static const double FARTHEST = 1e6;       /* pictures from the origin: beyond, coordinates make no sense */
static const double BEYOND_TEXELS = 0.25; /* so much beyond the border is a rounded coordinate, not outside */

struct corner {
    double at_m[3], source_m[3], uv[2];
};

struct piece {
    struct corner corners[CORNERS_MAX];
    size_t count;
};

struct wrapping {
    struct model *model;
    struct model_face *faces; /* the new ones */
    uint32_t *corners;
    size_t face_count, face_capacity, corner_count, corner_capacity, point_capacity;
    size_t uv_capacity, source_capacity;
};

/* What leaves a picture ------------------------------------------------------------------------ */

static double side_px(const struct picture *picture, int axis)
{
    return axis ? picture->h_px : picture->w_px;
}

static const struct picture *picture_of(const struct model *model, const struct model_face *face)
{
    const struct picture *picture = face->picture ? &model->pictures[face->picture - 1] : NULL;
    return picture && picture->pixels && !picture->sky.times && model->uvs ? picture : NULL;
}

/* Whether a face shows what is beyond its picture's borders, in one direction. Written so that NaN does not. */
static bool leaves(const struct model *model, const struct model_face *face, int axis)
{
    const struct picture *picture = picture_of(model, face);
    const double most = 1 + (picture ? BEYOND_TEXELS / side_px(picture, axis) : 0);
    bool any = false, is_known = picture != NULL;
    for (uint32_t k = 0; is_known && k < face->count; k++) {
        const double at = model->uvs[model->corners[face->first + k]][axis];
        is_known = fabs(at) < FARTHEST;
        any |= at > most || at < 1 - most;
    }
    return any && is_known;
}

static bool is_wrapped(const struct model *model, const struct model_face *face, int axis, enum picture_wrap wrap)
{
    const struct picture *picture = picture_of(model, face);
    return picture && picture->wrap[axis] == wrap && leaves(model, face, axis);
}

static bool is_cut(const struct model *model, const struct model_face *face)
{
    return is_wrapped(model, face, 0, PICTURE_CLAMPS) || is_wrapped(model, face, 1, PICTURE_CLAMPS);
}

bool texture_wrap_cuts(const struct model *model)
{
    for (size_t i = 0; i < model->face_count; i++)
        if (is_cut(model, &model->faces[i])) return true;
    return false;
}

/* Faces ---------------------------------------------------------------------------------------- */

static uint32_t add_point(struct wrapping *work, const struct corner *corner)
{
    struct model *model = work->model;
    const size_t count = model->point_count;
    model->points = grow(model->points, count, &work->point_capacity, sizeof *model->points);
    model->uvs = grow(model->uvs, count, &work->uv_capacity, sizeof *model->uvs);
    memcpy(model->points[count], corner->at_m, sizeof corner->at_m);
    memcpy(model->uvs[count], corner->uv, sizeof corner->uv);
    if (model->source_points) {
        model->source_points = grow(model->source_points, count, &work->source_capacity, sizeof *model->source_points);
        memcpy(model->source_points[count], corner->source_m, sizeof corner->source_m);
    }
    return (uint32_t)model->point_count++;
}

static void add_corner(struct wrapping *work, uint32_t point)
{
    work->corners = grow(work->corners, work->corner_count, &work->corner_capacity, sizeof *work->corners);
    work->corners[work->corner_count++] = point;
}

static struct model_face *add_face(struct wrapping *work, const struct model_face *like, uint32_t count)
{
    work->faces = grow(work->faces, work->face_count, &work->face_capacity, sizeof *work->faces);
    struct model_face *face = &work->faces[work->face_count++];
    *face = *like;
    face->first = (uint32_t)work->corner_count;
    face->count = count;
    return face;
}

/* Faces are cut in the middle of the border's texels: at their ends, a rounded coordinate would show the other end's.
 */
static double line_at(const struct picture *picture, int axis, bool is_last)
{
    const double half_texel = 0.5 / side_px(picture, axis);
    return is_last ? 1 - half_texel : half_texel;
}

/* All of a piece lies between the lines or on one side of them. */
static void clamp_piece(struct piece *piece, const struct picture *picture)
{
    for (int axis = 0; axis < 2; axis++) {
        if (picture->wrap[axis] != PICTURE_CLAMPS) continue;
        for (size_t k = 0; k < piece->count; k++) {
            double *at = &piece->corners[k].uv[axis];
            *at = fmin(fmax(*at, line_at(picture, axis, false)), line_at(picture, axis, true));
        }
    }
}

static void add_piece(struct wrapping *work, const struct model_face *face, struct piece *piece)
{
    if (piece->count < 3) return;
    clamp_piece(piece, picture_of(work->model, face));
    add_face(work, face, (uint32_t)piece->count);
    for (size_t k = 0; k < piece->count; k++)
        add_corner(work, add_point(work, &piece->corners[k]));
}

/* Cutting -------------------------------------------------------------------------------------- */

static bool is_before(const struct corner *a, const struct corner *b)
{
    for (int i = 0; i < 3; i++)
        if (a->at_m[i] != b->at_m[i]) return a->at_m[i] < b->at_m[i];
    return false;
}

/* Where the edge between two corners has `value`, which lies between theirs. */
static struct corner between(const struct corner *here, const struct corner *next, int axis, double value)
{
    const bool is_turned = is_before(next, here);
    const struct corner *a = is_turned ? next : here, *b = is_turned ? here : next;
    const double t = (value - a->uv[axis]) / (b->uv[axis] - a->uv[axis]);
    struct corner out = *a;
    for (int i = 0; i < 3; i++) {
        out.at_m[i] += t * (b->at_m[i] - a->at_m[i]);
        out.source_m[i] += t * (b->source_m[i] - a->source_m[i]);
    }
    for (int i = 0; i < 2; i++)
        out.uv[i] += t * (b->uv[i] - a->uv[i]);
    out.uv[axis] = value;
    return out;
}

static void piece_add(struct piece *piece, const struct corner *corner)
{
    if (piece->count < CORNERS_MAX) piece->corners[piece->count++] = *corner;
}

/* The part of a convex piece on one side of a line; corners on it belong to both sides. */
static void part_of(const struct piece *piece, int axis, double value, bool is_below, struct piece *out)
{
    const double sign = is_below ? -1 : 1;
    out->count = 0;
    for (size_t k = 0; k < piece->count; k++) {
        const struct corner *here = &piece->corners[k], *next = &piece->corners[(k + 1) % piece->count];
        const double from = sign * (here->uv[axis] - value), to = sign * (next->uv[axis] - value);
        if (from >= 0) piece_add(out, here);
        if ((from > 0 && to < 0) || (from < 0 && to > 0)) {
            const struct corner on_line = between(here, next, axis, value);
            piece_add(out, &on_line);
        }
    }
}

/* Whether it has corners on this side of the line, and not just on it. */
static bool reaches(const struct piece *piece, int axis, double value, bool is_below)
{
    for (size_t k = 0; k < piece->count; k++)
        if (is_below ? piece->corners[k].uv[axis] < value : piece->corners[k].uv[axis] > value) return true;
    return false;
}

/* Cuts by one line after the other, four in all. */
static void cut(struct wrapping *work, const struct model_face *face, struct piece *piece)
{
    enum { LINES = 4, MOST = 1 << LINES };
    struct piece pieces[MOST] = {*piece};
    size_t count = 1;
    for (int line = 0; line < LINES; line++) {
        const int axis = line / 2;
        const double value = line_at(picture_of(work->model, face), axis, line % 2);
        if (!is_wrapped(work->model, face, axis, PICTURE_CLAMPS)) continue;
        for (size_t i = 0, end = count; i < end; i++) {
            const struct piece whole = pieces[i];
            if (!reaches(&whole, axis, value, true) || !reaches(&whole, axis, value, false)) continue;
            part_of(&whole, axis, value, true, &pieces[i]);
            part_of(&whole, axis, value, false, &pieces[count++]);
        }
    }
    for (size_t i = 0; i < count; i++)
        add_piece(work, face, &pieces[i]);
}

static struct corner corner_of(const struct model *model, uint32_t point)
{
    struct corner out;
    memcpy(out.at_m, model->points[point], sizeof out.at_m);
    memcpy(out.source_m, model->source_points ? model->source_points[point] : model->points[point],
           sizeof out.source_m);
    memcpy(out.uv, model->uvs[point], sizeof out.uv);
    return out;
}

static void cut_face(struct wrapping *work, const struct model_face *face)
{
    const struct model *model = work->model;
    const struct loop loop = {model->points, &model->corners[face->first], face->count};
    const struct loop_view view = loop_view_along(loop_plane_of(&loop).normal);
    uint32_t(*triangles)[3] = grow_zeroed(face->count - 2, sizeof *triangles);
    triangulate(&loop, &view, triangles);
    for (uint32_t i = 0; i < face->count - 2; i++) {
        struct piece piece = {.count = 3};
        for (int k = 0; k < 3; k++)
            piece.corners[k] = corner_of(work->model, triangles[i][k]);
        cut(work, face, &piece);
    }
    free(triangles);
}

static void keep_face(struct wrapping *work, const struct model_face *face)
{
    const struct model *model = work->model;
    add_face(work, face, face->count);
    for (uint32_t k = 0; k < face->count; k++)
        add_corner(work, model->corners[face->first + k]);
}

static void cut_faces(struct model *model)
{
    struct wrapping work = {.model = model,
                            .point_capacity = model->point_count,
                            .uv_capacity = model->point_count,
                            .source_capacity = model->point_count};
    for (size_t i = 0; i < model->face_count; i++) {
        struct model_face face = model->faces[i];
        face.number = model_face_number(model, i);
        if (is_cut(model, &face))
            cut_face(&work, &face);
        else
            keep_face(&work, &face);
    }
    free(model->faces);
    free(model->corners);
    model->faces = work.faces;
    model->face_count = work.face_count;
    model->corners = work.corners;
    model->corner_count = work.corner_count;
}

/* Each picture knows how many faces show it. */
static void count_faces(struct model *model)
{
    for (size_t i = 0; i < model->picture_count; i++)
        model->pictures[i].faces = 0;
    for (size_t i = 0; i < model->face_count; i++)
        if (model->faces[i].picture) model->pictures[model->faces[i].picture - 1].faces++;
}

/* Pictures ------------------------------------------------------------------------------------- */

/* Twice as long, the second half mirrored. */
static void mirror_picture(struct picture *picture, int axis)
{
    const size_t w = picture->w_px, h = picture->h_px, to_w = axis ? w : 2 * w, to_h = axis ? 2 * h : h;
    uint32_t *pixels = grow_zeroed(to_w * to_h, sizeof *pixels);
    for (size_t y = 0; y < to_h; y++)
        for (size_t x = 0; x < to_w; x++)
            pixels[y * to_w + x] = picture->pixels[(y < h ? y : 2 * h - 1 - y) * w + (x < w ? x : 2 * w - 1 - x)];
    free(picture->pixels);
    picture->pixels = pixels;
    picture->w_px = (uint32_t)to_w;
    picture->h_px = (uint32_t)to_h;
    *(axis ? &picture->found_h_px : &picture->found_w_px) *= 2;
}

static bool shows(const struct model *model, const struct model_face *face, size_t picture)
{
    return face->picture == picture + 1 && picture_of(model, face);
}

/* The coordinates of all faces that show it are in the longer picture's. Points belong to one picture. */
static void halve_coordinates(struct model *model, size_t picture, int axis)
{
    bool *is_done = grow_zeroed(model->point_count, sizeof *is_done);
    for (size_t i = 0; i < model->face_count; i++) {
        const struct model_face *face = &model->faces[i];
        for (uint32_t k = 0; shows(model, face, picture) && k < face->count; k++) {
            const uint32_t point = model->corners[face->first + k];
            if (!is_done[point]) model->uvs[point][axis] /= 2;
            is_done[point] = true;
        }
    }
    free(is_done);
}

static bool is_left(const struct model *model, size_t picture, int axis)
{
    for (size_t i = 0; i < model->face_count; i++)
        if (shows(model, &model->faces[i], picture) && leaves(model, &model->faces[i], axis)) return true;
    return false;
}

static void mirror_pictures(struct model *model)
{
    for (size_t i = 0; i < model->picture_count; i++)
        for (int axis = 0; axis < 2; axis++) {
            if (model->pictures[i].wrap[axis] != PICTURE_MIRRORS || !is_left(model, i, axis)) continue;
            halve_coordinates(model, i, axis);
            mirror_picture(&model->pictures[i], axis);
        }
}

void texture_wrap_apply(struct model *model)
{
    if (texture_wrap_cuts(model)) {
        cut_faces(model);
        count_faces(model);
    }
    mirror_pictures(model);
    for (size_t i = 0; i < model->picture_count; i++)
        memset(model->pictures[i].wrap, PICTURE_REPEATS, sizeof model->pictures[i].wrap);
}
