/* SPDX-License-Identifier: MIT
 *
 * Random closed solids for the mesh stages. */
#ifndef TESTS_TINY_SCENES_H
#define TESTS_TINY_SCENES_H

#include "model/model.h"
#include "random.h"

/* A box, turned by a random angle about two axes, each side cut at random into rectangles that meet
 * in T-junctions. Starts from a zeroed model. */
void tiny_tiled_box(struct model *model, struct random *random);

#endif
