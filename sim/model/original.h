/* SPDX-License-Identifier: MIT
 *
 * The faces of a model as its file has them, before weld and grid: what a compiled scene is held against, and where
 * cameras go that look at what is small. */
#ifndef SIM_ORIGINAL_H
#define SIM_ORIGINAL_H

#include "model/model.h"

struct grid;

struct original_face {
    uint32_t first, count;         /* corners_m[first .. first + count); count is 0 of a face that is not to be seen:
                                      invisible, or without area in the file */
    uint32_t number;               /* in the file, from 1 */
    uint32_t patch;                /* the lowest index of a face of the same surface patch */
    uint32_t thing;                /* the lowest index of a face that common corners join it to */
    double size_m;                 /* the longest side of the patch's bounds */
    double width_m;                /* of the face alone: how far corners leave the line through its two outermost */
    double centre_m[3], normal[3]; /* mean of the corners; of length 1 */
    double radius_m;               /* of the corners about the centre */
};

/* A surface patch is what the eye takes for one surface: faces with common edges at which it bends by less than 45
 * degrees. The side of a box is one, and so is the whole hull of a teapot. */
struct original {
    struct original_face *faces; /* one to one with the model's */
    size_t face_count;
    double (*corners_m)[3];
    uint32_t *points; /* of each corner: the mesh's point that it was welded to */
    size_t corner_count;
    uint32_t *by_size; /* indices of the faces to be seen, smallest patch first */
    size_t seen_count;
    unsigned more_owners;
};

/* `welded`: for each point of the model that of the mesh. The caller's to free, by original_free(). NULL: time is over
 * (deadline.h). */
struct original *original_make(const struct model *model, const struct grid *grid, const uint32_t *welded);

/* One more owner, who frees it as well; NULL stays NULL. */
struct original *original_share(struct original *original);
void original_free(struct original *original);

#endif
