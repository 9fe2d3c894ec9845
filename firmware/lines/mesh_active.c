/* SPDX-License-Identifier: MIT
 *
 * Points are looked up by a triangle's vertices whenever an edge begins: an entry keeps none of them. */
#include "lines/mesh_active.h"

#include "colour.h"
#include "lines/mesh_depth.h"
#include "screen/edge_begin.h"
#include "view/packed.h"
#include "view/view.h"

#if LIM_HAS_MESHES

void lim_mesh_clear(struct lim_mesh *mesh)
{
    mesh->free = NULL;
    mesh->unused = 0;
    mesh->first = mesh->begins = &mesh->end;
}

static void insert(struct lim_mesh *mesh, struct lim_mesh_active *active)
{
    struct lim_mesh_active **link = &mesh->begins;

    while ((*link)->rank < active->rank)
        link = &(*link)->next;
    active->next = *link;
    *link = active;
}

/* The lines that its edges are set for. */
static inline void set_lines(struct lim_mesh_active *active, int16_t turn, int16_t bottom)
{
    active->bottom = (uint16_t)bottom;
    active->turn = (uint16_t)(turn < bottom ? turn : bottom);
}

static inline uint16_t colour_of(const struct lim_mesh *mesh, lim_index triangle)
{
    return lim_memory_colour((uint16_t)lim_mesh_triangle(mesh, triangle)[3]);
}

static inline bool is_within(const struct lim_mesh_range *range, lim_mesh_rank rank)
{
    return rank >= range->from && rank < range->below;
}

/* A part of a fan: shape and corners. */
static void fan_part(const struct lim_mesh_clipped *clipped, uint8_t part, struct lim_mesh_clipped *out)
{
    lim_mesh_fan(clipped, part, out->at);
    lim_edge_bounds(&out->shape, out->at, 3);
    out->n = 3;
}

/* Edges of any polygon for line y, by EDGE. Those of a part may begin farther down: until then it has no pixels. */
static void set_any(struct lim_mesh_active *active, const struct lim_point *at, uint8_t n,
                    const struct lim_edge_shape *shape, uint16_t y)
{
    struct lim_edge_pair pair;

    active->goes_on = LIM_MESH_ANEW;
    if (shape->top > (int16_t)y) {
        active->edges[0] = active->edges[1] = (struct lim_mesh_edge){.at = 0};
        set_lines(active, shape->top, shape->bottom);
        return;
    }
    set_lines(active, lim_edge_start(&pair, at, n, shape->first, (int16_t)y), shape->bottom);
    active->edges[0] = (struct lim_mesh_edge){pair.left.at, pair.left.step};
    active->edges[1] = (struct lim_mesh_edge){pair.right.at, pair.right.step};
}

static bool begin_part(struct lim_mesh *mesh, const struct lim_mesh_clipped *clipped, lim_index triangle, uint8_t part,
                       lim_mesh_rank rank, uint16_t y)
{
    struct lim_mesh_clipped own;

    if (part) fan_part(clipped, part, &own);
    const struct lim_mesh_clipped *const shown = part ? &own : clipped;
    if (shown->shape.bottom <= (int16_t)y || shown->shape.top >= shown->shape.bottom) return true;
    struct lim_mesh_active *active = lim_mesh_new(mesh);
    if (!active) return false;
    active->rank = rank;
    active->colour = colour_of(mesh, triangle);
    active->part = part;
    if (LIM_HAS_STATS) *active->seen = false;
    set_any(active, shown->at, shown->n, &shown->shape, y);
    if (lim_mesh_is_deep(mesh, triangle)) lim_mesh_depth_clipped(active, clipped, y);
    insert(mesh, active);
    return true;
}

/* By the mean of its corners' nearness, times 3/2: what three halves add up to. */
static uint32_t nearness_of(const struct lim_mesh_clipped *clipped)
{
    uint32_t sum = 0;

    for (uint_fast8_t k = 0; k < clipped->n; k++)
        sum += clipped->nearness[k];
    return sum * 3 / (2u * clipped->n);
}

/* Those of a rank are given back. */
static void take_out(struct lim_mesh *mesh, lim_mesh_rank rank)
{
    struct lim_mesh_active **link = &mesh->begins;

    while (*link != &mesh->end)
        if ((*link)->rank == rank)
            lim_mesh_give_back(mesh, link);
        else
            link = &(*link)->next;
}

static LIM_RARE bool begin_clipped(struct lim_mesh *mesh, lim_index triangle, uint16_t y,
                                   const struct lim_mesh_range *range)
{
    struct lim_mesh_clipped clipped;

    if (!lim_mesh_clip(mesh, triangle, &clipped)) return true;
    const lim_mesh_rank rank = lim_mesh_rank_of(nearness_of(&clipped), triangle);
    if (range && !is_within(range, rank)) return true;
    if (!clipped.shape.non_monotone) return begin_part(mesh, &clipped, triangle, 0, rank, y);
    for (uint8_t part = 1; part + 1u < clipped.n; part++) {
        if (begin_part(mesh, &clipped, triangle, part, rank, y)) continue;
        take_out(mesh, rank);
        return false;
    }
    return true;
}

/* A triangle's corners from the top down, on the screen. */
struct three {
    lim_packed top, middle, low;
    bool left; /* the middle one is on the left boundary */
};

/* Corners are counter-clockwise as the eye sees them: what follows the uppermost is on the left. */
static LIM_INLINE struct three three_of(lim_packed a, lim_packed b, lim_packed c)
{
    if (lim_packed_is_above(b, a) || lim_packed_is_above(c, a)) {
        const lim_packed first = a;
        if (lim_packed_is_above(b, c)) {
            a = b;
            b = c;
            c = first;
        } else {
            a = c;
            c = b;
            b = first;
        }
    }
    if (lim_packed_is_above(b, c)) return (struct three){a, b, c, true};
    return (struct three){a, c, b, false};
}

static inline int32_t row_of(lim_packed at)
{
    return lim_edge_row(lim_packed_y(at));
}

static LIM_ALONE bool begin_slow(struct lim_mesh_edge *edge, lim_packed from, lim_packed to, int32_t row, int32_t end)
{
    struct lim_edge begun;

    if (!lim_edge_begin_slow(&begun, lim_packed_point(from), lim_packed_point(to), (int16_t)(row + LIM_ORIGIN_PX),
                             (int16_t)(end + LIM_ORIGIN_PX)))
        return false;
    edge->at = begun.at;
    edge->step = begun.step;
    return true;
}

/* An edge on a line, both from the origin. false: it is to be begun anew before it ends. */
static LIM_INLINE bool begin_edge(struct lim_mesh_edge *edge, lim_packed from, lim_packed to, int32_t row, int32_t end)
{
    struct lim_edge begun;

    if (!lim_edge_begin_fast(&begun, lim_packed_x(from), lim_packed_y(from), lim_packed_x(to), lim_packed_y(to), row,
                             end))
        return begin_slow(edge, from, to, row, end);
    edge->at = begun.at;
    edge->step = begun.step;
    return true;
}

/* What has an edge that is begun anew on the way, and where small code is asked for: by EDGE. */
static LIM_RARE void set_long(struct lim_mesh_active *active, const struct three *three, uint16_t y)
{
    const struct lim_point at[3] = {lim_packed_point(three->top),
                                    lim_packed_point(three->left ? three->middle : three->low),
                                    lim_packed_point(three->left ? three->low : three->middle)};
    struct lim_edge_shape shape;

    lim_edge_bounds(&shape, at, 3);
    set_any(active, at, 3, &shape, y);
}

/* Edges for line y, which the triangle has: one goes from top to bottom, the other turns at the middle corner. */
static LIM_INLINE void set_three(struct lim_mesh_active *active, const struct three *three, uint16_t y)
{
    const int32_t row = (int32_t)y - LIM_ORIGIN_PX, turn = row_of(three->middle), bottom = row_of(three->low);
    struct lim_mesh_edge *const whole = &active->edges[three->left], *const other = &active->edges[!three->left];
    const bool is_over = turn <= row;

    active->part = 0;
    if (LIM_OPTIMISE_SIZE || LIM_8_BIT || !begin_edge(whole, three->top, three->low, row, bottom) ||
        !begin_edge(other, is_over ? three->middle : three->top, is_over ? three->low : three->middle, row,
                    is_over ? bottom : turn) ||
        (!is_over && turn < bottom && !begin_edge(&active->lower, three->middle, three->low, turn, bottom))) {
        set_long(active, three, y);
        return;
    }
    active->goes_on = three->left ? LIM_MESH_LEFT : LIM_MESH_RIGHT;
    active->bottom = (uint16_t)(bottom + LIM_ORIGIN_PX);
    active->turn = (uint16_t)((is_over ? bottom : turn) + LIM_ORIGIN_PX);
}

static LIM_INLINE struct three three_at(const struct lim_mesh *mesh, const LIM_FLASH lim_index *corners)
{
    return three_of(lim_packed_load(&mesh->points[corners[0]]), lim_packed_load(&mesh->points[corners[1]]),
                    lim_packed_load(&mesh->points[corners[2]]));
}

static LIM_INLINE bool begin(struct lim_mesh *mesh, lim_index triangle, uint16_t y, const struct lim_mesh_range *range)
{
    const LIM_FLASH lim_index *corners = lim_mesh_triangle(mesh, triangle);
    const lim_index a = corners[0], b = corners[1], c = corners[2];
    const uint16_t near[3] = {mesh->nearness[a], mesh->nearness[b], mesh->nearness[c]};

    if (mesh->extent == LIM_VIEW_CLIPPED && (!near[0] || !near[1] || !near[2]))
        return begin_clipped(mesh, triangle, y, range);
    const lim_mesh_rank rank = lim_mesh_rank_of(((uint32_t)near[0] + near[1] + near[2]) / 2, triangle);
    if (range && !is_within(range, rank)) return true;
    struct lim_mesh_active *active = lim_mesh_new(mesh);
    if (!active) return false;
    const struct three three = three_at(mesh, corners);
    active->rank = rank;
    active->colour = colour_of(mesh, triangle);
    if (LIM_HAS_STATS) *active->seen = false;
    set_three(active, &three, y);
    if (lim_mesh_is_deep(mesh, triangle)) {
        const struct lim_point at[3] = {mesh->points[a], mesh->points[b], mesh->points[c]};
        lim_mesh_depth_set(active, at, near, y);
    }
    insert(mesh, active);
    return true;
}

bool lim_mesh_begin(struct lim_mesh *mesh, lim_index triangle, uint16_t y)
{
    return begin(mesh, triangle, y, NULL);
}

bool lim_mesh_begin_within(struct lim_mesh *mesh, lim_index triangle, uint16_t y, const struct lim_mesh_range *range)
{
    return begin(mesh, triangle, y, range);
}

static void turn_clipped(const struct lim_mesh *mesh, struct lim_mesh_active *active, uint16_t y)
{
    struct lim_mesh_clipped clipped, part;

    (void)lim_mesh_clip(mesh, lim_mesh_number(active), &clipped);
    if (active->part) fan_part(&clipped, active->part, &part);
    const struct lim_mesh_clipped *const shown = active->part ? &part : &clipped;
    set_any(active, shown->at, shown->n, &shown->shape, y);
}

void lim_mesh_turn(const struct lim_mesh *mesh, struct lim_mesh_active *active, uint16_t y)
{
    const LIM_FLASH lim_index *corners = lim_mesh_triangle(mesh, lim_mesh_number(active));

    if (lim_mesh_is_cut(mesh, corners)) {
        turn_clipped(mesh, active, y);
        return;
    }
    const struct three three = three_at(mesh, corners);
    set_long(active, &three, y);
}

#endif
