/* SPDX-License-Identifier: MIT
 *
 * A plane cuts a polygon along a line, and that line and the eye span a plane through the eye, m . r = 0. The
 * ray through the centre of pixel (x, y) of w times h is r = ((2x + 1 - w) / w, (2y + 1 - h) / h, 1), so along a line
 * of pixels w h m . r steps by 2 h m[0]: with |m| < 2^30 all of it stays below 2^52; of samples, below 2^58. */
#include "lines/layers.h"
#include "pieces/corners.h"
#include "pieces/entry.h"
#include "pieces/piece.h"

#if LIM_HAS_PIECES

/* w h m . r at the centres of pixels, >= 0 where the plane's front is; all 0, which is all front, if the line is a
 * point.
 */
struct trace {
    int64_t first, step, down; /* of pixel (0, 0), and to the next one in its line and in its column */
#if LIM_HAS_ANTIALIAS
    int64_t shift; /* for samples, by column of the lattice that holds them, 16 times and 4 times as many; else 0 */
#endif
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

/* A mover's corners are where its view has them; in the scene they have fraction bits. */
static int64_t corner_value(const struct lim *lim, uint16_t entry, lim_index vertex,
                            const struct lim_plane_unpacked *plane)
{
    if (LIM_HAS_MOVERS && lim_entry_owner(lim, entry) != LIM_NONE) {
        int32_t at_q12[3];
        lim_entry_corner(lim, entry, vertex, at_q12);
        return lim_corner_value(plane, at_q12);
    }
    const struct lim_vertex at = lim->scene->vertices[vertex];
    return lim_plane_value(plane, at.x, at.y, at.z, 1);
}

static void find_chord(struct chord *chord, const struct lim *lim, uint16_t entry,
                       const struct lim_plane_unpacked *plane)
{
    const struct lim_scene *scene = lim_entry_scene(lim, entry);
    const LIM_FLASH lim_index *record = lim_entry_record(lim, entry);
    const LIM_FLASH lim_index *corners = record + LIM_POLYGON_HEAD_WORDS;
    const uint_fast8_t n = record[0] & LIM_POLYGON_COUNT;
    int32_t before[3] = {0, 0, 0}, here[3];
    int64_t value_before = 0;

    *chord = (struct chord){.far_value = 0};
    for (uint_fast8_t k = 0; k <= n; k++) {
        const lim_index vertex = corners[k < n ? k : 0];
        struct lim_view_point point;
        lim_view_transform(lim_entry_rows(lim, entry), scene, &scene->vertices[vertex], &point);
        const int64_t value = corner_value(lim, entry, vertex, plane);
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

/* m above, turned so that it is >= 0 where the plane's front is. */
static void find_line(int32_t out[3], const struct chord *chord)
{
    int64_t m[3], dot = 0;
    uint64_t bits = 0;
    uint8_t shift = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
        const uint_fast8_t j = lim_axis_after(i), k = lim_axis_after(j);
        m[i] = (int64_t)chord->out[j] * chord->back[k] - (int64_t)chord->out[k] * chord->back[j];
        bits |= m[i] < 0 ? 0 - (uint64_t)m[i] : (uint64_t)m[i];
    }
    while (bits >> shift >> 30)
        shift++;
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
#if LIM_HAS_ANTIALIAS
    trace->shift = across > 1 ? 2 * mx : 0;
#endif
}

static void set_trace(struct trace *trace, const struct lim *lim, uint16_t entry,
                      const struct lim_plane_unpacked *plane)
{
    const int32_t w_px = lim->target.w_px, h_px = lim->target.h_px;
    struct chord chord;
    int32_t m[3];

    find_chord(&chord, lim, entry, plane);
    find_line(m, &chord);
    if (lim_is_antialiased(&lim->view))
        set_lattice(trace, m, w_px * LIM_SAMPLE_COLUMNS, h_px * LIM_SAMPLE_ROWS, LIM_SAMPLES_A_ROW);
    else
        set_lattice(trace, m, w_px, h_px, 1);
}

/* At a pixel of a line, or a sample of a row. */
static inline int64_t value_at(const struct trace *trace, int32_t x, int16_t row)
{
    int64_t value = trace->first + trace->step * x + trace->down * row;

#if LIM_HAS_ANTIALIAS
    if (trace->shift) value += trace->shift * lim_sample_shift(row);
#endif
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

/* The part of the screen that is drawn: no line leaves it. */
static void trace_fill_lines(struct lim_point *last, const struct lim_screen_polygon *whole,
                             const struct lim_rect *open, int16_t top, int16_t bottom)
{
    struct lim_edge_pair pair;

    lim_edge_begin(&pair, whole->n, whole->shape.first);
    for (int16_t y = top; y < bottom; y++) {
        lim_edge_advance(&pair, whole->at, whole->n, y);
        struct lim_point *line = &last[bottom - 1 - y];
        const int16_t left = lim_edge_x(&pair.left), right = lim_edge_x(&pair.right);
        line->x = left > (int16_t)open->x0 ? left : (int16_t)open->x0;
        line->y = right < (int16_t)open->x1 ? right : (int16_t)open->x1;
    }
}

static void cut_lines(const struct lim *lim, uint16_t entry, struct lim_point *last, int16_t top, int16_t bottom)
{
    const struct lim_newell *newell = &lim->sorter.newell;

    for (uint16_t cut = newell->polygons[entry].cuts; cut != LIM_NONE; cut = newell->cuts[cut].next) {
        struct lim_plane_unpacked plane;
        struct trace trace;
        lim_plane_load(&plane, lim, newell->cuts[cut].by & LIM_SORTED_MAX);
        set_trace(&trace, lim, entry, &plane);
        for (int16_t y = top; y < bottom; y++) {
            struct lim_point *line = &last[bottom - 1 - y];
            if (line->x < line->y) narrow(line, &trace, y, newell->cuts[cut].by & LIM_CUT_FRONT);
        }
    }
}

#if LIM_HAS_SPANS
static enum lim_span_result trace_close_lines(struct lim_spans *spans, const struct lim_point *last, int16_t top,
                                              int16_t bottom)
{
    uint8_t result = LIM_SPAN_NOTHING;

    for (int16_t y = top; y < bottom; y++) {
        const struct lim_point *line = &last[bottom - 1 - y];
        if (line->x < line->y)
            result |= (uint8_t)lim_span_close(spans, &spans->lines[y], (int16_t)line->x, (int16_t)line->y, NULL, NULL);
    }
    return result & LIM_SPAN_EXHAUSTED ? LIM_SPAN_EXHAUSTED : (enum lim_span_result)result;
}

static bool see_lines(const struct lim_spans *spans, const struct lim_point *last, int16_t top, int16_t bottom)
{
#if LIM_HAS_TRANSPARENT
    for (int16_t y = top; y < bottom; y++) {
        const struct lim_point *line = &last[bottom - 1 - y];
        if (lim_layers_see_line(spans, (uint16_t)y, (int16_t)line->x, (int16_t)line->y)) return true;
    }
#else
    (void)spans, (void)last, (void)top, (void)bottom;
#endif
    return false;
}

/* A transparent piece leaves its pixels open. */
static enum lim_span_result pass(struct lim *lim, uint8_t alpha, const struct lim_point *last, int16_t top,
                                 int16_t bottom)
{
    if (!LIM_HAS_TRANSPARENT || alpha == LIM_OPAQUE) return trace_close_lines(&lim->spans, last, top, bottom);
    return see_lines(&lim->spans, last, top, bottom) ? LIM_SPAN_SOME : LIM_SPAN_NOTHING;
}

static bool is_empty(const struct lim_point *line)
{
    return line->x >= line->y;
}

/* Lines of the whole above and below the piece need not be retained. */
static void trim(struct lim_point *last, int16_t *top, int16_t *bottom)
{
    int16_t below = 0;

    while (*top < *bottom && is_empty(&last[*bottom - 1 - *top]))
        ++*top;
    while (*top < *bottom - below && is_empty(&last[below]))
        below++;
    *bottom = (int16_t)(*bottom - below);
    for (int16_t i = 0; below && i < *bottom - *top; i++)
        last[i] = last[i + below];
}

#if LIM_HAS_ANTIALIAS
/* trace_fill_lines() for rows of samples. */
static void fill_rows(struct lim_point *last, const struct lim_screen_polygon *whole, const struct lim_rect *open,
                      int16_t top, int16_t bottom)
{
    const int16_t x0 = (int16_t)(open->x0 * LIM_SAMPLES_A_ROW), x1 = (int16_t)(open->x1 * LIM_SAMPLES_A_ROW);
    struct lim_sample_edges edges;
    struct lim_strip strip;

    lim_strip_begin(&edges, whole->n, whole->shape.first);
    for (int16_t y = top; y < bottom; y++) {
        lim_strip_next(&strip, &edges, whole->at, whole->n, whole->shape.first, y, whole->shape.end_row);
        for (uint_fast8_t s = 0; s < LIM_SAMPLE_ROWS; s++) {
            struct lim_point *row = &last[(bottom - y) * LIM_SAMPLE_ROWS - 1 - (int16_t)s];
            row->x = strip.left[s] > x0 ? strip.left[s] : x0;
            row->y = strip.right[s] < x1 ? strip.right[s] : x1;
        }
    }
}

/* pass() for them; a line that is drawn alone takes them at once. */
static enum lim_span_result pass_rows(struct lim *lim, const struct lim_screen_polygon *whole,
                                      const struct lim_point *last, int16_t top, int16_t bottom)
{
    const int16_t end_row = (int16_t)(bottom * LIM_SAMPLE_ROWS);
    uint8_t result = LIM_SPAN_NOTHING;
    struct lim_strip strip;

    for (int16_t y = top; y < bottom; y++) {
        lim_strip_of_rows(&strip, last, end_row, y);
        if (lim->paint.smooth.line)
            lim_smooth_add(lim, &strip, whole);
        else if (!LIM_HAS_TRANSPARENT || lim_alpha_of(whole) == LIM_OPAQUE)
            result |= (uint8_t)lim_mask_close(&lim->spans, &lim->spans.lines[y], &strip, NULL, NULL);
        else if (lim_mask_see(&lim->spans, &lim->spans.lines[y], &strip, NULL, NULL))
            return LIM_SPAN_SOME;
    }
    return result & LIM_SPAN_EXHAUSTED ? LIM_SPAN_EXHAUSTED : (enum lim_span_result)result;
}
#endif

/* Rows of a line that are retained one by one, for pixels or for samples. */
static inline int16_t rows_of(const struct lim *lim)
{
    return lim_is_antialiased(&lim->view) ? LIM_SAMPLE_ROWS : 1;
}

/* Which pixels or samples of lines top <= y < bottom the piece has, and whether any is open. */
static inline enum lim_span_result see_piece(struct lim *lim, uint16_t entry, const struct lim_screen_polygon *whole,
                                             struct lim_point *last, int16_t *top, int16_t *bottom)
{
#if LIM_HAS_ANTIALIAS
    if (lim_is_antialiased(&lim->view)) {
        fill_rows(last, whole, &lim->spans.open, *top, *bottom);
        cut_lines(lim, entry, last, (int16_t)(*top * LIM_SAMPLE_ROWS), (int16_t)(*bottom * LIM_SAMPLE_ROWS));
        return pass_rows(lim, whole, last, *top, *bottom);
    }
#endif
    trace_fill_lines(last, whole, &lim->spans.open, *top, *bottom);
    cut_lines(lim, entry, last, *top, *bottom);
    trim(last, top, bottom);
    const uint8_t alpha = lim_wireframe_of(lim) ? (uint8_t)LIM_OPAQUE : lim_alpha_of(whole);
    return pass(lim, alpha, last, *top, *bottom);
}

static uint32_t trace_cells_of(const struct lim *lim, int16_t top, int16_t bottom)
{
    return (uint32_t)(bottom - top) * (uint32_t)rows_of(lim);
}

static bool trace_take_plain(struct lim *lim, uint16_t entry, const struct lim_screen_polygon *whole)
{
    const struct lim_rect *open = &lim->spans.open;
    int16_t top = whole->shape.top > (int16_t)open->y0 ? whole->shape.top : (int16_t)open->y0;
    int16_t bottom = whole->shape.bottom < (int16_t)open->y1 ? whole->shape.bottom : (int16_t)open->y1;
    struct lim_retained *retained = &lim->retained;
    struct lim_point *last = &retained->cells[retained->used].at + LIM_RETAINED_HEAD_CELLS;

    if (top >= bottom) return true;
    if (LIM_RETAINED_HEAD_CELLS + trace_cells_of(lim, top, bottom) > (uint32_t)(retained->size - retained->used))
        return false;
    if (LIM_HAS_STATS) lim_stats_of(lim)->lines += (uint32_t)(bottom - top);
    const enum lim_span_result result = see_piece(lim, entry, whole, last, &top, &bottom);
    if (result != LIM_SPAN_SOME) return result == LIM_SPAN_NOTHING;
    if (LIM_HAS_STATS) lim_stats_of(lim)->polygons_seen++;
    struct lim_retained_polygon seen =
        lim_retained_of(whole, top, (int16_t)(bottom * rows_of(lim)), lim_wireframe_of(lim));
    seen.at = last;
    seen.n = seen.first = 0;
    if (!lim_retain(retained, lim->spans.lines, &seen)) return false;
    retained->used = (uint16_t)(retained->used + trace_cells_of(lim, top, bottom)); /* what is left of them */
    return true;
}

#endif

struct lim_point lim_piece_line(const struct lim *lim, uint16_t entry, const struct lim_screen_polygon *whole,
                                int16_t y)
{
    const struct lim_rect screen = {0, 0, lim->target.w_px, lim->target.h_px};
    struct lim_point line;

    trace_fill_lines(&line, whole, &screen, y, (int16_t)(y + 1));
    cut_lines(lim, entry, &line, y, (int16_t)(y + 1));
    return line;
}

#if LIM_HAS_SPANS
bool lim_piece_take(struct lim *lim, uint16_t entry, const struct lim_screen_polygon *whole)
{
    struct lim_screen_polygon triangle;

    if (!whole->shape.non_monotone) return trace_take_plain(lim, entry, whole);
    for (uint8_t k = 1; k + 1 < whole->n; k++) {
        lim_project_fan(whole, k, &triangle);
        if (!trace_take_plain(lim, entry, &triangle)) return false;
    }
    return true;
}

#endif

#endif
