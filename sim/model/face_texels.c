/* SPDX-License-Identifier: MIT
 *
 * The area of a polygon within a cell is an integral along its edges: of how far right of the cell's left side they
 * are, 0..1, over what they climb within the cell. No polygon is clipped, and concave ones are as good as others. */
#include "model/face_texels.h"

#include "base/grow.h"

#include <math.h>
#include <stdlib.h>

static const double ALL_MOST = 1 << 20, SAMPLED_MOST = 1 << 16; /* cells */
static const double LINE_TEXELS = 1e-9;                         /* an area: less is a line */
static const double ROUNDING = 1.0 / 256; /* of a texel, and of the face: what is less is its coordinates' rounding */
static const double FARTHEST = 1e6;       /* pictures from the origin */
static const double EDGE_MOST = 4096;     /* samples along an edge of what is a line */

struct outline {
    double (*at)[2]; /* cells, from the first one */
    uint32_t count;
    double first[2]; /* texels */
    double step_px;  /* texels a cell's side; odd, so that a picture's columns have all their turn */
    double cells[2]; /* across and down */
};

static bool set_corners(const struct model *model, const struct model_face *face, const struct picture *picture,
                        struct outline *outline, double most[2])
{
    const double size_px[2] = {picture->w_px, picture->h_px};
    for (int i = 0; i < 2; i++)
        outline->first[i] = INFINITY, most[i] = -INFINITY;
    for (uint32_t k = 0; k < face->count; k++)
        for (int i = 0; i < 2; i++) {
            const double at = model->uvs[model->corners[face->first + k]][i];
            if (!(fabs(at) < FARTHEST)) return false;
            outline->at[k][i] = at * size_px[i];
            outline->first[i] = fmin(outline->first[i], outline->at[k][i]);
            most[i] = fmax(most[i], outline->at[k][i]);
        }
    return true;
}

static double cell_count(const double extent_px[2], double step_px)
{
    return ceil(extent_px[0] / step_px) * ceil(extent_px[1] / step_px);
}

/* false: there are too many. */
static bool set_cells(struct outline *outline, const double most[2], enum face_texels_how how)
{
    double extent_px[2];
    for (int i = 0; i < 2; i++) {
        outline->first[i] = floor(outline->first[i]);
        extent_px[i] = fmax(1, ceil(most[i] - outline->first[i]));
    }
    outline->step_px = 1;
    if (how == TEXELS_ALL && cell_count(extent_px, 1) > ALL_MOST) return false;
    while (how == TEXELS_SAMPLED && cell_count(extent_px, outline->step_px) > SAMPLED_MOST)
        outline->step_px += 2 * fmax(1, floor(outline->step_px / 4));
    for (int i = 0; i < 2; i++)
        outline->cells[i] = ceil(extent_px[i] / outline->step_px);
    for (uint32_t k = 0; k < outline->count; k++)
        for (int i = 0; i < 2; i++)
            outline->at[k][i] = (outline->at[k][i] - outline->first[i]) / outline->step_px;
    return true;
}

/* At a place in cells. */
static uint32_t texel_at(const struct picture *picture, const struct outline *outline, const double at[2])
{
    const double size_px[2] = {picture->w_px, picture->h_px};
    size_t index[2];
    for (int i = 0; i < 2; i++) {
        const double px = floor(outline->first[i] + at[i] * outline->step_px);
        index[i] = (size_t)(px - size_px[i] * floor(px / size_px[i]));
    }
    return picture->pixels[index[1] * picture->w_px + index[0]];
}

/* Areas ---------------------------------------------------------------------------------------- */

static double unit_clamp(double x)
{
    return fmin(fmax(x, 0), 1);
}

/* The integral of unit_clamp() from 0 on. */
static double clamp_integral(double x)
{
    return x <= 0 ? 0 : x < 1 ? x * x / 2 : x - 0.5;
}

/* The mean of unit_clamp() from `a` to `b`. */
static double clamp_mean(double a, double b)
{
    static const double LEAST = 1e-6;
    if (fabs(b - a) < LEAST) return unit_clamp((a + b) / 2);
    return (clamp_integral(b) - clamp_integral(a)) / (b - a);
}

/* What the edge adds to the area in the cell right of x and below y. */
static double edge_part(const double from[2], const double to[2], double x, double y)
{
    const double y0 = unit_clamp(from[1] - y), y1 = unit_clamp(to[1] - y), climb = to[1] - from[1];
    if (y0 == y1) return 0;
    const double x0 = from[0] + (to[0] - from[0]) * ((y0 + y - from[1]) / climb);
    const double x1 = from[0] + (to[0] - from[0]) * ((y1 + y - from[1]) / climb);
    return clamp_mean(x0 - x, x1 - x) * (y1 - y0);
}

static double part_of_cell(const struct outline *outline, double x, double y)
{
    double area = 0;
    for (uint32_t k = 0; k < outline->count; k++)
        area += edge_part(outline->at[k], outline->at[(k + 1) % outline->count], x, y);
    return fabs(area);
}

static double area_of(const struct outline *outline)
{
    double area = 0;
    for (uint32_t k = 0; k < outline->count; k++) {
        const double *a = outline->at[k], *b = outline->at[(k + 1) % outline->count];
        area += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
    return fabs(area);
}

static void visit_cells(const struct picture *picture, const struct outline *outline, enum face_texels_how how,
                        texel_visitor *visitor, void *user)
{
    const double least = how == TEXELS_ALL ? ROUNDING * fmin(1, area_of(outline)) : 0;
    for (double y = 0; y < outline->cells[1]; y++)
        for (double x = 0; x < outline->cells[0]; x++) {
            const double part = part_of_cell(outline, x, y), centre[2] = {x + 0.5, y + 0.5};
            if (part > least && !visitor(texel_at(picture, outline, centre), part, user)) return;
        }
}

/* Lines ---------------------------------------------------------------------------------------- */

static bool visit_edge(const struct picture *picture, const struct outline *outline, const double from[2],
                       const double to[2], texel_visitor *visitor, void *user)
{
    const double length = hypot(to[0] - from[0], to[1] - from[1]);
    const double samples = fmin(fmax(ceil(2 * length), 1), EDGE_MOST);
    for (double k = 0.5; k < samples; k++) {
        const double t = k / samples, at[2] = {from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])};
        if (!visitor(texel_at(picture, outline, at), fmax(length / samples, LINE_TEXELS), user)) return false;
    }
    return true;
}

static void visit_line(const struct picture *picture, const struct outline *outline, texel_visitor *visitor, void *user)
{
    for (uint32_t k = 0; k < outline->count; k++)
        if (!visit_edge(picture, outline, outline->at[k], outline->at[(k + 1) % outline->count], visitor, user)) return;
}

bool face_texels_visit(const struct model *model, const struct model_face *face, const struct picture *picture,
                       enum face_texels_how how, texel_visitor *visitor, void *user)
{
    struct outline outline = {.count = face->count};
    double most[2];
    outline.at = grow_zeroed(face->count, sizeof *outline.at);
    const bool ok = set_corners(model, face, picture, &outline, most) && set_cells(&outline, most, how);
    if (ok && area_of(&outline) > LINE_TEXELS)
        visit_cells(picture, &outline, how, visitor, user);
    else if (ok)
        visit_line(picture, &outline, visitor, user);
    free(outline.at);
    return ok;
}
