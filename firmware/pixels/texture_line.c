/* SPDX-License-Identifier: MIT
 *
 * A line that is level, or stretches of 2^bits pixels, with a division at each end and texels along a straight line in
 * between. How long they may be is decided where the line is farthest away, where texels are closest together. */
#include "pixels/texture.h"

#if LIM_HAS_TEXTURE

static inline int32_t first_px(const struct lim_textured_span *span)
{
    return span->left < 0 ? 0 : span->left;
}

static inline int32_t width_px(const struct lim_textured_span *span)
{
    return lim_texture_lesser(span->right, span->texturing->w_px) - first_px(span);
}

/* Level ------------------------------------------------------------------------------------------------------------ */

static inline int32_t over_depth(int32_t plane, int32_t recip_q31, int_fast16_t down)
{
    return lim_texture_times(plane, recip_q31) >> down;
}

/* What a pixel adds, of what 2^bits pixels add to a plane. */
static inline uint32_t level_step(int32_t plane_x, int32_t recip_q31, int_fast16_t down, uint32_t bits)
{
    const int32_t way_q16 = over_depth((int32_t)((uint32_t)plane_x << bits << 1), recip_q31, down);

    return (uint32_t)((way_q16 + (((int32_t)1 << bits) >> 1)) >> bits);
}

/* A line that is equally far away all over, as of a floor, is even: from its first pixel on. false: it is not, or so
 * long that a step's rounding would show. */
static LIM_INLINE bool walk_level(const struct lim_textured_span *span, struct lim_texture_walk *walk)
{
    struct lim_gradients *const gradients = span->gradients;
    const struct lim_texture_planes *planes = &gradients->planes;
    const uint32_t bits = 32u - clz_u32((uint32_t)width_px(span));

    if (planes->depth.x || bits + gradients->texture->w_bits > LIM_TEXTURE_MOST_BITS) return false;
    const int32_t x = 2 * first_px(span) + 1 - span->texturing->w_px, y = 2 * span->y + 1 - span->texturing->h_px;
    const int32_t seen_depth = planes->depth.at + planes->depth.y * y;
    const uint32_t depth = (uint32_t)(seen_depth < planes->depth_min ? planes->depth_min : seen_depth);
    uint8_t zeros;
    const int32_t recip_q31 = lim_texture_reciprocal(depth, &zeros);
    const int_fast16_t shift = (int_fast16_t)(gradients->shift - zeros), down = shift < 0 ? 0 : shift;
    const struct lim_texture_plane *u = &planes->uv[0], *v = &planes->uv[1];

    if (depth - planes->level_depth >= planes->level_depths)
        lim_texture_suit_level(span->texturing->scene, gradients, depth);
    walk->place = lim_texture_packed(
        planes->eye_uv_q16[0] + (uint32_t)over_depth(u->at + u->x * x + u->y * y, recip_q31, down),
        (uint16_t)(planes->eye_uv_q16[1] + (uint32_t)over_depth(v->at + v->x * x + v->y * y, recip_q31, down)));
    walk->step = lim_texture_packed(level_step(u->x, recip_q31, down, bits), level_step(v->x, recip_q31, down, bits));
    return true;
}

static LIM_ALONE bool fill_level(const struct lim_textured_span *span, uint16_t *pixels, int32_t x, int32_t x1)
{
    struct lim_texture_walk walk;

    if (!walk_level(span, &walk)) return false;
    span->gradients->level.step = walk.step;
    lim_texels_paint(pixels + x, (uint_fast16_t)(x1 - x), walk.place + walk.step * (uint32_t)(x - first_px(span)),
                     &span->gradients->level);
    return true;
}

/* Stretches -------------------------------------------------------------------------------------------------------- */

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
    const int32_t left = first_px(span), w_px = width_px(span);

    line->texturing = span->texturing;
    line->gradients = span->gradients;
    go_to(line, planes, left, span->y);
    uint32_t bits = span->gradients->bits;
    if (!bits) {
        const int32_t right_depth = line->depth + planes->depth.x * 2 * (w_px - 1);
        bits = lim_texture_stretch_bits(span->gradients, lim_texture_lesser(line->depth, right_depth));
    }
    /* A stretch that goes on twice as far as the line is long enough. */
    line->bits = (uint32_t)lim_texture_lesser((int32_t)bits, 32 - clz_u32((uint32_t)w_px));
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
    line->x = first_px(span);
    line->end = line->x + width_px(span);
    if (!span->gradients->is_even) {
        if (walk_level(span, &line->walk))
            line->divisions++;
        else
            begin_stretches(line, span, x);
        return;
    }
    line->walk.step = span->gradients->level.step;
    line->walk.place = lim_texture_even_place(&span->gradients->even, line->walk.step, line->x, span->y);
}

void lim_texture_line_next(struct lim_texture_line *line)
{
    stretch(line, &line->gradients->planes);
}

uint16_t lim_texture_fill_stretches(const struct lim_textured_span *span, uint16_t *pixels, int32_t x, int32_t x1)
{
    struct lim_texture_line line;

    if (!span->gradients->planes.depth.x && fill_level(span, pixels, x, x1)) return 1;
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
