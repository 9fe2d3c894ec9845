/* SPDX-License-Identifier: MIT
 *
 * One scene, drawn with every visibility method that can: what each gets wrong and costs. */
#ifndef SIM_COMPARE_METHODS_H
#define SIM_COMPARE_METHODS_H

#include "compiler/compile.h"
#include "measure/compare_table.h"

/* Compiles the scene for every method; table->rows must be zero. What a method cannot draw is in its row; false only
 * if none can. */
bool compare_methods_compile(const struct measure_source *source, const struct compile_options *options,
                             struct compare_table *table, struct error *err);

/* Draws all frames with all methods; what these get wrong, into the rows. */
bool compare_methods_accuracy(struct measure_source *source, const struct measure_views *views,
                              struct compare_table *table, struct error *err);

/* Counts the instructions of these frames on every processor whose tools are there; the table says of the others
 * why not. `folder` is an empty one for the files of the way. */
void compare_methods_cost(const struct measure_views *views, const char *folder, struct compare_table *table);

#endif
