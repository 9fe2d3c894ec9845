/* SPDX-License-Identifier: MIT */
#include "formats/float_step.h"

#include "model/extent.h"

#include <float.h>
#include <math.h>

static const double GRID_SPAN_UNITS = 65534, PARTS_OF_A_UNIT = 16;

double float_step_at(double magnitude)
{
    const int least = FLT_MIN_EXP - 1;
    const int exponent = magnitude > 0 ? ilogb(magnitude) : least;
    return ldexp(1, (exponent > least ? exponent : least) - (FLT_MANT_DIG - 1));
}

void float_step_note(struct model *model, double step_m)
{
    const double unit_m = extent_longest_side(model->points, model->corners, model->corner_count) / GRID_SPAN_UNITS;
    if (!(step_m * PARTS_OF_A_UNIT > unit_m)) return;
    model_note(model,
               "its vertices come as float32 numbers, which are %.3g m apart as far out as they are: more than 1/16 of "
               "the grid's unit of %.3g m",
               step_m, unit_m);
}
