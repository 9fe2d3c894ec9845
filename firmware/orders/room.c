/* SPDX-License-Identifier: MIT
 *
 * Input: a band in the middle of pass one. Output: the same, lower, as if it had never had the lines below. To find all
 * of a band again costs a walk; to give up its lowest lines costs what was found for these alone. At least an eighth of
 * the lines goes. More go, up to half of them, until an eighth of the pool is free: each time the pool is moved up, so
 * it should seldom be. Memory: none of its own. Retained polygons come one after the other in their pool. Those that
 * stay are moved up to one another in that order, and linked into their lines as they were when they came. */
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
           !(LIM_HAS_MOVERS && lim_moves(*nearest->movers));
}

static uint_fast16_t cells_of(const union lim_retained_cell *cells)
{
    const bool transparent = LIM_HAS_TRANSPARENT && cells[1].look.bottom & LIM_RETAINED_TRANSPARENT;

    return (uint_fast16_t)(LIM_RETAINED_HEAD_CELLS + cells[0].link.n + transparent);
}

/* Takes the list of line y apart: each polygon has the line in the place of its link. Returns the cells that they take.
 */
static uint_fast16_t unlink_line(const struct lim_nearest *nearest, uint_fast16_t y)
{
    union lim_retained_cell *const cells = nearest->retained.cells;
    uint16_t *const link = &nearest->spans.lines[y].retained;
    uint_fast16_t count = 0;

    while (*link != LIM_NONE) {
        union lim_retained_cell *const polygon = &cells[*link];
        *link = polygon[0].link.next;
        polygon[0].link.next = (uint16_t)y;
        count += cells_of(polygon);
    }
    return count;
}

/* Takes all lines apart. From the lowest one up they are closed and given up, until that is enough. */
static void give_up(struct lim_nearest *nearest)
{
    const uint_fast16_t top = nearest->top, height = nearest->bottom - top;
    const uint_fast16_t least = height - height / PART, most = height - height / MOST_PART;
    uint_fast16_t wanted = nearest->retained.used / PART;

    for (uint_fast16_t row = height; row-- > 0;) {
        if (row >= least || (row >= most && wanted)) {
            nearest->bottom = (uint16_t)(top + row);
            (void)lim_span_close(&nearest->spans, &nearest->spans.lines[top + row], 0, INT16_MAX, NULL, NULL);
        }
        const uint_fast16_t count = unlink_line(nearest, top + row);
        wanted -= count < wanted ? count : wanted;
    }
    if (nearest->spans.open.y1 > nearest->bottom) nearest->spans.open.y1 = nearest->bottom;
    nearest->spans.trimmed = true;
}

static void keep_above(struct lim_nearest *nearest)
{
    struct lim_retained *retained = &nearest->retained;
    const union lim_retained_cell *from = retained->cells, *const end = from + retained->used;
    union lim_retained_cell *to = retained->cells;

    while (from < end) {
        const union lim_retained_cell *const after = from + cells_of(from);
        const uint16_t y = from[0].link.next;
        if (y < nearest->bottom) {
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
    give_up(nearest);
    keep_above(nearest);
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
