/* SPDX-License-Identifier: MIT
 *
 * How far what is drawn below a node may reach to the wrong side of its plane n . p = d, in units times
 * |n0| + |n1| + |n2|. A corner was within the tolerance of 1/2 and then rounded by 1/2 along each axis: 1. A ray meets
 * a polygon in its plane, from which corners are off by as much; along the longest component of the normal that is up
 * to 3/2 + 0.87, and 1 more as polygons reach half a unit beyond their edges: 3.4. So 5 is enough for planes, and 4 for
 * boxes, which hold corners.
 *
 * A plane is tried by its 16-bit normal and points in units: n . floor(p) is off by less than |n0| + |n1| + |n2| <=
 * 32767, and that of a LARGE plane's filter by less than 73729, as eye.c derives, with a normal whose components add up
 * to 24573 at most. 5 * 32767 + 32767 and 5 * 24573 + 73729 are below DESCENT_SLACK. From outside of the cube all of it
 * is shifted and the slack is not: it grows with the distance. */
#include "touch/descent.h"

#include "movers/deform.h"

#define DESCENT_SLACK (INT32_C(3) << 16)
enum { AXIS_SLACK_Q8 = 5 * 256, BOX_SLACK = 4, RAY_WAY_BITS = 13 };

static bool is_in_cube(const int32_t at_q8[3], uint8_t shift)
{
    bool fits = true;

    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t whole = at_q8[i] >> 8 >> shift;
        fits = fits && whole >= -32768 && whole <= 32767;
    }
    return fits;
}

static void set_end(struct lim_descent_end *end, const int32_t at_q8[3])
{
    end->shift = 0;
    while (!is_in_cube(at_q8, end->shift))
        end->shift++;
    for (uint_fast8_t i = 0; i < 3; i++) {
        end->at_q8[i] = at_q8[i];
        end->whole[i] = at_q8[i] >> 8 >> end->shift;
    }
}

/* The cuboid around box and way, rounded outwards to units. */
static void bound_way(struct lim_descent *descent)
{
    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t a = descent->from.at_q8[i] >> 8, b = descent->to.at_q8[i] >> 8;
        const int32_t reach = descent->half_units[i] + BOX_SLACK;
        descent->low[i] = (a < b ? a : b) - reach;
        descent->high[i] = (a < b ? b : a) + reach + 1;
    }
}

/* Shifted to 13 bits, so each component is off by less than 1. */
static void set_way(struct lim_descent *descent)
{
    uint32_t longest = 0;
    uint8_t shift = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
        descent->way[i] = descent->to.at_q8[i] - descent->from.at_q8[i];
        longest |= abs_s32(descent->way[i]);
    }
    while (longest >> shift >> RAY_WAY_BITS)
        shift++;
    for (uint_fast8_t i = 0; i < 3; i++)
        descent->way[i] >>= shift;
}

void lim_descent_begin(struct lim_descent *descent, const struct lim_solid *solid, const int32_t from_q8[3],
                       const int32_t to_q8[3], const int32_t half_q8[3])
{
    descent->scene = solid->scene;
    descent->stack = solid->stack;
    descent->next = solid->scene->node_count ? 0 : LIM_NO_INDEX;
    descent->depth = 0;
    descent->is_ray = !half_q8;
    for (uint_fast8_t i = 0; i < 3; i++) {
        descent->half_q8[i] = half_q8 ? half_q8[i] : 0;
        descent->half_units[i] = (descent->half_q8[i] + 255) >> 8;
    }
    set_end(&descent->from, from_q8);
    set_end(&descent->to, to_q8);
    bound_way(descent);
    if (descent->is_ray) set_way(descent);
}

void lim_descent_shorten(struct lim_descent *descent, const int32_t way_q8[3], uint32_t part_q30)
{
    int32_t at_q8[3];

    for (uint_fast8_t i = 0; i < 3; i++)
        at_q8[i] = descent->from.at_q8[i] + lim_part_of(way_q8[i], part_q30);
    set_end(&descent->to, at_q8);
    bound_way(descent);
}

/* Whether the way's line misses the box, both seen along the third axis: (c - a) x way is beyond what the box reaches.
 * |c - a| <= 2^16 and |way| <= 2^13, so each sum is 2^30 at most; a component of the way that is off by 1 moves the
 * product by |c - a|, and the reach by the box's. */
static bool passes_beside(const struct lim_descent *descent, const LIM_FLASH struct lim_box *box, uint_fast8_t i,
                          uint_fast8_t j)
{
    const int32_t from_i = box->centre[i] - descent->from.whole[i], from_j = box->centre[j] - descent->from.whole[j];
    const int32_t reach_i = box->half[i] + BOX_SLACK + 1, reach_j = box->half[j] + BOX_SLACK + 1;
    const int32_t way_i = descent->way[i], way_j = descent->way[j];
    const uint32_t reach = abs_s32(way_i) * (uint32_t)reach_j + abs_s32(way_j) * (uint32_t)reach_i;

    return abs_s32(from_i * way_j - from_j * way_i) >
           reach + abs_s32(from_i) + abs_s32(from_j) + (uint32_t)reach_i + (uint32_t)reach_j;
}

static bool misses_box(const struct lim_descent *descent, const LIM_FLASH struct lim_box *box)
{
    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t centre = box->centre[i], half = box->half[i];
        if (centre + half < descent->low[i] || centre - half > descent->high[i]) return true;
    }
    if (!descent->is_ray || descent->from.shift) return false;
    return passes_beside(descent, box, 0, 1) || passes_beside(descent, box, 1, 2) || passes_beside(descent, box, 2, 0);
}

/* n . p - d by the 16-bit normal, units: scene.h's bounds keep it in 32 bits. */
static int32_t end_value(const struct lim_descent_end *end, const LIM_FLASH struct lim_plane *plane)
{
    const int32_t sum =
        lim_plane_x(plane) * end->whole[0] + lim_plane_y(plane) * end->whole[1] + lim_plane_z(plane) * end->whole[2];

    return sum - (lim_plane_d(plane) >> end->shift);
}

/* A way's two ends as values of a plane, and how far from 0 they may be on either side. */
struct ends {
    int32_t from, to, slack;
};

static struct ends ends_of(const struct lim_descent *descent, const LIM_FLASH struct lim_plane_ref *ref)
{
    if (!LIM_HAS_SLANTED || ref->plane >= LIM_PLANE_X) {
        const uint_fast8_t axis = ref->plane & 3;
        const int32_t at_q8 = (int32_t)ref->offset * 256;
        return (struct ends){descent->from.at_q8[axis] - at_q8, descent->to.at_q8[axis] - at_q8,
                             descent->half_q8[axis] + AXIS_SLACK_Q8};
    }
    const LIM_FLASH struct lim_plane *plane = lim_plane_at(descent->scene->planes, ref->plane);
    const uint32_t reach = abs_s32(lim_plane_x(plane)) * (uint32_t)descent->half_units[0] +
                           abs_s32(lim_plane_y(plane)) * (uint32_t)descent->half_units[1] +
                           abs_s32(lim_plane_z(plane)) * (uint32_t)descent->half_units[2];

    return (struct ends){end_value(&descent->from, plane), end_value(&descent->to, plane),
                         (int32_t)reach + DESCENT_SLACK};
}

/* Goes to the near child, and leaves the far one and the node's own polygons on the stack if the way may come there. */
static void enter_node(struct lim_descent *descent, const LIM_FLASH struct lim_node *node, lim_index at)
{
    const struct ends ends = ends_of(descent, &node->split);
    const bool front = ends.from > 0;

    descent->next = front ? node->front : node->back;
    if (ends.from > ends.slack && ends.to > ends.slack) return;
    if (ends.from < -ends.slack && ends.to < -ends.slack) return;
    LIM_DEBUG_ASSERT(descent->depth < descent->scene->limits.depth);
    descent->stack[descent->depth++] = at;
}

/* A node whose near side is done. The way may be shorter by now; which side is near depends on where it begins alone.
 */
static const LIM_FLASH struct lim_node *leave_node(struct lim_descent *descent)
{
    const LIM_FLASH struct lim_node *node = &descent->scene->nodes[descent->stack[--descent->depth]];
    const struct ends ends = ends_of(descent, &node->split);
    const bool front = ends.from > 0;

    if (front ? ends.from > ends.slack && ends.to > ends.slack : ends.from < -ends.slack && ends.to < -ends.slack)
        return NULL;
    descent->next = front ? node->back : node->front;
    return node;
}

const LIM_FLASH struct lim_node *lim_descent_next(struct lim_descent *descent)
{
    for (;;) {
        const lim_index at = descent->next;
        if (at == LIM_NO_INDEX) {
            if (!descent->depth) return NULL;
            const LIM_FLASH struct lim_node *left = leave_node(descent);
            if (left) return left;
            continue;
        }
        const LIM_FLASH struct lim_node *node = &descent->scene->nodes[at];
        descent->next = LIM_NO_INDEX;
        if (node->box != LIM_NO_INDEX && misses_box(descent, &descent->scene->boxes[node->box])) continue;
        if (lim_node_is_leaf(node)) return node;
        enter_node(descent, node, at);
    }
}

/* Shifted until the divisor has 33 bits. Rounding it up adds 2 to it at most, and the other loses 1 at most: together
 * less than 2^-30 of a whole. */
uint32_t lim_part_q30(uint64_t num, uint64_t den)
{
    while (den >> 33) {
        num >>= 1;
        den = (den >> 1) + 1;
    }
    return (uint32_t)((num << 30) / den);
}

bool lim_descent_plane(struct lim_plane_unpacked *plane, const struct lim_scene *scene,
                       const LIM_FLASH lim_index *record)
{
    if (LIM_HAS_MESH_LEAVES && !(record[0] & LIM_POLYGON_PLANE)) return lim_deform_plane(plane, scene, record);
    lim_plane_unpack(plane, scene, lim_record_plane(record));
    return true;
}

void lim_hit_normal(const int32_t axis[3], bool other_way, int16_t normal[3])
{
    const uint32_t sizes = abs_s32(axis[0]) | abs_s32(axis[1]) | abs_s32(axis[2]);
    uint8_t shift = 0;

    while (sizes >> shift >> 15)
        shift++;
    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t size = (int32_t)(abs_s32(axis[i]) >> shift);
        normal[i] = (int16_t)((axis[i] < 0) != other_way ? -size : size);
    }
}
