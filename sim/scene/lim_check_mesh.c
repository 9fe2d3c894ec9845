/* SPDX-License-Identifier: MIT
 *
 * What the renderer relies on in a scene without nodes. */
#include "scene/bounds.h"
#include "scene/lim_check.h"
#include "scene/records.h"

#include <stdlib.h>

enum { EVEN_MOST = 127 };

/* What only scenes with nodes have. */
static bool check_absent(const struct lim_scene *scene, struct error *err)
{
    const struct {
        const char *what;
        unsigned long count;
    } absent[] = {{"planes", scene->plane_count},
                  {"exact planes", scene->exact_count},
                  {"places", scene->place_count},
                  {"bytes of visible sets", scene->pvs_bytes},
                  {"mappings", scene->mapping_count},
                  {"levels of a tree", scene->limits.depth},
                  {"layers", scene->limits.layers},
                  {"polygons of a mesh leaf", scene->limits.leaf_polygons},
                  {"vertices of one", scene->limits.leaf_vertices}};
    for (size_t i = 0; i < sizeof absent / sizeof *absent; i++)
        if (absent[i].count) return error_set(err, "a mesh, and %lu %s beside it", absent[i].count, absent[i].what);
    return true;
}

/* Differences of places have 15 bits and a sign. */
static bool check_places_of(const struct lim_scene *scene, size_t index, struct error *err)
{
    const lim_index *words = &scene->polygons[index * LIM_TRIANGLE_WORDS];
    for (int k = 0; k < 3; k++) {
        const struct lim_uv *a = &(*scene->uvs)[words[k]], *b = &(*scene->uvs)[words[(k + 1) % 3]];
        if (abs(a->u - b->u) > INT16_MAX || abs(a->v - b->v) > INT16_MAX)
            return error_set(err, "triangle %zu: its places in the texture are too far apart", index);
    }
    const unsigned long texture = words[3] & lim_triangle_texture_mask(scene->texture_count);
    const lim_index above = words[3] >> (scene->texture_count > LIM_TRIANGLE_TEXTURES ? 0 : LIM_TRIANGLE_TEXTURE_BITS);
    if (above > (scene->texture_count > LIM_TRIANGLE_TEXTURES ? UINT16_MAX : EVEN_MOST))
        return error_set(err, "triangle %zu: texture 0x%lx", index, (unsigned long)words[3]);
    return texture < scene->texture_count ||
           error_set(err, "triangle %zu: texture %lu of %u", index, texture, (unsigned)scene->texture_count);
}

static bool check_triangle(const struct lim_scene *scene, size_t index, struct error *err)
{
    const lim_index *words = &scene->polygons[index * LIM_TRIANGLE_WORDS];
    for (int k = 0; k < 3; k++) {
        if (words[k] >= scene->vertex_count)
            return error_set(err, "triangle %zu: vertex %lu of %lu", index, (unsigned long)words[k],
                             (unsigned long)scene->vertex_count);
        if (words[k] == words[(k + 1) % 3])
            return error_set(err, "triangle %zu: vertex %lu is two of its corners", index, (unsigned long)words[k]);
    }
    if (scene->texture_count) return check_places_of(scene, index, err);
    return words[3] <= UINT16_MAX ||
           error_set(err, "triangle %zu: its colour is 0x%lx", index, (unsigned long)words[3]);
}

bool lim_check_mesh(const struct lim_scene *scene, struct error *err)
{
    if (scene->polygon_count == 0) return error_set(err, "no nodes, and no triangles");
    if (!check_absent(scene, err)) return false;
    if (scene->polygon_words % LIM_TRIANGLE_WORDS || scene->polygon_words / LIM_TRIANGLE_WORDS != scene->polygon_count)
        return error_set(err, "%lu triangles in %lu words; each takes %d", (unsigned long)scene->polygon_count,
                         (unsigned long)scene->polygon_words, LIM_TRIANGLE_WORDS);
    if (*scene->deep_from > scene->polygon_count)
        return error_set(err, "depth from triangle %lu on, of %lu", (unsigned long)*scene->deep_from,
                         (unsigned long)scene->polygon_count);
    if (*scene->near_deep_from > *scene->deep_from)
        return error_set(err, "depth from triangle %lu on near the eye, and from %lu on elsewhere",
                         (unsigned long)*scene->near_deep_from, (unsigned long)*scene->deep_from);
    if (!*scene->uvs != !scene->texture_count)
        return error_set(err, "a mesh of %u textures, and %s places of vertices in them",
                         (unsigned)scene->texture_count, *scene->uvs ? "with" : "without");
    if (scene->limits.vertices != 3)
        return error_set(err, "limit of %u vertices a polygon in a mesh of triangles",
                         (unsigned)scene->limits.vertices);
    for (size_t i = 0; i < scene->polygon_count; i++)
        if (!check_triangle(scene, i, err)) return false;
    const struct bounds bounds = bounds_of_mesh(scene);
    if (scene->box_count != 1)
        return error_set(err, "%lu boxes of a mesh, which has one", (unsigned long)scene->box_count);
    return bounds_fit(&bounds, &scene->boxes[0]) || error_set(err, "the box does not hold all of the mesh");
}
