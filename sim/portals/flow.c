/* SPDX-License-Identifier: MIT
 *
 * For each group of openings that lead out of a zone (a door), its hull is what all further rays come from. From an
 * opening's window, the part of it that rays reach, the openings of the cell behind are clipped: through each edge of
 * the window goes the plane that has source and window on different sides and touches the source; nothing is seen
 * beyond it. These are the separating planes of Teller (1992), the windows' edges alone.
 *
 * Windows that meet in an opening become their hull, and what lies behind is looked at again: an opening is
 * looked at a few times, not once for each of the many sequences that lead to it. One that keeps growing is taken
 * as a whole.
 *
 * Margins. What is drawn is rounded. Openings are widened by what that can move, an angle on the screen included, times
 * the distance; once, so that it does not add up from opening to opening. */
#include "portals/flow.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "base/vec3.h"

#include <stdlib.h>
#include <string.h>

enum { WIDENED_MAX = 4 };
static const double SLACK_UNITS = 1.0 / 64.0;  /* more than arithmetic errs */
static const double GRAZING_UNITS = 1.0 / 4.0; /* an eighth of what openings are widened by at least */
static const double RECORD_MARGIN_UNITS = CELLS_MARGIN_UNITS + 2.0;
static const double SAME_UNITS = 0.5; /* a window that grows by less does not */

struct sphere {
    double centre[3], radius;
};

/* One group of openings that lead out of the zone. */
struct source {
    struct flat flat;
    struct patch patch;
    struct sphere eyes; /* holds the zone */
};

void flow_init(struct flow *flow, const struct cells *cells, const struct zones *zones, double angle_rad)
{
    *flow = (struct flow){.cells = cells, .zones = zones, .angle_rad = angle_rad};
    flow->grown = grow_zeroed(cells->opening_count, sizeof *flow->grown);
    flow->grown_for = grow_zeroed(cells->opening_count, sizeof *flow->grown_for);
    flow->window_for = grow_zeroed(cells->opening_count, sizeof *flow->window_for);
    flow->windows = grow_zeroed(cells->opening_count, sizeof *flow->windows);
    flow->widened = grow_zeroed(cells->opening_count, sizeof *flow->widened);
    flow->waiting = grow_zeroed(cells->opening_count, sizeof *flow->waiting);
    flow->queue = grow_zeroed(cells->opening_count + 1, sizeof *flow->queue);
}

void flow_free(struct flow *flow)
{
    free(flow->grown);
    free(flow->grown_for);
    free(flow->window_for);
    free(flow->windows);
    free(flow->widened);
    free(flow->waiting);
    free(flow->queue);
    *flow = (struct flow){0};
}

/* Margins ------------------------------------------------------------------------------------ */

static struct sphere sphere_of_zone(const struct flow *flow, size_t zone)
{
    const struct zones *zones = flow->zones;
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    struct sphere sphere = {{0, 0, 0}, 0};
    for (size_t i = zones->first[zone]; i < zones->first[zone + 1]; i++) {
        const struct cell *cell = &flow->cells->items[zones->cells[i]];
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(low[k], cell->low[k]);
            high[k] = fmax(high[k], cell->high[k]);
        }
    }
    for (int k = 0; k < 3; k++) {
        sphere.centre[k] = (low[k] + high[k]) / 2;
        sphere.radius += (high[k] - low[k]) * (high[k] - low[k]) / 4;
    }
    sphere.radius = sqrt(sphere.radius);
    return sphere;
}

/* How far the edges of a patch may seem to be from where they are, to any eye of the zone. */
static double margin_of(const struct flow *flow, const struct sphere *eyes, const struct patch *patch)
{
    double farthest2 = 0;
    for (size_t i = 0; i < patch->count; i++)
        farthest2 = fmax(farthest2, vec3_distance2(eyes->centre, patch->at[i]));
    return 2.0 + 2.0 * flow->cells->noise_units + flow->angle_rad * (sqrt(farthest2) + eyes->radius);
}

/* An opening as wide as it may seem from the zone. */
static const struct patch *grown(struct flow *flow, const struct source *source, uint32_t index)
{
    const struct opening *opening = &flow->cells->openings[index];
    if (flow->grown_for[index] != flow->zone_number) {
        const double margin_units = margin_of(flow, &source->eyes, &opening->patch);
        patch_grow(&opening->patch, &opening->flat, margin_units, &flow->grown[index]);
        flow->grown_for[index] = flow->zone_number;
    }
    return &flow->grown[index];
}

/* Clipping ----------------------------------------------------------------------------------- */

/* The plane through the window's edge `side` (its plane that stands on the window, the inside in front) that has the
 * source behind it. false: there is none but the window's own. */
static bool separate(const struct source *source, const struct flat *window, const struct flat *side, struct flat *out)
{
    double slope = -INFINITY;
    for (size_t i = 0; i < source->patch.count; i++) {
        const double inward = flat_distance(side, source->patch.at[i]) + SLACK_UNITS;
        const double before = -flat_distance(window, source->patch.at[i]);
        const double apart = inward > 0 ? before - SLACK_UNITS : before + SLACK_UNITS;
        if (apart > SLACK_UNITS)
            slope = fmax(slope, inward / apart);
        else if (inward > GRAZING_UNITS)
            return false; /* rays along the window leave it anywhere */
    }
    if (slope == -INFINITY) return false;
    const double length = sqrt(1 + slope * slope); /* side and window stand on one another */
    for (int k = 0; k < 3; k++)
        out->n[k] = (side->n[k] + slope * window->n[k]) / length;
    out->d = (side->d - SLACK_UNITS + slope * window->d) / length;
    return true;
}

/* What of the patch, which may be off by the margin, is seen through the window. */
static bool clip_through(struct flow *flow, const struct source *source, const struct flat *flat,
                         const struct patch *window, double margin_units, struct patch *patch)
{
    struct flat ahead = *flat;
    ahead.d -= margin_units;
    if (!patch_clip(patch, &ahead)) return false;
    for (size_t i = 0; i < window->count; i++) {
        struct flat side, beyond;
        flow->work++;
        if (!patch_side(window, flat, i, &side) || !separate(source, flat, &side, &beyond)) continue;
        beyond.d -= margin_units;
        if (!patch_clip(patch, &beyond)) return false;
    }
    return true;
}

/* Whether some ray that has come through `source` can pass the plane to its front. */
static bool has_points_behind(const struct patch *patch, const struct flat *flat, double margin_units)
{
    double low, high;
    patch_range(patch, flat, &low, &high);
    return low < margin_units;
}

/* Propagation -------------------------------------------------------------------------------- */

struct front {
    size_t first, count; /* in flow->queue, a ring */
};

static void wait(struct flow *flow, struct front *front, uint32_t opening)
{
    if (flow->waiting[opening]) return;
    flow->waiting[opening] = true;
    const size_t size = flow->cells->opening_count + 1;
    flow->queue[(front->first + front->count++) % size] = opening;
}

static uint32_t next(struct flow *flow, struct front *front)
{
    const size_t size = flow->cells->opening_count + 1;
    const uint32_t opening = flow->queue[front->first];
    front->first = (front->first + 1) % size;
    front->count--;
    flow->waiting[opening] = false;
    return opening;
}

/* Adds a part to an opening's window. */
static void widen(struct flow *flow, struct front *front, uint32_t index, const struct patch *part)
{
    const struct opening *opening = &flow->cells->openings[index];
    struct patch *window = &flow->windows[index];
    if (flow->window_for[index] != flow->group_number) {
        flow->window_for[index] = flow->group_number;
        flow->widened[index] = 0;
        flow->waiting[index] = false;
        window->count = 0;
    }
    if (window->count && patch_holds(window, &opening->flat, part, SAME_UNITS)) return;
    if (window->count && ++flow->widened[index] > WIDENED_MAX) {
        *window = flow->grown[index];
    } else if (window->count) {
        double points[2 * PATCH_CORNERS_MAX][3];
        memcpy(points, window->at, window->count * sizeof *points);
        memcpy(points + window->count, part->at, part->count * sizeof *points);
        patch_hull(window, &opening->flat, (const double(*)[3])points, window->count + part->count);
    } else {
        *window = *part;
    }
    wait(flow, front, index);
}

/* Records of the cell behind an opening that are seen through its window. */
static void records_see(struct flow *flow, const struct source *source, const struct opening *through,
                        const struct patch *window)
{
    const struct cell *cell = &flow->cells->items[through->to];
    for (size_t i = 0; i < cell->touch_count; i++) {
        const uint32_t index = flow->cells->touches[cell->first_touch + i];
        struct patch patch = flow->cells->records[index].patch;
        if (flow->visible[index]) continue;
        flow->visible[index] = clip_through(flow, source, &through->flat, window, RECORD_MARGIN_UNITS, &patch);
        flow->unseen -= flow->visible[index];
    }
}

static void look_on(struct flow *flow, struct front *front, const struct source *source, uint32_t index)
{
    const struct opening *through = &flow->cells->openings[index];
    const struct cell *cell = &flow->cells->items[through->to];
    const struct patch window = flow->windows[index];
    struct source behind = *source; /* the part that rays through the window can come from */
    struct flat back = flat_turned(&through->flat);
    back.d -= SLACK_UNITS;
    if (!patch_clip(&behind.patch, &back)) return;
    source = &behind;
    records_see(flow, source, through, &window);
    for (size_t i = 0; i < cell->opening_count; i++) {
        const uint32_t onward = (uint32_t)(cell->first_opening + i);
        const struct opening *opening = &flow->cells->openings[onward];
        if (opening->node == through->node) continue;
        if (!has_points_behind(&source->patch, &opening->flat, SLACK_UNITS)) continue;
        struct patch part = *grown(flow, source, onward);
        if (clip_through(flow, source, &through->flat, &window, SLACK_UNITS, &part)) widen(flow, front, onward, &part);
    }
}

/* Groups ------------------------------------------------------------------------------------- */

static bool is_exit(const struct flow *flow, size_t zone, const struct opening *opening)
{
    return flow->zones->of_cell[opening->from] == zone && flow->zones->of_cell[opening->to] != zone;
}

static bool same_group(const struct flow *flow, const struct opening *a, const struct opening *b)
{
    return a->node == b->node && vec3_dot(a->flat.n, b->flat.n) > 0 &&
           flow->zones->of_cell[a->to] == flow->zones->of_cell[b->to];
}

struct exits {
    uint32_t *items;
    size_t count, capacity;
};

static void exits_find(const struct flow *flow, size_t zone, struct exits *exits)
{
    const struct zones *zones = flow->zones;
    for (size_t i = zones->first[zone]; i < zones->first[zone + 1]; i++) {
        const struct cell *cell = &flow->cells->items[zones->cells[i]];
        for (size_t k = 0; k < cell->opening_count; k++) {
            const uint32_t index = (uint32_t)(cell->first_opening + k);
            if (!is_exit(flow, zone, &flow->cells->openings[index])) continue;
            exits->items = grow(exits->items, exits->count, &exits->capacity, sizeof *exits->items);
            exits->items[exits->count++] = index;
        }
    }
}

/* Moves the first exit's group to the front of the list; returns its size. */
static size_t group_gather(const struct flow *flow, uint32_t *exits, size_t count)
{
    const struct opening *openings = flow->cells->openings;
    size_t gathered = 1;
    for (size_t i = 1; i < count; i++) {
        if (!same_group(flow, &openings[exits[0]], &openings[exits[i]])) continue;
        const uint32_t moved = exits[i];
        exits[i] = exits[gathered];
        exits[gathered++] = moved;
    }
    return gathered;
}

static void source_make(struct flow *flow, const uint32_t *exits, size_t count, struct source *source)
{
    const struct opening *openings = flow->cells->openings;
    double(*points)[3] = grow_zeroed(count * PATCH_CORNERS_MAX, sizeof *points);
    size_t point_count = 0;
    for (size_t i = 0; i < count; i++) {
        const struct patch *patch = grown(flow, source, exits[i]);
        memcpy(points + point_count, patch->at, patch->count * sizeof *points);
        point_count += patch->count;
    }
    source->flat = openings[exits[0]].flat;
    patch_hull(&source->patch, &source->flat, (const double(*)[3])points, point_count);
    if (source->patch.count == 0) source->patch = *grown(flow, source, exits[0]);
    free(points);
}

static bool group_follow(struct flow *flow, const struct source *source, const uint32_t *exits, size_t count)
{
    struct front front = {0, 0};
    flow->group_number++;
    for (size_t i = 0; i < count; i++)
        widen(flow, &front, exits[i], grown(flow, source, exits[i]));
    while (front.count && flow->unseen && flow->work < flow->work_max && !deadline_passed())
        look_on(flow, &front, source, next(flow, &front));
    return !front.count || !flow->unseen;
}

/* Records ------------------------------------------------------------------------------------ */

/* Whether all the zone's cells lie behind the polygon: its back is not drawn. */
static bool turns_its_back(const struct flow *flow, size_t zone, const struct flat *faces)
{
    const struct zones *zones = flow->zones;
    for (size_t i = zones->first[zone]; i < zones->first[zone + 1]; i++) {
        const struct cell *cell = &flow->cells->items[zones->cells[i]];
        double highest = -faces->d;
        for (int k = 0; k < 3; k++)
            highest += faces->n[k] * (faces->n[k] > 0 ? cell->high[k] : cell->low[k]);
        if (highest > -1.0) return false;
    }
    return true;
}

/* What the zone's own cells touch; and slivers: nobody knows what they touch. Backs are not looked for, and dropped in
 * the end. */
static void records_begin(struct flow *flow, size_t zone)
{
    const struct zones *zones = flow->zones;
    flow->unseen = 0;
    for (size_t r = 0; r < flow->cells->record_count; r++)
        flow->visible[r] =
            flow->cells->records[r].patch.count == 0 || turns_its_back(flow, zone, &flow->cells->records[r].faces);
    for (size_t i = zones->first[zone]; i < zones->first[zone + 1]; i++) {
        const struct cell *cell = &flow->cells->items[zones->cells[i]];
        for (size_t k = 0; k < cell->touch_count; k++)
            flow->visible[flow->cells->touches[cell->first_touch + k]] = true;
    }
    for (size_t r = 0; r < flow->cells->record_count; r++)
        flow->unseen += !flow->visible[r];
}

static void backs_drop(struct flow *flow, size_t zone)
{
    for (size_t r = 0; r < flow->cells->record_count; r++)
        if (flow->visible[r] && turns_its_back(flow, zone, &flow->cells->records[r].faces)) flow->visible[r] = false;
}

bool flow_see(struct flow *flow, size_t zone, bool *visible)
{
    struct exits exits = {0};
    struct source source;
    bool ok = true;
    flow->work = 0;
    flow->zone_number = zone + 1;
    flow->visible = visible;
    records_begin(flow, zone);
    source.eyes = sphere_of_zone(flow, zone);
    exits_find(flow, zone, &exits);
    for (size_t i = 0, size; ok && i < exits.count; i += size) {
        size = group_gather(flow, exits.items + i, exits.count - i);
        source_make(flow, exits.items + i, size, &source);
        ok = group_follow(flow, &source, exits.items + i, size);
    }
    backs_drop(flow, zone);
    free(exits.items);
    return ok;
}
