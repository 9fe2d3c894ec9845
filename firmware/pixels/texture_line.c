/* SPDX-License-Identifier: MIT
 *
 * A line: stretches of 2^bits pixels, with a division at each end and texels along a straight line in between. How long
 * they may be is decided where the line is farthest away, where texels are closest together. */
#include "pixels/texture.h"

#if LIM_HAS_TEXTURE

/* The planes at a pixel of the line. */
static LIM_IN_EACH_CALLER void go_to(struct lim_texture_line *line, const struct lim_texture_planes *planes,
                                     int32_t x_px, int32_t y_px)
{
    const int32_t x = 2 * x_px + 1 - line->texturing->w_px, y = 2 * y_px + 1 - line->texturing->h_px;

    line->depth = planes->depth.at + planes->depth.x * x + planes->depth.y * y;
    line->uv[0] = planes->uv[0].at + planes->uv[0].x * x + planes->uv[0].y * y;
    line->uv[1] = planes->uv[1].at + planes->uv[1].x * x + planes->uv[1].y * y;
}

/* Where the planes have come to. A place so far away that a shift would have to go left is finer than any pixel. */
static LIM_IN_EACH_CALLER uint32_t sample(struct lim_texture_line *line, const struct lim_texture_planes *planes)
{
    const uint32_t depth = (uint32_t)(line->depth < planes->depth_min ? planes->depth_min : line->depth);
    uint8_t zeros;
    const int32_t recip_q31 = lim_texture_reciprocal(depth, &zeros);
    const int32_t shift = line->gradients->shift - zeros, down = shift & ~(shift >> 31);

    line->seen_depth = depth;
    line->at_q16[0] = planes->eye_uv_q16[0] + (uint32_t)(lim_texture_times(line->uv[0], recip_q31) >> down);
    line->at_q16[1] = planes->eye_uv_q16[1] + (uint32_t)(lim_texture_times(line->uv[1], recip_q31) >> down);
    if (LIM_HAS_STATS) line->divisions++;
    /* (depth - depth before) / depth, doubled twice: what a stretch may have of it is a half at most. */
    int32_t bend = line->bend;
    __asm__("" : "+r"(bend)); /* else it is widened before the loop, and all 64 bits of the product are found */
    return (uint32_t)lim_texture_times(bend, recip_q31) << zeros;
}

static inline int32_t sum(int32_t a, int32_t b)
{
    return (int32_t)((uint32_t)a + (uint32_t)b);
}

/* A whole stretch from `end` on. */
static LIM_IN_EACH_CALLER void stretch(struct lim_texture_line *line, struct lim_texture_planes *planes)
{
    const uint32_t u = line->at_q16[0], v = line->at_q16[1];

    if (line->seen_depth - planes->level_depth >= planes->level_depths)
        lim_texture_suit_level(line->texturing->scene, line->gradients, line->seen_depth);
    line->depth = sum(line->depth, line->depth_step);
    line->uv[0] = sum(line->uv[0], line->uv_step[0]);
    line->uv[1] = sum(line->uv[1], line->uv_step[1]);
    const int32_t bend_q30 = (int32_t)sample(line, planes);
    const int32_t half = line->n_px >> 1;
    const int32_t u_way = (int32_t)(line->at_q16[0] - u), v_way = (int32_t)(line->at_q16[1] - v);
    line->walk.place = lim_texture_packed(u + (uint32_t)(mul_high_s32(u_way, bend_q30) >> 1),
                                          (uint16_t)(v + (uint32_t)(mul_high_s32(v_way, bend_q30) >> 1)));
    line->walk.step =
        lim_texture_packed((uint32_t)((u_way + half) >> line->bits), (uint32_t)((v_way + half) >> line->bits));
    line->x = line->end;
    line->end = line->x + line->n_px;
}

static LIM_IN_EACH_CALLER void begin_stretches(struct lim_texture_line *line, const struct lim_textured_span *span,
                                               int32_t x)
{
    struct lim_texture_planes *planes = &span->gradients->planes;
    const int32_t left = span->left < 0 ? 0 : span->left,
                  right = lim_texture_lesser(span->right, span->texturing->w_px);

    line->texturing = span->texturing;
    line->gradients = span->gradients;
    go_to(line, planes, left, span->y);
    uint32_t bits = span->gradients->bits;
    if (!bits) {
        const int32_t right_depth = line->depth + planes->depth.x * 2 * (right - 1 - left);
        bits = lim_texture_stretch_bits(span->gradients, lim_texture_lesser(line->depth, right_depth));
    }
    /* A stretch that goes on twice as far as the line is long enough. */
    line->bits = (uint32_t)lim_texture_lesser((int32_t)bits, 32 - clz_u32((uint32_t)(right - left)));
    line->n_px = (int32_t)1 << line->bits;
    line->end = left + ((x - left) >> line->bits << line->bits);
    if (line->end != left) go_to(line, planes, line->end, span->y);
    line->depth_step = (int32_t)((uint32_t)planes->depth.x << line->bits << 1);
    line->bend = line->bits ? line->depth_step : 0;
    line->uv_step[0] = (int32_t)((uint32_t)planes->uv[0].x << line->bits << 1);
    line->uv_step[1] = (int32_t)((uint32_t)planes->uv[1].x << line->bits << 1);
    sample(line, planes);
    stretch(line, planes);
}

void lim_texture_line_begin(struct lim_texture_line *line, const struct lim_textured_span *span, int16_t x)
{
    line->divisions = 0;
    if (!span->gradients->is_even) {
        begin_stretches(line, span, x);
        return;
    }
    line->x = span->left;
    line->end = span->right;
    line->walk.step = span->gradients->level.step;
    line->walk.place = lim_texture_even_place(&span->gradients->even, line->walk.step, span->left, span->y);
}

void lim_texture_line_next(struct lim_texture_line *line)
{
    stretch(line, &line->gradients->planes);
}

uint16_t lim_texture_fill_stretches(const struct lim_textured_span *span, uint16_t *pixels, int32_t x, int32_t x1)
{
    struct lim_texture_line line;

    line.divisions = 0;
    begin_stretches(&line, span, x);
    line.walk.place = lim_texture_place(&line, x);
    for (;;) {
        const int32_t end = lim_texture_lesser(line.end, x1);
        line.gradients->level.step = line.walk.step;
        lim_texels_paint(pixels + x, (uint_fast16_t)(end - x), line.walk.place, &line.gradients->level);
        if (end == x1) return line.divisions;
        x = end;
        stretch(&line, &line.gradients->planes);
    }
}

#endif
