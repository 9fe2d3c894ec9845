/* SPDX-License-Identifier: MIT
 *
 * A triangle with a corner twice may go: its two other edges are one, there and back. One that rounding has made a line
 * of three points must stay, as its neighbours do not meet without it. */
#include "compiler/encode_mesh.h"

#include "base/grow.h"
#include "base/rgb565.h"
#include "compiler/encode_even.h"
#include "compiler/encode_texture.h"
#include "compiler/encode_uv.h"
#include "compiler/encode_vertex.h"
#include "compiler/outline.h"
#include "compiler/outline_triangles.h"

#include <stdlib.h>
#include <string.h>

struct mesh_encoder {
    const struct mesh *mesh;
    struct encoding *out;
    struct grid_point *snapped; /* the exact points, rounded */
    struct vertex_encoder vertices;
    bool has_textures;
    struct texture_encoder textures;
    struct uv_encoder uvs;
    struct outline outline;   /* of the polygon at hand */
    uint32_t (*triangles)[3]; /* of it: corners of the outline */
    size_t triangle_capacity;
};

static void word_add(struct encoding *out, size_t word)
{
    out->words = grow(out->words, out->word_count, &out->word_capacity, sizeof *out->words);
    out->words[out->word_count++] = (lim_index)word;
}

/* The polygon's own corner that is rounded to a point of its outline. */
static uint32_t corner_at(const struct mesh_encoder *work, const struct mesh_polygon *polygon, struct grid_point point)
{
    const uint32_t *corners = &work->mesh->corners[polygon->first];
    uint32_t k = 0;
    while (k + 1 < polygon->count && memcmp(&work->snapped[corners[k]], &point, sizeof point) != 0)
        k++;
    return corners[k];
}

static uint32_t corner_encode(struct mesh_encoder *work, const struct mesh_polygon *polygon, struct grid_point point)
{
    if (!work->has_textures) return vertex_encode(&work->vertices, point);
    return uv_encode(&work->uvs, polygon, corner_at(work, polygon, point), point);
}

static void triangle_encode(struct mesh_encoder *work, const uint32_t corners[3], const struct mesh_polygon *polygon,
                            bool turned)
{
    struct encoding *out = work->out;
    uint32_t indices[3];
    for (int k = 0; k < 3; k++)
        indices[k] = corner_encode(work, polygon, work->outline.corners[corners[turned ? 2 - k : k]]);
    if (indices[0] == indices[1] || indices[1] == indices[2] || indices[2] == indices[0]) {
        out->collapsed++;
        return;
    }
    out->faces = grow(out->faces, out->record_count, &out->face_capacity, sizeof *out->faces);
    out->faces[out->record_count++] = polygon->face;
    for (int k = 0; k < 3; k++)
        word_add(out, indices[k]);
    word_add(out, work->has_textures ? texture_encode_look(&work->textures, polygon) : rgb565_nearest(polygon->colour));
}

static void trace(struct mesh_encoder *work, const struct mesh_polygon *polygon)
{
    const uint32_t *corners = &work->mesh->corners[polygon->first];
    work->outline.count = 0;
    for (uint32_t i = 0; i < polygon->count; i++)
        outline_add(&work->outline, work->snapped[corners[i]], false);
    outline_close(&work->outline);
}

static void polygon_encode(struct mesh_encoder *work, const struct mesh_polygon *polygon)
{
    trace(work, polygon);
    if (!work->outline.count) {
        work->out->collapsed++;
        return;
    }
    const size_t count = work->outline.count - 2;
    while (work->triangle_capacity < count)
        work->triangles =
            grow(work->triangles, work->triangle_capacity, &work->triangle_capacity, sizeof *work->triangles);
    outline_triangulate(&work->outline, work->triangles);
    for (int side = 0; side < (polygon->two_sided ? 2 : 1); side++)
        for (size_t i = 0; i < count; i++)
            triangle_encode(work, work->triangles[i], polygon, side);
}

static bool check_polygons(const struct mesh *mesh, struct error *err)
{
    for (size_t i = 0; i < mesh->polygon_count; i++) {
        const struct mesh_polygon *polygon = &mesh->polygons[i];
        if (polygon->transparency)
            return error_set(err, "face %lu: as a mesh, transparent faces are not drawn; take another method",
                             (unsigned long)polygon->face);
        if (polygon->mapping && mesh->textures[mesh->mappings[polygon->mapping].texture].sky.times)
            return error_set(err, "face %lu: as a mesh, no sky is drawn; take another method",
                             (unsigned long)polygon->face);
    }
    return true;
}

static bool begin_textures(struct mesh_encoder *work, struct error *err)
{
    for (size_t i = 0; i < work->mesh->polygon_count; i++)
        work->has_textures = work->has_textures || work->mesh->polygons[i].mapping;
    if (!work->has_textures) return true;
    texture_encoder_init(&work->textures, work->mesh, &work->out->textures);
    const bool ok = uv_encoder_init(&work->uvs, work->mesh, &work->vertices, err);
    work->textures.place_bits = work->uvs.place_bits;
    return ok;
}

static bool finish_textures(struct mesh_encoder *work, struct error *err)
{
    if (!work->has_textures) return true;
    uv_encoder_finish(&work->uvs);
    texture_encoder_finish(&work->textures);
    return texture_arrays_check(&work->out->textures, err);
}

static bool encode(struct mesh_encoder *work, const struct exact_points *points, struct error *err)
{
    work->snapped = grow_zeroed(points->count, sizeof *work->snapped);
    for (uint32_t i = 0; i < points->count; i++)
        work->snapped[i] = exact_snap(points, i, work->vertices.with_fractions ? 8 : 0);
    if (!begin_textures(work, err)) return false;
    for (size_t i = 0; i < work->mesh->polygon_count; i++)
        polygon_encode(work, &work->mesh->polygons[i]);
    if (!finish_textures(work, err)) return false;
    encode_even(work->out);
    if (!work->out->record_count) return error_set(err, "nothing is left of the scene on its grid");
    work->out->widest = 3;
    encode_boxes(work->out);
    return true;
}

bool encode_mesh(const struct mesh *mesh, const struct exact_points *points, bool with_fractions, struct encoding *out,
                 struct error *err)
{
    struct mesh_encoder work = {.mesh = mesh, .out = out, .vertices = {.out = out, .with_fractions = with_fractions}};
    *out = (struct encoding){0};
    const bool ok = check_polygons(mesh, err) && encode(&work, points, err);
    texture_encoder_free(&work.textures);
    uv_encoder_free(&work.uvs);
    free(work.snapped);
    free(work.triangles);
    outline_free(&work.outline);
    vertex_encoder_free(&work.vertices);
    return ok;
}
