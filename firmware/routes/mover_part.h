/* SPDX-License-Identifier: MIT
 *
 * A part of an instance is the instance and a list of planes, each with the side on which the part lies: an entry of a
 * list as the whole is, without a polygon of its own. Its polygons are cut where they are asked for: one that all of
 * its planes have on the part's side is the object's own, and one that crosses some is a piece (piece.h) by these. */
#ifndef LIM_MOVER_PART_H
#define LIM_MOVER_PART_H

#include "orders.h"
#include "pieces/piece.h"
#include "view/plane_unpacked.h"

/* A plane as an object has it, so that products of 32 bits decide what lies on one side by far. */
struct lim_turned_plane {
    int32_t n_q14[3];
    int32_t front_q14, back_q14; /* n . v beyond these is certainly in front, or behind */
};

void lim_plane_turn(struct lim_turned_plane *turned, const struct lim_instance *instance,
                    const struct lim_plane_unpacked *plane);

/* Where vertices are: of those that were asked so far, the least and the most. */
struct lim_turned_range {
    int32_t least_q14, most_q14;
};

static inline void lim_turned_add(struct lim_turned_range *range, const struct lim_turned_plane *plane,
                                  const struct lim_vertex *at)
{
    const int32_t value_q14 = plane->n_q14[0] * at->x + plane->n_q14[1] * at->y + plane->n_q14[2] * at->z;

    if (value_q14 < range->least_q14) range->least_q14 = value_q14;
    if (value_q14 > range->most_q14) range->most_q14 = value_q14;
}

/* The sides that they reach to, by far; 0: that is not certain. */
static inline uint8_t lim_turned_sides(const struct lim_turned_range *range, const struct lim_turned_plane *plane)
{
    if (range->least_q14 > plane->front_q14) return LIM_SIDE_FRONT;
    if (range->most_q14 < plane->back_q14) return LIM_SIDE_BACK;
    return range->least_q14 < plane->back_q14 && range->most_q14 > plane->front_q14 ? LIM_SIDE_BOTH : 0;
}

/* The planes of a part, for its polygons. */
enum { LIM_PART_PLANES = 4 }; /* what is beyond is turned for each polygon */
struct lim_part {
    uint16_t cuts; /* LIM_NONE: it is whole */
    struct lim_turned_plane planes[LIM_PART_PLANES];
};
void lim_part_begin(struct lim_part *part, const struct lim_sorter *sorter, uint16_t entry);

/* What of an entry, a polygon of the part's instance that nothing has cut, belongs to the part. */
enum lim_part_share {
    LIM_PART_NOTHING,
    LIM_PART_ALL,
    LIM_PART_PIECE /* the entry has the cuts that make it: the newest ones in use */
};
enum lim_part_share lim_part_take(const struct lim_part *part, struct lim_sorter *sorter, uint16_t entry);

#endif
