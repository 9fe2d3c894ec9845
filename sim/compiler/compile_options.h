/* SPDX-License-Identifier: MIT
 *
 * How a model is to be compiled. */
#ifndef SIM_COMPILE_OPTIONS_H
#define SIM_COMPILE_OPTIONS_H

#include "base/error.h"
#include "cameras/camera_choice.h"
#include "model/model_orientation.h"
#include "scene/method.h"
#include "scene/tree_kind.h"

struct core;
struct model;

/* When to try what other trees cost (tree_choice.h); where none is tried it is the BSP tree. */
enum tree_trial { TRIAL_NEVER, TRIAL_IF_SPLIT, TRIAL_ALWAYS };

/* Which dense parts become leaves whose order is by distance (mesh_leaf_choice.h). AUTO: those that pay. */
enum mesh_leaves { MESH_LEAVES_AUTO, MESH_LEAVES_NONE, MESH_LEAVES_ALL };

extern const char *const mesh_leaves_names[MESH_LEAVES_ALL + 2]; /* and NULL */

enum portals_wanted { PORTALS_OFF, PORTALS_AUTO, PORTALS_ON };

/* How many bits coordinates have: AUTO takes 32 where 16 would not keep what faithful.h promises. */
enum coordinates { COORDINATES_AUTO, COORDINATES_16, COORDINATES_32 };

struct compile_options {
    double tolerance_units;      /* a polygon this near to a plane lies on it; 0.5 by default, 0 = exact; in 1/256 unit
                                    where the grid has fractions */
    const struct method *method; /* how it is to be drawn; NULL: convex for one convex solid, else nearest first */
    bool choose_order;           /* where that is NULL: or by scan lines, or as a mesh, if that is cheaper */
    double wrong_percent;        /* most of pixels that a mesh without a tree may have wrong; 0: its profile's */
    enum tree_kind tree;         /* TREE_AUTO by default */
    enum tree_trial trial;       /* of other trees, where it is TREE_AUTO */
    enum mesh_leaves mesh_leaves;
    bool leaves_open; /* AUTO chooses although method and tree are named: the compiler named them */
    bool whole_leaf;  /* of what moves: a mesh leaf of all its polygons, or none */
    enum coordinates coordinates;
    const char *splitter;           /* heuristic of the tree builder: splitter.h's names */
    bool keep_faces;                /* do not merge: every face keeps its own number in --ids */
    const struct core *core;        /* precision profile of the prediction and of NAME.h; NULL: fast */
    unsigned w_px, h_px;            /* the panel that pool sizes are measured for; 0: 240 */
    struct orientation orientation; /* of the model's file */
    uint16_t background;            /* RGB565 as a number */
    bool unlit;                     /* colours stay as they are in the model: no light is baked in */
    bool mono;                      /* tones and light are those for black and white pixels; unlit: nothing changes */
    bool antialias;                 /* for drawing with antialiased edges: pools are measured so */
    bool delta;                     /* for sending what changes alone: its memory is measured */
    bool overlay;                   /* for drawing over frames */
    bool round;                     /* for round glass, too */
    bool fill;                      /* for targets that keep the whole picture in pixels of their own */
    bool framebuffer;               /* for targets with all pixels in memory: polygons are painted there */
    bool framebuffer_by_lines;      /* or lines are copied there, where polygons cannot be painted */
    bool wireframe;                 /* for drawing as wireframe: edges that are not the model's are known */
    enum portals_wanted portals;    /* whether to store what is seen from where; AUTO: if it pays */
    double fov_deg;                 /* the narrowest of these cameras, from top to bottom; 0: lens_usual_fov_deg() */
    double near_m;                  /* of the cameras that it is for; 0: lens_default_near_m() */
    double forced_near_m;    /* of what moves: how near the scene's cameras may have their near plane, if no nearer */
    bool drop_small;         /* leave out what is too small for the grid, instead of refusing the model */
    struct camera_path path; /* cameras that it is chosen for, compile_options_free()'s; empty: sampled ones */
    struct camera_path eyes; /* cameras that must see it, compile_options_free()'s; empty: they are not known */
    size_t worst_tries;      /* cameras to search the worst views among, for pools that hold them; 0: none */
    bool predict;            /* measure the wrong-pixel share for the report: takes a second or so */
};

/* Rows of a table for getopt_long(), and the codes that it returns for them. All commands that compile models have the
 * first ones, those that may choose a tree the others, too. */
#define COMPILE_MODEL_OPTIONS                                                                                          \
    {"near", required_argument, NULL, COMPILE_NEAR}, {"coordinates", required_argument, NULL, COMPILE_COORDINATES},    \
        {"unlit", no_argument, NULL, COMPILE_UNLIT}, {"drop-small", no_argument, NULL, COMPILE_DROP_SMALL},            \
        ORIENTATION_OPTIONS
#define COMPILE_TREE_OPTIONS                                                                                           \
    {"tree", required_argument, NULL, COMPILE_TREE}, {"splitter", required_argument, NULL, COMPILE_SPLITTER},          \
        {"mesh-leaves", required_argument, NULL, COMPILE_MESH_LEAVES},                                                 \
        {"portals", required_argument, NULL, COMPILE_PORTALS}, {"path", required_argument, NULL, COMPILE_PATH},        \
    {                                                                                                                  \
        "fov", required_argument, NULL, COMPILE_FOV                                                                    \
    }
enum compile_code {
    COMPILE_NEAR = ORIENTATION_TWO_SIDED + 1,
    COMPILE_COORDINATES,
    COMPILE_UNLIT,
    COMPILE_DROP_SMALL,
    COMPILE_TREE,
    COMPILE_SPLITTER,
    COMPILE_MESH_LEAVES,
    COMPILE_PORTALS,
    COMPILE_PATH,
    COMPILE_FOV,
    COMPILE_CODES_END
};

/* Those of a command line that says nothing, for all commands alike: what they choose is the same (decision.h). */
struct compile_options compile_options_usual(void);

/* Whether a code is one of these. */
bool compile_options_know(int code);

/* Sets what it is the code of. text: the option's value, or NULL; that of --splitter stays the caller's. --path reads a
 * camera file, or a map's cameras. */
bool compile_options_take(int code, const char *text, struct compile_options *out, struct error *err);

/* Whether scenes may have mesh leaves: not where the order is promised, or by methods that do not walk a tree, as
 * wireframe, into a framebuffer, or beside portals. */
bool compile_options_may_leaf(const struct compile_options *options);

/* The coordinates that a model's scene may have: what is not drawn by a method that walks a tree of all polygons cannot
 * be long (firmware/long.h), and has 16 bits. Refuses it where 32 were asked for. */
bool compile_options_coordinates(const struct compile_options *options, enum coordinates *out, struct error *err);

/* camera_choice_read(), of cameras for a model that is taken so. Those of a file become the options' eyes. */
bool compile_options_cameras(struct compile_options *options, const struct camera_choice *choice,
                             struct camera_path *out, struct error *err);

/* Whether a scene may have 32 where it needs them. */
bool compile_options_may_be_long(const struct compile_options *options);
/* --portals: off, auto or on; anything else is refused. */
bool portals_parse(const char *text, enum portals_wanted *out, struct error *err);

/* What options own: after the scenes, which may lead into it, whether they were parsed or not. */
void compile_options_free(struct compile_options *options);

/* --method: names how to draw and, for some methods, the tree. */
bool compile_method_parse(const char *text, struct compile_options *out, struct error *err);

/* The method that is named; else what draws such a tree. */
enum lim_method compile_options_draws(const struct compile_options *options);

/* The light that is baked into the model, and what goes with it. */
void compile_options_light(const struct compile_options *options, struct model *model);

/* When all options are known: the method's tree, if none is asked for. An error if the two do not go together. */
bool compile_options_settle(struct compile_options *options, struct error *err);

#endif
