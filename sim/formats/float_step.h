/* SPDX-License-Identifier: MIT
 *
 * Formats that hold vertices as float32 are coarse far from the origin; people are to know how coarse. */
#ifndef SIM_FLOAT_STEP_H
#define SIM_FLOAT_STEP_H

#include "model/model.h"

/* From a magnitude to the next larger float32. */
double float_step_at(double magnitude);

/* step_m: the largest step among vertices that came as float32. If that is more than 1/16 of what the scene's longest
 * side gives as its grid's unit, below which points are one (grid_weld_m()), model->notice says so, in metres. */
void float_step_note(struct model *model, double step_m);

#endif
