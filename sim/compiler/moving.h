/* SPDX-License-Identifier: MIT
 *
 * A model with moving objects: what stands still is one compiled scene, each object another, on the same grid or one
 * that is finer by a power of two; and the table of each object's motion. */
#ifndef SIM_MOVING_H
#define SIM_MOVING_H

#include "scene/compiled.h"

struct reference;

struct moving_object {
    char name[MODEL_NAME_B];
    struct compiled scene; /* its faces have the model's numbers */
    struct lim_motion motion;
    struct lim_motion_key *keys;
};

struct moving {
    struct model model;             /* as it was read: movers and keys */
    struct moving_object *objects;  /* one a mover of the model */
    struct lim_instance *instances; /* likewise */
    size_t count;                   /* 0: nothing moves */
    size_t stopped;                 /* movers of the file that MOVING_OFF made a part of the scene */
    struct lim_light light;         /* on: objects have none baked in */
    struct lim_movers_limits limits;
};

/* How movers enter the walk: --movers. MOVING_OFF: they stay where the file has them, a part of the scene. */
enum moving_mode { MOVING_CLIPPED, MOVING_BY_CENTRE, MOVING_OFF };

bool moving_mode_parse(const char *text, enum moving_mode *out, struct error *err);

/* What `limner` has to be told of movers. */
struct moving_options {
    enum moving_mode mode;
    bool light; /* in each frame; else it is baked into them where the file has them */
};

/* --mover-light baked or turning. */
bool moving_light_parse(const char *text, bool *out, struct error *err);

/* Model file -> compiled scene and objects. Refuses objects that do not fit the scene's grid, and models in which
 * nothing stands still. Both are the caller's to free, also after a failure. */
bool moving_compile(const char *path, const struct compile_options *options, const struct moving_options *movers,
                    struct compiled *scene, struct moving *moving, struct error *err);

/* The same of a model, which becomes *moving's. */
bool moving_compile_model(const struct model *model, const struct compile_options *options,
                          const struct moving_options *movers, struct compiled *scene, struct moving *moving,
                          struct error *err);

/* moving_compile() into scene->moving, which stays NULL if nothing moves; *scene must be zero. */
bool moving_compile_own(const char *path, const struct compile_options *options, enum moving_mode mode,
                        struct compiled *scene, struct error *err);

/* Which faces of the model count as one once coplanar neighbours are merged, as mesh.merged_into; the caller's. */
bool moving_groups(const struct moving *moving, uint32_t **groups, struct error *err);

/* The time of the last keys. */
double moving_length_s(const struct moving *moving);

/* When frame i of count is drawn that are spread over the whole animation; firmware counts milliseconds. */
double moving_time_s(const struct moving *moving, size_t frame, size_t count);

/* Places all instances as firmware would. */
void moving_pose(struct moving *moving, double time_s);

/* simulator_set_movers() with what moves in the scene, if anything does. */
struct simulator;
bool simulator_add_movers(struct simulator *simulator, const struct compiled *scene, struct error *err);

/* The reference of such a model; and where everything is at a time, in double precision. */
bool moving_reference(const struct moving *moving, struct reference *reference, unsigned w_px, unsigned h_px,
                      struct error *err);
void moving_pose_reference(const struct moving *moving, struct reference *reference, double time_s);

/* What the objects cost, beside the scene's report. `name`: that of the files; NULL: none are written. */
void moving_report_print(const struct moving *moving, const struct compiled *scene, const char *name);

void moving_free(struct moving *moving);

#endif
