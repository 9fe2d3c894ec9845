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
    if (LIM_HAS_TEXTURE) lim_mesh_texture_clear(mesh);
    mesh->first = mesh->begins = &mesh->end;
}

/* `last`: mesh->end, or the one that was inserted before: neighbours are much as near as each other. */
static LIM_INLINE void mesh_insert(struct lim_mesh *mesh, struct lim_mesh_active *active, struct lim_mesh_active *last)
{
    struct lim_mesh_active **link = last->rank < active->rank ? &last->next : &mesh->begins;

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

static inline uint16_t mesh_colour_of(const struct lim_mesh *mesh, lim_index triangle)
{
    return lim_memory_colour((uint16_t)lim_mesh_triangle(mesh, triangle)[3]);
}

/* NULL: there is none to be left out. */
static inline bool is_left_out(struct lim_mesh_trial *trial, lim_mesh_rank rank)
{
    if (!trial) return false;
    trial->rank = rank;
    return rank < trial->from;
}

/* A part of a fan: shape and corners. false: it has no pixels. */
static bool fan_part(const struct lim_mesh_clipped *clipped, uint8_t part, struct lim_mesh_clipped *out)
{
    const bool has_pixels = lim_mesh_fan(clipped, part, out->at);

    lim_edge_bounds(&out->shape, out->at, 3);
    out->n = 3;
    return has_pixels;
}

/* Edges of any polygon for line y, by EDGE. Those of a part may begin farther down: until then it has no pixels. */
static void set_any(struct lim_mesh_active *active, const struct lim_point *at, uint8_t n,
                    const struct lim_edge_shape *shape, uint16_t y)
{
    struct lim_edge_pair pair;

    active->goes_on = LIM_MESH_ANEW;
    if (shape->top > (int16_t)y) {
        lim_mesh_edges_rest(&active->edges);
        set_lines(active, shape->top, shape->bottom);
        return;
    }
    set_lines(active, lim_edge_start(&pair, at, n, shape->first, (int16_t)y), shape->bottom);
    lim_mesh_edges_take(&active->edges, LIM_MESH_LEFT, &pair.left);
    lim_mesh_edges_take(&active->edges, LIM_MESH_RIGHT, &pair.right);
}

static bool begin_part(struct lim_mesh *mesh, const struct lim_mesh_clipped *clipped, lim_index triangle, uint8_t part,
                       lim_mesh_rank rank, uint16_t y)
{
    struct lim_mesh_clipped own;

    if (part && !fan_part(clipped, part, &own)) return true;
    const struct lim_mesh_clipped *const shown = part ? &own : clipped;
    if (shown->shape.bottom <= (int16_t)y || shown->shape.top >= shown->shape.bottom) return true;
    struct lim_mesh_active *active = lim_mesh_new(mesh);
    if (!active) return false;
    active->rank = rank;
    if (!LIM_HAS_TEXTURE) active->colour = mesh_colour_of(mesh, triangle);
    if (LIM_HAS_TEXTURE) lim_mesh_texture_begin_clipped(mesh, active);
    active->part = part;
    if (LIM_HAS_STATS) *active->seen = false;
    set_any(active, shown->at, shown->n, &shown->shape, y);
    if (lim_mesh_is_deep(mesh, triangle)) lim_mesh_depth_clipped(active, clipped, y);
    mesh_insert(mesh, active, &mesh->end);
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
            lim_mesh_give_back(mesh, link, *link);
        else
            link = &(*link)->next;
}

static LIM_RARE bool begin_clipped(struct lim_mesh *mesh, lim_index triangle, uint16_t y, struct lim_mesh_trial *trial)
{
    struct lim_mesh_clipped clipped;

    if (!lim_mesh_clip(mesh, triangle, &clipped)) return true;
    const lim_mesh_rank rank = lim_mesh_rank_of(nearness_of(&clipped), triangle);
    if (is_left_out(trial, rank)) return false;
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
    uint8_t side; /* of the middle one: LIM_MESH_LEFT or LIM_MESH_RIGHT */
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
    if (lim_packed_is_above(b, c)) return (struct three){a, b, c, LIM_MESH_LEFT};
    return (struct three){a, c, b, LIM_MESH_RIGHT};
}

static inline int32_t mesh_row_of(lim_packed at)
{
    return lim_edge_row((lim_edge_sub)lim_packed_y(at));
}

static LIM_ALONE bool begin_slow(struct lim_edge *edge, lim_packed from, lim_packed to, int32_t row, int32_t end)
{
    return lim_edge_begin_slow(edge, lim_packed_point(from), lim_packed_point(to), (int16_t)(row + LIM_ORIGIN_PX),
                               (int16_t)(end + LIM_ORIGIN_PX));
}

/* An edge on a line, both from the origin. false: it is to be begun anew before it ends. */
static LIM_INLINE bool begin_edge(struct lim_edge *edge, lim_packed from, lim_packed to, int32_t row, int32_t end)
{
    const int32_t ax = lim_packed_x(from), ay = lim_packed_y(from), bx = lim_packed_x(to), by = lim_packed_y(to);

    return lim_edge_begin_fast(edge, ax, ay, bx, by, row, end) ||
           (EDGE_HAS_SMALL && begin_medium(edge, ax, ay, bx, by, row)) || begin_slow(edge, from, to, row, end);
}

/* What has an edge that is begun anew on the way, and where small code is asked for: by EDGE. */
static LIM_RARE void set_long(struct lim_mesh_active *active, lim_packed top, lim_packed middle, lim_packed low,
                              uint16_t y)
{
    const bool is_left = active->goes_on == LIM_MESH_LEFT;
    const struct lim_point at[3] = {lim_packed_point(top), lim_packed_point(is_left ? middle : low),
                                    lim_packed_point(is_left ? low : middle)};
    struct lim_edge_shape shape;

    lim_edge_bounds(&shape, at, 3);
    set_any(active, at, 3, &shape, y);
}

/* Edge by edge, on a line from the origin. false: one is long. */
static LIM_INLINE bool set_each(struct lim_mesh_active *active, lim_packed top, lim_packed middle, lim_packed low,
                                int32_t row, int32_t middle_row, int32_t bottom_row)
{
    struct lim_edge edge;

    if (LIM_OPTIMISE_SIZE || LIM_8_BIT || !begin_edge(&edge, top, low, row, bottom_row)) return false;
    lim_mesh_edges_take(&active->edges, active->goes_on ^ 1, &edge);
    if (middle_row <= row) {
        if (!begin_edge(&edge, middle, low, row, bottom_row)) return false;
        lim_mesh_edges_take(&active->edges, active->goes_on, &edge);
        return true;
    }
    if (!begin_edge(&edge, top, middle, row, middle_row)) return false;
    lim_mesh_edges_take(&active->edges, active->goes_on, &edge);
    if (middle_row == bottom_row) return true;
    if (!begin_edge(&edge, middle, low, middle_row, bottom_row)) return false;
    lim_mesh_edge_take(&active->lower, &edge);
    return true;
}

/* Edges for line y, which the triangle has: one goes from top to bottom, the other turns at the middle corner, on the
 * side that goes_on says. */
static LIM_ALONE void set_one_by_one(struct lim_mesh_active *active, lim_packed top, lim_packed middle, lim_packed low)
{
    const uint16_t y = active->turn;
    const int32_t row = (int32_t)y - LIM_ORIGIN_PX, middle_row = mesh_row_of(middle), bottom_row = mesh_row_of(low);

    if (!set_each(active, top, middle, low, row, middle_row, bottom_row)) {
        set_long(active, top, middle, low, y);
        return;
    }
    active->bottom = (uint16_t)(bottom_row + LIM_ORIGIN_PX);
    active->turn = middle_row > row ? (uint16_t)(middle_row + LIM_ORIGIN_PX) : active->bottom;
}

#if LIM_DIVIDES && !LIM_8_BIT && !LIM_OPTIMISE_SIZE

static LIM_INLINE void set_short_from(struct lim_edge *edge, lim_packed from, int32_t dx, int32_t dy, int32_t row)
{
    set_short(edge, lim_packed_x(from), lim_packed_y(from), dx, dy, row);
}

/* The same for line active->turn; where all edges are short, which is asked once. A function of its own: it wants all
 * registers. */
static LIM_ALONE void set_three(struct lim_mesh_active *active, lim_packed top, lim_packed middle, lim_packed low)
{
    const struct lim_packed_way whole = lim_packed_way(top, low), upper = lim_packed_way(top, middle);
    const int32_t lower_dx = whole.dx - upper.dx;
    const int32_t row = (int32_t)active->turn - LIM_ORIGIN_PX, middle_row = mesh_row_of(middle),
                  bottom_row = mesh_row_of(low);
    struct lim_edge edge;

    if (!edge_is_low(whole.dy, bottom_row - (lim_packed_y(top) >> LIM_SUB_BITS)) ||
        !edge_are_narrow(edge_width(whole.dx) | edge_width(upper.dx) | edge_width(lower_dx))) {
        set_one_by_one(active, top, middle, low);
        return;
    }
    set_short_from(&edge, top, whole.dx, whole.dy, row);
    lim_mesh_edges_take(&active->edges, active->goes_on ^ 1, &edge);
    active->bottom = (uint16_t)(bottom_row + LIM_ORIGIN_PX);
    if (middle_row > row) {
        set_short_from(&edge, top, upper.dx, upper.dy, row);
        lim_mesh_edges_take(&active->edges, active->goes_on, &edge);
        active->turn = (uint16_t)(middle_row + LIM_ORIGIN_PX);
        if (middle_row == bottom_row) return;
        set_short_from(&edge, middle, lower_dx, whole.dy - upper.dy, middle_row);
        lim_mesh_edge_take(&active->lower, &edge);
        return;
    }
    active->turn = active->bottom;
    set_short_from(&edge, middle, lower_dx, whole.dy - upper.dy, row);
    lim_mesh_edges_take(&active->edges, active->goes_on, &edge);
}

#else

static inline void set_three(struct lim_mesh_active *active, lim_packed top, lim_packed middle, lim_packed low)
{
    set_one_by_one(active, top, middle, low);
}

#endif

static LIM_INLINE struct three three_at(const struct lim_point *points, lim_index a, lim_index b, lim_index c)
{
    return three_of(lim_packed_load(&points[a]), lim_packed_load(&points[b]), lim_packed_load(&points[c]));
}

/* Apart and rare: so the compiler keeps registers for what is done with every triangle. */
static LIM_RARE void add_depth(const struct lim_mesh *mesh, struct lim_mesh_active *active, uint16_t y)
{
    lim_mesh_depth_begin(mesh, active, y);
}

static inline lim_mesh_rank rank_of_three(uint32_t near_a, uint32_t near_b, uint32_t near_c, lim_index triangle)
{
    return lim_mesh_rank_of((near_a + near_b + near_c) / 2, triangle);
}

/* `trial`: NULL, or as in lim_mesh_try(). *last: as in mesh_insert(). */
static LIM_INLINE bool mesh_begin(struct lim_mesh *mesh, const LIM_FLASH lim_index *triangles, lim_index triangle,
                                  uint16_t y, struct lim_mesh_trial *trial, struct lim_mesh_active **last,
                                  bool may_clip)
{
    const LIM_FLASH lim_index *corners = triangles + (size_t)triangle * LIM_TRIANGLE_WORDS;
    const lim_index a = corners[0], b = corners[1], c = corners[2];
    const uint32_t near_a = mesh->nearness[a], near_b = mesh->nearness[b], near_c = mesh->nearness[c];

    if (may_clip && (!near_a || !near_b || !near_c)) return begin_clipped(mesh, triangle, y, trial);
    const lim_mesh_rank rank = rank_of_three(near_a, near_b, near_c, triangle);
    if (is_left_out(trial, rank)) return false;
    struct lim_mesh_active *active = lim_mesh_new(mesh);
    if (LIM_UNLIKELY(!active)) return false;
    active->rank = rank;
    if (!LIM_HAS_TEXTURE) active->colour = lim_memory_colour((uint16_t)corners[3]);
    if (LIM_HAS_TEXTURE) lim_mesh_texture_begin(mesh, active);
    active->turn = y;
    if (LIM_HAS_STATS) *active->seen = false;
    mesh_insert(mesh, active, *last);
    *last = active;
    const struct three three = three_at(mesh->points, a, b, c);
    active->goes_on = three.side;
    set_three(active, three.top, three.middle, three.low);
    if (lim_mesh_is_deep(mesh, triangle)) add_depth(mesh, active, y);
    return true;
}

static LIM_INLINE lim_index mesh_begin_line(struct lim_mesh *mesh, uint16_t y, bool may_clip)
{
    const LIM_FLASH lim_index *const triangles = mesh->pass->scene->polygons;
    const lim_index *const links = mesh->links;
    struct lim_mesh_active *last = &mesh->end;

    for (lim_index triangle = mesh->tops[y]; triangle != LIM_NO_INDEX; triangle = links[triangle])
        if (!mesh_begin(mesh, triangles, triangle, y, NULL, &last, may_clip)) return triangle;
    return LIM_NO_INDEX;
}

static LIM_ALONE lim_index begin_unclipped(struct lim_mesh *mesh, uint16_t y)
{
    return mesh_begin_line(mesh, y, false);
}

lim_index lim_mesh_begin_all(struct lim_mesh *mesh, uint16_t y)
{
    if (!LIM_OPTIMISE_SIZE && mesh->extent != LIM_VIEW_CLIPPED) return begin_unclipped(mesh, y);
    return mesh_begin_line(mesh, y, mesh->extent == LIM_VIEW_CLIPPED);
}

bool lim_mesh_try(struct lim_mesh *mesh, lim_index triangle, uint16_t y, struct lim_mesh_trial *trial,
                  struct lim_mesh_active **last)
{
    return mesh_begin(mesh, mesh->pass->scene->polygons, triangle, y, trial, last, mesh->extent == LIM_VIEW_CLIPPED);
}

lim_mesh_rank lim_mesh_find_rank(const struct lim_mesh *mesh, lim_index triangle)
{
    const LIM_FLASH lim_index *corners = lim_mesh_triangle(mesh, triangle);
    struct lim_mesh_clipped clipped;

    if (!lim_mesh_is_cut(mesh, corners)) {
        const uint16_t *const nearness = mesh->nearness;
        return rank_of_three(nearness[corners[0]], nearness[corners[1]], nearness[corners[2]], triangle);
    }
    return lim_mesh_clip(mesh, triangle, &clipped) ? lim_mesh_rank_of(nearness_of(&clipped), triangle) : 0;
}

static void turn_clipped(const struct lim_mesh *mesh, struct lim_mesh_active *active, uint16_t y)
{
    struct lim_mesh_clipped clipped, part;

    (void)lim_mesh_clip(mesh, lim_mesh_number(active), &clipped);
    if (active->part) (void)fan_part(&clipped, active->part, &part);
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
    const struct three three = three_at(mesh->points, corners[0], corners[1], corners[2]);
    active->goes_on = three.side;
    active->turn = y;
    set_three(active, three.top, three.middle, three.low);
}

#endif
