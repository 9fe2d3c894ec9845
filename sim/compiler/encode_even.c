/* SPDX-License-Identifier: MIT
 *
 * Texels that advance evenly between corners where 1 / z is w are off by a quarter of the product of what place and w
 * gain along a side, over the least w. At a mean distance d no corner is a side's length l nearer or farther; so w
 * gains less than l / d / (1 - l / d)^2 of its least value, and a gain of p texels is off by less than a quarter of one
 * where l p <= d (1 - l / d)^2 = d - 2 l + l^2 / d.
 *
 * Steps are rounded to 2^-16 of the picture's width. Where d >= k l a lens of f pixels, and what it shows aslant near
 * the screen's corners, make a side 1.3 f / (k - 1) pixels long, so that texels are off by an eighth of one in pictures
 * of 2^w texels if 1.84 f / (k - 1) <= 2^(14 - w). That is so up to f = MESH_EVEN_LENS_PX for k = 1 + 10 2^(w - 8).
 * With 5 no side has 128 pixels: more would be too long for 16 bits. */
#include "compiler/encode_even.h"

#include <math.h>
#include <stdlib.h>

enum { STEPS = 4, CODES = 128, LEAST_SIDES = 5 };

static double side_of(const struct lim_vertex *a, const struct lim_vertex *b)
{
    const double x = b->x - a->x, y = b->y - a->y, z = b->z - a->z;
    return sqrt(x * x + y * y + z * z) + 1; /* and what is cut off of vertices with fractions */
}

/* In texels. */
static double gain_of(const struct lim_texture *texture, const struct lim_uv *a, const struct lim_uv *b)
{
    return ldexp(fmax(abs(b->u - a->u), abs(b->v - a->v)), texture->w_bits - texture->place_bits);
}

static double distance_of(const struct encoding *out, const lim_index *words)
{
    const struct lim_texture *texture = &out->textures.textures[words[3]];
    const double sides = fmax(1 + ldexp(10, texture->w_bits - 8), LEAST_SIDES);
    double distance = 1;
    for (int k = 0; k < 3; k++) {
        const lim_index a = words[k], b = words[(k + 1) % 3];
        const double side = side_of(&out->vertices[a], &out->vertices[b]);
        distance = fmax(distance, side * fmax(gain_of(texture, &out->uvs[a], &out->uvs[b]) + 2, sides));
    }
    return distance;
}

/* The least that is not nearer; of what is farther than all, 0. */
static lim_index code_of(double distance)
{
    for (int code = CODES - 1; code > 0; code--)
        if (ldexp(2 * STEPS - 1 - code % STEPS, CODES / STEPS - 3 - code / STEPS) >= distance) return (lim_index)code;
    return 0;
}

void encode_even(struct encoding *out)
{
    if (!out->uvs || out->textures.texture_count > LIM_TRIANGLE_TEXTURES) return;
    for (size_t i = 0; i < out->word_count; i += LIM_TRIANGLE_WORDS) {
        lim_index *words = &out->words[i];
        words[3] = (lim_index)(words[3] | code_of(distance_of(out, words)) << LIM_TRIANGLE_TEXTURE_BITS);
    }
}
