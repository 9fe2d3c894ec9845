/* SPDX-License-Identifier: MIT
 *
 * A plane cuts a polygon along a line, and that line and the eye span a plane through the eye, m . r = 0. The
 * ray through the centre of pixel (x, y) of w times h is r = ((2x + 1 - w) / w, (2y + 1 - h) / h, 1), so along a line
 * of pixels w h m . r steps by 2 h m[0]: with |m| < 2^30 all of it stays below 2^52; of samples, below 2^58. */
#include "pieces/trace.h"

#include "math/fixed.h"
#include "pieces/entry.h"
#include "screen/edge.h"
#include "screen/samples.h"
#include "view/plane_unpacked.h"
#include "view/view.h"

#if LIM_HAS_NEWELL

/* w h m . r at the centres of pixels, >= 0 where the plane's front is; all 0, which is all front, if the line is a
 * point.
 */
struct trace {
    int64_t first, step, down; /* of pixel (0, 0), and to the next one in its line and in its column */
    int64_t shift; /* for samples, by column of the lattice that holds them, 16 times and 4 times as many; else 0 */
};

/* Halves, so that differences of two products fit 64 bits. */
static void halve_point(int32_t out[3], const struct lim_view_point *point)
{
    for (uint_fast8_t i = 0; i < 3; i++)
        out[i] = point->qv[i] >> 1;
}

/* Where the polygon's boundary leaves the front of the plane and where it comes back; and the corner that is farthest
 * from it. */
struct chord {
    int32_t out[3], back[3], far[3];
    int64_t far_value;
};

static void find_chord(struct chord *chord, const struct lim_sorter *sorter, uint16_t entry,
                       const struct lim_plane_unpacked *plane)
{
    const struct lim_scene *scene = sorter->pass->scene;
    const struct lim_view *view = &sorter->pass->view;
    const LIM_FLASH lim_index *record = lim_entry_record(sorter, entry);
    const LIM_FLASH lim_index *corners = record + LIM_POLYGON_HEAD_WORDS;
    const uint_fast8_t n = record[0] & LIM_POLYGON_COUNT;
    int32_t before[3] = {0, 0, 0}, here[3];
    int64_t value_before = 0;

    chord->far_value = 0;
    for (uint_fast8_t i = 0; i < 3; i++) /* an initialiser would be a call of memset() */
        chord->out[i] = chord->back[i] = chord->far[i] = 0;
    for (uint_fast8_t k = 0; k <= n; k++) {
        const LIM_FLASH struct lim_vertex *vertex = &scene->vertices[corners[k < n ? k : 0]];
        struct lim_view_point point;
        lim_view_transform(view, scene, vertex, &point);
        if (LIM_HAS_TELE) lim_view_even(&view->rows, &point);
        const int64_t value = lim_plane_value(plane, vertex->x, vertex->y, vertex->z, 1);
        halve_point(here, &point);
        if (k && value_before >= 0 && value < 0) lim_plane_cross(chord->out, before, value_before, here, value);
        if (k && value_before < 0 && value >= 0) lim_plane_cross(chord->back, here, value, before, value_before);
        const int64_t size = value < 0 ? -value : value;
        if (size > (chord->far_value < 0 ? -chord->far_value : chord->far_value)) {
            chord->far_value = value;
            for (uint_fast8_t i = 0; i < 3; i++)
                chord->far[i] = here[i];
        }
        for (uint_fast8_t i = 0; i < 3; i++)
            before[i] = here[i];
        value_before = value;
    }
}

/* How many more bits than 30 a number has. */
static uint8_t bits_above_s30(uint64_t bits)
{
    const uint32_t high = (uint32_t)(bits >> 32), low = (uint32_t)bits;

    return (uint8_t)(high ? 34 - clz_u32(high) : low >> 30 ? 2 - clz_u32(low) : 0);
}

/* m above, turned so that it is >= 0 where the plane's front is. */
static void find_line(int32_t out[3], const struct chord *chord)
{
    int64_t m[3], dot = 0;
    uint64_t bits = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
        const uint_fast8_t j = lim_axis_after(i), k = lim_axis_after(j);
        m[i] = (int64_t)chord->out[j] * chord->back[k] - (int64_t)chord->out[k] * chord->back[j];
        bits |= m[i] < 0 ? 0 - (uint64_t)m[i] : (uint64_t)m[i];
    }
    const uint8_t shift = bits_above_s30(bits);
    for (uint_fast8_t i = 0; i < 3; i++) {
        out[i] = (int32_t)(m[i] >> shift);
        dot += (int64_t)out[i] * (chord->far[i] >> 1);
    }
    for (uint_fast8_t i = 0; i < 3 && (dot < 0) != (chord->far_value < 0); i++)
        out[i] = -out[i];
}

/* Of a lattice of columns times rows; a pixel, or the first sample of it, is at column `across` of it. */
static void set_lattice(struct trace *trace, const int32_t m[3], int32_t columns, int32_t rows, int32_t across)
{
    const int64_t mx = (int64_t)m[0] * rows, my = (int64_t)m[1] * columns;

    trace->first = mx * (1 - columns) + my * (1 - rows) + (int64_t)m[2] * columns * rows;
    trace->step = 2 * mx * across;
    trace->down = 2 * my;
    if (LIM_HAS_ANTIALIAS) trace->shift = across > 1 ? 2 * mx : 0;
}

static void set_trace(struct trace *trace, const struct lim_sorter *sorter, uint16_t entry,
                      const struct lim_plane_unpacked *plane)
{
    const int32_t w_px = sorter->pass->target.w_px, h_px = sorter->pass->target.h_px;
    struct chord chord;
    int32_t m[3];

    find_chord(&chord, sorter, entry, plane);
    find_line(m, &chord);
    if (lim_is_antialiased(&sorter->pass->view))
        set_lattice(trace, m, w_px * LIM_SAMPLE_COLUMNS, h_px * LIM_SAMPLE_ROWS, LIM_SAMPLES_A_ROW);
    else
        set_lattice(trace, m, w_px, h_px, 1);
}

/* At a pixel of a line, or a sample of a row. */
static inline int64_t value_at(const struct trace *trace, int32_t x, int16_t row)
{
    int64_t value = trace->first + trace->step * x + trace->down * row;

    if (LIM_HAS_ANTIALIAS && trace->shift) value += trace->shift * lim_sample_shift(row);
    return value;
}

static bool is_in_front(int64_t value)
{
    return value >= 0;
}

/* Leaves of the pixels x <= .. < y of line `row`, or of the samples of a row, those on one side. */
static void narrow(struct lim_point *line, const struct trace *trace, int16_t row, bool front)
{
    int64_t value = value_at(trace, line->x, row);
    int32_t ahead = line->y - 1 - line->x, x = line->x;
    const bool keeps_low = is_in_front(value) == front, keeps_high = is_in_front(value + trace->step * ahead) == front;

    if (keeps_low && keeps_high) return;
    if (!keeps_low && !keeps_high) {
        line->y = line->x;
        return;
    }
    /* The last one on the side of the first, by powers of two. */
    int32_t part = INT32_C(1) << (31 - clz_u32((uint32_t)ahead));
    for (int64_t stride = trace->step * part; part; part >>= 1, stride >>= 1) {
        if (ahead < part || (is_in_front(value + stride) == front) != keeps_low) continue;
        value += stride;
        x += part;
        ahead -= part;
    }
    if (keeps_low)
        line->y = (lim_sub)(x + 1);
    else
        line->x = (lim_sub)(x + 1);
}

/* Where a trace crosses the rows of a lattice of pixels: at x + row * slope. Neither is exact, but both pieces get the
 * same. */
struct crossing {
    int32_t x_q20, slope_q20; /* so that the sum fits on any line */
    bool front_is_low;
};

#define CROSSING_ONE_Q20 (INT32_C(1) << 20)
enum { CROSSING_SLACK_Q20 = 1 << 6, CROSSING_BITS_MAX = 20 };

/* The number as 32 bits, the highest of which is set, times 2^*shift. */
static uint32_t mantissa_of(int64_t number, int8_t *shift)
{
    const uint64_t size = number < 0 ? 0 - (uint64_t)number : (uint64_t)number;
    const uint32_t high = (uint32_t)(size >> 32), low = (uint32_t)size;

    if (high) {
        const uint8_t zeros = clz_u32(high);
        *shift = (int8_t)(32 - zeros);
        return zeros ? high << zeros | low >> (32 - zeros) : high;
    }
    const uint8_t zeros = clz_u32(low);
    *shift = (int8_t)-zeros;
    return low << zeros;
}

/* -num / step. false: the quotient is too large. */
static bool quotient_q20(int64_t num, int64_t step, uint32_t step_recip_q31, int8_t step_shift, int64_t *out_q20)
{
    int8_t shift;

    *out_q20 = 0;
    if (!num) return true;
    const uint32_t high =
        (uint32_t)(((uint64_t)mantissa_of(num, &shift) * step_recip_q31) >> 32); /* / 2^30, below 2^32 */
    const int16_t places = (int16_t)(30 - 20 - shift + step_shift);              /* to the right */
    if (places < -CROSSING_BITS_MAX) return false;
    const int64_t size = places >= 32 ? 0 : places >= 0 ? high >> places : (int64_t)high * (INT64_C(1) << -places);
    *out_q20 = (num < 0) == (step < 0) ? -size : size;
    return true;
}

static bool is_s31(int64_t x)
{
    return x < INT32_MAX / 2 - 2 * CROSSING_ONE_Q20 && x > INT32_MIN / 2 + 2 * CROSSING_ONE_Q20;
}

/* false: it is too level, or leaves the screen far to the side, which is asked for all lines that there are: so both
 * pieces hear the same. */
static bool set_crossing(struct crossing *crossing, const struct trace *trace, uint16_t h_px)
{
    int64_t x_q20, slope_q20;
    int8_t step_shift;
    uint8_t zeros;

    if (!trace->step || (LIM_HAS_ANTIALIAS && trace->shift)) return false;
    const uint32_t recip_q31 = recip_q31_of(mantissa_of(trace->step, &step_shift), &zeros);
    crossing->front_is_low = trace->step < 0;
    if (!quotient_q20(trace->first, trace->step, recip_q31, step_shift, &x_q20) ||
        !quotient_q20(trace->down, trace->step, recip_q31, step_shift, &slope_q20) || !is_s31(x_q20) ||
        !is_s31(slope_q20 * h_px))
        return false;
    crossing->x_q20 = (int32_t)x_q20 + (crossing->front_is_low ? CROSSING_ONE_Q20 + CROSSING_SLACK_Q20
                                                               : CROSSING_ONE_Q20 - 1 - CROSSING_SLACK_Q20);
    crossing->slope_q20 = (int32_t)slope_q20;
    return true;
}

/* Which of a line's pixels a cut leaves: all, or those on one side of its trace. What is as good as on the plane is in
 * front. */
enum trace_side { WHOLE, LOW, HIGH };

static enum trace_side kept_side(const struct crossing *crossing, bool front)
{
    return front == crossing->front_is_low ? LOW : HIGH;
}

static inline struct lim_point narrowed(struct lim_point line, int32_t x, enum trace_side side)
{
    if (side == LOW && x < line.y) line.y = (lim_sub)(x > line.x ? x : line.x);
    if (side == HIGH && x > line.x) line.x = (lim_sub)(x < line.y ? x : line.y);
    return line;
}

/* Cuts all lines. */
static void narrow_all(struct lim_point *last, const struct crossing *crossing, int16_t top, int16_t bottom, bool front)
{
    const enum trace_side side = kept_side(crossing, front);
    int32_t x_q20 = crossing->x_q20 + crossing->slope_q20 * top;

    for (struct lim_point *line = &last[bottom - top]; line > last;) {
        line--;
        *line = narrowed(*line, x_q20 >> 20, side);
        x_q20 = (int32_t)((uint32_t)x_q20 + (uint32_t)crossing->slope_q20);
    }
}

/* Lines top <= y < bottom of the whole, within the part of the screen that is drawn, that of bottom - 1 first; and what
 * a cut leaves of them. */
static LIM_HOT_INLINE void trace_lines(struct lim_point *last, const struct lim_screen_polygon *whole,
                                       const struct lim_rect *open, int16_t top, int16_t bottom,
                                       const struct crossing *crossing, enum trace_side side)
{
    const int32_t x0 = open->x0, x1 = open->x1;
    const int32_t slope_q20 = side == WHOLE ? 0 : crossing->slope_q20;
    int32_t x_q20 = side == WHOLE ? 0 : crossing->x_q20 + slope_q20 * top;
    struct lim_point *line = &last[bottom - top];
    struct lim_edge_pair pair;
    int16_t turn = lim_edge_start(&pair, whole->at, whole->n, whole->shape.first, top);

    for (;;) {
        struct lim_point *const end = &last[bottom - (turn < bottom ? turn : bottom)];
        struct lim_edge left, right;
        lim_edge_copy(&left, &pair.left);
        lim_edge_copy(&right, &pair.right);
        while (line > end) {
            const int32_t from = lim_edge_next_x(&left), to = lim_edge_next_x(&right);
            const struct lim_point all = {(lim_sub)(from > x0 ? from : x0), (lim_sub)(to < x1 ? to : x1)};
            *--line = narrowed(all, x_q20 >> 20, side);
            x_q20 = (int32_t)((uint32_t)x_q20 + (uint32_t)slope_q20);
        }
        if (line == last) return;
        lim_edge_follow(&pair.left, &left);
        lim_edge_follow(&pair.right, &right);
        turn = lim_edge_turn(&pair, whole->at, whole->n, turn);
    }
}

static void trace_of(struct trace *trace, const struct lim_sorter *sorter, uint16_t entry, uint16_t cut)
{
    struct lim_plane_unpacked plane;

    lim_plane_load(&plane, sorter, sorter->newell->cuts[cut].by & LIM_SORTED_MAX);
    set_trace(trace, sorter, entry, &plane);
}

/* Rows that are searched, not stepped. Most of them the trace does not cross: both ends of the screen tell. */
static void search_all(struct lim_point *last, const struct trace *trace, int16_t top, int16_t bottom, bool front,
                       uint16_t w_px)
{
    const bool is_slanted = LIM_HAS_ANTIALIAS && trace->shift;
    const int64_t across = trace->step * (w_px - 1);
    int64_t value = trace->first + trace->down * top;

    for (struct lim_point *line = &last[bottom - top]; line > last; value += trace->down) {
        line--;
        const bool is_front = is_in_front(value), is_one_side = is_front == is_in_front(value + across);
        if (is_slanted || !is_one_side) {
            if (line->x < line->y) narrow(line, trace, (int16_t)(bottom - 1 - (line - last)), front);
        } else if (is_front != front) {
            line->y = line->x < line->y ? line->x : line->y;
        }
    }
}

/* A screen coordinate of a corner. */
static int32_t corner_q4(int32_t at)
{
    return (at >> (LIM_SUB_BITS > 4 ? LIM_SUB_BITS - 4 : 0)) * (1 << (LIM_SUB_BITS < 4 ? 4 - LIM_SUB_BITS : 0)) +
           LIM_ORIGIN_PX * 16;
}

/* 16 times the trace's value at a corner, as far as that is certain: negative, where a cut leaves nothing of it. Two
 * pixels each way are more than all that is rounded. Sums stay below 2^59. */
static int64_t left_at(const struct lim_point *at, const struct trace *trace, bool front)
{
    const int64_t value = trace->first * 16 + trace->step * corner_q4(at->x) + trace->down * corner_q4(at->y);
    const int64_t step = trace->step < 0 ? -trace->step : trace->step;
    const int64_t down = trace->down < 0 ? -trace->down : trace->down;

    return (front ? value : -value) + 32 * (step + down);
}

/* Leaves of the lines top <= y < bottom those on which a cut may leave anything of the whole. */
static void bound_lines(const struct lim_screen_polygon *whole, const struct trace *trace, bool front, int16_t *top,
                        int16_t *bottom)
{
    const struct lim_point *before = &whole->at[whole->n - 1];
    int64_t value_before = left_at(before, trace, front);
    int32_t low = LIM_SUB_BITS ? INT32_MAX : INT32_MAX / 2, high = INT32_MIN; /* of none; with LIM_ORIGIN_PX in range */

    for (uint_fast8_t k = 0; k < whole->n; k++) {
        const struct lim_point *here = &whole->at[k];
        const int64_t value = left_at(here, trace, front);
        const bool crosses = (value < 0) != (value_before < 0);
        const int32_t y =
            crosses ? lerp_q31(before->y, here->y, lim_plane_zero_q31(value_before, value)) : (int32_t)here->y;
        if (crosses || value >= 0) {
            if (y < low) low = y;
            if (y > high) high = y;
        }
        if (value >= 0 && here->y < low) low = here->y;
        if (value >= 0 && here->y > high) high = here->y;
        before = here;
        value_before = value;
    }
    const int32_t from = (low >> LIM_SUB_BITS) + LIM_ORIGIN_PX - 1, to = (high >> LIM_SUB_BITS) + LIM_ORIGIN_PX + 3;
    if (low > high) *bottom = *top;
    if (low <= high && from > *top) *top = (int16_t)(from < *bottom ? from : *bottom);
    if (low <= high && to < *bottom) *bottom = (int16_t)(to > *top ? to : *top);
}

/* By the cuts from `cut` on. */
static void cut_rows(const struct lim_sorter *sorter, uint16_t entry, uint16_t cut, struct lim_point *last, int16_t top,
                     int16_t bottom)
{
    const struct lim_newell *newell = sorter->newell;

    for (; cut != LIM_NONE; cut = newell->cuts[cut].next) {
        const bool front = newell->cuts[cut].by & LIM_CUT_FRONT;
        struct trace trace;
        struct crossing crossing;
        trace_of(&trace, sorter, entry, cut);
        if (set_crossing(&crossing, &trace, sorter->pass->target.h_px))
            narrow_all(last, &crossing, top, bottom, front);
        else
            search_all(last, &trace, top, bottom, front, sorter->pass->target.w_px);
    }
}

void lim_trace_cut(const struct lim_sorter *sorter, uint16_t entry, const struct lim_screen_polygon *whole,
                   struct lim_point *last, int16_t top, int16_t bottom)
{
    (void)whole;
    cut_rows(sorter, entry, sorter->newell->polygons[entry].cuts, last, top, bottom);
}

void lim_trace_lines(const struct lim_sorter *sorter, uint16_t entry, const struct lim_screen_polygon *whole,
                     const struct lim_rect *open, struct lim_point *last, int16_t *top, int16_t *bottom)
{
    const struct lim_target *target = &sorter->pass->target;
    const struct lim_newell *newell = sorter->newell;
    const uint16_t cut = newell->polygons[entry].cuts;
    struct trace trace;
    struct crossing crossing;

    if (cut == LIM_NONE) {
        trace_lines(last, whole, open, *top, *bottom, NULL, WHOLE);
        return;
    }
    trace_of(&trace, sorter, entry, cut);
    const bool front = newell->cuts[cut].by & LIM_CUT_FRONT;
    if (!LIM_OPTIMISE_SIZE) bound_lines(whole, &trace, front, top, bottom);
    if (*top >= *bottom) return;
    if (!set_crossing(&crossing, &trace, target->h_px)) {
        trace_lines(last, whole, open, *top, *bottom, NULL, WHOLE);
        search_all(last, &trace, *top, *bottom, front, target->w_px);
    } else if (kept_side(&crossing, front) == LOW) {
        trace_lines(last, whole, open, *top, *bottom, &crossing, LOW);
    } else {
        trace_lines(last, whole, open, *top, *bottom, &crossing, HIGH);
    }
    cut_rows(sorter, entry, newell->cuts[cut].next, last, *top, *bottom);
}

struct lim_point lim_piece_line(const struct lim_sorter *sorter, uint16_t entry, const struct lim_screen_polygon *whole,
                                int16_t y)
{
    const struct lim_rect screen = {0, 0, sorter->pass->target.w_px, sorter->pass->target.h_px};
    struct lim_point line = {0, 0};
    int16_t top = y, bottom = (int16_t)(y + 1);

    lim_trace_lines(sorter, entry, whole, &screen, &line, &top, &bottom);
    return line;
}

#endif
