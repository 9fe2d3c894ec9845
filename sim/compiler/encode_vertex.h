/* SPDX-License-Identifier: MIT
 *
 * The vertex table of a scene: each point of the grid once, in the order in which records come to it. */
#ifndef SIM_ENCODE_VERTEX_H
#define SIM_ENCODE_VERTEX_H

#include "base/map.h"
#include "scene/encoding.h"
#include "trees/exact.h"

struct vertex_encoder {
    struct encoding *out;
    bool with_fractions; /* of units; else points lie on the grid */
    struct map slices;   /* x -> number */
    struct map columns;  /* slice's number and y -> number */
    struct map indices;  /* column's number and z -> index */
};

/* The index of a point, entered if new. */
uint32_t vertex_encode(struct vertex_encoder *encoder, struct grid_point point);

/* Enters a point that another encoder of the same scene has, unless it is known already. */
void vertex_encode_known(struct vertex_encoder *encoder, struct grid_point point, uint32_t index);

/* The same point once more, for a record that has another place in its texture there. Nobody finds it by its point. */
uint32_t vertex_encode_again(struct vertex_encoder *encoder, struct grid_point point);

void vertex_encoder_free(struct vertex_encoder *encoder);

#endif
