/* SPDX-License-Identifier: MIT
 *
 * The reference's own readers: faces of OBJ, PLY, STL and glTF files, in double precision, by code that has nothing in
 * common with the importer's. What one of them reads wrongly, the other does not. */
#ifndef SIM_SOURCE_H
#define SIM_SOURCE_H

#include "model/model.h"

/* The faces of a file in model_import()'s order, corners in theirs. */
struct source {
    uint32_t *counts; /* of corners, for each face */
    size_t face_count, face_capacity;
    double (*corners)[3];                        /* metres, of one face after the other */
    size_t corner_count, corner_capacity, ended; /* ended: of faces that are complete */
    double reach_m;                              /* the largest coordinate on the way to any of them */
    struct source_motion motion;                 /* of glTF */
};

/* Of the face being read, which source_face() ends: one of fewer than three corners is none. */
void source_corner(struct source *source, const double at_m[3]);
void source_face(struct source *source);
void source_free(struct source *source);

enum source_result {
    SOURCE_READ,
    SOURCE_UNKNOWN, /* nothing that these readers know */
    SOURCE_BAD      /* *err says why */
};

enum source_result source_obj_read(const char *path, struct source *source, struct error *err);
enum source_result source_ply_read(const char *path, struct source *source, struct error *err);
enum source_result source_stl_read(const char *path, struct source *source, struct error *err);
enum source_result source_gltf_read(const char *path, struct source *source, struct error *err);

/* Sets model->source_points, and model->source_motion where the file has animations that are read, of a model that was
 * imported from `path`, or model->has_no_source, unless they are set; *known: whether there is a reader for the format.
 * An error says where the two readers disagree: on how many faces there are, on a face's corners, or on where one is,
 * by more than rounding. Whoever cuts faces asks for it before. */
bool source_find(const char *path, struct model *model, bool *known, struct error *err);

/* The same; where there is no reader for the format, model->notice says that the reference has the importer's points.
 */
bool source_take(const char *path, struct model *model, struct error *err);

/* The model as the reference is to see it: the same arrays, other points. Not to be freed. */
struct model source_view(const struct model *model);

#endif
