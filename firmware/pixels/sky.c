/* SPDX-License-Identifier: MIT
 *
 * A node's direction D is affine on the screen. Its turn is the angle of (x, z), and its rise the height at which D
 * leaves a cylinder of radius 1, in parts of the circumference: y / sqrt(x^2 + z^2) / 2 pi. */
#include "pixels/sky.h"

#include "math/fixed.h"
#include "pixels/fill.h"
#include "pixels/texture_planes.h"

#if LIM_HAS_SKY

/* Directions have 24 bits for a length of 1: with lenses up to 16 to either side, sums stay within 30. */
enum { AHEAD_BITS = 24 };

/* A straight line over an angle a is off by 3/4 a^2 / 8 of the cylinder's radius, as far as the eye sees 45 degrees to
 * either side: nodes are 0.16 apart at most along a line, and half of that from line to line. Of a picture that goes 4
 * times round in 1024 texels that is 0.4 and 0.1 of one. Beyond 100 degrees there may be too few nodes for that. */
static const uint32_t ACROSS_MOST_Q28 = 42949673, DOWN_MOST_Q28 = 21474836;

/* Once a frame ------------------------------------------------------------------------------------- */

/* log2 of pixels from node to node: as many as the angle allows, and more where there would be too many nodes. */
static uint8_t sky_node_bits(uint32_t half_px_q28, uint16_t side_px, uint32_t most_q28, uint16_t most_nodes)
{
    uint8_t bits = 0;

    while (bits < 9 && ((side_px >> bits) + 2 > most_nodes || half_px_q28 <= most_q28 >> (bits + 2)))
        bits++;
    return bits;
}

void lim_sky_begin(struct lim_sky *sky, const struct lim_camera *camera, const int32_t axes_q30[9], uint16_t w_px,
                   uint16_t h_px)
{
    const uint32_t half_w_q28 = camera->tan_x_q28 / w_px, half_h_q28 = camera->tan_y_q28 / h_px;
    sky->across_bits = sky_node_bits(half_w_q28, w_px, ACROSS_MOST_Q28, LIM_SKY_NODES);
    sky->down_bits = sky_node_bits(half_h_q28, h_px, DOWN_MOST_Q28, UINT16_MAX);
    sky->pixel_q16 = half_w_q28 >> 11;
    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t right_q26 = mul_high_s32(axes_q30[i], (int32_t)half_w_q28),
                      down_q26 = mul_high_s32(axes_q30[3 + i], (int32_t)half_h_q28);
        sky->first_q24[i] =
            (axes_q30[6 + i] >> (30 - AHEAD_BITS)) - (right_q26 * (w_px - 1) >> 2) - (down_q26 * (h_px - 1) >> 2);
        sky->across_q24[i] = right_q26 * (2 << sky->across_bits) >> 2;
        sky->down_q24[i] = down_q26 * (2 << sky->down_bits) >> 2;
    }
    sky->rows[0].number = sky->rows[1].number = -1;
}

/* Nodes -------------------------------------------------------------------------------------------- */

/* A sky_polynomial of the third degree in s, all in 2^-15. */
static inline int32_t sky_polynomial(int32_t s, int32_t a, int32_t b, int32_t c, int32_t d)
{
    return a + (s * (b + (s * (c + (s * d >> 15)) >> 15)) >> 15);
}

/* Of the upper half of x << zeros, with the reciprocal of the larger side: a quotient in 2^-15. */
static inline int32_t sky_quotient_q15(uint32_t x, uint8_t zeros, uint32_t recip_q24)
{
    return (int32_t)(((x << zeros) >> 16) * (recip_q24 >> 9) >> 15);
}

enum { SLOPE_BITS = 3, TURN_OF_Q15 = 20861, RISE_OF_Q15 = 83443 }; /* 2^32 / 2 pi / 2^15, 2^16 8 / 2 pi */

/* Chebyshev's nodes of atan(t) / t and of 1 / sqrt(1 + s) for s = t^2, 0 to 1: off by 0.00014 and 0.00055. */
static void sky_look(const int32_t way[3], struct lim_sky_node *node)
{
    const uint32_t x = abs_s32(way[0]), y = abs_s32(way[1]), z = abs_s32(way[2]);
    const uint32_t larger = (x > z ? x : z) | 1, smaller = x > z ? z : x;
    uint8_t zeros;
    const uint32_t recip = recip_q24(larger, &zeros);
    const int32_t t = sky_quotient_q15(smaller > larger ? larger : smaller, zeros, recip), s = t * t >> 15;
    uint32_t turn = (uint32_t)(t * sky_polynomial(s, 32760, -10657, 5049, -1421) >> 15) * TURN_OF_Q15;
    int32_t slope_q12 = 32768; /* of y, to the larger side: 8 at most */

    if (z > x) turn = 0x40000000u - turn;
    if (way[0] < 0) turn = 0x80000000u - turn;
    if (way[2] < 0) turn = 0u - turn;
    if (y >> SLOPE_BITS < larger) slope_q12 = sky_quotient_q15(y >> SLOPE_BITS, zeros, recip);
    slope_q12 = slope_q12 * sky_polynomial(s, 32750, -15798, 8923, -2714) >> 15;
    const int32_t rise_q16 = (int32_t)((uint32_t)slope_q12 * RISE_OF_Q15 >> 15);
    node->turn = turn;
    node->rise_q16 = way[1] < 0 ? -rise_q16 : rise_q16;
}

static void set_sky_node(const struct lim_sky *sky, struct lim_sky_row *row, uint_fast8_t k)
{
    int32_t way[3];

    for (uint_fast8_t i = 0; i < 3; i++)
        way[i] = sky->first_q24[i] + sky->across_q24[i] * (int32_t)k + sky->down_q24[i] * row->number;
    sky_look(way, &row->nodes[k]);
}

/* Nodes from <= k < end of a row, and all between these and others of it. */
static const struct lim_sky_node *sky_row_of(struct lim_sky *sky, int16_t number, uint_fast8_t from, uint_fast8_t end)
{
    struct lim_sky_row *const row = &sky->rows[number & 1];

    if (row->number != number) {
        row->number = number;
        row->from = row->end = (uint8_t)from;
    }
    while (row->from > from)
        set_sky_node(sky, row, --row->from);
    for (; row->end < end; row->end++)
        set_sky_node(sky, row, row->end);
    return row->nodes;
}

/* Texels ------------------------------------------------------------------------------------------- */

/* A texel more a pixel than this, times 2 pi 2^15 / width, and the next level is nearer: the root of 2. */
static const uint32_t FINER_Q16 = 291000;

void lim_sky_set(const struct lim_texturing *texturing, const LIM_FLASH struct lim_mapping *mapping,
                 struct lim_gradients *out)
{
    const LIM_FLASH struct lim_texture *texture = out->texture;
    const uint8_t times = (uint8_t)mapping->uv[0][0];
    const uint32_t texels = ((*texturing->sky)->pixel_q16 >> 1) * times << texture->w_bits;
    uint8_t level = 0;

    while (level + 1 < texture->levels && texels >> level > FINER_Q16)
        level++;
    out->is_even = true;
    out->pace = LIM_PACE_SKY;
    out->sky.times = times;
    out->sky.horizon_q16 = 2 * (int32_t)mapping->at_zero_q16[1];
    lim_texture_set_level(texturing->scene, level, out);
}

/* A line through the sky, in widths of the picture from its upper left corner. */
struct sky_line {
    struct lim_gradients *gradients;
    uint16_t *pixels;
    uint32_t place, step;      /* u and v as in struct lim_texture_walk */
    int32_t v_q16, v_step_q16; /* v beyond the picture, too */
    uint32_t h_q16;
};

/* -1: above the picture, 1: below it. */
static inline int_fast8_t sky_beside(const struct sky_line *line, int32_t v_q16)
{
    return v_q16 < 0 ? -1 : (uint32_t)v_q16 >= line->h_q16;
}

static inline void sky_paint_texels(const struct sky_line *line, int32_t from, int32_t x, int32_t end)
{
    line->gradients->level.step = line->step;
    line->gradients->paint(line->pixels + end, (uint_fast16_t)(end - x),
                           line->place + line->step * (uint32_t)(x - from), &line->gradients->level);
}

/* Pixels x to the one before `end`, in runs that lie on one side of the picture's ends. `from`: where the line is. */
static LIM_RARE void sky_paint_across_end(const struct sky_line *line, int32_t from, int32_t x, int32_t end)
{
    const LIM_FLASH uint16_t *const colours = line->gradients->level.palette;

    while (x < end) {
        const int32_t first = x;
        const int_fast8_t side = sky_beside(line, line->v_q16 + line->v_step_q16 * (x - from));
        do
            x++;
        while (x < end && sky_beside(line, line->v_q16 + line->v_step_q16 * (x - from)) == side);
        if (side)
            lim_fill(line->pixels, (uint16_t)first, (uint16_t)(x - first), colours[side > 0]);
        else
            sky_paint_texels(line, from, first, x);
    }
}

static inline void sky_paint_between(const struct sky_line *line, int32_t from, int32_t x, int32_t end)
{
    const int_fast8_t side = sky_beside(line, line->v_q16 + line->v_step_q16 * (x - from));

    if (side != sky_beside(line, line->v_q16 + line->v_step_q16 * (end - 1 - from)))
        sky_paint_across_end(line, from, x, end);
    else if (side)
        lim_fill(line->pixels, (uint16_t)x, (uint16_t)(end - x), line->gradients->level.palette[side > 0]);
    else
        sky_paint_texels(line, from, x, end);
}

/* Between a node and the one below it. */
static inline struct lim_sky_node sky_between_rows(const struct lim_sky_node *upper, const struct lim_sky_node *lower,
                                                   int32_t part, uint_fast8_t bits)
{
    return (struct lim_sky_node){upper->turn + (uint32_t)(((int32_t)(lower->turn - upper->turn) >> bits) * part),
                                 upper->rise_q16 + ((lower->rise_q16 - upper->rise_q16) * part >> bits)};
}

/* Texels advance by whole 2^-16 of the picture's width for so many pixels, and are found anew then: they are off by 16
 * of these at most, a quarter of a texel. */
enum { SKY_STRETCH_PX = 32 };

/* From node to node: what is seen at the left one, and how it changes. */
struct sky_gap {
    uint32_t u_q32, u_step_q32; /* of the picture's width */
    int32_t v_q16, v_way_q16;   /* likewise; to the next node */
    uint_fast8_t bits;          /* 2^bits pixels */
};

static inline struct sky_gap sky_gap_of(const struct lim_texture_sky *look, const struct lim_sky_node *left,
                                        const struct lim_sky_node *right, uint_fast8_t bits)
{
    return (struct sky_gap){.u_q32 = left->turn * (uint32_t)look->times,
                            .u_step_q32 =
                                (uint32_t)((int32_t)(right->turn - left->turn) >> bits) * (uint32_t)look->times,
                            .v_q16 = look->horizon_q16 - left->rise_q16 * look->times,
                            .v_way_q16 = (left->rise_q16 - right->rise_q16) * look->times,
                            .bits = bits};
}

/* Pixels x0 <= x < x1 of a gap that begins at `from`. */
static inline void sky_paint_gap(struct sky_line *line, const struct sky_gap *gap, int32_t from, int32_t x0, int32_t x1)
{
    const int32_t v_step_q16 = (gap->v_way_q16 + (1 << gap->bits >> 1)) >> gap->bits;

    line->v_step_q16 = v_step_q16;
    line->step = lim_texture_packed((gap->u_step_q32 + 0x8000u) >> 16, (uint32_t)v_step_q16);
    for (int32_t at = from + ((x0 - from) & -SKY_STRETCH_PX); at < x1; at += SKY_STRETCH_PX) {
        const uint32_t u_q32 = gap->u_q32 + gap->u_step_q32 * (uint32_t)(at - from);
        const int32_t end = at + SKY_STRETCH_PX;
        line->v_q16 = gap->v_q16 + (gap->v_way_q16 * (at - from) >> gap->bits);
        line->place = (u_q32 & 0xFFFF0000u) + (uint16_t)line->v_q16;
        sky_paint_between(line, at, at < x0 ? x0 : at, end < x1 ? end : x1);
    }
}

void lim_sky_fill(const struct lim_textured_span *span, uint16_t *pixels, int32_t x0, int32_t x1)
{
    struct lim_sky *const sky = *span->texturing->sky;
    const struct lim_texture_sky look = span->gradients->sky;
    const LIM_FLASH struct lim_texture *const texture = span->gradients->texture;
    const uint_fast8_t bits = sky->across_bits, down_bits = sky->down_bits;
    const uint_fast8_t first = (uint_fast8_t)(x0 >> bits), end = (uint_fast8_t)(((x1 - 1) >> bits) + 2);
    const int16_t number = (int16_t)(span->y >> down_bits);
    const int32_t part = span->y - (number << down_bits);
    const struct lim_sky_node *upper = sky_row_of(sky, number, first, end) + first,
                              *lower = sky_row_of(sky, (int16_t)(number + 1), first, end) + first;
    struct lim_sky_node left = sky_between_rows(upper, lower, part, down_bits);
    struct sky_line line = {.gradients = span->gradients,
                            .pixels = pixels,
                            .h_q16 = UINT32_C(65536) >> (texture->w_bits - texture->h_bits)};

    for (int32_t from = (int32_t)first << bits; from < x1; from += INT32_C(1) << bits) {
        const struct lim_sky_node right = sky_between_rows(++upper, ++lower, part, down_bits);
        const struct sky_gap gap = sky_gap_of(&look, &left, &right, bits);
        const int32_t until = from + (INT32_C(1) << bits);
        sky_paint_gap(&line, &gap, from, from < x0 ? x0 : from, until < x1 ? until : x1);
        left = right;
    }
}

#endif
