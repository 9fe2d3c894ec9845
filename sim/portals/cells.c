/* SPDX-License-Identifier: MIT
 *
 * A node's facet is its plane within the regions of the nodes above. It is filed down both subtrees: each pair of
 * cells that a part of it lies between are neighbours, through what is left of that part when the polygons of the
 * node that face the one side are taken out. What remains along a polygon's edge and is thinner than rounding
 * explains is no opening: there the polygon ends at another one, with which it shares that edge. */
#include "portals/cells.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "base/vec3.h"
#include "scene/plane.h"
#include "scene/vertex_units.h"

#include <stdlib.h>
#include <string.h>

enum { OPENINGS_MAX = 100000 };
/* With any other flag, one may see through a polygon. */
enum { KNOWN_FLAGS = LIM_POLYGON_COUNT | LIM_POLYGON_LAST | LIM_POLYGON_EDGES | LIM_POLYGON_TEXTURE };

static const double GROWN_UNITS = 16.0;
static const double LEAST_OPENING_UNITS = 1.0 / 16.0;
static const double NOISE_FACTOR = 3.0; /* two faces' noise where they meet at an angle of 60 degrees or more */

/* Planes and records ------------------------------------------------------------------------- */

static struct flat flat_of(const struct lim_scene *scene, lim_index node)
{
    int64_t n[3], d;
    plane_exact(scene, &scene->nodes[node].split, n, &d);
    const double length = sqrt((double)n[0] * (double)n[0] + (double)n[1] * (double)n[1] + (double)n[2] * (double)n[2]);
    return (struct flat){{(double)n[0] / length, (double)n[1] / length, (double)n[2] / length}, (double)d / length};
}

static void vertex_at(const struct lim_scene *scene, lim_index index, double out[3])
{
    vertex_units(scene, index, out);
}

/* How far the corners lie off their plane, and on the wrong side of those above. */
static void note_noise(struct cells *cells, uint32_t node, const double (*corners)[3], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        cells->noise_units = fmax(cells->noise_units, fabs(flat_distance(&cells->planes[node], corners[i])));
        for (uint32_t at = node; at != cells->parents[at]; at = cells->parents[at]) {
            const uint32_t above = cells->parents[at];
            const double distance = flat_distance(&cells->planes[above], corners[i]);
            const bool in_front = cells->scene->nodes[above].front == at;
            cells->noise_units = fmax(cells->noise_units, in_front ? -distance : distance);
        }
    }
}

static void record_add(struct cells *cells, uint32_t node, const lim_index *record, bool back)
{
    const size_t count = record[0] & LIM_POLYGON_COUNT;
    double(*corners)[3] = grow_zeroed(count, sizeof *corners);
    for (size_t i = 0; i < count; i++)
        vertex_at(cells->scene, record[LIM_POLYGON_HEAD_WORDS + i], corners[i]);
    cells->records = grow(cells->records, cells->record_count, &cells->record_capacity, sizeof *cells->records);
    struct cell_record *out = &cells->records[cells->record_count++];
    *out = (struct cell_record){.node = node};
    out->faces = back ? flat_turned(&cells->planes[node]) : cells->planes[node];
    const bool whole = patch_hull(&out->patch, &out->faces, (const double(*)[3])corners, count);
    out->opaque = whole && !(record[0] & ~(lim_index)KNOWN_FLAGS);
    note_noise(cells, node, (const double(*)[3])corners, count);
    free(corners);
}

static void run_add(struct cells *cells, uint32_t node, lim_index run, bool back)
{
    if (run == LIM_NO_INDEX) return;
    for (const lim_index *at = &cells->scene->polygons[run];; at += lim_record_words(*at)) {
        record_add(cells, node, at, back);
        if (at[0] & LIM_POLYGON_LAST) return;
    }
}

static void records_read(struct cells *cells)
{
    for (uint32_t i = 0; i < cells->scene->node_count; i++) {
        run_add(cells, i, cells->scene->nodes[i].front_run, false);
        run_add(cells, i, cells->scene->nodes[i].back_run, true);
    }
}

static void nodes_read(struct cells *cells)
{
    const struct lim_scene *scene = cells->scene;
    for (lim_index i = 0; i < scene->node_count; i++) {
        const struct lim_node *node = &scene->nodes[i];
        cells->planes[i] = flat_of(scene, i);
        if (node->front != LIM_NO_INDEX) cells->parents[node->front] = i;
        if (node->back != LIM_NO_INDEX) cells->parents[node->back] = i;
        for (int behind = 0; behind < 2; behind++) {
            struct cell *cell = &cells->items[cell_of(i, behind)];
            cell->is_free = (behind ? node->back_run : node->front_run) != LIM_NO_INDEX;
            cell->bounded = true;
            for (int k = 0; k < 3; k++) {
                cell->low[k] = INFINITY;
                cell->high[k] = -INFINITY;
            }
        }
    }
}

static void box_find(struct cells *cells)
{
    for (int k = 0; k < 3; k++) {
        cells->low[k] = INFINITY;
        cells->high[k] = -INFINITY;
    }
    for (size_t i = 0; i < cells->scene->vertex_count; i++) {
        double at[3];
        vertex_at(cells->scene, (lim_index)i, at);
        for (int k = 0; k < 3; k++) {
            cells->low[k] = fmin(cells->low[k], at[k] - GROWN_UNITS);
            cells->high[k] = fmax(cells->high[k], at[k] + GROWN_UNITS);
        }
    }
    for (int k = 0; k < 3; k++)
        cells->reach_units = fmax(cells->reach_units, fmax(-cells->low[k], cells->high[k]));
}

/* The box's side, its front inside. */
static struct flat box_side(const struct cells *cells, int side)
{
    struct flat flat = {{0, 0, 0}, 0};
    flat.n[side / 2] = side % 2 ? -1 : 1;
    flat.d = side % 2 ? -cells->high[side / 2] : cells->low[side / 2];
    return flat;
}

static bool clip_to_box(const struct cells *cells, struct patch *patch, int but)
{
    for (int side = 0; side < 6; side++) {
        const struct flat flat = box_side(cells, side);
        if (side != but && !patch_clip(patch, &flat)) return false;
    }
    return true;
}

/* Filing ------------------------------------------------------------------------------------- */

/* Parts of a patch and where they have come to: a node, or a cell. */
struct part {
    uint32_t at;
    bool is_cell;
    struct patch patch;
};

struct parts {
    struct part *items;
    size_t count, capacity;
};

static void part_add(struct parts *parts, uint32_t at, bool is_cell, const struct patch *patch)
{
    parts->items = grow(parts->items, parts->count, &parts->capacity, sizeof *parts->items);
    parts->items[parts->count++] = (struct part){at, is_cell, *patch};
}

static void part_file(struct parts *parts, const struct cells *cells, uint32_t node, bool behind,
                      const struct patch *patch)
{
    const struct lim_node *here = &cells->scene->nodes[node];
    const lim_index child = behind ? here->back : here->front;
    if (child == LIM_NO_INDEX)
        part_add(parts, cell_of(node, behind), true, patch);
    else
        part_add(parts, child, false, patch);
}

/* What reaches beyond the plane by more than -margin on either side goes there. */
static void part_split(struct parts *parts, const struct cells *cells, uint32_t node, const struct patch *patch,
                       double margin_units)
{
    double low, high;
    const struct flat *plane = &cells->planes[node];
    patch_range(patch, plane, &low, &high);
    const bool lies_on = high < LEAST_OPENING_UNITS && low > -LEAST_OPENING_UNITS; /* nobody knows: both */
    for (int behind = 0; behind < 2; behind++) {
        struct flat side = behind ? flat_turned(plane) : *plane;
        struct patch part = *patch;
        side.d -= margin_units;
        if (lies_on || patch_clip(&part, &side)) part_file(parts, cells, node, behind, &part);
    }
}

/* Files a patch from one side of a node down to cells; `cells_met` gets the parts. */
static void file_down(const struct cells *cells, uint32_t node, bool behind, const struct patch *patch,
                      double margin_units, struct parts *cells_met)
{
    struct parts open = {0};
    cells_met->count = 0;
    part_file(&open, cells, node, behind, patch);
    while (open.count) {
        const struct part part = open.items[--open.count];
        if (part.is_cell)
            part_add(cells_met, part.at, true, &part.patch);
        else
            part_split(&open, cells, part.at, &part.patch, margin_units);
    }
    free(open.items);
}

/* The same from the root on. */
static void file_all(const struct cells *cells, const struct patch *patch, double margin_units, struct parts *cells_met)
{
    struct parts halves = {0};
    cells_met->count = 0;
    part_split(&halves, cells, 0, patch, margin_units);
    while (halves.count) {
        const struct part part = halves.items[--halves.count];
        if (part.is_cell)
            part_add(cells_met, part.at, true, &part.patch);
        else
            part_split(&halves, cells, part.at, &part.patch, margin_units);
    }
    free(halves.items);
}

/* Facets and openings ------------------------------------------------------------------------ */

static bool facet_of(const struct cells *cells, uint32_t node, struct patch *facet)
{
    patch_square(facet, &cells->planes[node], 2 * cells->reach_units);
    if (!clip_to_box(cells, facet, -1)) return false;
    for (uint32_t at = node; at != cells->parents[at]; at = cells->parents[at]) {
        const uint32_t above = cells->parents[at];
        const bool in_front = cells->scene->nodes[above].front == at;
        const struct flat side = in_front ? cells->planes[above] : flat_turned(&cells->planes[above]);
        if (!patch_clip(facet, &side)) return false;
    }
    return true;
}

static void extend(struct cell *cell, const struct patch *patch)
{
    cell->exists = true;
    for (size_t i = 0; i < patch->count; i++)
        for (int k = 0; k < 3; k++) {
            cell->low[k] = fmin(cell->low[k], patch->at[i][k]);
            cell->high[k] = fmax(cell->high[k], patch->at[i][k]);
        }
}

static void opening_add(struct cells *cells, uint32_t from, uint32_t to, uint32_t node, bool to_front,
                        const struct patch *patch)
{
    cells->openings = grow(cells->openings, cells->opening_count, &cells->opening_capacity, sizeof *cells->openings);
    struct opening *opening = &cells->openings[cells->opening_count++];
    *opening = (struct opening){from, to, node, cells->planes[node], *patch};
    if (to_front) return;
    opening->flat = flat_turned(&opening->flat);
    patch_turn(&opening->patch);
}

/* A part of a node's facet with a cell on either side. Its records lie in one piece of the list: nodes come in order.
 */
struct contact {
    uint32_t node, front, back; /* cells */
    size_t first_record;
    const struct patch *patch;
};

/* What polygons leave of it for one who looks to the front, or to the back. */
static void open_parts(const struct cells *cells, const struct contact *contact, bool to_front, struct patches *out)
{
    const struct flat *plane = &cells->planes[contact->node];
    const double noise_units = LEAST_OPENING_UNITS + NOISE_FACTOR * cells->noise_units;
    bool met = false;
    out->count = 0;
    patches_add(out, contact->patch);
    for (size_t i = contact->first_record; i < cells->record_count && cells->records[i].node == contact->node; i++) {
        const struct cell_record *record = &cells->records[i];
        struct patch hole = record->patch;
        const bool faces_front = vec3_dot(record->faces.n, plane->n) > 0;
        if (faces_front == to_front || !record->opaque || hole.count == 0) continue;
        if (!faces_front) patch_turn(&hole);
        met = patches_subtract(out, plane, &hole) || met;
    }
    const bool into_matter = !cells->items[to_front ? contact->front : contact->back].is_free;
    size_t kept = 0;
    for (size_t i = 0; i < out->count; i++)
        if (patch_width(&out->items[i], plane) >= (met || into_matter ? noise_units : 0))
            out->items[kept++] = out->items[i];
    out->count = kept;
}

static void contact_open(struct cells *cells, const struct contact *contact, struct patches *open)
{
    for (int to_front = 0; to_front < 2; to_front++) {
        open_parts(cells, contact, to_front, open);
        for (size_t i = 0; i < open->count; i++)
            opening_add(cells, to_front ? contact->back : contact->front, to_front ? contact->front : contact->back,
                        contact->node, to_front, &open->items[i]);
    }
}

/* Files the facet down to the cells in front, and each part of it to the cells behind. */
static void facet_open(struct cells *cells, uint32_t node, size_t first_record, const struct patch *facet)
{
    struct parts front = {0}, back = {0};
    struct patches open = {0};
    file_down(cells, node, false, facet, 0, &front);
    for (size_t i = 0; i < front.count && cells->opening_count <= OPENINGS_MAX && !deadline_passed(); i++) {
        file_down(cells, node, true, &front.items[i].patch, 0, &back);
        for (size_t k = 0; k < back.count; k++) {
            const struct contact contact = {node, front.items[i].at, back.items[k].at, first_record,
                                            &back.items[k].patch};
            contact_open(cells, &contact, &open);
        }
    }
    free(front.items);
    free(back.items);
    patches_free(&open);
}

/* A polyhedron is made of the pyramids from the origin to its facets; those that it lies behind count against it. */
static void note_cells(struct cells *cells, uint32_t node, const struct patch *facet)
{
    const struct flat *plane = &cells->planes[node];
    struct parts met = {0};
    for (int behind = 0; behind < 2; behind++) {
        file_down(cells, node, behind, facet, 0, &met);
        for (size_t i = 0; i < met.count; i++) {
            struct cell *cell = &cells->items[met.items[i].at];
            extend(cell, &met.items[i].patch);
            cell->volume += patch_area(&met.items[i].patch, plane) * (behind ? plane->d : -plane->d) / 3;
        }
    }
    free(met.items);
}

static void openings_find(struct cells *cells)
{
    size_t first_record = 0;
    for (uint32_t i = 0; i < cells->scene->node_count && cells->opening_count <= OPENINGS_MAX && !deadline_passed();
         i++) {
        struct patch facet;
        while (first_record < cells->record_count && cells->records[first_record].node < i)
            first_record++;
        if (!facet_of(cells, i, &facet)) continue;
        note_cells(cells, i, &facet);
        facet_open(cells, i, first_record, &facet);
    }
}

/* Cells at the box's border go on beyond it. */
static void borders_find(struct cells *cells)
{
    struct parts met = {0};
    for (int side = 0; side < 6; side++) {
        const struct flat flat = box_side(cells, side);
        struct patch patch;
        patch_square(&patch, &flat, 2 * cells->reach_units);
        if (!clip_to_box(cells, &patch, side)) continue;
        file_all(cells, &patch, 0, &met);
        for (size_t i = 0; i < met.count; i++) {
            cells->items[met.items[i].at].bounded = false;
            extend(&cells->items[met.items[i].at], &met.items[i].patch);
        }
    }
    free(met.items);
}

/* Lists by cell ------------------------------------------------------------------------------ */

static int compare_openings(const void *a, const void *b)
{
    const struct opening *p = a, *q = b;
    return (p->from > q->from) - (p->from < q->from);
}

static void openings_sort(struct cells *cells)
{
    if (cells->opening_count) qsort(cells->openings, cells->opening_count, sizeof *cells->openings, compare_openings);
    for (size_t i = cells->opening_count; i-- > 0;) {
        struct cell *cell = &cells->items[cells->openings[i].from];
        cell->first_opening = i;
        cell->opening_count++;
    }
}

struct touch {
    uint32_t cell, record;
};

static int compare_touches(const void *a, const void *b)
{
    const struct touch *p = a, *q = b;
    if (p->cell != q->cell) return p->cell < q->cell ? -1 : 1;
    return (p->record > q->record) - (p->record < q->record);
}

static void touches_find(struct cells *cells)
{
    struct touch *touches = NULL;
    size_t count = 0, capacity = 0;
    struct parts met = {0};
    for (uint32_t r = 0; r < cells->record_count; r++) {
        if (cells->records[r].patch.count == 0) continue;
        file_all(cells, &cells->records[r].patch, CELLS_MARGIN_UNITS + cells->noise_units, &met);
        for (size_t i = 0; i < met.count; i++) {
            touches = grow(touches, count, &capacity, sizeof *touches);
            touches[count++] = (struct touch){met.items[i].at, r};
        }
    }
    if (count) qsort(touches, count, sizeof *touches, compare_touches);
    cells->touches = grow_zeroed(count, sizeof *cells->touches);
    for (size_t i = count; i-- > 0;) {
        struct cell *cell = &cells->items[touches[i].cell];
        cells->touches[i] = touches[i].record;
        cell->first_touch = i;
        cell->touch_count++;
    }
    free(touches);
    free(met.items);
}

bool cells_find(const struct lim_scene *scene, struct cells *out, struct error *err)
{
    *out = (struct cells){.scene = scene, .count = 2 * (size_t)scene->node_count};
    out->planes = grow_zeroed(scene->node_count, sizeof *out->planes);
    out->parents = grow_zeroed(scene->node_count, sizeof *out->parents);
    out->items = grow_zeroed(out->count, sizeof *out->items);
    box_find(out);
    nodes_read(out);
    records_read(out);
    openings_find(out);
    if (out->opening_count > OPENINGS_MAX)
        return error_set(err, "too many portals between its cells, more than %d", OPENINGS_MAX);
    borders_find(out);
    openings_sort(out);
    touches_find(out);
    return true;
}

void cells_free(struct cells *cells)
{
    free(cells->planes);
    free(cells->parents);
    free(cells->items);
    free(cells->openings);
    free(cells->records);
    free(cells->touches);
    *cells = (struct cells){0};
}
