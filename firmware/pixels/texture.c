/* SPDX-License-Identifier: MIT
 *
 * Setting up: per frame the camera's axes, per polygon three planes over the screen. Axes have 30 fraction bits in two
 * limbs and normals 15, so no sum of products leaves 32 bits. The planes are then scaled, each by a
 * power of two, until they fill 30 bits: what rounding a gradient adds up to over half a screen of 240 pixels is 2^-23
 * of the largest depth on the screen. */
#include "pixels/texture.h"

#include "math/fixed.h"
#include "math/orientation.h"

#if LIM_HAS_TEXTURE

enum { PLANE_BITS = 30, MIDDLE_OF_LEVEL_Q4 = 8 };

/* x times 2^bits, rounded. */
static int32_t scaled(int32_t x, int_fast16_t bits)
{
    if (bits >= 0) return (int32_t)((uint32_t)x << bits);
    return bits < -PLANE_BITS ? 0 : (int32_t)shift_round_s64(x, (uint8_t)-bits);
}

/* log2(x) for x >= 1. */
static int16_t log2_q4(uint32_t x)
{
    uint8_t zeros;
    const uint32_t mantissa_q31 = normalise_u32(x, &zeros);

    return (int16_t)(LIM_TEXTURE_LOG2_Q4 + (int16_t)(mantissa_q31 >> 27) - zeros * 16);
}

/* Once a frame ------------------------------------------------------------------------------------- */

static void texture_set_axes(struct lim_texturing *texturing, const struct lim_camera *camera)
{
    int32_t axes_q30[9];

    lim_orientation_set(axes_q30, camera);
    for (uint_fast8_t i = 0; i < 9; i++) {
        struct lim_texture_axis *axis = &texturing->axes[i / 3];
        const int32_t high_q15 = shift_round_s32(axes_q30[i], 15);
        axis->high_q15[i % 3] = high_q15;
        axis->low_q30[i % 3] = axes_q30[i] - high_q15 * 32768;
    }
}

/* tan / side. Both mantissas are cut, by 2^-21 at most: the texture is that much too narrow, a 4000th of a pixel. */
static void set_tangent(struct lim_texturing *texturing, uint_fast8_t i, uint32_t tan_q28, int16_t side_px)
{
    uint8_t zeros, more;
    const uint32_t quotient = normalise_u32(tan_q28, &zeros) / (uint16_t)side_px;

    texturing->tan_q28[i] = tan_q28;
    texturing->tan_a_px[i] = (int32_t)(normalise_u32(quotient, &more) >> 1);
    texturing->tan_a_px_bits[i] = (int8_t)(zeros + more - 4);
}

void lim_texture_begin(struct lim_texturing *texturing, const struct lim_scene *scene, const struct lim_view *view,
                       const struct lim_camera *camera)
{
    texturing->scene = scene;
    texturing->w_px = (int16_t)view->width.px;
    texturing->h_px = (int16_t)view->height.px;
    texturing->far_bits = (uint8_t)(32 - clz_u32(view->rows.far_units));
    for (uint_fast8_t i = 0; i < 3; i++)
        texturing->eye_q8[i] = camera->eye_q8[i];
    texture_set_axes(texturing, camera);
    set_tangent(texturing, 0, camera->tan_x_q28, texturing->w_px);
    set_tangent(texturing, 1, camera->tan_y_q28, texturing->h_px);
    /* log2 of a pixel's side at depth 1, the mean of both: 2 tan / side. */
    const int16_t sum_q4 = (int16_t)(log2_q4(camera->tan_x_q28) + log2_q4(camera->tan_y_q28) -
                                     log2_q4((uint32_t)texturing->w_px) - log2_q4((uint32_t)texturing->h_px));
    texturing->level_q4 = (int16_t)((sum_q4 >> 1) - 27 * 16);
}

/* Once a polygon ----------------------------------------------------------------------------------- */

/* |n[0]| + |n[1]| + |n[2]| <= 32767: below 2^30 with both limbs. */
static int32_t dot_q15(const int16_t n[3], const struct lim_texture_axis *axis)
{
    int32_t high = 0, low = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
        high += n[i] * axis->high_q15[i];
        low += n[i] * axis->low_q30[i];
    }
    return high + (low >> 15);
}

static int64_t dot_eye_q8(const int16_t n[3], const int32_t eye_q8[3])
{
    return (int64_t)n[0] * eye_q8[0] + (int64_t)n[1] * eye_q8[1] + (int64_t)n[2] * eye_q8[2];
}

/* (a b) / 2^32 of numbers without a sign, b < 2^31, and at least that much. */
static uint32_t bound_of(int32_t a, uint32_t b)
{
    return (uint32_t)mul_high_s32((int32_t)abs_s32(a), (int32_t)b) + 1;
}

/* n . D, times 2^15 and times what fills PLANE_BITS: returns how many bits that is. */
static int8_t texture_set_plane(const struct lim_texturing *texturing, const int16_t n[3],
                                struct lim_texture_plane *out)
{
    const int32_t right = dot_q15(n, &texturing->axes[0]), down = dot_q15(n, &texturing->axes[1]);
    const int32_t ahead = dot_q15(n, &texturing->axes[2]);
    /* A 16th of the largest value: X goes twice as far as the screen. Tangents have 28 bits, and 4 more make 32. */
    const uint32_t most_q11 =
        (abs_s32(ahead) >> 4) + 1 + bound_of(right, texturing->tan_q28[0]) * 2 + bound_of(down, texturing->tan_q28[1]);
    const int8_t bits = (int8_t)(clz_u32(most_q11) - (32 - PLANE_BITS + 4));

    out->at = scaled(ahead, bits);
    out->x = scaled(mul_high_s32(right * 2, texturing->tan_a_px[0]), bits - texturing->tan_a_px_bits[0]);
    out->y = scaled(mul_high_s32(down * 2, texturing->tan_a_px[1]), bits - texturing->tan_a_px_bits[1]);
    return bits;
}

/* The eye's distance from the mapping's plane, in the length of its normal: h = mantissa 2^bits, mantissa of 30 bits.
 */
struct height {
    int32_t mantissa;
    int8_t bits;
};

static struct height height_of(int64_t h_q8)
{
    struct height height = {0, 0};

    while (h_q8 > INT32_MAX) {
        h_q8 >>= 1;
        height.bits++;
    }
    uint8_t zeros;
    height.mantissa = (int32_t)(normalise_u32((uint32_t)h_q8, &zeros) >> 1);
    height.bits = (int8_t)(height.bits + 1 - zeros);
    return height;
}

static void times(struct lim_texture_plane *plane, int32_t by_q31)
{
    plane->at = mul_high_s32(plane->at * 2, by_q31);
    plane->x = mul_high_s32(plane->x * 2, by_q31);
    plane->y = mul_high_s32(plane->y * 2, by_q31);
}

static void negate(struct lim_texture_plane *plane)
{
    plane->at = -plane->at;
    plane->x = -plane->x;
    plane->y = -plane->y;
}

/* Depth at 2^far_bits units: h / 2^far_bits, in the format of `depth`. Rounding leaves some pixels outside of their
 * polygon, and there the depth may be anything; no smaller one is ever divided by. */
static int32_t depth_min_of(struct height height, int8_t depth_bits, uint8_t far_bits)
{
    const int_fast16_t bits = (int_fast16_t)(height.bits + 7 + depth_bits - far_bits);
    const int32_t least = bits >= 0 ? INT32_C(1) << 29 : scaled(height.mantissa, bits);

    return least < 1 ? 1 : least > INT32_C(1) << 29 ? INT32_C(1) << 29 : least;
}

static uint32_t eye_texel_q16(int64_t sum_q8, uint8_t bits, int32_t at_zero_q16)
{
    const uint64_t sum = bits >= 8 ? (uint64_t)(sum_q8 >> (bits - 8)) : (uint64_t)sum_q8 << (8 - bits);

    return (uint32_t)sum + (uint32_t)at_zero_q16;
}

/* An eye in the plane itself sees nothing of it; with rounding perhaps a line of pixels, whose texels are as good as
 * any. */
static int64_t height_q8(const struct lim_texturing *texturing, const struct lim_mapping *mapping)
{
    const int64_t h_q8 = mapping->d * INT64_C(256) - dot_eye_q8(mapping->n, texturing->eye_q8);

    return h_q8 ? h_q8 : 1;
}

void lim_texture_set(const struct lim_texturing *texturing, uint16_t word, struct lim_gradients *out)
{
    const LIM_FLASH lim_index *words = &texturing->scene->polygons[word];
    const struct lim_mapping mapping = texturing->scene->mappings[words[1]];
    const int64_t h_q8 = height_q8(texturing, &mapping);
    const struct height height = height_of(h_q8 < 0 ? -h_q8 : h_q8);
    const int8_t depth_bits = texture_set_plane(texturing, mapping.n, &out->depth);

    out->texture = texturing->scene->textures[words[0]];
    if (h_q8 < 0) negate(&out->depth);
    for (uint_fast8_t i = 0; i < 2; i++) {
        const int8_t bits = texture_set_plane(texturing, mapping.uv[i], &out->uv[i]);
        times(&out->uv[i], height.mantissa);
        out->shift[i] = (int8_t)(23 - 32 + bits + mapping.bits[i] - height.bits - depth_bits);
        out->eye_uv_q16[i] =
            eye_texel_q16(dot_eye_q8(mapping.uv[i], texturing->eye_q8), mapping.bits[i], mapping.at_zero_q16[i]);
    }
    out->depth_min = depth_min_of(height, depth_bits, texturing->far_bits);
    out->level_q4 =
        (int16_t)(mapping.level_q4 + texturing->level_q4 + log2_q4((uint32_t)height.mantissa) + 16 * height.bits +
                  (29 * 16 + 3 * 16 * depth_bits) / 2 + MIDDLE_OF_LEVEL_Q4 - 3 * LIM_TEXTURE_LOG2_Q4 / 2);
}

#endif
