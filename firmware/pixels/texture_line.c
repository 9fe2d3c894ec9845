/* SPDX-License-Identifier: MIT
 *
 * Stretches of 2^bits pixels, with a division in the middle of each. Where depth gains q times what it is there on the
 * way to the end, and a coordinate would gain W if depth did not, it gains W / (1 + q) up to there, and W / (1 - q)
 * from the beginning: V - O and V + O, for V = W (1 + q^2 + ...) and O = q V. So a stretch is straight, with V on
 * either side, or bent in its middle. What is straight passes the middle at a distance of O, each half of what is bent
 * its own middle at O / 4: they are moved by half of that, and err as much at their ends. How long a stretch may be is
 * decided where the line is farthest away, where texels are closest together. */
#include "pixels/texture.h"

#if LIM_HAS_TEXTURE

static inline int32_t shifted_left(int32_t x, uint32_t bits)
{
    return (int32_t)((uint32_t)x << bits);
}

/* a + 4 b, a - 4 b: modulo 2^32, as are all sums of planes that are out of all bounds. */
static inline int32_t plus_4(int32_t a, int32_t b)
{
    return (int32_t)((uint32_t)a + 4 * (uint32_t)b);
}

static inline int32_t less_4(int32_t a, int32_t b)
{
    return (int32_t)((uint32_t)a - 4 * (uint32_t)b);
}

/* The plane's value at twice a pixel's coordinates, on a line where it is `at` for x = 0. */
static inline int32_t at_twice(int32_t at, int32_t plane_x, int32_t twice_x)
{
    return (int32_t)((uint32_t)at + (uint32_t)plane_x * (uint32_t)twice_x);
}

static LIM_IN_EACH_CALLER void suit_level(const struct lim_texture_line *line, uint32_t depth)
{
    const struct lim_texture_planes *planes = &line->gradients->planes;

    if (depth - planes->level_depth >= planes->level_depths)
        lim_texture_suit_level(line->texturing->scene, line->gradients, depth);
}

/* What all coordinates have in common in the middle of a stretch. */
struct course {
    int32_t recip_q31, down;
    int32_t half_depth; /* shifted as depth is for its reciprocal */
    int32_t q_q32, q2_q32;
};

/* Of a coordinate: where its middle is, V, and O. */
struct course_of {
    uint32_t at_q16;
    int32_t even_q16, odd_q16;
};

/* A place so far away that a shift would have to go left is finer than any pixel. */
static LIM_IN_EACH_CALLER struct course_of course_of(const struct course *course, int32_t plane, int32_t half)
{
    const int32_t ratio = lim_texture_part(plane, course->recip_q31);
    const int32_t rest = (int32_t)((uint32_t)half - ((uint32_t)mul_high_s32(ratio, course->half_depth) << 2));
    const int32_t way_q16 = lim_texture_part(rest, course->recip_q31) >> course->down;
    const int32_t even_q16 = lim_texture_plus_part(way_q16, way_q16, course->q2_q32);

    return (struct course_of){(uint32_t)(ratio >> course->down), even_q16, lim_texture_part(even_q16, course->q_q32)};
}

/* A whole stretch from `next` on. */
static LIM_IN_EACH_CALLER void stretch(struct lim_texture_line *line)
{
    const struct lim_texture_planes *planes = &line->gradients->planes;
    const uint32_t twice_bits = line->bits + 1;
    const uint32_t n_px = line->n_px & ~UINT32_C(1);
    const int32_t twice_x = 2 * line->next + (int32_t)n_px;
    const int32_t half_depth = (int32_t)((uint32_t)planes->depth.x * n_px);
    const int32_t at_middle = at_twice(line->depth, planes->depth.x, twice_x);
    const uint32_t depth = (uint32_t)(at_middle < planes->depth_min ? planes->depth_min : at_middle);
    struct course course;
    uint32_t zeros;

    suit_level(line, depth - (uint32_t)half_depth);
    if (LIM_HAS_STATS) line->divisions++;
    line->middle_depth = depth;
    course.recip_q31 = lim_texture_reciprocal_part(depth, &zeros);
    course.down = lim_texture_not_negative(line->gradients->shift - (int32_t)zeros);
    course.half_depth = shifted_left(half_depth, zeros);
    course.q_q32 = shifted_left(lim_texture_part(course.half_depth, course.recip_q31), 2);
    course.q2_q32 = lim_texture_square(course.q_q32);
    const struct course_of u = course_of(&course, at_twice(line->uv[0], planes->uv[0].x, twice_x),
                                         (int32_t)((uint32_t)planes->uv[0].x * n_px));
    const struct course_of v = course_of(&course, at_twice(line->uv[1], planes->uv[1].x, twice_x),
                                         (int32_t)((uint32_t)planes->uv[1].x * n_px));
    const int32_t u_even = plus_4((int32_t)n_px, u.even_q16), v_even = plus_4((int32_t)n_px, v.even_q16);
    const uint32_t u_q16 = u.at_q16 + (planes->eye_place >> 16), v_q16 = v.at_q16 + planes->eye_place;

    line->x = line->next;
    line->middle = line->x + (int32_t)(n_px >> 1);
    line->next = line->x + (int32_t)line->n_px;
    if (!line->bent) {
        line->end = line->next;
        line->walk.place = pair_of_lows(v_q16 - (uint32_t)(v.odd_q16 >> 1), u_q16 - (uint32_t)(u.odd_q16 >> 1));
        line->walk.step = lim_texture_packed((uint32_t)(u_even >> twice_bits), (uint32_t)(v_even >> twice_bits));
    } else {
        line->end = line->middle;
        line->walk.place = pair_of_lows(v_q16 + (uint32_t)(v.odd_q16 >> 3), u_q16 + (uint32_t)(u.odd_q16 >> 3));
        line->walk.step = lim_texture_packed((uint32_t)(plus_4(u_even, u.odd_q16) >> twice_bits),
                                             (uint32_t)(plus_4(v_even, v.odd_q16) >> twice_bits));
        line->step_after = lim_texture_packed((uint32_t)(less_4(u_even, u.odd_q16) >> twice_bits),
                                              (uint32_t)(less_4(v_even, v.odd_q16) >> twice_bits));
    }
}

static LIM_IN_EACH_CALLER void other_half(struct lim_texture_line *line)
{
    suit_level(line, line->middle_depth);
    line->walk.step = line->step_after;
    line->x = line->end;
    line->end = line->next;
}

/* How long stretches of a line are that has `depth` where x is 0, and which of them pixel x is in. */
static LIM_IN_EACH_CALLER void divide_line(struct lim_texture_line *line, const struct lim_textured_span *span,
                                           int32_t depth, int32_t x)
{
    struct lim_gradients *const gradients = span->gradients;
    const struct lim_texture_planes *const planes = &gradients->planes;
    const int32_t left = span->left < 0 ? 0 : span->left;
    const int32_t right = lim_texture_lesser(span->right, span->texturing->w_px);
    uint32_t pace = gradients->pace;

    line->texturing = span->texturing;
    line->gradients = gradients;
    if (!pace) {
        const int32_t far_x = planes->depth.x < 0 ? right - 1 : left;
        pace = lim_texture_pace(gradients, at_twice(depth, planes->depth.x, 2 * far_x));
    }
    uint32_t bits = pace >> 1, bent = pace & 1;
    /* One that goes on twice as far as the line is long enough. */
    for (; !((uint32_t)(right - left) * 2 >> bits); bits--)
        bent = 0;
    line->bent = bent;
    line->n_px = UINT32_C(1) << bits;
    line->bits = bits;
    line->next = left + ((x - left) >> bits << bits);
}

static LIM_IN_EACH_CALLER void begin_stretches(struct lim_texture_line *line, const struct lim_textured_span *span,
                                               int32_t x)
{
    const struct lim_texture_planes *const planes = &span->gradients->planes;
    const int32_t twice_y = 2 * span->y;

    line->depth = at_twice(planes->depth.at, planes->depth.y, twice_y);
    line->uv[0] = at_twice(planes->uv[0].at, planes->uv[0].y, twice_y);
    line->uv[1] = at_twice(planes->uv[1].at, planes->uv[1].y, twice_y);
    divide_line(line, span, line->depth, x);
}

void lim_texture_line_begin(struct lim_texture_line *line, const struct lim_textured_span *span, int16_t x)
{
    const struct lim_gradients *const gradients = span->gradients;

    line->divisions = 0;
    if (!gradients->is_even) {
        begin_stretches(line, span, x);
        stretch(line);
        if (x >= line->end) other_half(line);
        return;
    }
    line->x = line->middle = x;
    line->end = span->right;
    line->walk.step = gradients->level.step;
    line->walk.place = lim_texture_even_place(&gradients->even, line->walk.step, x, span->y);
}

void lim_texture_line_next(struct lim_texture_line *line)
{
    if (line->end == line->next)
        stretch(line);
    else
        other_half(line);
}

/* Pixels from x to the one before `end`, or x1. Returns the first that is left. */
static LIM_IN_EACH_CALLER int32_t fill_until(struct lim_texture_line *line, uint16_t *pixels, int32_t x, int32_t end,
                                             int32_t x1)
{
    const int32_t until = lim_texture_lesser(end, x1);

    line->gradients->level.step = line->walk.step;
    line->gradients->paint(pixels + until, (uint_fast16_t)(until - x), lim_texture_place(line, x),
                           &line->gradients->level);
    return until;
}

/* A place's plane and its gradient of n pixels, as the reciprocal has them. */
static inline int32_t flat_part(int32_t x, int32_t recip_q31, int32_t down)
{
    return lim_texture_part(x, recip_q31) >> down;
}

/* Of a line that is equally far away all over, as floors have them: one reciprocal does, and nothing is bent. */
uint16_t lim_texture_fill_flat(const struct lim_textured_span *span, uint16_t *pixels, int32_t x, int32_t x1)
{
    struct lim_gradients *const gradients = span->gradients;
    const struct lim_texture_planes *const planes = &gradients->planes;
    const int32_t twice_y = 2 * span->y, at = at_twice(planes->depth.at, planes->depth.y, twice_y);
    const uint32_t depth = (uint32_t)(at < planes->depth_min ? planes->depth_min : at);
    struct lim_texture_line line;
    uint32_t zeros;

    divide_line(&line, span, at, x);
    suit_level(&line, depth);
    const int32_t recip_q31 = lim_texture_reciprocal_part(depth, &zeros);
    const int32_t down = lim_texture_not_negative(gradients->shift - (int32_t)zeros), n_px = (int32_t)line.n_px & ~1;
    const int32_t u_gain =
        plus_4(n_px, flat_part((int32_t)((uint32_t)planes->uv[0].x * (uint32_t)n_px), recip_q31, down));
    const int32_t v_gain =
        plus_4(n_px, flat_part((int32_t)((uint32_t)planes->uv[1].x * (uint32_t)n_px), recip_q31, down));
    line.walk.step = lim_texture_packed((uint32_t)(u_gain >> (line.bits + 1)), (uint32_t)(v_gain >> (line.bits + 1)));
    do {
        const int32_t twice_x = 2 * line.next + n_px;
        const int32_t u_at = at_twice(at_twice(planes->uv[0].at, planes->uv[0].y, twice_y), planes->uv[0].x, twice_x);
        const int32_t v_at = at_twice(at_twice(planes->uv[1].at, planes->uv[1].y, twice_y), planes->uv[1].x, twice_x);
        line.walk.place = pair_of_lows((uint32_t)flat_part(v_at, recip_q31, down) + planes->eye_place,
                                       (uint32_t)flat_part(u_at, recip_q31, down) + (planes->eye_place >> 16));
        line.middle = line.next + (n_px >> 1);
        line.next += (int32_t)line.n_px;
        x = fill_until(&line, pixels, x, line.next, x1);
    } while (x != x1);
    return LIM_HAS_STATS;
}

uint16_t lim_texture_fill_slanted(const struct lim_textured_span *span, uint16_t *pixels, int32_t x, int32_t x1)
{
    struct lim_texture_line line;

    line.divisions = 0;
    begin_stretches(&line, span, x);
    do {
        stretch(&line);
        if (line.bent) {
            if (x < line.middle) x = fill_until(&line, pixels, x, line.middle, x1);
            if (x == x1) break;
            other_half(&line);
        }
        x = fill_until(&line, pixels, x, line.next, x1);
    } while (x != x1);
    return line.divisions;
}

#endif
