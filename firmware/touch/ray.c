/* SPDX-License-Identifier: MIT
 *
 * A segment against the polygons that DESCENT gives. With the values N and N - M of a polygon's plane at its ends, it
 * crosses at N / M of the way, at the point h = a + D N / M.
 *
 * Whether h is in the polygon is asked along the longest component of the normal, in the other two axes i and j. For an
 * edge from p by e, E = e_i (h_j - p_j) - e_j (h_i - p_i) tells the side, and the square around h, of half a unit,
 * touches the edge's line where |E| <= (|e_i| + |e_j|) / 2. All of that is tried at h rounded to 2^-8 units, which is
 * off by less than NEAR_OFF_Q8 along either axis, so E is off by less than that times |e_i| + |e_j|. Where that leaves
 * it open whether an edge is touched, it is decided on h itself: M E = A M + B N, in 128 bits. Where no edge is
 * touched, no edge lies between h and the rounded point, and how often a line from there crosses edges is the same. */
#include "collide.h"
#include "eye.h"
#include "math/wide.h"
#include "touch/descent.h"
#include "view/plane_unpacked.h"

enum { REACH_Q8 = 128, NEAR_OFF_Q8 = 2 };

struct ray {
    const struct lim_scene *scene;
    int32_t from_q8[3], to_q8[3], way_q8[3];
    uint64_t num, den; /* of the nearest polygon, so far */
    struct lim_hit *hit;
    bool found, backs;
};

/* Where a ray crosses a plane. */
struct ray_crossing {
    struct lim_plane_unpacked plane;
    uint64_t num, den;        /* N and M, both positive whichever side it comes from */
    bool from_back;           /* of the plane */
    uint_fast8_t i, j;        /* axes in which polygons are looked at */
    int32_t at_i_q8, at_j_q8; /* h, rounded */
};

static uint_fast8_t longest_axis(const int32_t n[3])
{
    const uint32_t x = abs_s32(n[0]), y = abs_s32(n[1]), z = abs_s32(n[2]);

    if (x >= y && x >= z) return 0;
    return y >= z ? 1 : 2;
}

static int32_t along(const struct ray *ray, uint_fast8_t axis, uint32_t part_q30)
{
    return ray->from_q8[axis] + lim_part_of(ray->way_q8[axis], part_q30);
}

/* false: the ray does not cross crossing->plane. */
static bool cross_plane(const struct ray *ray, struct ray_crossing *crossing)
{
    const int64_t from = lim_plane_value_q8(&crossing->plane, ray->from_q8),
                  to = lim_plane_value_q8(&crossing->plane, ray->to_q8);

    if (from == to || (from > 0 && to > 0) || (from < 0 && to < 0)) return false;
    crossing->from_back = from < 0 || (!from && to > 0);
    crossing->num = crossing->from_back ? 0 - (uint64_t)from : (uint64_t)from;
    crossing->den = crossing->from_back ? (uint64_t)to - (uint64_t)from : (uint64_t)from - (uint64_t)to;
    return true;
}

/* Where that is, once something has to be looked at there. */
static void place_crossing(const struct ray *ray, struct ray_crossing *crossing)
{
    const uint32_t part_q30 = lim_part_q30(crossing->num, crossing->den);

    crossing->i = lim_axis_after(longest_axis(crossing->plane.n));
    crossing->j = lim_axis_after(crossing->i);
    crossing->at_i_q8 = along(ray, crossing->i, part_q30);
    crossing->at_j_q8 = along(ray, crossing->j, part_q30);
}

struct corner {
    int32_t i, j; /* units */
};

static int32_t coordinate(const LIM_FLASH struct lim_vertex *vertex, uint_fast8_t axis)
{
    return axis == 0 ? vertex->x : axis == 1 ? vertex->y : vertex->z;
}

static struct corner corner_at(const struct ray *ray, const struct ray_crossing *crossing,
                               const LIM_FLASH lim_index *record, uint_fast8_t k)
{
    const LIM_FLASH struct lim_vertex *vertex = &ray->scene->vertices[record[LIM_POLYGON_HEAD_WORDS + k]];

    return (struct corner){coordinate(vertex, crossing->i), coordinate(vertex, crossing->j)};
}

/* How h lies to c along an axis, times M: its sign. */
static int32_t side_of_value(const struct ray *ray, const struct ray_crossing *crossing, uint_fast8_t axis,
                             int32_t c_q8)
{
    return lim_wide_sign((int64_t)ray->from_q8[axis] - c_q8, crossing->den, ray->way_q8[axis], crossing->num);
}

/* Whether the square around h itself touches the edge. */
static LIM_RARE bool touches_exactly(const struct ray *ray, const struct ray_crossing *crossing, struct corner p,
                                     struct corner q)
{
    const int32_t e_i = q.i - p.i, e_j = q.j - p.j;
    const int64_t a =
        e_i * ((int64_t)ray->from_q8[crossing->j] - p.j * 256) - e_j * ((int64_t)ray->from_q8[crossing->i] - p.i * 256);
    const int64_t b = (int64_t)e_i * ray->way_q8[crossing->j] - (int64_t)e_j * ray->way_q8[crossing->i];
    const int64_t reach = (int64_t)(abs_s32(e_i) + abs_s32(e_j)) * REACH_Q8;
    const struct corner low = {p.i < q.i ? p.i : q.i, p.j < q.j ? p.j : q.j};
    const struct corner high = {p.i < q.i ? q.i : p.i, p.j < q.j ? q.j : p.j};

    return side_of_value(ray, crossing, crossing->i, low.i * 256 - REACH_Q8) >= 0 &&
           side_of_value(ray, crossing, crossing->i, high.i * 256 + REACH_Q8) <= 0 &&
           side_of_value(ray, crossing, crossing->j, low.j * 256 - REACH_Q8) >= 0 &&
           side_of_value(ray, crossing, crossing->j, high.j * 256 + REACH_Q8) <= 0 &&
           lim_wide_sign(a + reach, crossing->den, b, crossing->num) >= 0 &&
           lim_wide_sign(a - reach, crossing->den, b, crossing->num) <= 0;
}

enum touching { TOUCHES_NOT, TOUCHES_PERHAPS, TOUCHES };

/* How far a value is outside of a..b: 0 or less within. */
static int32_t outside(int32_t value_q8, int32_t a, int32_t b)
{
    const int32_t from_a_q8 = value_q8 - a * 256, from_b_q8 = value_q8 - b * 256;

    if (a < b) return from_a_q8 < 0 ? -from_a_q8 : from_b_q8;
    return from_b_q8 < 0 ? -from_b_q8 : from_a_q8;
}

/* Of the square around the rounded point, and what that says of the other. Corners and that point are less than 2^29
 * apart, edges are 2^16 long: `side` is below 2^46. */
static enum touching touches_edge(const struct ray_crossing *crossing, struct corner p, struct corner q, int64_t side)
{
    const int32_t out_i_q8 = outside(crossing->at_i_q8, p.i, q.i), out_j_q8 = outside(crossing->at_j_q8, p.j, q.j);
    const int32_t out_q8 = out_i_q8 > out_j_q8 ? out_i_q8 : out_j_q8;

    if (out_q8 > REACH_Q8 + NEAR_OFF_Q8) return TOUCHES_NOT;
    const int64_t length = (int64_t)(abs_s32(q.i - p.i) + abs_s32(q.j - p.j));
    const int64_t from_line = side < 0 ? -side : side;
    if (from_line > length * (REACH_Q8 + NEAR_OFF_Q8)) return TOUCHES_NOT;
    return out_q8 <= REACH_Q8 - NEAR_OFF_Q8 && from_line <= length * (REACH_Q8 - NEAR_OFF_Q8) ? TOUCHES
                                                                                              : TOUCHES_PERHAPS;
}

static bool is_inside(const struct ray *ray, const struct ray_crossing *crossing, const LIM_FLASH lim_index *record)
{
    const uint_fast8_t count = (uint_fast8_t)(record[0] & LIM_POLYGON_COUNT);
    struct corner p = corner_at(ray, crossing, record, (uint_fast8_t)(count - 1));
    bool inside = false;

    for (uint_fast8_t k = 0; k < count; k++) {
        const struct corner q = corner_at(ray, crossing, record, k);
        const int64_t side = (int64_t)(q.i - p.i) * (crossing->at_j_q8 - p.j * 256) -
                             (int64_t)(q.j - p.j) * (crossing->at_i_q8 - p.i * 256);
        const enum touching touching = touches_edge(crossing, p, q, side);
        if (touching == TOUCHES) return true;
        if (touching == TOUCHES_PERHAPS && touches_exactly(ray, crossing, p, q)) return true;
        const bool p_is_above = p.j * 256 > crossing->at_j_q8, q_is_above = q.j * 256 > crossing->at_j_q8;
        if (p_is_above != q_is_above && (side > 0) == q_is_above) inside = !inside;
        p = q;
    }
    return inside;
}

/* The nearest, so far. */
static void note_hit(struct ray *ray, const struct ray_crossing *crossing, const LIM_FLASH lim_index *record)
{
    ray->found = true;
    ray->num = crossing->num;
    ray->den = crossing->den;
    ray->hit->record = (lim_index)(record - ray->scene->polygons);
    ray->hit->part_q30 = lim_part_q30(crossing->num, crossing->den);
    lim_hit_normal(crossing->plane.n, crossing->from_back, ray->hit->normal);
    /* Each coordinate moves by less than 1 when it is rounded, and the plane's value by less than the slack. */
    const uint64_t slack = (uint64_t)crossing->plane.slack;
    const uint64_t num = crossing->num > slack ? crossing->num - slack : 0;
    const uint32_t part_q30 = lim_part_q30(num, crossing->den);
    for (uint_fast8_t i = 0; i < 3; i++)
        ray->hit->at_q8[i] = along(ray, i, part_q30);
}

static bool crosses_nearer(const struct ray *ray, const struct ray_crossing *crossing)
{
    return !ray->found || lim_wide_compare(crossing->num, ray->den, ray->num, crossing->den) < 0;
}

/* back: its records face the back of the plane. */
static void try_run(struct ray *ray, struct ray_crossing *crossing, lim_index run, bool back, bool *placed)
{
    const LIM_FLASH lim_index *record = ray->scene->polygons + run;

    if (run == LIM_NO_INDEX || (crossing->from_back != back && !(ray->backs && crossing->num))) return;
    for (;; record += lim_record_words(record[0])) {
        if (!*placed) place_crossing(ray, crossing);
        *placed = true;
        if (is_inside(ray, crossing, record)) {
            note_hit(ray, crossing, record);
            return;
        }
        if (record[0] & LIM_POLYGON_LAST) return;
    }
}

static void try_node(struct ray *ray, const LIM_FLASH struct lim_node *node)
{
    struct ray_crossing crossing;
    bool placed = false;

    lim_plane_unpack(&crossing.plane, ray->scene, &node->split);
    if (!cross_plane(ray, &crossing) || !crosses_nearer(ray, &crossing)) return;
    try_run(ray, &crossing, node->front_run, false, &placed);
    if (crosses_nearer(ray, &crossing)) try_run(ray, &crossing, node->back_run, true, &placed);
}

/* Each record has a plane of its own. */
static void try_leaf(struct ray *ray, const LIM_FLASH struct lim_node *node)
{
    const LIM_FLASH lim_index *record = ray->scene->polygons + node->front_run;

    for (;; record += lim_record_words(record[0])) {
        const bool back = record[0] & LIM_POLYGON_BACK;
        struct ray_crossing crossing;
        if (lim_descent_plane(&crossing.plane, ray->scene, record) && cross_plane(ray, &crossing) &&
            (crossing.from_back == back || (ray->backs && crossing.num)) && crosses_nearer(ray, &crossing)) {
            place_crossing(ray, &crossing);
            if (is_inside(ray, &crossing, record)) note_hit(ray, &crossing, record);
        }
        if (record[0] & LIM_POLYGON_LAST) return;
    }
}

static bool is_in_range(const int32_t at_q8[3])
{
    bool in = true;

    for (uint_fast8_t i = 0; i < 3; i++)
        in = in && at_q8[i] > -LIM_EYE_MAX_Q8 && at_q8[i] < LIM_EYE_MAX_Q8;
    return in;
}

int lim_trace(const struct lim_solid *solid, const int32_t from_q8[3], const int32_t to_q8[3], uint8_t flags,
              struct lim_hit *hit)
{
    LIM_ASSERT(solid && from_q8 && to_q8 && hit);
    struct ray ray = {.scene = solid->scene, .hit = hit, .backs = flags & LIM_STOP_BACKS};
    struct lim_descent descent;
    const LIM_FLASH struct lim_node *node;

    if (!is_in_range(from_q8) || !is_in_range(to_q8)) return LIM_ERR_CAMERA;
    for (uint_fast8_t i = 0; i < 3; i++) {
        ray.from_q8[i] = from_q8[i];
        ray.to_q8[i] = to_q8[i];
        ray.way_q8[i] = to_q8[i] - from_q8[i];
    }
    lim_descent_begin(&descent, solid, from_q8, to_q8, NULL);
    while ((node = lim_descent_next(&descent))) {
        const uint64_t num = ray.num;
        const uint64_t den = ray.den;
        if (lim_node_is_leaf(node))
            try_leaf(&ray, node);
        else
            try_node(&ray, node);
        if (ray.num != num || ray.den != den) lim_descent_shorten(&descent, ray.way_q8, ray.hit->part_q30);
    }
    return ray.found;
}
