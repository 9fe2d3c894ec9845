/* SPDX-License-Identifier: MIT
 *
 * The function is fitted to the corners by least squares within their plane; for a triangle that is exact. */
#include "model/mapping.h"

#include "base/grow.h"
#include "base/vec3.h"
#include "model/loop.h"

#include <math.h>
#include <stdlib.h>

static const double AFFINE_TEXELS = 1.0 / 8, AGREE_TEXELS = 1.0 / 16;
static const double UV_MAX = 32768;           /* pictures: beyond, float32 has no texels left */
static const double LONG_UV_MAX = 2147483648; /* of scenes of many scales, whose files tell more */
static const double TEXELS_A_UNIT_MAX = 8192; /* 16 bits hold four times that */

struct corner {
    double at[2]; /* in the plane, from its centre */
    double uv[2];
};

void mapping_at(const struct mapping *mapping, const double point_m[3], double uv[2])
{
    double from_centre[3];
    vec3_sub(from_centre, point_m, mapping->centre_m);
    for (int i = 0; i < 2; i++)
        uv[i] = vec3_dot(mapping->gradient[i], from_centre) + mapping->uv[i];
}

static const double *uv_of(const struct model *model, const struct model_face *face, const uint32_t *welded,
                           uint32_t corner)
{
    for (uint32_t k = 0; k < face->count; k++) {
        const uint32_t point = model->corners[face->first + k];
        if (welded[point] == corner) return model->uvs[point];
    }
    return NULL; /* not a corner of the face: cannot be */
}

/* What stands in the way of showing the texture. UNMAPPED_KINDS: nothing. */
static enum unmapped fault_of(double uv, double uv_max)
{
    if (isnan(uv)) return UNMAPPED_MISSING;
    if (isinf(uv)) return UNMAPPED_INFINITE;
    return fabs(uv) <= uv_max ? UNMAPPED_KINDS : UNMAPPED_FAR;
}

static enum unmapped set_corners(struct corner *corners, const struct model *model, const struct model_face *face,
                                 const uint32_t *welded, const struct loop *loop, const struct loop_plane *plane,
                                 double axes[2][3], bool transposed, double uv_max)
{
    enum unmapped worst = UNMAPPED_KINDS;
    for (size_t k = 0; k < loop->count; k++) {
        const double *uv = uv_of(model, face, welded, loop->corners[k]);
        double from_centre[3];
        vec3_sub(from_centre, loop->points[loop->corners[k]], plane->centre);
        for (int i = 0; i < 2; i++) {
            corners[k].at[i] = vec3_dot(axes[i], from_centre);
            corners[k].uv[i] = uv ? uv[transposed ? 1 - i : i] : NAN;
            const enum unmapped fault = fault_of(corners[k].uv[i], uv_max);
            if (fault < worst) worst = fault;
        }
    }
    return worst;
}

/* Two directions of length 1 in the plane. */
static void set_axes(const double normal[3], double axes[2][3])
{
    int least = 0;
    for (int i = 1; i < 3; i++)
        if (fabs(normal[i]) < fabs(normal[least])) least = i;
    const double along = normal[least], length = sqrt(1 - along * along);
    for (int i = 0; i < 3; i++)
        axes[0][i] = ((i == least) - along * normal[i]) / length;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        axes[1][i] = normal[j] * axes[0][k] - normal[k] * axes[0][j];
    }
}

/* The normal equations. false: the corners lie on a line. */
static bool fit(const struct corner *corners, size_t count, double axes[2][3], struct mapping *out)
{
    double xx = 0, xy = 0, yy = 0;
    for (size_t k = 0; k < count; k++) {
        const double *at = corners[k].at;
        xx += at[0] * at[0], xy += at[0] * at[1], yy += at[1] * at[1];
    }
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 1e-12 * (xx + yy) * (xx + yy))) return false;
    for (int i = 0; i < 2; i++) {
        double x = 0, y = 0, sum = 0;
        for (size_t k = 0; k < count; k++)
            sum += corners[k].uv[i] / (double)count;
        for (size_t k = 0; k < count; k++)
            x += corners[k].at[0] * (corners[k].uv[i] - sum), y += corners[k].at[1] * (corners[k].uv[i] - sum);
        for (int axis = 0; axis < 3; axis++)
            out->gradient[i][axis] =
                ((x * yy - y * xy) * axes[0][axis] + (y * xx - x * xy) * axes[1][axis]) / determinant;
        out->uv[i] = sum;
    }
    return true;
}

static double side_px(const struct mesh *mesh, const struct mapping *mapping, int i)
{
    const struct texture *texture = &mesh->textures[mapping->texture];
    return (double)(1u << (i ? texture->h_bits : texture->w_bits));
}

static double worst_texels(const struct mesh *mesh, const struct mapping *mapping, const struct loop *loop,
                           const struct corner *corners)
{
    double worst = 0;
    for (size_t k = 0; k < loop->count; k++) {
        double uv[2];
        mapping_at(mapping, loop->points[loop->corners[k]], uv);
        for (int i = 0; i < 2; i++)
            worst = fmax(worst, fabs(uv[i] - corners[k].uv[i]) * side_px(mesh, mapping, i));
    }
    return worst;
}

static bool is_too_fine(const struct mesh *mesh, const struct mapping *mapping)
{
    for (int i = 0; i < 2; i++)
        for (int axis = 0; axis < 3; axis++)
            if (!(fabs(mapping->gradient[i][axis]) * side_px(mesh, mapping, i) <
                  TEXELS_A_UNIT_MAX * mesh->grid.units_per_m))
                return true;
    return false;
}

static uint32_t list_add(struct mesh *mesh, const struct mapping *mapping)
{
    size_t *count = &mesh->mapping_count;
    if (*count == 0) (*count)++; /* 0 means none */
    while (*count >= mesh->mapping_capacity)
        mesh->mappings = grow(mesh->mappings, mesh->mapping_capacity, &mesh->mapping_capacity, sizeof *mesh->mappings);
    mesh->mappings[*count] = *mapping;
    return (uint32_t)(*count)++;
}

/* All faces of a sky share one, and corners have no part in it. */
static uint32_t sky_add(struct mesh *mesh, uint32_t texture)
{
    for (size_t i = 1; i < mesh->mapping_count; i++)
        if (mesh->mappings[i].texture == texture) return (uint32_t)i;
    return list_add(mesh, &(struct mapping){.texture = texture});
}

uint32_t mapping_add(struct mesh *mesh, const struct model *model, const struct model_face *face,
                     const uint32_t *welded, const struct loop *loop, bool *is_affine)
{
    *is_affine = true;
    if (!face->picture || mesh->textures[face->picture - 1].texel_count == 0) return 0;
    if (mesh->textures[face->picture - 1].sky.times) return sky_add(mesh, face->picture - 1);
    const struct loop_plane plane = loop_plane_of(loop);
    struct mapping mapping = {.texture = face->picture - 1};
    double axes[2][3];
    struct corner *corners = grow_zeroed(loop->count, sizeof *corners);
    for (int i = 0; i < 3; i++)
        mapping.centre_m[i] = plane.centre[i], mapping.normal[i] = plane.normal[i];
    set_axes(plane.normal, axes);
    enum unmapped fault = UNMAPPED_MISSING;
    if (model->uvs)
        fault = set_corners(corners, model, face, welded, loop, &plane, axes,
                            mesh->textures[mapping.texture].transposed, mesh->grid.is_long ? LONG_UV_MAX : UV_MAX);
    if (fault == UNMAPPED_KINDS && (!fit(corners, loop->count, axes, &mapping) || is_too_fine(mesh, &mapping)))
        fault = UNMAPPED_FINE;
    const bool ok = fault == UNMAPPED_KINDS;
    if (ok) *is_affine = worst_texels(mesh, &mapping, loop, corners) <= AFFINE_TEXELS;
    free(corners);
    if (!ok) mesh->counts.unmapped[fault]++;
    return ok ? list_add(mesh, &mapping) : 0;
}

const char *unmapped_words(enum unmapped kind)
{
    static const char *const words[UNMAPPED_KINDS] = {
        "have a texture, but no texture coordinates", "have texture coordinates that are not finite",
        "have texture coordinates too large to tell texels apart: take whole numbers off them",
        "have a texture that is too fine, or no area, to be mapped on them"};
    return words[kind];
}

bool mapping_agree(const struct mesh *mesh, uint32_t a, uint32_t b, const uint32_t *corners, size_t count)
{
    if (a == b) return true;
    if (!a || !b) return false;
    const struct mapping *one = &mesh->mappings[a], *other = &mesh->mappings[b];
    if (one->texture != other->texture) return false;
    double turns[2] = {0, 0};
    for (size_t k = 0; k < count; k++) {
        double uv[2], other_uv[2];
        mapping_at(one, mesh->points[corners[k]], uv);
        mapping_at(other, mesh->points[corners[k]], other_uv);
        for (int i = 0; i < 2; i++) {
            const double apart = uv[i] - other_uv[i];
            if (k == 0) turns[i] = floor(apart + 0.5);
            if (!(fabs(apart - turns[i]) * side_px(mesh, one, i) <= AGREE_TEXELS)) return false;
        }
    }
    return true;
}
