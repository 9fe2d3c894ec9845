/* SPDX-License-Identifier: MIT
 *
 * How far pictures are from the true one where a pixel holds an edge. The true one is the reference's, in double
 * precision, 256 rays a pixel on a lattice of 16 x 16: other samples than the renderer's 16, which are rounded, too.
 * In: the same frame as the renderer draws it with antialiasing and without. Flat colours, as baked. */
#ifndef SIM_EDGE_ERROR_H
#define SIM_EDGE_ERROR_H

#include "accuracy/reference.h"
#include "render/simulator.h"
#include "scene/compiled.h"

enum { EDGE_ERROR_PICTURES = 2, EDGE_ERROR_LATTICE = 16 };
/* The last: the true picture, rounded to what the panel can show. */
enum edge_error_picture { EDGE_ERROR_ALIASED, EDGE_ERROR_SMOOTH, EDGE_ERROR_ROUNDED, EDGE_ERRORS };

/* Sums of frames. Errors are of the panel's values, widened to 0..255, per channel. */
struct edge_error_sum {
    size_t pixels; /* whose rays end at more than one colour */
    double error[EDGE_ERRORS];
};

struct edge_error {
    struct simulator pictures[EDGE_ERROR_PICTURES];
    struct lim_scene scene; /* without textures, all opaque: what the reference knows */
    lim_index *polygons;
    uint16_t *colour_of_face; /* face numbers below face_count; 0 is the background */
    size_t face_count;
    uint16_t *first; /* a pixel each: the colour of its first ray */
    bool *is_edge;
    double (*sums)[3];
};

/* `scene` has its face numbers; it and *out must stay where they are. */
bool edge_error_init(struct edge_error *out, const struct compiled *scene, const struct simulator_setup *setup,
                     struct error *err);

/* A frame: `camera` is the viewpoint's. `reference` is of the setup's size; what it has drawn is drawn over. */
bool edge_error_frame(struct edge_error *error, struct reference *reference, const struct viewpoint *viewpoint,
                      const struct lens *lens, const struct lim_camera *camera, struct edge_error_sum *sum,
                      struct error *err);

/* Mean absolute error, in levels of 256. */
double edge_error_mean(const struct edge_error_sum *sum, enum edge_error_picture picture);

void edge_error_free(struct edge_error *error);

#endif
