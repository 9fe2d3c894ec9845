/* SPDX-License-Identifier: MIT
 *
 * Planes as a scene stores them: integers, so that the firmware decides sides exactly and the
 * compiler partitions by the very same planes. Each gets the cheapest kind that is good enough. */
#ifndef SIM_PLANE_H
#define SIM_PLANE_H

#include "base/point_blocks.h"
#include "scene.h"

#include <stddef.h>

/* What a plane costs: axis planes, upright ones (n[1] = 0), and SMALL ones are exact in 16-bit numbers, LARGE ones are
 * stored twice, as a filter and exactly. */
enum plane_kind { PLANE_X, PLANE_Y, PLANE_Z, PLANE_XZ, PLANE_SMALL, PLANE_LARGE, PLANE_KINDS };

/* n . p = d. |n[i]| <= 2^30, |d| < 2^48; within scene.h's bounds for its kind. Of a long scene |d| < 2^61. */
struct plane {
    int64_t n[3], d;
    enum plane_kind kind;
    double length; /* |n|, rounded */
};

enum { PLANE_SUM_MAX = 32767 }; /* of |n[0]| + |n[1]| + |n[2]| in a record */

/* No plane is stored with a larger error, in units, at a point of the grid: LARGE normals round
 * by 2^-31 of their length, which at 2^16 * sqrt(3) units from the face is 2^-14. */
#define PLANE_STORAGE_ERROR_UNITS (1.0 / 4096.0)

/* What a stored plane has to get right. */
struct plane_fit {
    double normal[3];     /* unit length */
    double (*corners)[3]; /* of the polygons that shall lie on the plane; units */
    size_t corner_count;
    const struct point_blocks *blocks; /* the points of the whole mesh; units */
    double tolerance_units;            /* 0: cheap kinds only if they hold every corner exactly */
    bool is_long;                      /* of a long scene: an axis plane, or a LARGE one */
};

/* Chooses the stored plane: parallel to fit->normal, in the middle of fit->corners. A cheap kind
 * is taken only if no corner lies farther than the tolerance from it, no point that lies on the
 * ideal plane leaves it, and no other point changes sides. Otherwise it is LARGE. */
void plane_store(const struct plane_fit *fit, struct plane *out);

/* Signed distance of a point, in units; off by less than 2^-30 for points of the grid. */
static inline double plane_distance(const struct plane *plane, const double point[3])
{
    double sum = (double)plane->n[0] * point[0] + (double)plane->n[1] * point[1] + (double)plane->n[2] * point[2];
    return (sum - (double)plane->d) / plane->length;
}

/* The record of a plane within scene.h's bounds; of a LARGE plane, exactly the filter that scene.h prescribes, which
 * belongs to the exact plane of that index. */
struct lim_plane plane_record(const int64_t n[3], int64_t d);
struct lim_plane plane_filter(const int64_t n[3], int64_t d, lim_index exact);

/* The kind of a plane that a scene names, and the exact plane. */
enum plane_kind plane_kind_of(const struct lim_scene *scene, const struct lim_plane_ref *ref);
void plane_exact(const struct lim_scene *scene, const struct lim_plane_ref *ref, int64_t n[3], int64_t *d);

#endif
