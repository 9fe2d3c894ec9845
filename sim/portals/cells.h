/* SPDX-License-Identifier: MIT
 *
 * The cells of a compiled scene, the convex regions where its tree ends, and the openings between them: the parts of
 * the planes that no polygon closes. Limner's polygons have one side, so an opening has a direction: what faces the
 * one who looks through closes it, a back does not. All of it as drawn: stored planes, rounded vertices. */
#ifndef SIM_CELLS_H
#define SIM_CELLS_H

#include "base/error.h"
#include "portals/patch.h"
#include "scene.h"

#include <stdint.h>

/* A cell's number: twice the node whose child is missing, and 1 more behind its plane. Others do not exist. */
static inline uint32_t cell_of(uint32_t node, bool behind)
{
    return 2 * node + behind;
}

/* One looks from the back of `flat` to its front. */
struct opening {
    uint32_t from, to; /* cells */
    uint32_t node;     /* whose plane it is */
    struct flat flat;
    struct patch patch; /* counter-clockwise seen from the front of `flat` */
};

/* A polygon record as cells see it. */
struct cell_record {
    uint32_t node;
    struct flat faces;  /* the plane, its front where the polygon is seen from */
    struct patch patch; /* the hull of its vertices */
    bool opaque;
};

struct cell {
    bool exists;            /* it holds a point of the scene's box */
    bool is_free;           /* polygons of its last plane face it: an eye may be here. Else it is matter, or unknown */
    bool bounded;           /* it does not reach the border of the scene's box */
    double low[3], high[3]; /* its bounds, if bounded */
    double volume;          /* the same */
    size_t first_opening, opening_count; /* that lead out of it */
    size_t first_touch, touch_count;     /* records that touch it */
};

struct cells {
    const struct lim_scene *scene;
    struct flat *planes;    /* of each node */
    uint32_t *parents;      /* of each node; the root's is its own number */
    double low[3], high[3]; /* the scene's box, grown by a little */
    double reach_units;     /* of the box from the origin, along the axes */
    double noise_units;     /* how far vertices lie off the planes that they belong to */
    struct cell *items;
    size_t count;             /* 2 a node */
    struct opening *openings; /* by the cell that they lead out of */
    size_t opening_count, opening_capacity;
    struct cell_record *records;
    size_t record_count, record_capacity;
    uint32_t *touches; /* records, by cell */
};

/* Polygons so close to a cell are as good as in it: more than rounding can move anything. */
#define CELLS_MARGIN_UNITS 4.0

/* Refuses a scene whose openings are too many to be looked at. Of a scene that pvs_may_be(). */
bool cells_find(const struct lim_scene *scene, struct cells *out, struct error *err);
void cells_free(struct cells *cells);

#endif
