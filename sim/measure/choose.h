/* SPDX-License-Identifier: MIT
 *
 * The cheapest renderer that is right enough: every profile measured on a model, the bound
 * applied, the cost compared. */
#ifndef SIM_CHOOSE_H
#define SIM_CHOOSE_H

#include "cameras/camera_choice.h"
#include "compiler/compile.h"
#include "measure/measure_refusals.h"
#include "measure/measurement.h"

#include <stdio.h>

/* What must hold, on which cameras, and whose cost counts. */
struct choice_bound {
    double wrong_percent;          /* of pixels that show another polygon than the model; below 0: any */
    double vertex_px;              /* largest error of a vertex on the screen; below 0: any */
    struct camera_choice cameras;  /* not given: CHOICE_SAMPLES ones sampled in the scene's free space */
    const struct measure_cpu *cpu; /* counted on it; NULL: fewer bits are cheaper */
};

enum { CHOICE_SAMPLES = 24, CHOICE_CORES_MAX = 32 };

struct choice_row {
    const struct core *core;
    struct accuracy accuracy;
    double instructions; /* a frame, mean; NaN: not counted */
    bool meets;
};

struct choice {
    struct choice_row rows[CHOICE_CORES_MAX]; /* cheapest first as far as bits tell */
    size_t count;
    struct measure_refusals refused; /* those without a scene, which are not among the rows */
    const struct core *core;         /* the one chosen */
    size_t frames;
};

/* `options` has the size of the panel; the bound's cameras, if a file has them, become its eyes. Fails when no renderer
 * meets the bound, saying which is nearest, and when the model has no scene for any. */
bool choose_core(const char *model_path, struct compile_options *options, const struct choice_bound *bound,
                 struct choice *out, struct error *err);

/* The evidence: a line a renderer, and one for each reason by which some are refused. */
void choice_print(const struct choice *choice, const struct choice_bound *bound, FILE *out);

#endif
