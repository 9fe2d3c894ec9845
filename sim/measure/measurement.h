/* SPDX-License-Identifier: MIT
 *
 * What a renderer gets wrong and what it costs, measured: accuracy against the source model in double
 * precision, instructions counted on emulated processors. `limner measure` prints both; the compiler
 * can ask for either. */
#ifndef SIM_MEASUREMENT_H
#define SIM_MEASUREMENT_H

#include "accuracy/compare.h"
#include "accuracy/unsettled.h"
#include "base/map.h"
#include "cameras/camera_path.h"
#include "compiler/compile.h"
#include "measure/measure_refusals.h"
#include "render/simulator.h"
#include "scene/compiled.h"

/* -- Accuracy --------------------------------------------------------------------------------- */

/* A model as accuracy is measured against it. */
struct measure_source {
    struct reference reference; /* of the model's own faces */
    struct mesh mesh;           /* what compile_mesh() takes; mesh.merged_into: faces that count as one */
    struct mesh fine;           /* what the reference was made of, whose mappings it names; empty if something moves */
    struct map points;          /* grid position -> first point of the mesh there */
    uint32_t *next_point;       /* of the mesh, at the same grid position; or MEASURE_NO_POINT */
    struct compiled still;      /* if something moves: still.moving; the mesh is of what does not */
    char *path;                 /* of the model */
};

#define MEASURE_NO_POINT UINT32_MAX

/* Reads a model as `limner compile` does, for pictures of w_px x h_px. */
bool measure_source_read(struct measure_source *source, const char *model_path, const struct compile_options *options,
                         unsigned w_px, unsigned h_px, struct error *err);

/* Where a vertex of a scene of this mesh was in the model, metres; false for one that splitting made. */
bool measure_source_point(const struct measure_source *source, const struct lim_scene *scene, lim_index vertex,
                          double out_m[3]);

/* The model's scene with these options, and with all that moves in it. */
bool measure_source_compile(const struct measure_source *source, const struct compile_options *options,
                            struct compiled *scene, struct error *err);

void measure_source_free(struct measure_source *source);

/* Changed pixels of slow moves, and those of them that were soon as before (shimmer.h). */
struct shimmer_count {
    size_t changed, back;
};
struct shimmer {
    bool known; /* there was time */
    struct shimmer_count turn, walk;
};

struct accuracy {
    struct comparison pixels;
    struct shimmer shimmer; /* not by measure_accuracy() */
    /* Vertices of polygons that are seen, once a frame, unless clipped or made by splitting: how far the
     * renderer's point is from the double projection of the model's. */
    size_t vertices, vertices_without_source;
    double vertex_sum2_px, vertex_max_px;
    /* Every node's plane from every eye: decisions, and those that 128-bit arithmetic contradicts. */
    size_t sides, sides_wrong;
    /* Pixels of textured faces: how far the texel shown is from the true one, mean and 99 of 100, texels of the level
     * of detail shown; the mean in texels of the whole picture; divisions a frame, for the perspective. */
    size_t textures_b; /* of the scene: texture_memory_b() */
    size_t texel_pixels;
    double texel_mean, texel_p99, texel_mean_finest, divisions;
    /* By any method: root of the mean square, % of pixels whose texel is neither the true one nor next to it, and of
     * those at another level of detail than the nearest; of trees, the share of the squares that is the straight
     * pieces',
     * %, else NaN. */
    size_t texels_painted;
    double texel_rms, texel_far_percent, texel_level_percent, texel_straight_percent;
    /* Of methods that sort: polygons split in all frames, and pairs whose order could not be settled. */
    size_t splits;
    struct unsettled unsettled;
};

double accuracy_vertex_rms_px(const struct accuracy *accuracy);

/* Where a scene's pictures are drawn: what its firmware paints into. */
static inline enum simulator_panel measure_panel(const struct compiled *scene)
{
    return scene->report.framebuffer ? SIMULATOR_FRAMEBUFFER : SIMULATOR_MEMORY;
}

/* What is drawn, from where. */
struct measure_views {
    const struct camera_path *path;
    const struct lens *lens;
    unsigned w_px, h_px;
    const char *optimise; /* what the code that is counted is for, as --optimise has it; NULL: speed */
};

/* A renderer and the scene compiled for it (profile exact wants vertices with fractions). */
struct measure_candidate {
    const struct core *core;
    const struct compiled *scene;
};

enum { MEASURE_PROFILES = LIM_PROFILE_EXACT + 1 };

/* A model's scene for each profile; what nobody asks for stays empty. One may be refused and another not: with
 * fractions, corners are rounded less. */
struct measure_scenes {
    struct compiled of[MEASURE_PROFILES];   /* by profile */
    struct error refused[MEASURE_PROFILES]; /* why; empty: not refused so far */
};

/* The scene that a renderer wants: what `limner compile` makes for its profile. Compiled when first asked for; what was
 * refused is not tried again. */
bool measure_scene_for(struct measure_scenes *scenes, const struct measure_source *source, const struct core *core,
                       const struct compile_options *options, const struct compiled **out, struct error *err);

/* Gives the candidates, whose renderers are named and of which there are *count, their scenes. Those that are refused
 * (and added to `refused`), or take more than half of the time that the first scene leaves, go from the list; one at
 * least stays, or it is an error that names the model. */
bool measure_compile(struct measure_scenes *scenes, const struct measure_source *source,
                     const struct compile_options *options, struct measure_candidate *candidates, size_t *count,
                     struct measure_refusals *refused, struct error *err);

void measure_scenes_free(struct measure_scenes *scenes);

/* Draws all frames with all candidates, and each once with the reference. Shows progress. When time is over
 * (deadline.h) the frames so far count, one at least: out[].pixels.frames. */
bool measure_accuracy(struct measure_source *source, const struct measure_views *views,
                      const struct measure_candidate *candidates, size_t count, struct accuracy *out,
                      struct error *err);

/* -- Cost ------------------------------------------------------------------------------------- */

enum { COST_STAGES_MAX = 64, COST_NAME_B = 24 };

/* A processor that cost can be measured on. */
struct measure_cpu {
    const char *name;  /* as sim/targets/targets.sh has it, and --core */
    const char *title; /* for people */
    /* What it takes, and the Debian packages that have it. */
    const char *compiler, *compiler_package, *emulator, *emulator_package;
};

extern const struct measure_cpu measure_cpus[];
extern const size_t measure_cpu_count;

const struct measure_cpu *measure_cpu_find(const char *name);

/* --core NAME */
bool measure_cpu_parse(const char *name, const struct measure_cpu **out, struct error *err);

/* Refuses, naming the Debian package, when a tool for the processor is not there. */
bool measure_cpu_check(const struct measure_cpu *cpu, struct error *err);

/* Whether the sources and the build are where they were, which counting on any processor takes. */
bool measure_sources_check(struct error *err);

/* Of --optimise: sim/targets/count.sh has the flags. */
bool measure_optimise_check(const char *name, struct error *err);

/* One source file of firmware/, with what the compiler's support library does for it. */
struct cost_stage {
    char name[COST_NAME_B];
    double mean, library; /* instructions a frame; library is a part of mean */
    uint64_t worst;       /* of any frame */
};

struct cost {
    size_t frames, worst_frame;
    double mean; /* instructions of lim_frame() a frame, without the target's functions */
    uint64_t worst;
    struct cost_stage stages[COST_STAGES_MAX]; /* by name */
    size_t stage_count;
    double vertex;                     /* instructions to transform and project a vertex; NaN: none was */
    double side;                       /* of an average plane test; NaN: there was none */
    size_t state_b, pools_b, static_b; /* RAM: struct lim, lim_init()'s memory, the renderer's variables */
    size_t code_b, library_b, scene_b; /* flash: the renderer with its tables, support library, scene */
};

size_t cost_ram_b(const struct cost *cost);
size_t cost_flash_b(const struct cost *cost); /* without the scene */

/* Builds the renderer for the candidate and the processor (sim/targets), runs all frames on the emulated
 * processor, and counts. The frames must be those that the host draws, and a loop of known length must
 * count as it should: else false. `folder` is an empty one for the files of the way. */
bool measure_cost(const struct measure_candidate *candidate, const struct measure_cpu *cpu,
                  const struct measure_views *views, const char *folder, struct cost *out, struct error *err);

#endif
