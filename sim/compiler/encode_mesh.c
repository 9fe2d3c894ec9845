/* SPDX-License-Identifier: MIT
 *
 * A triangle with a corner twice may go: its two other edges are one, there and back. One that rounding has made a line
 * of three points must stay, as its neighbours do not meet without it. */
#include "compiler/encode_mesh.h"

#include "base/grow.h"
#include "base/rgb565.h"
#include "compiler/encode_vertex.h"
#include "compiler/outline.h"
#include "compiler/outline_triangles.h"

#include <stdlib.h>

struct mesh_encoder {
    const struct mesh *mesh;
    struct encoding *out;
    struct grid_point *snapped; /* the exact points, rounded */
    struct vertex_encoder vertices;
    struct outline outline;   /* of the polygon at hand */
    uint32_t (*triangles)[3]; /* of it: corners of the outline */
    size_t triangle_capacity;
};

static void word_add(struct encoding *out, size_t word)
{
    out->words = grow(out->words, out->word_count, &out->word_capacity, sizeof *out->words);
    out->words[out->word_count++] = (lim_index)word;
}

static void triangle_encode(struct mesh_encoder *work, const uint32_t corners[3], const struct mesh_polygon *polygon,
                            bool turned)
{
    struct encoding *out = work->out;
    uint32_t indices[3];
    for (int k = 0; k < 3; k++)
        indices[k] = vertex_encode(&work->vertices, work->outline.corners[corners[turned ? 2 - k : k]]);
    if (indices[0] == indices[1] || indices[1] == indices[2] || indices[2] == indices[0]) {
        out->collapsed++;
        return;
    }
    out->faces = grow(out->faces, out->record_count, &out->face_capacity, sizeof *out->faces);
    out->faces[out->record_count++] = polygon->face;
    for (int k = 0; k < 3; k++)
        word_add(out, indices[k]);
    word_add(out, rgb565_nearest(polygon->colour));
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
        if (polygon->transparency || polygon->mapping)
            return error_set(err, "face %lu: as a mesh, %s are not drawn; take another method",
                             (unsigned long)polygon->face, polygon->mapping ? "textures" : "transparent faces");
    }
    return true;
}

static bool encode(struct mesh_encoder *work, const struct exact_points *points, struct error *err)
{
    work->snapped = grow_zeroed(points->count, sizeof *work->snapped);
    for (uint32_t i = 0; i < points->count; i++)
        work->snapped[i] = exact_snap(points, i, work->vertices.with_fractions ? 8 : 0);
    for (size_t i = 0; i < work->mesh->polygon_count; i++)
        polygon_encode(work, &work->mesh->polygons[i]);
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
    free(work.snapped);
    free(work.triangles);
    outline_free(&work.outline);
    vertex_encoder_free(&work.vertices);
    return ok;
}
