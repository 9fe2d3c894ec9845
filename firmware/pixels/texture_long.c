/* SPDX-License-Identifier: MIT
 *
 * What texture.c sees of a polygon, in a scene whose coordinates have 32 bits.
 *
 * With p the point that a ray from the eye e meets, and v the plane's vertex, u = a . (p - v) + b = (a . (e - v) + b) +
 * a . (p - e). What is in brackets is the place at the eye, which may be a million pictures away from v: it is exact,
 * in 64 bits. The other way is in view, a screen's width or so of the texels shown, and so is what n . D has to tell:
 * in profiles without limbs 16 bits of a and n do for both, as in a scene of 16 bits, and in others as many as planes
 * have. Where the plane is must be exact again: h = n . (v - e) + rest, in 64 bits. All else is as in a scene of 16
 * bits.
 *
 * n, whose longest component is 2^30 or near that, and a, which LIM_LONG_UV_MAX bounds, are below 2^31 in length, so
 * their products with an axis are below 2^61, and planes, which have 31 bits less, below 2^30. */
#include "pixels/texture_seen.h"

#include "eye.h"

#if LIM_HAS_TEXTURE && LIM_HAS_LONG

enum { HALF_BITS = 16 };                  /* what upper halves lack, and planes in any profile */
#define LONG_UPRIGHT_N (INT32_C(1) << 30) /* how long the normal of an axis plane is taken to be */

static inline int32_t whole_product(const int32_t n[3], const struct lim_texture_axis *axis)
{
    int64_t sum = 0;

    LIM_UNROLLED(3)
    for (uint_fast8_t i = 0; i < 3; i++)
        sum += (int64_t)n[i] * (axis->high_q14[i] * INT32_C(65536) + axis->low_q30[i]);
    return (int32_t)(sum >> 31);
}

static inline struct lim_texture_plane long_plane(const struct lim_texturing *texturing, const int32_t n[3])
{
    const struct lim_texture_axis *axes = texturing->axes;
    int16_t halves[3];

    if (LIM_HAS_LIMBS)
        return (struct lim_texture_plane){whole_product(n, &axes[2]), whole_product(n, &axes[0]),
                                          whole_product(n, &axes[1])};
    for (uint_fast8_t i = 0; i < 3; i++)
        halves[i] = (int16_t)((n[i] + 0x8000) >> HALF_BITS);
    return (struct lim_texture_plane){normal_q15(halves, &axes[2]), normal_q15(halves, &axes[0]),
                                      normal_q15(halves, &axes[1])};
}

/* |h| < 2^63. What is below a unit of it counts for nothing where n is as long as it should be. */
static inline struct height height_of_long(int64_t h)
{
    const uint64_t size = h < 0 ? 0 - (uint64_t)h : (uint64_t)h;
    struct height height = height_of_words((uint32_t)(size >> 32), (uint32_t)size, h < 0);

    height.bits = (int8_t)(height.bits + 8 - HALF_BITS);
    return height;
}

/* Where the mapping's plane is. Returns the vertex by which it goes. */
static const LIM_FLASH struct lim_long_vertex *see_plane(const struct lim_texturing *texturing,
                                                         const LIM_FLASH struct lim_mapping *mapping, struct seen *seen)
{
    const struct lim_long_eye *eye = texturing->far;
    const struct lim_long *all = lim_scene_long(texturing->scene);
    const LIM_FLASH struct lim_long_vertex *vertex;
    int32_t n[3] = {0, 0, 0};
    int64_t h;

    if (mapping->scale & LIM_MAPPING_UPRIGHT) {
        const uint_fast8_t axis = mapping->scale >> LIM_MAPPING_AXIS_SHIFT;
        vertex = &all->vertices[mapping->plane];
        n[axis] = LONG_UPRIGHT_N;
        h = ((vertex->at[axis] - eye->at[axis]) * INT64_C(256) - eye->fraction_q8[axis]) * (LONG_UPRIGHT_N / 256);
    } else {
        const LIM_FLASH struct lim_long_plane *plane = &all->planes[mapping->plane];
        uint8_t fraction_q8;
        vertex = &all->vertices[plane->vertex];
        for (uint_fast8_t i = 0; i < 3; i++)
            n[i] = plane->n[i];
        h = -lim_eye_long_value(eye, plane, vertex, &fraction_q8);
    }
    seen->height = height_of_long(h);
    seen->depth = long_plane(texturing, n);
    if (seen->height.behind) negate(&seen->depth);
    seen->depth_bits = fill_bits(texturing, &seen->depth, 1);
    return vertex;
}

void lim_texture_see_long(const struct lim_texturing *texturing, uint16_t number, struct seen *seen)
{
    const struct lim_long_eye *eye = texturing->far;
    const LIM_FLASH struct lim_mapping *mapping = &texturing->scene->mappings[number];
    const LIM_FLASH struct lim_long_mapping *places = &lim_scene_long(texturing->scene)->mappings[number];
    const LIM_FLASH struct lim_long_vertex *vertex = see_plane(texturing, mapping, seen);
    const uint_fast8_t j = lim_axis_after(mapping->scale >> LIM_MAPPING_AXIS_SHIFT), k = lim_axis_after(j);
    const int32_t way_j = eye->at[j] - vertex->at[j], way_k = eye->at[k] - vertex->at[k];

    for (uint_fast8_t i = 0; i < 2; i++) {
        const int32_t a_j = places->uv[i][0], a_k = places->uv[i][1];
        int32_t a[3] = {0, 0, 0};
        a[j] = a_j;
        a[k] = a_k;
        seen->uv[i] = long_plane(texturing, a);
        const int64_t part_q8 = (int64_t)a_j * eye->fraction_q8[j] + (int64_t)a_k * eye->fraction_q8[k];
        const int64_t place = (int64_t)a_j * way_j + (int64_t)a_k * way_k + (part_q8 >> 8);
        seen->eye_uv_q16[i] = mapping->at_zero_q16[i] + (uint32_t)(place >> (places->bits - 16));
    }
    const int8_t uv_bits = fill_bits(texturing, seen->uv, 2);
    seen->shift = (int8_t)(places->bits - HALF_BITS + uv_bits - seen->depth_bits - seen->height.bits - 9);
    seen->level_q4 =
        (int16_t)(places->level_q4 + 7 * 16 + texturing->level_q4 + log2_q4((uint32_t)seen->height.mantissa) +
                  16 * seen->height.bits + (29 * 16 + 3 * 16 * seen->depth_bits) / 2 + MIDDLE_OF_LEVEL_Q4 -
                  3 * LIM_TEXTURE_LOG2_Q4 /
                      2); /* as in see() of texture.c: one piece for both makes that 48 bytes longer */
}

#endif
