/* SPDX-License-Identifier: MIT
 *
 * Painting: a division every so many pixels of a line, texels along a straight line in between. */
#include "pixels/texture.h"

#include "math/fixed.h"

#if LIM_HAS_TEXTURE

enum { STEP_PX = 1 << LIM_TEXTURE_STEP_BITS, TEXEL_BLOCK = LIM_TEXEL_BLOCK };

/* x / 2^bits; what leaves 32 bits to the left are whole turns of the texture, or texels finer than any pixel. */
static uint32_t shifted(int32_t x, int_fast16_t bits)
{
    if (bits >= 0) return (uint32_t)(x >> (bits < 31 ? bits : 31));
    return bits > -32 ? (uint32_t)x << -bits : 0;
}

/* 1 / depth as r * 2^(zeros - 62). In draft and fast r has 15 bits, as good as x / z has: texels are off by 2^-15 of
 * their distance from where the eye looks, which is a screen's width of texels. */
static inline int32_t reciprocal(uint32_t depth, uint8_t *zeros)
{
    if (LIM_HAS_LIMBS) return (int32_t)recip_q31_of(depth, zeros);
    return (int32_t)((recip_q24(depth, zeros) >> 9) * 65536);
}

static inline int32_t times_reciprocal(int32_t x, int32_t recip_q31)
{
    return LIM_HAS_LIMBS ? mul_high_s32(x, recip_q31) : mul_s32_top(x, recip_q31);
}

/* log2(depth) is that of the mantissa and its shift: the reciprocal has found both already. */
static inline uint8_t level_of(const struct lim_gradients *gradients, uint32_t depth, uint8_t zeros)
{
    const int32_t log2_q4 = (int32_t)(depth << zeros >> 27) - zeros * 16;
    const int32_t level = (gradients->level_q4 - (3 * log2_q4 >> 1)) >> 4;
    const int32_t last = gradients->texture.levels - 1;

    return (uint8_t)(level < 0 ? 0 : level > last ? last : level);
}

static void sample(struct lim_texture_line *line, int16_t x_px, struct lim_texel *out)
{
    const struct lim_gradients *gradients = line->gradients;
    const int32_t x = 2 * (int32_t)x_px + 1 - line->w_px;
    const int32_t sum = line->depth + gradients->depth.x * x;
    const uint32_t depth = (uint32_t)(sum < gradients->depth_min ? gradients->depth_min : sum);
    uint8_t zeros;
    const int32_t recip_q31 = reciprocal(depth, &zeros);

    LIM_UNROLLED(2)
    for (uint_fast8_t i = 0; i < 2; i++) {
        const int32_t product = times_reciprocal(line->uv[i] + gradients->uv[i].x * x, recip_q31);
        out->uv_q16[i] = gradients->eye_uv_q16[i] + shifted(product, (int_fast16_t)(gradients->shift[i] - zeros));
    }
    out->level = level_of(gradients, depth, zeros);
    if (LIM_HAS_STATS) line->divisions++;
}

#if LIM_TEXTURE_STEP_BITS <= 4
/* 2^15 / n, rounded down. */
static const LIM_FLASH uint16_t shares_q15[16] = {0,    0,    16384, 10922, 8192, 6553, 5461, 4681,
                                                  4096, 3640, 3276,  2978,  2730, 2520, 2340, 2184};
#endif

/* way / n for 2 <= n, rounded down. */
static inline int32_t share(int32_t way_q16, int_fast16_t n)
{
#if LIM_TEXTURE_STEP_BITS <= 4
    return mul_s32_top(way_q16, (int32_t)shares_q15[n] * 65536) * 2;
#else
    uint8_t zeros;
    const uint32_t recip_q31 = recip_q31_of((uint32_t)n, &zeros);

    return mul_high_s32(way_q16, (int32_t)recip_q31) >> (30 - zeros);
#endif
}

/* A whole stretch from `at` on, or what is left up to the line's last pixel. */
static void stretch(struct lim_texture_line *line)
{
    const int_fast16_t left_px = line->right - line->x;
    const bool is_whole = left_px > STEP_PX;
    const int_fast16_t way_px = is_whole ? STEP_PX : left_px - 1;

    line->end = (int16_t)(line->x + (is_whole ? STEP_PX : left_px));
    if (way_px)
        sample(line, (int16_t)(line->x + way_px), &line->to);
    else
        line->to = line->at;
    LIM_UNROLLED(2)
    for (uint_fast8_t i = 0; i < 2; i++) {
        const int32_t way_q16 = (int32_t)(line->to.uv_q16[i] - line->at.uv_q16[i]);
        line->step_q16[i] = is_whole ? way_q16 >> LIM_TEXTURE_STEP_BITS : way_px > 1 ? share(way_q16, way_px) : way_q16;
    }
    line->level = line->at.level < line->to.level ? line->at.level : line->to.level;
}

void lim_texture_line_begin(struct lim_texture_line *line, const struct lim_textured_span *span, int16_t x)
{
    const struct lim_gradients *gradients = span->gradients;
    const int32_t y = 2 * (int32_t)span->y + 1 - span->texturing->h_px;

    line->gradients = gradients;
    line->w_px = span->texturing->w_px;
    line->right = span->right;
    line->divisions = 0;
    line->depth = gradients->depth.at + gradients->depth.y * y;
    for (uint_fast8_t i = 0; i < 2; i++)
        line->uv[i] = gradients->uv[i].at + gradients->uv[i].y * y;
    line->x = (int16_t)(span->left + (x - span->left) / STEP_PX * STEP_PX);
    sample(line, line->x, &line->at);
    stretch(line);
}

void lim_texture_line_next(struct lim_texture_line *line)
{
    line->x = line->end;
    line->at = line->to;
    stretch(line);
}

/* A 2^-16 of a side's way, rounded. */
static inline int32_t part_of_side(int32_t texels_q16, uint8_t side_bits)
{
    return ((texels_q16 >> side_bits) + 1) >> 1;
}

/* Steps of a picture and more wrap, as texels do. */
static inline int32_t texture_line_twice(int32_t x)
{
    return (int32_t)((uint32_t)x * 2);
}

struct lim_texture_walk lim_texture_at(const struct lim_texture_line *line, int16_t x)
{
    const struct lim_texture *texture = &line->gradients->texture;
    const uint8_t w_bits = texture->w_bits, h_bits = texture->h_bits;
    const uint32_t at = (line->at.uv_q16[1] >> h_bits << 16) + (uint16_t)(line->at.uv_q16[0] >> w_bits);
    const int32_t u_step = part_of_side(texture_line_twice(line->step_q16[0]), w_bits);
    const int32_t v_step = part_of_side(texture_line_twice(line->step_q16[1]), h_bits);
    const uint32_t step = ((uint32_t)v_step << 16) + (uint32_t)u_step;

    return (struct lim_texture_walk){at + step * (uint32_t)(x - line->x), step};
}

/* How to find texels of one level. */
struct level {
    const LIM_FLASH uint8_t *texels;
    const LIM_FLASH uint16_t *palette;
    uint32_t v_down, w_bits, u_down; /* shifts from a 2^-16 of a side to rows, from rows to texels, and to columns */
    uint8_t number;
};

static void set_level(struct level *level, const struct lim_scene *scene, const struct lim_texture *texture,
                      uint8_t number)
{
    uint32_t size = UINT32_C(1) << (texture->w_bits + texture->h_bits);

    level->number = number;
    level->w_bits = (uint32_t)texture->w_bits - number;
    level->u_down = 16 - level->w_bits;
    level->v_down = 16u + number - texture->h_bits;
    level->texels = scene->texels + (uint32_t)texture->texels * TEXEL_BLOCK;
    for (; number; number--, size >>= 2)
        level->texels += size;
}

/* A function of its own: small cores have registers for just this. What u carries over to v is a 2^-16 of a side. */
static LIM_ALONE void fill_texels(uint16_t *to, uint16_t *const end, struct lim_texture_walk walk,
                                  const struct level *level)
{
    const LIM_FLASH uint8_t *const texels = level->texels;
    const LIM_FLASH uint16_t *const palette = level->palette;
    const uint32_t v_down = level->v_down, w_bits = level->w_bits, u_down = level->u_down;

    do {
        *to++ = palette[texels[(walk.at >> 16 >> v_down << w_bits) + ((uint32_t)(uint16_t)walk.at >> u_down)]];
        walk.at += walk.step;
    } while (to != end);
}

void lim_texture_fill(const struct lim_textured_span *span, uint16_t *pixels, uint16_t x0, uint16_t x1,
                      struct lim_stats *stats)
{
    const struct lim_scene *scene = span->texturing->scene;
    const struct lim_texture *texture = &span->gradients->texture;
    const int16_t end = (int16_t)x1;
    int16_t x = (int16_t)x0;
    struct lim_texture_line line;
    struct level level;

    lim_texture_line_begin(&line, span, x);
    level.palette = scene->palettes + texture->palette;
    set_level(&level, scene, texture, line.level);
    for (;;) {
        const int16_t to = line.end < end ? line.end : end;
        fill_texels(pixels + x, pixels + to, lim_texture_at(&line, x), &level);
        if (to == end) break;
        lim_texture_line_next(&line);
        x = to;
        if (line.level != level.number) set_level(&level, scene, texture, line.level);
    }
    if (LIM_HAS_STATS) stats->divisions += line.divisions;
}

#endif
