/* SPDX-License-Identifier: MIT
 *
 * A model that a reader of our own fills: vertices first, then faces of them. It grows, and keeps the limits and the
 * words of errors that the importer's models have. Colours become final at the end, when all of them are known. */
#ifndef SIM_MODEL_BUILD_H
#define SIM_MODEL_BUILD_H

#include "files/masked_picture.h"
#include "model/mean_colour.h"
#include "model/model.h"

struct build_colour {
    float rgba[4], spread; /* as the file has them: in parts of model_build.full_colour */
    bool is_set;
};

struct model_build {
    const char *path;
    struct model *model;
    struct error *err;
    size_t vertex_first, vertex_count; /* of model.points: what indices of corners count */
    struct build_colour *colours;      /* of each face */
    double full_colour;                /* 1 at first; 255 where colours are whole numbers */
    double step_m;                     /* between float32 numbers that vertices came as, the largest */
    size_t point_capacity, uv_capacity, corner_capacity, face_capacity, colour_capacity, picture_capacity;
    size_t first_corner; /* of the face that is being read */
    size_t lines;        /* and points, which are not drawn */
    double (*uvs)[2];    /* of each point; NaN: none */
};

/* What a face looks like, but for its corners. An opacity of NaN: nothing is said of it. */
struct build_look {
    struct mean_colour colour; /* empty: the default */
    uint32_t picture;          /* 1-based; 0: none */
    bool two_sided;
};

/* Indices of corners count from the next vertex on. */
void build_vertices_begin(struct model_build *build);

/* As many vertices as it takes to refuse the file. is_float32: that is how the file has it. */
bool build_vertex(struct model_build *build, const double at_m[3], bool is_float32);

/* Of the vertex that was added last: across from the left and down from the top. */
void build_vertex_uv(struct model_build *build, const double uv[2]);

/* A corner of the face being read, by its vertex's index. NULL: what the vertex has. */
bool build_corner(struct model_build *build, double index, const double uv[2]);

/* Ends a face; with fewer than three corners it is none, but a line or a point. */
bool build_face(struct model_build *build, const struct build_look *look);

/* Pictures, as faces number them: of a file beside the model, or of bytes in it. */
uint32_t build_picture_file(struct model_build *build, const char *name);
uint32_t build_picture_bytes(struct model_build *build, const char *name, void *bytes, size_t size_b);

typedef bool model_builder(struct model_build *build);

/* Reads a file by a reader; the model is complete, or empty. */
bool model_build_from(const char *path, model_builder *read, struct model *model, struct error *err);

#endif
