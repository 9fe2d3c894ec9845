/* SPDX-License-Identifier: MIT
 *
 * Both coordinates are in widths of the picture. A vertex of which two places differ is there twice. What of a place
 * differs by the last bit comes of mappings that were fitted one by one: that is the same place. */
#include "compiler/encode_uv.h"

#include "base/grow.h"
#include "model/mapping.h"

#include <math.h>
#include <stdlib.h>

enum { BITS_MAX = 15, FINE_BITS = 4 }; /* a 16th of a texel is fine enough */
static const uint32_t NONE = UINT32_MAX;
static const double PLACE_MAX = 32760; /* and what rounding adds */

static const struct texture *texture_of(const struct uv_encoder *encoder, const struct mesh_polygon *polygon)
{
    return &encoder->mesh->textures[encoder->mesh->mappings[polygon->mapping].texture];
}

static struct uv_scale *scale_of(const struct uv_encoder *encoder, const struct mesh_polygon *polygon)
{
    return &encoder->scales[encoder->mesh->mappings[polygon->mapping].texture];
}

/* In widths. */
static void place_of(const struct uv_encoder *encoder, const struct mesh_polygon *polygon, uint32_t corner,
                     double uv[2])
{
    const struct texture *texture = texture_of(encoder, polygon);
    mapping_at(&encoder->mesh->mappings[polygon->mapping], encoder->mesh->points[corner], uv);
    uv[1] = ldexp(uv[1], texture->h_bits - texture->w_bits);
}

static void range_of(const struct uv_encoder *encoder, const struct mesh_polygon *polygon, double low[2],
                     double high[2])
{
    for (uint32_t k = 0; k < polygon->count; k++) {
        double uv[2];
        place_of(encoder, polygon, encoder->mesh->corners[polygon->first + k], uv);
        for (int i = 0; i < 2; i++)
            low[i] = fmin(low[i], uv[i]), high[i] = fmax(high[i], uv[i]);
    }
}

/* The whole number of pictures next to the middle. */
static double whole_near(const struct texture *texture, double low, double high, int i)
{
    const double picture = i ? ldexp(1, texture->h_bits - texture->w_bits) : 1;
    return floor((low + high) / 2 / picture + 0.5) * picture;
}

static uint8_t bits_for(double reach)
{
    uint8_t bits = BITS_MAX;
    while (bits > 0 && ldexp(reach, bits) > PLACE_MAX)
        bits--;
    return bits;
}

static double reach_of(double whole, double low, double high)
{
    return fmax(high - whole, whole - low);
}

static void scale_once(const struct texture *texture, struct uv_scale *scale)
{
    double reach = 0;
    for (int i = 0; i < 2; i++) {
        scale->whole[i] = whole_near(texture, scale->low[i], scale->high[i], i);
        reach = fmax(reach, reach_of(scale->whole[i], scale->low[i], scale->high[i]));
    }
    scale->bits = bits_for(reach);
    scale->by_polygon = scale->bits < texture->w_bits + FINE_BITS;
    if (scale->by_polygon) scale->bits = BITS_MAX;
}

static bool scale_for_polygon(struct uv_encoder *encoder, const struct mesh_polygon *polygon, struct error *err)
{
    struct uv_scale *scale = scale_of(encoder, polygon);
    const struct texture *texture = texture_of(encoder, polygon);
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    range_of(encoder, polygon, low, high);
    for (int i = 0; i < 2; i++) {
        const double whole = scale->by_polygon ? whole_near(texture, low[i], high[i], i) : low[i];
        const uint8_t bits = bits_for(fmax(reach_of(whole, low[i], high[i]), high[i] - low[i]));
        if (bits < scale->bits) scale->bits = bits;
    }
    return scale->bits > texture->w_bits ||
           error_set(err, "face %lu: as a mesh, its texture repeats too often; take another method",
                     (unsigned long)polygon->face);
}

bool uv_encoder_init(struct uv_encoder *encoder, const struct mesh *mesh, struct vertex_encoder *vertices,
                     struct error *err)
{
    *encoder = (struct uv_encoder){.mesh = mesh, .vertices = vertices};
    encoder->scales = grow_zeroed(mesh->texture_count, sizeof *encoder->scales);
    encoder->place_bits = grow_zeroed(mesh->texture_count, sizeof *encoder->place_bits);
    for (size_t i = 0; i < mesh->texture_count; i++)
        encoder->scales[i] = (struct uv_scale){.low = {INFINITY, INFINITY}, .high = {-INFINITY, -INFINITY}};
    for (size_t i = 0; i < mesh->polygon_count; i++) {
        const struct mesh_polygon *polygon = &mesh->polygons[i];
        if (polygon->mapping)
            range_of(encoder, polygon, scale_of(encoder, polygon)->low, scale_of(encoder, polygon)->high);
    }
    for (size_t i = 0; i < mesh->texture_count; i++)
        if (encoder->scales[i].low[0] <= encoder->scales[i].high[0])
            scale_once(&mesh->textures[i], &encoder->scales[i]);
    for (size_t i = 0; i < mesh->polygon_count; i++)
        if (mesh->polygons[i].mapping && !scale_for_polygon(encoder, &mesh->polygons[i], err)) return false;
    for (size_t i = 0; i < mesh->texture_count; i++)
        encoder->place_bits[i] = encoder->scales[i].bits;
    return true;
}

static struct lim_uv round_place(const struct uv_encoder *encoder, const struct mesh_polygon *polygon, uint32_t corner)
{
    const struct uv_scale *scale = scale_of(encoder, polygon);
    double uv[2], whole[2] = {scale->whole[0], scale->whole[1]}, rounded[2];
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    if (scale->by_polygon) {
        range_of(encoder, polygon, low, high);
        for (int i = 0; i < 2; i++)
            whole[i] = whole_near(texture_of(encoder, polygon), low[i], high[i], i);
    }
    place_of(encoder, polygon, corner, uv);
    for (int i = 0; i < 2; i++)
        rounded[i] = fmax(fmin(floor(ldexp(uv[i] - whole[i], scale->bits) + 0.5), PLACE_MAX), -PLACE_MAX);
    return (struct lim_uv){(int16_t)rounded[0], (int16_t)rounded[1]};
}

static bool is_same(struct lim_uv a, struct lim_uv b)
{
    return abs(a.u - b.u) <= 1 && abs(a.v - b.v) <= 1;
}

/* Room for all vertices that there are. */
static void catch_up(struct uv_encoder *encoder)
{
    struct encoding *out = encoder->vertices->out;
    while (encoder->next_count < out->vertex_count) {
        const size_t at = encoder->next_count++;
        encoder->next = grow(encoder->next, at, &encoder->next_capacity, sizeof *encoder->next);
        encoder->is_set = grow(encoder->is_set, at, &encoder->set_capacity, sizeof *encoder->is_set);
        out->uvs = grow(out->uvs, at, &out->uv_capacity, sizeof *out->uvs);
        encoder->next[at] = NONE;
        encoder->is_set[at] = false;
        out->uvs[at] = (struct lim_uv){0, 0};
    }
}

uint32_t uv_encode(struct uv_encoder *encoder, const struct mesh_polygon *polygon, uint32_t corner,
                   struct grid_point point)
{
    uint32_t index = vertex_encode(encoder->vertices, point);
    catch_up(encoder);
    if (!polygon->mapping) return index;
    struct lim_uv *uvs = encoder->vertices->out->uvs;
    const struct lim_uv place = round_place(encoder, polygon, corner);
    while (encoder->is_set[index] && !is_same(uvs[index], place)) {
        if (encoder->next[index] == NONE) {
            const uint32_t again = vertex_encode_again(encoder->vertices, point);
            catch_up(encoder);
            uvs = encoder->vertices->out->uvs;
            encoder->next[index] = again;
        }
        index = encoder->next[index];
    }
    if (!encoder->is_set[index]) uvs[index] = place;
    encoder->is_set[index] = true;
    return index;
}

void uv_encoder_finish(struct uv_encoder *encoder)
{
    catch_up(encoder);
}

void uv_encoder_free(struct uv_encoder *encoder)
{
    free(encoder->scales);
    free(encoder->place_bits);
    free(encoder->next);
    free(encoder->is_set);
    *encoder = (struct uv_encoder){0};
}
