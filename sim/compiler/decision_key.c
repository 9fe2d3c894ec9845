/* SPDX-License-Identifier: MIT
 *
 * Fields one by one: what lies between a struct's fields may be anything. */
#include "compiler/decision_key.h"

#include "base/grow.h"
#include "core/core.h"
#include "model/original.h"

#include <stdlib.h>
#include <string.h>

/* Bytes one behind the other. */
struct bytes {
    uint8_t *items;
    size_t count, capacity;
};

static void add(struct bytes *bytes, const void *from, size_t n_b)
{
    if (bytes->count + n_b > bytes->capacity) {
        bytes->capacity = 2 * (bytes->count + n_b);
        uint8_t *more = grow_zeroed(bytes->capacity, 1);
        if (bytes->count) memcpy(more, bytes->items, bytes->count);
        free(bytes->items);
        bytes->items = more;
    }
    if (n_b) memcpy(bytes->items + bytes->count, from, n_b);
    bytes->count += n_b;
}

static void add_number(struct bytes *bytes, double number)
{
    add(bytes, &number, sizeof number);
}

/* With its length: no two lists of arrays are alike. */
static void add_array(struct bytes *bytes, const void *items, size_t count, size_t item_b)
{
    add_number(bytes, (double)count);
    add(bytes, items, count * item_b);
}

static void add_text(struct bytes *bytes, const char *text)
{
    add_array(bytes, text, text ? strlen(text) : 0, 1);
}

/* The mesh ------------------------------------------------------------------------------------- */

static void add_grid(struct bytes *bytes, const struct grid *grid)
{
    add(bytes, grid->origin_m, sizeof grid->origin_m);
    add_number(bytes, grid->units_per_m);
    add_number(bytes, grid->is_long);
    add_number(bytes, grid->has_fractions);
}

static void add_polygons(struct bytes *bytes, const struct mesh *mesh)
{
    add_array(bytes, mesh->points, mesh->point_count, sizeof *mesh->points);
    add_array(bytes, mesh->corners, mesh->corner_count, sizeof *mesh->corners);
    add_number(bytes, (double)mesh->polygon_count);
    for (size_t i = 0; i < mesh->polygon_count; i++) {
        const struct mesh_polygon *polygon = &mesh->polygons[i];
        const uint32_t fields[] = {polygon->first,        polygon->count,     polygon->face,   polygon->colour,
                                   polygon->transparency, polygon->two_sided, polygon->mapping};
        add(bytes, fields, sizeof fields);
    }
}

static void add_textures(struct bytes *bytes, const struct mesh *mesh)
{
    add_number(bytes, (double)mesh->texture_count);
    for (size_t i = 0; i < mesh->texture_count; i++) {
        const struct texture *texture = &mesh->textures[i];
        const uint32_t fields[] = {texture->w_bits,    texture->h_bits,    texture->levels,  texture->transposed,
                                   texture->is_masked, texture->sky.times, texture->colours, texture->mean};
        add(bytes, fields, sizeof fields);
        add_number(bytes, texture->sky.horizon);
        add(bytes, texture->palette, sizeof texture->palette);
        add_array(bytes, texture->texels, texture->texels ? texture->texel_count : 0, 1);
    }
    add_number(bytes, (double)mesh->mapping_count);
    for (size_t i = 0; i < mesh->mapping_count; i++) {
        const struct mapping *mapping = &mesh->mappings[i];
        add_number(bytes, mapping->texture);
        add(bytes, mapping->centre_m, sizeof mapping->centre_m);
        add(bytes, mapping->normal, sizeof mapping->normal);
        add(bytes, mapping->gradient, sizeof mapping->gradient);
        add(bytes, mapping->uv, sizeof mapping->uv);
    }
}

/* Edges in the order of the table, which their entering alone decides. */
static void add_inner(struct bytes *bytes, const struct map *inner)
{
    add_number(bytes, (double)inner->count);
    for (size_t i = 0; i < inner->capacity; i++)
        if (inner->entries[i].used) {
            add(bytes, &inner->entries[i].key, sizeof inner->entries[i].key);
            add(bytes, &inner->entries[i].value, sizeof inner->entries[i].value);
        }
}

static void add_original(struct bytes *bytes, const struct original *original)
{
    if (!original) return;
    add_array(bytes, original->corners_m, original->corner_count, sizeof *original->corners_m);
    add_array(bytes, original->points, original->corner_count, sizeof *original->points);
    add_array(bytes, original->by_size, original->seen_count, sizeof *original->by_size);
    add_number(bytes, (double)original->face_count);
    for (size_t i = 0; i < original->face_count; i++) {
        const struct original_face *face = &original->faces[i];
        const uint32_t fields[] = {face->first, face->count, face->number, face->patch, face->thing};
        add(bytes, fields, sizeof fields);
    }
}

static void add_mesh(struct bytes *bytes, const struct mesh *mesh)
{
    add_grid(bytes, &mesh->grid);
    add_polygons(bytes, mesh);
    add_textures(bytes, mesh);
    add_inner(bytes, &mesh->inner);
    add_original(bytes, mesh->original);
    add_number(bytes, mesh->is_interior);
    add_array(bytes, &mesh->counts, 1, sizeof mesh->counts);
    add_array(bytes, mesh->pieces, mesh->piece_count, sizeof *mesh->pieces);
    add_array(bytes, mesh->merged_into, mesh->merged_into ? mesh->counts.faces + 1 : 0, sizeof *mesh->merged_into);
}

/* The options ------------------------------------------------------------------------------------ */

static void add_path(struct bytes *bytes, const struct camera_path *path)
{
    add_number(bytes, (double)path->count);
    for (size_t i = 0; i < path->count; i++) {
        const struct viewpoint *view = &path->frames[i];
        add(bytes, view->eye_m, sizeof view->eye_m);
        add(bytes, view->target_m, sizeof view->target_m);
        add_number(bytes, view->has_time ? view->time_s : -1.0);
    }
}

/* All but orientation and what else the mesh shows already, and options->predict. */
static void add_options(struct bytes *bytes, const struct compile_options *options)
{
    add_text(bytes, options->method ? options->method->name : "");
    add_text(bytes, options->splitter);
    add_text(bytes, options->core ? options->core->name : core_fast.name);
    const double numbers[] = {
        options->tolerance_units, options->choose_order,  options->wrong_percent, options->tree,
        options->trial,           options->mesh_leaves,   options->leaves_open,   options->whole_leaf,
        options->coordinates,     options->keep_faces,    options->w_px,          options->h_px,
        options->background,      options->unlit,         options->mono,          options->antialias,
        options->delta,           options->overlay,       options->round,         options->fill,
        options->framebuffer,     options->wireframe,     options->portals,       options->fov_deg,
        options->near_m,          options->forced_near_m, options->drop_small,    (double)options->worst_tries};
    add(bytes, numbers, sizeof numbers);
    add_path(bytes, &options->path);
}

void decision_key(uint8_t key[CACHE_KEY_B], const struct mesh *mesh, const struct mesh *fine,
                  const struct compile_options *options)
{
    struct bytes bytes = {0};
    add_mesh(&bytes, mesh);
    if (fine) add_polygons(&bytes, fine);
    add_options(&bytes, options);
    cache_key(key, bytes.items, bytes.count);
    free(bytes.items);
}
