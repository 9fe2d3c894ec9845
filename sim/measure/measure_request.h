/* SPDX-License-Identifier: MIT
 *
 * The command lines of `limner measure`, `compare`, `worst` and `report`. */
#ifndef SIM_MEASURE_REQUEST_H
#define SIM_MEASURE_REQUEST_H

#include "cameras/camera_choice.h"
#include "compiler/compile.h"
#include "core/core.h"
#include "measure/measurement.h"
#include "measure/sub_bits.h"
#include "measure/worst_views.h"

enum { MEASURE_CORES_MAX = 32, MEASURE_REQUEST_CPUS_MAX = 8, MEASURE_NAME_B = 128, MEASURE_ORBIT_FRAMES = 16 };

/* Precisions of one method; or methods, in one precision; or of one scene the worst views, or all that is known. */
enum measure_of { MEASURE_PRECISIONS, MEASURE_METHODS, MEASURE_WORST, MEASURE_PAGE };

/* gnuplot's script. */
#define MEASURE_PLOT LIM_SOURCE_FOLDER "/sim/tools/measure.gp"

struct measure_request {
    enum measure_of of;
    const char *model;
    const char *folder; /* -o; of `worst` the beginning of paths, of `report` a file. NULL: not given */
    const char *result; /* --result: a file for `limner sweep`; NULL: not given */
    struct worst_options worst;
    struct camera_choice cameras;
    bool sub_bits;             /* with the usual variants */
    char name[MEASURE_NAME_B]; /* the model's, without folder and suffix */
    unsigned w_px, h_px;
    struct compile_options compile;
    const struct core *cores[MEASURE_CORES_MAX];
    char variants[MEASURE_CORES_MAX][SUB_BITS_NAME_B]; /* with other sub-pixel bits, to be loaded: they come behind */
    const struct measure_cpu *cpus[MEASURE_REQUEST_CPUS_MAX];
    size_t core_count, variant_count;
    const char *optimise;       /* as measure_views has it */
    size_t cpu_count;           /* 0: accuracy only */
    bool is_cost_asked;         /* by --core or --optimise: tools that are missing are an error */
    bool no_plot;               /* as its tool is not there */
    size_t frames, cost_frames; /* MEASURE_METHODS: how many of the cameras, and of these for instructions */
};

/* Fills in the defaults too: every profile on every processor; for methods, profile fast on m0plus and m4; for one
 * scene profile fast, and no processor. The strings stay argv's. */
bool measure_request_parse(int argc, char **argv, enum measure_of of, struct measure_request *out, struct error *err);

/* Puts the options of a command line in front of its other words, of which the first is argv[*words_from]. An error: an
 * option is unknown to `limner measure`, or its value missing. */
bool measure_request_order(int argc, char **argv, int *words_from, struct error *err);

/* Reads the camera file, if there is one, and the model, which is compiled for these cameras. All three must be zero
 * and are the caller's to free, also after a failure. */
bool measure_request_load(struct measure_request *request, struct measure_source *source, struct lens *lens,
                          struct camera_path *path, struct error *err);

/* As many cameras of the file, or of those planned for the scene, as are wanted; *path is what was loaded. */
bool measure_request_cameras(const struct measure_request *request, const struct compiled *scene,
                             const struct lens *lens, struct camera_path *path, struct error *err);

/* Whether all the tools that it takes are there. */
bool measure_request_check(const struct measure_request *request, struct error *err);

/* Compiles and loads the variants, which become cores behind the others; the folder is for files of that. */
bool measure_request_load_variants(struct measure_request *request, const char *folder, struct error *err);

#endif
