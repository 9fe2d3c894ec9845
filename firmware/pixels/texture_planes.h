/* SPDX-License-Identifier: MIT
 *
 * What textured polygons take, whether their records name a mapping (texture.c) or their corners have places
 * (texture_triangle.c): arithmetic, levels of detail, and what follows from planes over the screen. */
#ifndef LIM_TEXTURE_PLANES_H
#define LIM_TEXTURE_PLANES_H

#include "math/fixed.h"
#include "math/pair.h"
#include "stages.h"

/* By how much straight lines may leave the curve of texels, in 2^-LIM_TEXTURE_OFF_BITS of a texel of the level shown.
 * And how many bits of a place are left below a texel's, where places are added up pixel by pixel. */
#if LIM_PROFILE == LIM_PROFILE_DRAFT
#define LIM_TEXTURE_OFF_BITS 0
#elif LIM_PROFILE == LIM_PROFILE_FAST
#define LIM_TEXTURE_OFF_BITS 2
#elif LIM_PROFILE == LIM_PROFILE_FINE
#define LIM_TEXTURE_OFF_BITS 4
#else
#define LIM_TEXTURE_OFF_BITS 6
#endif

/* log2(x) of x = mantissa 2^-zeros, 2^31 <= mantissa < 2^32, in 16ths, is mantissa / 2^27 - 16 zeros and this, straight
 * between the powers of two: at most 1.4 sixteenths short. */
enum { LIM_TEXTURE_LOG2_Q4 = 30 * 16 };

/* 1 / depth as r * 2^(zeros - 62). In draft and fast r has 15 bits, as good as x / z has: texels are off by 2^-15 of
 * their distance from where the eye looks, which is a screen's width of texels. */
static inline int32_t lim_texture_reciprocal(uint32_t depth, uint8_t *zeros)
{
    if (LIM_HAS_LIMBS) return (int32_t)recip_q31_of(depth, zeros);
    return (int32_t)((recip_q24(depth, zeros) >> 9) * 65536);
}

/* As normalise_u32(), for what is seldom below 2^24. */
static inline uint32_t normalise_depth(uint32_t depth, uint32_t *zeros)
{
    uint32_t n = 0;

    if (LIM_HAS_CLZ) {
        *zeros = clz_u32(depth);
        return depth << *zeros;
    }
    for (; LIM_UNLIKELY(!(depth >> 24)); depth <<= 8)
        n += 8;
    if (!(depth >> 28)) {
        n += 4;
        depth <<= 4;
    }
    if (!(depth >> 30)) {
        n += 2;
        depth <<= 2;
    }
    if (!(depth >> 31)) {
        n++;
        depth <<= 1;
    }
    *zeros = n;
    return depth;
}

/* As recip_mantissa_q24(), whose table's entry GCC would find twice. */
static inline uint32_t recip_of_depth_q24(uint32_t mantissa_q31)
{
    if (!LIM_WRITTEN_THUMB || !LIM_RECIP_TABLE) return recip_mantissa_q24(mantissa_q31);
    const LIM_FLASH uint16_t *entry_q16 = &lim_recip_table_q16[mantissa_q31 << 1 >> 24];
    FOUND_FROM(entry_q16);
    const uint32_t left_q16 = entry_q16[0], fall_q16 = left_q16 - entry_q16[1];

    return (left_q16 << 8) - fall_q16 * (mantissa_q31 << 9 >> 24);
}

/* The same as lim_texture_reciprocal() for lim_texture_part() alone: which of its lower bits are set does not matter.
 */
static inline int32_t lim_texture_reciprocal_part(uint32_t depth, uint32_t *zeros)
{
    uint8_t shift;

    if (!LIM_HAS_LIMBS) return (int32_t)(recip_of_depth_q24(normalise_depth(depth, zeros)) << 7);
    const int32_t recip_q31 = (int32_t)recip_q31_of(depth, &shift);
    *zeros = shift;
    return recip_q31;
}

/* floor(x r / 2^32) of such a reciprocal. */
static inline int32_t lim_texture_times(int32_t x, int32_t recip_q31)
{
    return LIM_HAS_LIMBS ? mul_high_s32(x, recip_q31) : mul_s32_top(x, recip_q31);
}

/* lim_texture_part(): floor(x y / 2^32), of whose y draft and fast take the upper 16 bits. lim_texture_plus_part():
 * that and a. lim_texture_not_negative(): x or 0, for |x| < 32. lim_texture_square(): of the upper half. */
#if LIM_DUAL_MULTIPLY && defined(__arm__)

static inline int32_t lim_texture_not_negative(int32_t x)
{
    int32_t positive;

    __asm__("usat %0, #5, %1" : "=r"(positive) : "r"(x));
    return positive;
}

static inline int32_t lim_texture_square(int32_t x)
{
    int32_t square;

    __asm__("smultt %0, %1, %1" : "=r"(square) : "r"(x));
    return square;
}

static inline int32_t lim_texture_part(int32_t x, int32_t y)
{
    int32_t product;

    if (LIM_HAS_LIMBS) return mul_high_s32(x, y);
    __asm__("smulwt %0, %1, %2" : "=r"(product) : "r"(x), "r"(y));
    return product;
}

static inline int32_t lim_texture_plus_part(int32_t a, int32_t x, int32_t y)
{
    int32_t sum;

    if (LIM_HAS_LIMBS) return (int32_t)((uint32_t)a + (uint32_t)mul_high_s32(x, y));
    __asm__("smlawt %0, %1, %2, %3" : "=r"(sum) : "r"(x), "r"(y), "r"(a));
    return sum;
}

#else

static inline int32_t lim_texture_not_negative(int32_t x)
{
    return x & ~(x >> 31);
}

static inline int32_t lim_texture_square(int32_t x)
{
    return (x >> 16) * (x >> 16);
}

static inline int32_t lim_texture_part(int32_t x, int32_t y)
{
    if (LIM_HAS_LIMBS) return mul_high_s32(x, y);
    if (LIM_LONG_MULTIPLY) return mul_high_s32(x, (int32_t)((uint32_t)y & ~UINT32_C(0xFFFF)));
    return (x >> 16) * (y >> 16) + ((int32_t)LOW_16(x) * (y >> 16) >> 16);
}

static inline int32_t lim_texture_plus_part(int32_t a, int32_t x, int32_t y)
{
    return (int32_t)((uint32_t)a + (uint32_t)lim_texture_part(x, y));
}

#endif

/* h / depth, doubled, for lim_texture_times(). */
static inline int32_t lim_texture_h_recip(int32_t h_mantissa, int32_t recip_q31)
{
    const int32_t product = mul_high_s32(h_mantissa, recip_q31) * 2;

    return LIM_HAS_LIMBS ? product : (int32_t)((uint32_t)product & ~UINT32_C(0xFFFF));
}

/* u and v in one word: v carries over to u, by a 2^-16 of the side. */
static inline uint32_t lim_texture_packed(uint32_t u_q16, uint32_t v_q16)
{
    return (u_q16 << 16) + v_q16;
}

/* x / 2^bits; what leaves 32 bits to the left are whole turns of the texture, or texels finer than any pixel. */
static inline uint32_t lim_texture_shifted(int32_t x, int_fast16_t bits)
{
    if (bits >= 0) return (uint32_t)(x >> (bits < 31 ? bits : 31));
    return bits > -32 ? (uint32_t)x << -bits : 0;
}

/* The level of a depth, in 16ths: log2(depth) is that of the mantissa and its shift, which a reciprocal has found
 * already. */
static inline int16_t lim_texture_level_q4(int16_t level_q4, uint32_t depth, uint8_t zeros)
{
    const int32_t log2_q4 = (int32_t)(depth << zeros >> 27) - zeros * 16;

    return (int16_t)(level_q4 - (3 * log2_q4 >> 1));
}

static inline uint8_t lim_texture_level_of(int16_t level_q4, uint8_t levels)
{
    return (uint8_t)(level_q4 < 0 ? 0 : level_q4 >> 4 < levels ? level_q4 >> 4 : levels - 1);
}

static inline int32_t lim_texture_lesser(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

/* The longest stretches are so short that steps, which are rounded to 2^-16 of the picture's side, take texels no
 * farther away than curves do. */
enum { LIM_TEXTURE_MOST_BITS = 16 - LIM_TEXTURE_OFF_BITS };

/* How long a stretch may be where nothing is farther away than this, where texels are closest together: 2^(pace / 2)
 * pixels; if pace is odd only its halves may be even. None comes to less than half of the depth. */
uint32_t lim_texture_pace(const struct lim_gradients *gradients, int32_t far_depth);

/* A level of a polygon's texture, which is set; and that of a depth, with all depths that have it. */
void lim_texture_set_level(const struct lim_scene *scene, uint8_t number, struct lim_gradients *gradients);
void lim_texture_suit_level(const struct lim_scene *scene, struct lim_gradients *gradients, uint32_t depth);

enum { MIDDLE_OF_LEVEL_Q4 = 8 };

/* log2(x) for x >= 1. */
static inline int16_t log2_q4(uint32_t x)
{
    uint8_t zeros;
    const uint32_t mantissa_q31 = normalise_u32(x, &zeros);

    return (int16_t)(LIM_TEXTURE_LOG2_Q4 + (int16_t)(mantissa_q31 >> 27) - zeros * 16);
}

static inline int32_t plane_at(const struct lim_texture_plane *plane, int32_t x, int32_t y)
{
    return plane->at + plane->x * x + plane->y * y;
}

/* The pixels of the screen around a polygon: their middle, and how far they reach from there. */
struct around {
    int32_t x, y, w, h;
};

static inline void middle_of(int32_t least, int32_t most, int16_t side_px, int32_t *middle, int32_t *reach)
{
    int32_t from = (least >> LIM_SUB_BITS) + LIM_ORIGIN_PX, to = (most >> LIM_SUB_BITS) + LIM_ORIGIN_PX + 1;

    if (from < 0) from = 0;
    if (to > side_px) to = side_px;
    *middle = (from + to) >> 1;
    *reach = ((to - from) >> 1) + 1;
}

static inline struct around around_points(const struct lim_texturing *texturing, const struct lim_point *at, uint8_t n)
{
    struct around around;

    if (!n) {
        const int32_t w = texturing->w_px >> 1, h = texturing->h_px >> 1;
        return (struct around){w, h, w + 1, h + 1};
    }
    int32_t left = at->x, right = left, top = at->y, bottom = top;
    while (--n) {
        const int32_t x = (++at)->x, y = at->y;
        if (x < left) left = x;
        if (x > right) right = x;
        if (y < top) top = y;
        if (y > bottom) bottom = y;
    }
    middle_of(left, right, texturing->w_px, &around.x, &around.w);
    middle_of(top, bottom, texturing->h_px, &around.y, &around.h);
    return around;
}

/* How far from that of the middle the depth of any pixel is. */
static inline int32_t depth_range(const struct lim_texture_plane *depth, const struct around *around)
{
    return ((int32_t)abs_s32(depth->x) * around->w + (int32_t)abs_s32(depth->y) * around->h) * 2;
}

/* Planes, their depth_min and their level are set, and texels are the places' planes / depth * 2^(30 - shift): all else
 * of the perspective follows. */
void lim_texture_settle(const struct lim_texturing *texturing, const struct around *around, int8_t shift,
                        struct lim_gradients *out);

#endif
