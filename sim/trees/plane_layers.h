/* SPDX-License-Identifier: MIT
 *
 * Which polygons lie over which where several share a plane, or nearly: sheets, decals, posters. A tree takes what is
 * within its tolerance of one plane for one plane. Here the file's own corners, unwelded and unrounded, say which of
 * two is nearer to an eye; of two in one plane the later in the file lies over the earlier, seen from either side. */
#ifndef SIM_PLANE_LAYERS_H
#define SIM_PLANE_LAYERS_H

#include "model/mesh.h"

/* What is no farther apart than this share of the model's largest coordinate is in one plane: doubles, and what
 * transforms leave of them, tell no more. */
#define LAYERS_LEVEL_SHARE 0x1p-40

/* Another polygon that overlaps one, seen along its normal. */
struct layer {
    uint32_t other;
    int8_t height;  /* of the other: 1 in front of it, -1 behind it, 0 in its plane, or through it */
    bool is_turned; /* they face opposite ways */
};

struct layers {
    size_t *first; /* items[first[p] .. first[p + 1]) are polygon p's, by `other`; NULL: there are none at all */
    struct layer *items;
    size_t covered; /* polygons in one plane with a later one, which covers some of them */
};

/* Of the mesh's polygons that overlap within twice the tolerance, and can be seen from one side. */
void layers_find(const struct mesh *mesh, double tolerance_units, struct layers *out);

/* Those of a polygon; *count of them. */
const struct layer *layers_of(const struct layers *layers, uint32_t polygon, size_t *count);

/* How many polygons have any. */
size_t layers_polygons(const struct layers *layers, size_t polygon_count);

/* Which of two polygons hides a part of the other from some eye, as far as layers tell. */
struct layer_pair {
    bool p_hides_q, q_hides_p;
};
struct layer_pair layers_pair(const struct layers *layers, const struct mesh *mesh, uint32_t p, uint32_t q);

/* Puts polygons of one plane in order, nearest first for an eye on one side of it; where nothing decides, they stay as
 * they are. in_front[i]: the eye is in front of polygons[i]. order[]: indices into polygons[0 .. count). */
void layers_order(const struct layers *layers, const uint32_t *polygons, const bool *in_front, size_t count,
                  uint32_t *order);

void layers_free(struct layers *layers);

#endif
