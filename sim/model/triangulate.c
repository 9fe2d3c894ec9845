/* SPDX-License-Identifier: MIT
 *
 * Ear clipping in the view that sees most of the loop. An ear is a left-turning corner whose triangle
 * holds no other corner. Loops that have none (they cross themselves) lose the next best corner, so
 * the end is always reached. The search goes on behind the last cut, which keeps fans short. */
#include "model/triangulate.h"

#include "base/deadline.h"
#include "base/grow.h"

#include <stdlib.h>
#include <string.h>

/* What a corner must satisfy to be cut off, from the ideal down to anything. */
enum demand { DEMAND_EAR, DEMAND_LEFT_TURN, DEMAND_NOTHING };

struct clipping {
    double (*points)[3];
    const struct loop_view *view;
    uint32_t *left; /* the loop that is left */
    size_t count;
};

static bool is_inside(const struct clipping *clipping, const uint32_t ear[3], uint32_t point)
{
    for (int side = 0; side < 3; side++) {
        if (point == ear[side]) return false;
        if (loop_turn(clipping->points, clipping->view, ear[side], ear[(side + 1) % 3], point) < 0) return false;
    }
    return true;
}

static bool holds_other_corner(const struct clipping *clipping, const uint32_t ear[3])
{
    for (size_t i = 0; i < clipping->count; i++)
        if (is_inside(clipping, ear, clipping->left[i])) return true;
    return false;
}

static bool satisfies(const struct clipping *clipping, const uint32_t ear[3], enum demand demand)
{
    if (demand == DEMAND_NOTHING) return true;
    if (loop_turn(clipping->points, clipping->view, ear[0], ear[1], ear[2]) <= 0) return false;
    return demand == DEMAND_LEFT_TURN || !holds_other_corner(clipping, ear);
}

static void ear_at(const struct clipping *clipping, size_t i, uint32_t ear[3])
{
    ear[0] = clipping->left[(i + clipping->count - 1) % clipping->count];
    ear[1] = clipping->left[i];
    ear[2] = clipping->left[(i + 1) % clipping->count];
}

/* The first corner from `from` on that satisfies the highest demand that any does. */
static size_t find_ear(const struct clipping *clipping, size_t from, uint32_t ear[3])
{
    for (enum demand demand = deadline_passed() ? DEMAND_NOTHING : DEMAND_EAR;; demand++)
        for (size_t step = 0; step < clipping->count; step++) {
            size_t i = (from + step) % clipping->count;
            ear_at(clipping, i, ear);
            if (satisfies(clipping, ear, demand)) return i;
        }
}

void triangulate(const struct loop *loop, const struct loop_view *view, uint32_t (*triangles)[3])
{
    struct clipping clipping = {loop->points, view, grow_zeroed(loop->count, sizeof(uint32_t)), loop->count};
    memcpy(clipping.left, loop->corners, loop->count * sizeof *loop->corners);
    size_t from = 1;
    while (clipping.count > 3) {
        size_t ear = find_ear(&clipping, from, *triangles++);
        memmove(&clipping.left[ear], &clipping.left[ear + 1], (clipping.count - ear - 1) * sizeof *clipping.left);
        clipping.count--;
        from = (ear + 1) % clipping.count;
    }
    memcpy(*triangles, clipping.left, 3 * sizeof *clipping.left);
    free(clipping.left);
}
