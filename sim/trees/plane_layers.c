/* SPDX-License-Identifier: MIT
 *
 * Bounds are swept along the axis on which the model is longest. Of a pair that may overlap the outlines are compared
 * as the first one's normal sees them. Over a common part either plane is a linear function, so its corners tell how
 * far apart they are. */
#include "trees/plane_layers.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "base/map.h"
#include "base/vec3.h"
#include "model/grid.h"
#include "model/loop.h"
#include "model/original.h"
#include "trees/overlap.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double PARALLEL = 0.9;      /* cosine of what may be nearly parallel */
static const double WELDED_UNITS = 0.25; /* more than welding brings two planes together */
static const double MUCH_MORE = 2;       /* on one side than on the other: it is no crossing */

/* A polygon as the file has it. */
struct sheet {
    double normal[3], centre[3];
    double low[3], high[3];
    uint32_t polygon;
};

struct found {
    uint32_t p, q;
    int8_t height; /* of q, as p's normal points */
    bool is_turned;
};

struct search {
    const struct mesh *mesh;
    struct map corners; /* face << 32 | point -> corner of the original */
    struct sheet *sheets;
    double reach_m, level_m, least_m;
    int axis;
    struct outline_2d part, window, spare;
    struct found *found;
    size_t found_count, found_capacity;
    bool *is_covered; /* of each polygon */
};

/* Polygons as the file has them ----------------------------------------------------------------- */

static uint64_t corner_key(uint32_t face, uint32_t point)
{
    return (uint64_t)face << 32 | point;
}

static void note_corners(struct search *search)
{
    const struct mesh *mesh = search->mesh;
    const struct original *original = mesh->original;
    for (size_t i = 0; original && i < original->face_count; i++) {
        const struct original_face *face = &original->faces[i];
        for (uint32_t k = face->first; k < face->first + face->count; k++) {
            map_at(&search->corners, corner_key((uint32_t)i + 1, original->points[k]), k);
            map_at(&search->corners, corner_key(mesh->merged_into[i + 1], original->points[k]), k);
        }
    }
}

/* A corner's own place; NULL: it is another polygon's, in the middle of an edge. */
static const double *own_place(const struct search *search, const struct mesh_polygon *polygon, uint32_t point)
{
    const uint32_t *corner = map_find(&search->corners, corner_key(polygon->face, point));
    return corner ? search->mesh->original->corners_m[*corner] : NULL;
}

static struct loop_plane plane_of_places(double (*places)[3], size_t count)
{
    uint32_t *corners = grow_zeroed(count, sizeof *corners);
    for (uint32_t i = 0; i < count; i++)
        corners[i] = i;
    const struct loop loop = {places, corners, count};
    const struct loop_plane plane = loop_plane_of(&loop);
    free(corners);
    return plane;
}

/* Of at least three of its own corners, and else of all. */
static struct loop_plane own_plane(const struct search *search, const struct mesh_polygon *polygon)
{
    const struct mesh *mesh = search->mesh;
    double(*places)[3] = grow_zeroed(polygon->count, sizeof *places);
    size_t count = 0;
    for (uint32_t i = 0; i < polygon->count; i++) {
        const double *place = own_place(search, polygon, mesh->corners[polygon->first + i]);
        if (place) memcpy(places[count++], place, sizeof *places);
    }
    for (uint32_t i = 0; count < 3 && i < polygon->count; i++)
        memcpy(places[i], mesh->points[mesh->corners[polygon->first + i]], sizeof *places);
    const struct loop_plane plane = plane_of_places(places, count < 3 ? polygon->count : count);
    free(places);
    return plane;
}

static void sheet_set(const struct search *search, uint32_t index, struct sheet *sheet)
{
    const struct mesh *mesh = search->mesh;
    const struct mesh_polygon *polygon = &mesh->polygons[index];
    const struct loop_plane plane = own_plane(search, polygon);
    *sheet = (struct sheet){.polygon = index};
    memcpy(sheet->normal, plane.normal, sizeof sheet->normal);
    memcpy(sheet->centre, plane.centre, sizeof sheet->centre);
    for (int axis = 0; axis < 3; axis++) {
        sheet->low[axis] = DBL_MAX;
        sheet->high[axis] = -DBL_MAX;
        for (uint32_t i = 0; i < polygon->count; i++) {
            const double at_m = mesh->points[mesh->corners[polygon->first + i]][axis];
            sheet->low[axis] = fmin(sheet->low[axis], at_m);
            sheet->high[axis] = fmax(sheet->high[axis], at_m);
        }
    }
}

/* Pairs ----------------------------------------------------------------------------------------- */

/* As the view sees it, counted from `from`; counter-clockwise there. */
static void trace(const struct mesh *mesh, uint32_t index, const double from[3], const struct loop_view *view,
                  bool is_turned, struct outline_2d *out)
{
    const struct mesh_polygon *polygon = &mesh->polygons[index];
    out->count = 0;
    for (uint32_t i = 0; i < polygon->count; i++) {
        const double *at = mesh->points[mesh->corners[polygon->first + (is_turned ? polygon->count - 1 - i : i)]];
        outline_2d_add(out, at[view->u] - from[view->u], at[view->v] - from[view->v]);
    }
}

/* Where the line at (u, v) meets a sheet's plane, counted from `from`. */
static double depth_at(const struct sheet *sheet, const double from[3], const struct loop_view *view,
                       const double at[2])
{
    const int w = 3 - view->u - view->v;
    return sheet->centre[w] - from[w] -
           (sheet->normal[view->u] * (at[0] - (sheet->centre[view->u] - from[view->u])) +
            sheet->normal[view->v] * (at[1] - (sheet->centre[view->v] - from[view->v]))) /
               sheet->normal[w];
}

/* How far q is in front of p and behind it over what they have in common. */
static void find_heights(const struct search *search, const struct sheet *p, const struct sheet *q,
                         const struct loop_view *view, double *above_m, double *below_m)
{
    const double *from = p->centre, along = p->normal[3 - view->u - view->v];
    *above_m = *below_m = -DBL_MAX;
    for (size_t i = 0; i < search->part.count; i++) {
        const double *at = search->part.at[i];
        const double height_m = (depth_at(q, from, view, at) - depth_at(p, from, view, at)) * along;
        *above_m = fmax(*above_m, height_m);
        *below_m = fmax(*below_m, -height_m);
    }
}

static bool are_seen_together(const struct mesh *mesh, uint32_t p, uint32_t q, bool is_turned)
{
    return !is_turned || mesh->polygons[p].two_sided || mesh->polygons[q].two_sided;
}

static void note_pair(struct search *search, uint32_t p, uint32_t q, int8_t height, bool is_turned)
{
    search->found = grow(search->found, search->found_count, &search->found_capacity, sizeof *search->found);
    search->found[search->found_count++] = (struct found){p, q, height, is_turned};
}

static void compare(struct search *search, const struct sheet *p, const struct sheet *q)
{
    const struct mesh *mesh = search->mesh;
    const double cosine = vec3_dot(p->normal, q->normal);
    const bool is_turned = cosine < 0;
    double above_m, below_m;
    if (fabs(cosine) < PARALLEL || !are_seen_together(mesh, p->polygon, q->polygon, is_turned)) return;
    const struct loop_view view = loop_view_along(p->normal);
    trace(mesh, p->polygon, p->centre, &view, false, &search->part);
    trace(mesh, q->polygon, p->centre, &view, is_turned, &search->window);
    if (!overlap_find(&search->part, &search->window, &search->spare, search->least_m)) return;
    find_heights(search, p, q, &view, &above_m, &below_m);
    if (fmax(above_m, below_m) > search->reach_m) return;
    const bool is_level = fmax(above_m, below_m) <= search->level_m;
    const bool is_above = !is_level && above_m > MUCH_MORE * below_m;
    const bool is_below = !is_level && below_m > MUCH_MORE * above_m;
    note_pair(search, p->polygon, q->polygon, (int8_t)(is_above - is_below), is_turned);
    note_pair(search, q->polygon, p->polygon, (int8_t)((is_below - is_above) * (is_turned ? -1 : 1)), is_turned);
    if (is_level) search->is_covered[p->polygon < q->polygon ? p->polygon : q->polygon] = true;
}

/* The sweep ------------------------------------------------------------------------------------- */

static bool may_touch(const struct search *search, const struct sheet *p, const struct sheet *q)
{
    for (int axis = 0; axis < 3; axis++)
        if (p->low[axis] > q->high[axis] + search->reach_m || q->low[axis] > p->high[axis] + search->reach_m)
            return false;
    return true;
}

static int compare_low(double a, double b, uint32_t p, uint32_t q)
{
    if (a != b) return a < b ? -1 : 1;
    return (p > q) - (p < q);
}

#define BY_AXIS(name, axis)                                                                                            \
    static int name(const void *left, const void *right)                                                               \
    {                                                                                                                  \
        const struct sheet *a = left, *b = right;                                                                      \
        return compare_low(a->low[axis], b->low[axis], a->polygon, b->polygon);                                        \
    }
BY_AXIS(by_x, 0)
BY_AXIS(by_y, 1)
BY_AXIS(by_z, 2)

static void sweep(struct search *search)
{
    static int (*const by_axis[])(const void *, const void *) = {by_x, by_y, by_z};
    const size_t count = search->mesh->polygon_count;
    qsort(search->sheets, count, sizeof *search->sheets, by_axis[search->axis]);
    for (size_t i = 0; i < count && !deadline_passed(); i++) {
        const struct sheet *p = &search->sheets[i];
        const double end_m = p->high[search->axis] + search->reach_m;
        for (size_t k = i + 1; k < count && search->sheets[k].low[search->axis] <= end_m; k++) {
            const struct sheet *q = &search->sheets[k];
            if (may_touch(search, p, q)) compare(search, p, q);
        }
    }
}

static void measure(struct search *search, double tolerance_units)
{
    const struct mesh *mesh = search->mesh;
    double low[3] = {DBL_MAX, DBL_MAX, DBL_MAX}, high[3] = {-DBL_MAX, -DBL_MAX, -DBL_MAX}, most_m = 0;
    for (size_t i = 0; i < mesh->polygon_count; i++)
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = fmin(low[axis], search->sheets[i].low[axis]);
            high[axis] = fmax(high[axis], search->sheets[i].high[axis]);
        }
    for (int axis = 0; axis < 3; axis++) {
        if (high[axis] - low[axis] > high[search->axis] - low[search->axis]) search->axis = axis;
        most_m = fmax(most_m, fmax(fabs(low[axis]), fabs(high[axis])));
    }
    search->reach_m = (2 * tolerance_units + WELDED_UNITS) / mesh->grid.units_per_m;
    search->level_m = most_m * LAYERS_LEVEL_SHARE;
    search->least_m = grid_near_m(&mesh->grid);
}

static int by_pair(const void *left, const void *right)
{
    const struct found *a = left, *b = right;
    if (a->p != b->p) return a->p < b->p ? -1 : 1;
    return (a->q > b->q) - (a->q < b->q);
}

static void keep(struct search *search, struct layers *out)
{
    const size_t polygons = search->mesh->polygon_count;
    if (!search->found_count) return;
    qsort(search->found, search->found_count, sizeof *search->found, by_pair);
    out->first = grow_zeroed(polygons + 1, sizeof *out->first);
    out->items = grow_zeroed(search->found_count, sizeof *out->items);
    for (size_t i = 0; i < search->found_count; i++) {
        const struct found *found = &search->found[i];
        out->items[i] = (struct layer){found->q, found->height, found->is_turned};
        out->first[found->p + 1] = i + 1;
    }
    for (size_t i = 0; i < polygons; i++) {
        if (!out->first[i + 1]) out->first[i + 1] = out->first[i];
        out->covered += search->is_covered[i];
    }
}

void layers_find(const struct mesh *mesh, double tolerance_units, struct layers *out)
{
    struct search search = {.mesh = mesh,
                            .sheets = grow_zeroed(mesh->polygon_count, sizeof *search.sheets),
                            .is_covered = grow_zeroed(mesh->polygon_count, sizeof *search.is_covered)};
    *out = (struct layers){0};
    note_corners(&search);
    for (uint32_t i = 0; i < mesh->polygon_count; i++)
        sheet_set(&search, i, &search.sheets[i]);
    measure(&search, tolerance_units);
    sweep(&search);
    keep(&search, out);
    map_free(&search.corners);
    outline_2d_free(&search.part);
    outline_2d_free(&search.window);
    outline_2d_free(&search.spare);
    free(search.sheets);
    free(search.found);
    free(search.is_covered);
}

/* Asking ---------------------------------------------------------------------------------------- */

const struct layer *layers_of(const struct layers *layers, uint32_t polygon, size_t *count)
{
    *count = layers->first ? layers->first[polygon + 1] - layers->first[polygon] : 0;
    return *count ? &layers->items[layers->first[polygon]] : NULL;
}

size_t layers_polygons(const struct layers *layers, size_t polygon_count)
{
    size_t count = 0;
    for (size_t p = 0; layers->first && p < polygon_count; p++)
        count += layers->first[p + 1] > layers->first[p];
    return count;
}

/* For an eye on one side of polygon p, whether the other is nearer. */
static bool is_over(const struct layer *layer, uint32_t p, bool in_front)
{
    if (layer->height) return (layer->height > 0) == in_front;
    return layer->other > p;
}

static bool is_seen(const struct mesh *mesh, uint32_t polygon, bool in_front)
{
    return in_front || mesh->polygons[polygon].two_sided;
}

struct layer_pair layers_pair(const struct layers *layers, const struct mesh *mesh, uint32_t p, uint32_t q)
{
    struct layer_pair out = {false, false};
    size_t count;
    const struct layer *layer = layers_of(layers, p, &count);
    while (count && layer->other != q)
        layer++, count--;
    for (int side = 0; count && side < 2; side++) {
        const bool in_front = side == 0;
        if (!is_seen(mesh, p, in_front) || !is_seen(mesh, q, in_front != layer->is_turned)) continue;
        *(is_over(layer, p, in_front) ? &out.q_hides_p : &out.p_hides_q) = true;
    }
    return out;
}

/* Order ----------------------------------------------------------------------------------------- */

/* Those under way, each of which is over the one below it. */
struct ordering {
    const struct layers *layers;
    const bool *in_front;
    struct map at; /* polygon -> index, from 1; 0: it is in order, or on the stack */
    uint32_t *stack;
    size_t *next; /* of each on the stack: the layer to look at */
    size_t depth;
};

static void push(struct ordering *ordering, uint32_t index, uint32_t *is_waiting)
{
    *is_waiting = 0;
    ordering->stack[ordering->depth] = index;
    ordering->next[ordering->depth++] = 0;
}

/* Puts on top of the stack one that is over the top one, and waits. False: there is none. */
static bool push_over(struct ordering *ordering, const uint32_t *polygons)
{
    const uint32_t top = ordering->stack[ordering->depth - 1];
    size_t count, *next = &ordering->next[ordering->depth - 1];
    const struct layer *layers = layers_of(ordering->layers, polygons[top], &count);
    while (*next < count) {
        const struct layer *layer = &layers[(*next)++];
        if (!is_over(layer, polygons[top], ordering->in_front[top]) || !map_find(&ordering->at, layer->other)) continue;
        uint32_t *waiting = map_at(&ordering->at, layer->other, 0);
        if (!*waiting) continue;
        push(ordering, *waiting - 1, waiting);
        return true;
    }
    return false;
}

void layers_order(const struct layers *layers, const uint32_t *polygons, const bool *in_front, size_t count,
                  uint32_t *order)
{
    struct ordering ordering = {.layers = layers,
                                .in_front = in_front,
                                .stack = grow_zeroed(count, sizeof *ordering.stack),
                                .next = grow_zeroed(count, sizeof *ordering.next)};
    size_t done = 0;
    for (uint32_t i = 0; i < count; i++)
        map_at(&ordering.at, polygons[i], i + 1);
    for (uint32_t i = 0; i < count; i++) {
        uint32_t *waiting = map_at(&ordering.at, polygons[i], 0);
        if (!*waiting) continue;
        push(&ordering, i, waiting);
        while (ordering.depth)
            if (!push_over(&ordering, polygons)) order[done++] = ordering.stack[--ordering.depth];
    }
    map_free(&ordering.at);
    free(ordering.stack);
    free(ordering.next);
}

void layers_free(struct layers *layers)
{
    free(layers->first);
    free(layers->items);
    *layers = (struct layers){0};
}
