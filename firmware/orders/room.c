/* SPDX-License-Identifier: MIT
 *
 * Input: a band in the middle of pass one. Output: the same, lower, as if it had never had the lines below. To find all
 * of a band again costs a walk; to give up its lowest lines costs what was found for these alone. They are an eighth of
 * the band or more, and an eighth of what is retained starts on them, or more: the pool is moved up each time, which is
 * to pay. Memory: none of its own. Retained polygons come one after the other in their pool, so those that stay are
 * moved up to one another in that order, and linked into their lines as they were when they came. */
#include "orders/room.h"

#include "lines/retain.h"
#include "lines/span.h"
#include "view/pass.h"
#include "view/view.h"

#if LIM_HAS_SPANS

enum { LEAST_LINES = 8, PART = 8, MOST_PART = 2 };
enum { KEPT_PART = 6, LEAST_PARTS = 3 };

/* Pieces and the flags of edges take cells of which their polygon does not say how many; samples close a line in
 * several steps, which cannot be taken up again. */
static bool can_shorten(const struct lim_nearest *nearest)
{
    return nearest->bottom - nearest->top >= LEAST_LINES && !LIM_IS_SORTED(&nearest->pass->target) && !nearest->fills &&
           !lim_wireframe_of(nearest->pass) && !lim_is_antialiased(&nearest->pass->view) &&
           !(LIM_HAS_MOVERS && lim_moves(*nearest->sorter));
}

static void close_lines_from(struct lim_spans *spans, uint16_t bottom, uint16_t end)
{
    for (uint16_t y = bottom; y < end; y++)
        (void)lim_span_close(spans, &spans->lines[y], 0, INT16_MAX, NULL, NULL);
    if (spans->open.y1 > bottom) spans->open.y1 = bottom;
    spans->trimmed = true;
}

static uint16_t cells_of(const union lim_retained_cell *cells)
{
    const bool transparent = LIM_HAS_TRANSPARENT && cells[1].look.bottom & LIM_RETAINED_TRANSPARENT;

    return (uint16_t)(LIM_RETAINED_HEAD_CELLS + cells[0].link.n + transparent);
}

/* Takes a line's list apart: each polygon has `mark` in the place of its link. Returns the cells that they take. */
static uint16_t unlink_line(struct lim_line *line, union lim_retained_cell *cells, uint16_t mark)
{
    uint16_t polygon = line->retained, count = 0;

    while (polygon != LIM_NONE) {
        const uint16_t next = cells[polygon].link.next;
        cells[polygon].link.next = mark;
        count = (uint16_t)(count + cells_of(&cells[polygon]));
        polygon = next;
    }
    line->retained = LIM_NONE;
    return count;
}

/* Takes all lines apart: from the lowest one up they are given up, until that is enough. Polygons of the others have
 * their line in the place of their link. Returns the first line that is given up. */
static uint16_t unlink_lines(const struct lim_nearest *nearest)
{
    const uint16_t height = (uint16_t)(nearest->bottom - nearest->top), enough = nearest->retained.used / PART;
    const uint16_t least = (uint16_t)(nearest->bottom - height / PART),
                   most = (uint16_t)(nearest->bottom - height / MOST_PART);
    uint16_t bottom = nearest->bottom, count = 0;

    for (uint16_t y = nearest->bottom; y > nearest->top;) {
        const bool gives_up = y == bottom && (y > least || (y > most && count < enough));
        y--;
        if (gives_up) bottom = y;
        count = (uint16_t)(count + unlink_line(&nearest->spans.lines[y], nearest->retained.cells,
                                               gives_up ? (uint16_t)LIM_NONE : y));
    }
    return bottom;
}

static void keep_above(struct lim_nearest *nearest)
{
    struct lim_retained *retained = &nearest->retained;
    const union lim_retained_cell *from = retained->cells, *const end = from + retained->used;
    union lim_retained_cell *to = retained->cells;

    while (from < end) {
        const union lim_retained_cell *const after = from + cells_of(from);
        const uint16_t y = from[0].link.next;
        if (y != LIM_NONE) {
            struct lim_line *line = &nearest->spans.lines[y];
            union lim_retained_cell *const self = to;
            do
                *to++ = *from++;
            while (from < after);
            self[0].link.next = line->retained;
            line->retained = (uint16_t)(self - retained->cells);
        }
        from = after;
    }
    retained->used = (uint16_t)(to - retained->cells);
    lim_share_set_lowest(&nearest->spans);
}

bool lim_room_make(struct lim_nearest *nearest)
{
    if (!can_shorten(nearest)) return false;
    const uint16_t bottom = unlink_lines(nearest);
    close_lines_from(&nearest->spans, bottom, nearest->bottom);
    keep_above(nearest);
    nearest->bottom = bottom;
    nearest->since_shrink = LIM_POLYGONS_PER_SHRINK - 1;
    return true;
}

bool lim_room_keep(struct lim_nearest *nearest)
{
    struct lim_retained *retained = &nearest->retained;
    const uint16_t least = (uint16_t)(LIM_RETAINED_HEAD_CELLS + nearest->pass->scene->limits.vertices + CLIP_PLANES);
    const uint16_t part = (uint16_t)(retained->whole / KEPT_PART);

    if (!part || retained->end < LEAST_PARTS * part || retained->end - part < least) return false;
    retained->end = (uint16_t)(retained->end - part);
    return true;
}

#endif
