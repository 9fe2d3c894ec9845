/* SPDX-License-Identifier: MIT
 *
 * The command line of `limner render` and `limner view`, and what all commands that read models take. */
#ifndef SIM_OPTIONS_H
#define SIM_OPTIONS_H

#include "base/arguments.h"
#include "cameras/camera_choice.h"
#include "compiler/compile.h"
#include "compiler/moving_compile.h"
#include "displays/idle_options.h"
#include "render/simulator.h"
#include "scene/moving.h"
#include "target.h"

struct options {
    const char *scene_path; /* a model, or a compiled scene in a .lim file */
    struct camera_choice cameras;
    size_t orbit_frames; /* without cameras; fewer or more where something moves, unless frames says how many */
    struct simulator_ram ram;
    size_t frames; /* how many are drawn; 0: not said */
    struct simulator_setup setup;
    struct panel_choice panel;    /* for SIMULATOR_PANEL */
    enum panel_rotation rotation; /* of the picture on the glass that --size is of */
    struct compile_options compile;
    struct lim_wireframe wireframe;
    uint16_t delta_runs; /* 0: every frame is sent whole */
    /* limner render only; NULL or false: not asked for */
    const char *frame_pattern, *gif_path, *sheet_path, *ids_path, *check_path, *hashes_path, *cameras_path;
    const char *overlay_text; /* over each frame */
    bool stats, compare, brief;
    struct lim_newell_options newell;
    struct moving_options movers;
    double frames_per_s;      /* of what moves */
    bool has_rate;            /* it was said */
    struct idle_options idle; /* given ones, that may change nothing */
};

enum options_set { OPTIONS_RENDER, OPTIONS_VIEW };

/* Fills in the defaults too. The strings stay argv's. */
bool options_parse(int argc, char **argv, enum options_set set, struct options *out, struct error *err);

/* What is drawn otherwise for such a panel, unless the command line said how: light, tones and outlines. */
void options_settle_panel(struct options *options, const struct panel_choice *panel);

/* Reads or plans the cameras and reads the scene: a .lim file as it is, anything else compiled as `limner compile` does
 * it, and sets setup.method to what that chose. Options that change nothing for that scene are told. `moving`: NULL,
 * nothing moves. *scene, *moving and *path must be zero and are the caller's to free, also after a failure. */
bool options_load(struct options *options, struct compiled *scene, struct moving *moving, struct lens *lens,
                  struct camera_path *path, struct error *err);

/* Whether frames go to one file, whose name has no place for a number. */
bool options_one_file(const struct options *options);

/* Whether the frames show all of what moves, as often as it takes, and end where they began: an orbit's do, unless both
 * how many they are and how many a second was said. */
bool options_loop(const struct options *options, const struct moving *moving);

/* How many frames of count are shown a second. */
double options_rate(const struct options *options, const struct moving *moving, size_t count);

/* Says so, if the method moves nothing of a model that could move. */
void options_note_stopped(const struct options *options, const struct moving *moving);

/* What a value of an option is to the file system. */
enum option_files { OPTION_NAMES_NONE, OPTION_READS_CAMERAS, OPTION_NAMES_FILE };

struct given_option {
    const char *name;  /* without dashes; "o" for -o */
    const char *value; /* NULL: none */
    enum option_files files;
};

/* The options of a command line of render as they were given, values unread, and the scene, or NULL. The caller frees
 * *given; strings stay argv's. */
bool options_split(int argc, char **argv, struct given_option **given, size_t *count, const char **scene,
                   struct error *err);

bool options_scene_is_compiled(const struct options *options);

/* Options that mean the same to all commands which read models: --trust-paths, --no-textures, --textures, --sky,
 * --texture-budget,
 * --doors. They are taken out of a command line and hold for the process. An error: a value is missing or is none. */
bool model_options_take(struct arguments *arguments, struct error *err);

struct model_option {
    const char *name;  /* without dashes */
    const char *value; /* NULL: it has none */
};

enum { MODEL_OPTIONS_MAX = 5 };
struct model_options {
    struct model_option items[MODEL_OPTIONS_MAX];
    size_t count;
};

/* Those that the last command line had, but for --trust-paths. Values stay argv's. */
const struct model_options *model_options_given(void);

/* Whether a word, `--NAME` or `--NAME=VALUE`, is one of these, other than --trust-paths. */
bool model_options_knows(const char *word);

#endif
