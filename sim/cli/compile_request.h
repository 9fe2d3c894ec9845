/* SPDX-License-Identifier: MIT
 *
 * What compiling commands have in common: the options, and the models that become scenes. */
#ifndef SIM_COMPILE_REQUEST_H
#define SIM_COMPILE_REQUEST_H

#include "base/c_name.h"
#include "compiler/compile_options.h"
#include "compiler/moving_compile.h"
#include "displays/idle_options.h"
#include "displays/module_choice.h"
#include "measure/choose.h"
#include "scene/scene_files.h"

struct compile_request {
    const char *command; /* for errors */
    char **models;       /* what to compile */
    size_t model_count;
    const char *name; /* the path to write to, without suffix */
    struct compile_options compile;
    struct panel_choice panel; /* of --panel; without a family: not said */
    struct choice_bound bound; /* of --max-error and its like */
    struct moving_options movers;
    struct idle_options idle; /* given ones, that may change nothing */
    bool report;              /* tell all that there is to say, not only the summary */
    bool has_lim;             /* NAME.lim is written as well */
};

/* What becomes of the models, one to one. */
struct compile_result {
    struct compiled *scenes;
    struct moving *moving;
    struct named_scene *named;
    char (*names)[C_PATH_MAX_B];
    size_t count; /* so far */
};

/* Reads the options of `limner compile`, -o among them; what is left are models. argv[0] is the command. */
bool compile_request_parse(int argc, char **argv, struct compile_request *out, struct error *err);

/* Chooses a precision if a bound asks for one, and compiles all models. compile_result_free() in any case. */
bool compile_request_run(struct compile_request *request, struct compile_result *out, struct error *err);

/* What the options did not change, and what the scenes cost: a summary, or with --report all. */
void compile_result_report(const struct compile_request *request, const struct compile_result *result);

void compile_result_free(struct compile_result *result);

#endif
