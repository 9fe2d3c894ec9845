/* SPDX-License-Identifier: MIT
 *
 * TEXTURE: which texel a pixel of a textured polygon shows. In: the camera, once a frame; a record's mapping, once
 * a polygon; a span. Out: the span's pixels. Memory: the caller's structs.
 *
 * A mapping is affine in space: u = a . p + b on the plane n . p = d. The ray through a pixel is eye + z D with D
 * affine on the screen, so it meets the plane at z = h / (n . D), where h = d - n . eye, and shows
 *
 *     u = (a . eye + b) + h (a . D) / (n . D):
 *
 * two affine functions of the screen and a division. Vertices, clipping and splits have no part in it, so
 * polygons of one mapping agree wherever they meet.
 *
 * Between divisions texels are taken along a straight line, as far as that is off by no more than LIM_TEXTURE_OFF: over
 * all of a polygon that is small or that the eye sees from the front, else over a stretch of a line. */
#ifndef LIM_TEXTURE_H
#define LIM_TEXTURE_H

#include "camera.h"
#include "math/fixed.h"
#include "pixels/texels.h"
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

/* A line of a polygon, stretch by stretch: from pixel x to the one before `end` texels advance evenly. */
struct lim_texture_line {
    const struct lim_texturing *texturing;
    struct lim_gradients *gradients;      /* their level is that of the stretch */
    struct lim_texture_walk walk;         /* from pixel x on */
    int32_t x, end, right;                /* right: the pixel behind the line's last */
    int32_t depth, uv[2];                 /* the planes where the next stretch begins, or the first one */
    int32_t depth_step, uv_step[2], bend; /* what a stretch adds to them; the first again, or 0 of a single pixel */
    uint32_t seen_depth, at_q16[2];       /* there; no less than depth_min */
    int32_t n_px;                         /* of a stretch, of which the line may have less: */
    uint32_t bits;                        /* 2^bits */
    uint16_t divisions;                   /* so far */
};

/* Once a frame, after lim_view_begin(). */
void lim_texture_begin(struct lim_texturing *texturing, const struct lim_scene *scene, const struct lim_view *view,
                       const struct lim_camera *camera);

/* Once a polygon; its record names texture and mapping at this word of lim_scene.polygons. `at`: its n corners on the
 * screen; none of a piece, whose lines alone are known. */
void lim_texture_set(const struct lim_texturing *texturing, uint16_t word, const struct lim_point *at, uint8_t n,
                     struct lim_gradients *out);

/* A level of a texture; and of a polygon's that of a depth, with all the depths that have it. */
void lim_texture_set_level(const struct lim_scene *scene, const LIM_FLASH struct lim_texture *texture, uint8_t number,
                           struct lim_texture_level *level);
void lim_texture_suit_level(const struct lim_scene *scene, struct lim_gradients *gradients, uint32_t depth);

/* 1 / depth as r * 2^(zeros - 62). In draft and fast r has 15 bits, as good as x / z has: texels are off by 2^-15 of
 * their distance from where the eye looks, which is a screen's width of texels. */
static inline int32_t lim_texture_reciprocal(uint32_t depth, uint8_t *zeros)
{
    if (LIM_HAS_LIMBS) return (int32_t)recip_q31_of(depth, zeros);
    return (int32_t)((recip_q24(depth, zeros) >> 9) * 65536);
}

/* floor(x r / 2^32) of such a reciprocal. */
static inline int32_t lim_texture_times(int32_t x, int32_t recip_q31)
{
    return LIM_HAS_LIMBS ? mul_high_s32(x, recip_q31) : mul_s32_top(x, recip_q31);
}

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

/* How long a stretch may be where nothing is farther away than this, where texels are closest together. None comes to
 * less than half of the depth. */
static LIM_IN_EACH_CALLER uint32_t lim_texture_stretch_bits(const struct lim_gradients *gradients, int32_t far_depth)
{
    const struct lim_texture_planes *planes = &gradients->planes;
    const LIM_FLASH struct lim_texture *texture = gradients->texture;
    const uint32_t depth = (uint32_t)(far_depth < planes->depth_min ? planes->depth_min : far_depth);
    const uint8_t zeros = clz_u32(depth);
    const int32_t level_q4 = lim_texture_level_q4(planes->level_q4, depth, zeros), last_q4 = (texture->levels - 1) * 16;
    const int32_t shown_q4 = level_q4 < 0 ? 0 : lim_texture_lesser(level_q4, last_q4);
    int32_t bits = (planes->even_q4 - 2 * level_q4 + shown_q4) >> 5;

    bits = lim_texture_lesser(bits, LIM_TEXTURE_MOST_BITS - texture->w_bits);
    bits = lim_texture_lesser(bits, gradients->slope_zeros - zeros - 3);
    return (uint32_t)(bits < 0 ? 0 : bits);
}

/* A line of a textured polygon: pixels left <= x < right, before anything is cut off. */
struct lim_textured_span {
    const struct lim_texturing *texturing;
    struct lim_gradients *gradients;
    int16_t y, left, right;
};

/* The stretch of the line that pixel x is in, left <= x < right, on the screen; the next one. Stretches begin at left,
 * or the screen's side, whatever of the line is visible: all orders of drawing paint the same. */
void lim_texture_line_begin(struct lim_texture_line *line, const struct lim_textured_span *span, int16_t x);
void lim_texture_line_next(struct lim_texture_line *line);

/* The place that pixel x of the stretch shows. */
static inline uint32_t lim_texture_place(const struct lim_texture_line *line, int32_t x)
{
    return line->walk.place + line->walk.step * (uint32_t)(x - line->x);
}

/* Of a polygon that is even all over. */
static inline struct lim_texture_walk lim_texture_even_walk(const struct lim_texture_even *even, int32_t x, int32_t y)
{
    return (struct lim_texture_walk){even->place + even->x * (uint32_t)x + even->y * (uint32_t)y, even->x};
}

/* Paints pixels x0 <= x < x1 of it. */
void lim_texture_fill(const struct lim_textured_span *span, uint16_t *pixels, uint16_t x0, uint16_t x1,
                      struct lim_stats *stats);

#endif
