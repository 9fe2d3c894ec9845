/* SPDX-License-Identifier: MIT
 *
 * Points are found by three maps, as three coordinates are too many bits for one key. */
#include "compiler/encode_vertex.h"

#include "base/grow.h"

#include <math.h>

enum { COORDINATE_BITS = 38 }; /* the numbers of points, and of what leads to them, have the other 26 */

static void long_vertex_add(struct encoding *out, const int units[3])
{
    out->long_vertices = grow(out->long_vertices, out->vertex_count, &out->vertex_capacity, sizeof *out->long_vertices);
    out->long_vertices[out->vertex_count++] = (struct lim_long_vertex){{units[0], units[1], units[2]}};
}

/* Units to nearest, halves up, and what is left: -128..127. */
static void vertex_add(struct vertex_encoder *encoder, struct grid_point point)
{
    struct encoding *out = encoder->out;
    int units[3], rest_q8[3];
    for (int k = 0; k < 3; k++) {
        units[k] = (int)floor((double)point.q8[k] / 256.0 + 0.5);
        rest_q8[k] = (int)(point.q8[k] - (int64_t)units[k] * 256);
    }
    if (encoder->with_fractions) {
        out->fractions = grow(out->fractions, out->vertex_count, &out->fraction_capacity, sizeof *out->fractions);
        out->fractions[out->vertex_count] =
            (struct lim_fraction){(int8_t)rest_q8[0], (int8_t)rest_q8[1], (int8_t)rest_q8[2]};
    }
    if (out->is_long) {
        long_vertex_add(out, units);
        return;
    }
    out->vertices = grow(out->vertices, out->vertex_count, &out->vertex_capacity, sizeof *out->vertices);
    out->vertices[out->vertex_count++] = (struct lim_vertex){(int16_t)units[0], (int16_t)units[1], (int16_t)units[2]};
}

/* The point's index, entered as `absent` if new. */
static uint32_t index_at(struct vertex_encoder *encoder, struct grid_point point, uint32_t absent)
{
    const uint64_t mask = (UINT64_C(1) << COORDINATE_BITS) - 1;
    const uint64_t y = (uint64_t)point.q8[1] & mask, z = (uint64_t)point.q8[2] & mask;
    const uint64_t slice = *map_at(&encoder->slices, (uint64_t)point.q8[0], (uint32_t)encoder->slices.count);
    const uint64_t column = *map_at(&encoder->columns, slice << COORDINATE_BITS | y, (uint32_t)encoder->columns.count);
    return *map_at(&encoder->indices, column << COORDINATE_BITS | z, absent);
}

void vertex_encode_known(struct vertex_encoder *encoder, struct grid_point point, uint32_t index)
{
    index_at(encoder, point, index);
}

uint32_t vertex_encode(struct vertex_encoder *encoder, struct grid_point point)
{
    const uint32_t index = index_at(encoder, point, (uint32_t)encoder->out->vertex_count);
    if (index == encoder->out->vertex_count) vertex_add(encoder, point);
    return index;
}

uint32_t vertex_encode_again(struct vertex_encoder *encoder, struct grid_point point)
{
    vertex_add(encoder, point);
    return (uint32_t)encoder->out->vertex_count - 1;
}

void vertex_encoder_free(struct vertex_encoder *encoder)
{
    map_free(&encoder->slices);
    map_free(&encoder->columns);
    map_free(&encoder->indices);
}
