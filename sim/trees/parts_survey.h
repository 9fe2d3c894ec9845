/* SPDX-License-Identifier: MIT
 *
 * What is known of a mesh's parts while they are found. */
#ifndef SIM_PARTS_SURVEY_H
#define SIM_PARTS_SURVEY_H

#include "model/mesh.h"

/* A dense part: polygons that share points with one another, or lie among those that do (parts_gather.h); all opaque,
 * each small against all of it; not what has most of the others within its bounds. */
struct part {
    uint32_t face;   /* the first one's number in the model file */
    size_t polygons; /* as the mesh has them */
    double low[3], high[3];
};

/* The least polygons of a dense part, and the most records that a leaf holds. */
enum { PART_POLYGONS_MIN = 64, PART_RECORDS_MAX = 32767 };

/* What is known of a part, by its leader. */
struct survey {
    struct part part; /* no polygons: it is none, or has joined another one */
    double largest;   /* the longest diagonal of a polygon's box */
    size_t records;
};

#define PARTS_LARGEST_SHARE 0.5 /* most of the diagonal of a part's box that a polygon of it may have */

double parts_diagonal(const double low[3], const double high[3]);

/* The leader of a polygon's part; leaders[i] <= i. */
uint32_t parts_leader(uint32_t *leaders, uint32_t polygon);

#endif
