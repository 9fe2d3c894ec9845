/* SPDX-License-Identifier: MIT
 *
 * Convex polygons in space, in units and double precision: facets of cells and the openings in them. Whatever does
 * not fit is left larger than it is, never smaller: an opening may be too wide, not too narrow. */
#ifndef SIM_PATCH_H
#define SIM_PATCH_H

#include <stdbool.h>
#include <stddef.h>

enum { PATCH_CORNERS_MAX = 40 };

struct patch {
    size_t count; /* 0: empty */
    double at[PATCH_CORNERS_MAX][3];
};

/* n . p = d, |n| = 1 */
struct flat {
    double n[3], d;
};

double flat_distance(const struct flat *flat, const double point[3]);
struct flat flat_turned(const struct flat *flat);

/* The square of the plane that reaches `reach_units` and more from the origin to every side. */
void patch_square(struct patch *patch, const struct flat *flat, double reach_units);

/* Keeps what is in front of the plane or on it. Returns whether anything with an area is left. */
bool patch_clip(struct patch *patch, const struct flat *flat);

/* The same polygon for flat_turned(). */
void patch_turn(struct patch *patch);

/* The least and the greatest distance of its corners from a plane. */
void patch_range(const struct patch *patch, const struct flat *flat, double *low, double *high);

/* The convex hull of points of one plane, counter-clockwise seen from the front of `flat`; points off the plane are
 * brought down to it. A hull of too many corners becomes the rectangle around it: false. */
bool patch_hull(struct patch *patch, const struct flat *flat, const double (*points)[3], size_t count);

/* The plane through the edge behind corner i that stands on `flat`, of which it has the inside of the patch in
 * front. The patch lies in `flat`, corners counter-clockwise seen from its front. false: the edge has no length. */
bool patch_side(const struct patch *patch, const struct flat *flat, size_t i, struct flat *side);

/* The patch with its sides moved out by a margin, but no corner beyond the rectangle around it that is as much larger.
 */
void patch_grow(const struct patch *patch, const struct flat *flat, double margin_units, struct patch *out);

/* The distance between the two closest parallel lines that hold it. */
double patch_width(const struct patch *patch, const struct flat *flat);

double patch_area(const struct patch *patch, const struct flat *flat);

/* Whether all corners of the other, in the same plane, lie inside or closer than `slack_units`. */
bool patch_holds(const struct patch *patch, const struct flat *flat, const struct patch *other, double slack_units);

/* A list of patches. */
struct patches {
    struct patch *items;
    size_t count, capacity;
};

void patches_add(struct patches *patches, const struct patch *patch);
void patches_free(struct patches *patches);

/* Takes `hole` out of all of them; all lie in `flat`. Returns whether it met any. */
bool patches_subtract(struct patches *patches, const struct flat *flat, const struct patch *hole);

#endif
