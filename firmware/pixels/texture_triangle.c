/* SPDX-License-Identifier: MIT
 *
 * The eye is the origin, and the ray through a pixel is r = (X / w, Y / h, 1), as view space is scaled by the lens.
 * With e and f from corner P to the others, the triangle's plane is n . p = n . P for n = e x f, and a ray meets it at
 * z = n . P / n . r. A place that gains p on the way along e, and q along f, is that of P and (m . r) / (n . r) there,
 *
 *     m = P x (q e - p f):
 *
 * on P itself m . r is 0, and along e it gains p as it should. No product leaves 64 bits, as vectors are shortened to
 * 30 before they are multiplied. That is 2^-29 of what they are, times how much wider the screen is than the triangle.
 */
#include "pixels/texture_triangle.h"

#if LIM_HAS_TEXTURE && LIM_HAS_MESHES

enum { VECTOR_BITS = 30 };

/* A vector times 2^bits. */
struct long_vector {
    int64_t at[3];
    int_fast16_t bits;
};

/* Bits of the largest of them, without a sign. */
static uint_fast8_t vector_bits_of(const int64_t at[3])
{
    const uint64_t all =
        (uint64_t)(at[0] ^ at[0] >> 63) | (uint64_t)(at[1] ^ at[1] >> 63) | (uint64_t)(at[2] ^ at[2] >> 63);
    const uint32_t high = (uint32_t)(all >> 32), low = (uint32_t)all;

    return (uint_fast8_t)(high ? 64 - clz_u32(high) : low ? 32 - clz_u32(low) : 0);
}

/* Until each is below 2^VECTOR_BITS; what is short stays as it is. */
static void vector_shorten(struct long_vector *vector)
{
    const uint_fast8_t bits = vector_bits_of(vector->at);

    if (bits <= VECTOR_BITS) return;
    for (uint_fast8_t i = 0; i < 3; i++)
        vector->at[i] >>= bits - VECTOR_BITS;
    vector->bits = (int_fast16_t)(vector->bits + (int_fast16_t)bits - VECTOR_BITS);
}

/* Of shortened ones. */
static void vector_cross(const struct long_vector *a, const struct long_vector *b, struct long_vector *out)
{
    for (uint_fast8_t i = 0; i < 3; i++) {
        const uint_fast8_t j = lim_axis_after(i), k = lim_axis_after(j);
        out->at[i] = a->at[j] * b->at[k] - a->at[k] * b->at[j];
    }
    out->bits = a->bits + b->bits;
}

/* As planes over the screen, so long that they fill 30 bits three screens wide; both are scaled by the same. Returns
 * by how many bits they are too long. */
static int_fast16_t take_planes(const struct lim_texturing *texturing, const struct long_vector *vectors,
                                uint_fast8_t count, struct lim_texture_plane *planes)
{
    uint_fast8_t most = 0;

    for (uint_fast8_t i = 0; i < count; i++) {
        const uint_fast8_t bits = vector_bits_of(vectors[i].at);
        if (bits > most) most = bits;
    }
    const int_fast16_t down = (int_fast16_t)most - (VECTOR_BITS - 3);
    for (uint_fast8_t i = 0; i < count; i++) {
        int32_t at[3];
        for (uint_fast8_t k = 0; k < 3; k++)
            at[k] = (int32_t)(down >= 0 ? vectors[i].at[k] >> down : vectors[i].at[k] * ((int64_t)1 << -down));
        planes[i] = (struct lim_texture_plane){at[2], at[0] / texturing->w_px, at[1] / texturing->h_px};
    }
    return vectors[0].bits + down;
}

/* log2, of one that is not negative. */
static int32_t log2_long_q4(int64_t x)
{
    const uint32_t high = (uint32_t)((uint64_t)x >> 32);

    if (!high) return log2_q4((uint32_t)x | 1);
    const uint_fast8_t bits = (uint_fast8_t)(32 - clz_u32(high));
    return log2_q4((uint32_t)((uint64_t)x >> bits)) + 16 * (int32_t)bits;
}

/* What all of it is made of. */
struct sides {
    struct long_vector corner, normal, places[2]; /* P, n, m */
    int32_t p[2], q[2];
};

static void set_corner_sides(const struct lim_texture_corner corners[3], struct sides *sides)
{
    struct long_vector e, f, way;

    e.bits = f.bits = sides->corner.bits = 0;
    for (uint_fast8_t i = 0; i < 3; i++) {
        sides->corner.at[i] = corners[0].at.qv[i];
        e.at[i] = (int64_t)corners[1].at.qv[i] - corners[0].at.qv[i];
        f.at[i] = (int64_t)corners[2].at.qv[i] - corners[0].at.qv[i];
    }
    vector_shorten(&sides->corner);
    while (vector_bits_of(e.at) > VECTOR_BITS || vector_bits_of(f.at) > VECTOR_BITS) { /* both alike */
        for (uint_fast8_t i = 0; i < 3; i++)
            e.at[i] >>= 1, f.at[i] >>= 1;
        e.bits = ++f.bits;
    }
    vector_cross(&e, &f, &sides->normal);
    for (uint_fast8_t c = 0; c < 2; c++) {
        sides->p[c] = corners[1].place[c] - corners[0].place[c];
        sides->q[c] = corners[2].place[c] - corners[0].place[c];
        for (uint_fast8_t i = 0; i < 3; i++)
            way.at[i] = e.at[i] * sides->q[c] - f.at[i] * sides->p[c];
        way.bits = e.bits;
        vector_shorten(&way);
        vector_cross(&sides->corner, &way, &sides->places[c]);
    }
    /* Both are scaled alike from here on. */
    const uint_fast8_t less = sides->places[0].bits < sides->places[1].bits ? 0 : 1;
    const int_fast16_t apart = sides->places[less ^ 1].bits - sides->places[less].bits;
    for (uint_fast8_t i = 0; i < 3; i++)
        sides->places[less].at[i] >>= apart;
    sides->places[less].bits += apart;
}

static void vector_turn(struct long_vector *vector)
{
    for (uint_fast8_t i = 0; i < 3; i++)
        vector->at[i] = -vector->at[i];
}

/* n . P of the plane as it is scaled, which is what z times depth is. */
static int64_t height_in(const struct lim_texturing *texturing, const struct lim_texture_plane *depth,
                         const struct long_vector *corner)
{
    return depth->at * corner->at[2] + (int64_t)depth->x * texturing->w_px * corner->at[0] +
           (int64_t)depth->y * texturing->h_px * corner->at[1];
}

/* Half of what the farthest corner has: rounding leaves some pixels outside of the triangle. */
static int32_t least_depth(const struct lim_texture_corner corners[3], int64_t height)
{
    int32_t far_qv = 1;

    for (uint_fast8_t k = 0; k < 3; k++)
        if (corners[k].at.z_qv > far_qv) far_qv = corners[k].at.z_qv;
    const int64_t least = height >> (33 - clz_u32((uint32_t)far_qv));
    return least < 1 ? 1 : least > INT32_C(1) << 29 ? INT32_C(1) << 29 : (int32_t)least;
}

/* From the area of the picture that a pixel shows: (n . P)^2 (p q' - p' q) / (n . r)^3 for each of r. */
static int16_t level_of_sides(const struct lim_texturing *texturing, const LIM_FLASH struct lim_texture *texture,
                              const struct sides *sides, int64_t height, int_fast16_t depth_bits)
{
    int64_t area = (int64_t)sides->p[0] * sides->q[1] - (int64_t)sides->p[1] * sides->q[0];

    if (area < 0) area = -area;
    const int32_t twice_q4 = 2 * (log2_long_q4(height) + 16 * (int32_t)sides->corner.bits) + log2_long_q4(area) -
                             16 * (int32_t)depth_bits + 2 * 16 - log2_q4((uint32_t)texturing->w_px) -
                             log2_q4((uint32_t)texturing->h_px) + 2 * 16 * (texture->w_bits - texture->place_bits);
    const int32_t level_q4 = (twice_q4 >> 1) + MIDDLE_OF_LEVEL_Q4 - 3 * LIM_TEXTURE_LOG2_Q4 / 2;
    return (int16_t)(level_q4 > INT16_MAX ? INT16_MAX : level_q4 < INT16_MIN ? INT16_MIN : level_q4);
}

void lim_texture_set_triangle(const struct lim_texturing *texturing, const LIM_FLASH struct lim_texture *texture,
                              const struct lim_texture_corner corners[3], const struct lim_point *at, uint8_t n,
                              struct lim_gradients *out)
{
    const struct around around = around_points(texturing, at, n);
    struct lim_texture_planes *planes = &out->planes;
    struct sides sides;

    out->texture = texture;
    out->is_even = false;
    set_corner_sides(corners, &sides);
    const int_fast16_t depth_bits = take_planes(texturing, &sides.normal, 1, &planes->depth);
    int64_t height = height_in(texturing, &planes->depth, &sides.corner);
    if (height < 0) {
        vector_turn(&sides.places[0]);
        vector_turn(&sides.places[1]);
        planes->depth = (struct lim_texture_plane){-planes->depth.at, -planes->depth.x, -planes->depth.y};
        height = -height;
    }
    const int_fast16_t place_bits = take_planes(texturing, sides.places, 2, planes->uv);
    const uint_fast8_t up = (uint_fast8_t)(16 - texture->place_bits);
    planes->eye_place = pair_of_lows((uint32_t)corners[0].place[1] << up, (uint32_t)corners[0].place[0] << up);
    planes->depth_min = least_depth(corners, height << sides.corner.bits);
    planes->level_q4 = level_of_sides(texturing, texture, &sides, height, depth_bits);
    lim_texture_settle(texturing, &around, (int8_t)(14 + texture->place_bits - place_bits + depth_bits), out);
}

#endif
