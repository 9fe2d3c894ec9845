/* SPDX-License-Identifier: MIT
 *
 * Input: a band in the middle of pass one. Output: the same, lower, as if it had never had the lines below. To find all
 * of a band again costs a walk; to give up an eighth of its lines costs what was found for these alone. Memory: none of
 * its own. Retained polygons come one after the other in their pool, so those that stay are moved up to one another in
 * that order, and linked into their lines as they were when they came. */
#include "orders/room.h"

#include "lines/retain.h"
#include "lines/span.h"
#include "view/pass.h"
#include "view/view.h"

#if LIM_HAS_SPANS

enum { LEAST_LINES = 8, PART = 8 };
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

/* In the place of links, the lines that lists belong to. */
static void note_lines(const struct lim_nearest *nearest)
{
    union lim_retained_cell *cells = nearest->retained.cells;

    for (uint16_t y = nearest->top; y < nearest->bottom; y++) {
        uint16_t polygon = nearest->spans.lines[y].retained;
        while (polygon != LIM_NONE) {
            const uint16_t next = cells[polygon].link.next;
            cells[polygon].link.next = y;
            polygon = next;
        }
        nearest->spans.lines[y].retained = LIM_NONE;
    }
}

static uint16_t cells_of(const union lim_retained_cell *cells)
{
    const bool transparent = LIM_HAS_TRANSPARENT && cells[1].look.bottom & LIM_RETAINED_TRANSPARENT;

    return (uint16_t)(LIM_RETAINED_HEAD_CELLS + cells[0].link.n + transparent);
}

static void keep_above(struct lim_nearest *nearest, uint16_t bottom)
{
    struct lim_retained *retained = &nearest->retained;
    union lim_retained_cell *cells = retained->cells;
    uint16_t to = 0;

    for (uint16_t from = 0; from < retained->used;) {
        struct lim_line *line = &nearest->spans.lines[cells[from].link.next];
        const bool stays = cells[from].link.next < bottom;
        const uint16_t self = to, end = (uint16_t)(from + cells_of(&cells[from]));
        if (!stays) {
            from = end;
            continue;
        }
        while (from < end)
            cells[to++] = cells[from++];
        cells[self].link.next = line->retained;
        line->retained = self;
    }
    retained->used = to;
    lim_share_set_lowest(&nearest->spans);
}

bool lim_room_make(struct lim_nearest *nearest)
{
    struct lim_spans *spans = &nearest->spans;

    if (!can_shorten(nearest)) return false;
    const uint16_t bottom = (uint16_t)(nearest->bottom - (nearest->bottom - nearest->top) / PART);
    close_lines_from(spans, bottom, nearest->bottom);
    note_lines(nearest);
    keep_above(nearest, bottom);
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
