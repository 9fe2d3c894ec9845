/* SPDX-License-Identifier: MIT
 *
 * From a model with moving objects to the scene and the objects; and what they cost. */
#ifndef SIM_MOVING_COMPILE_H
#define SIM_MOVING_COMPILE_H

#include "compiler/compile.h"
#include "scene/moving.h"

/* --movers. MOVING_OFF: they stay where the file has them, a part of the scene. */
enum moving_mode { MOVING_ON, MOVING_OFF };

bool moving_mode_parse(const char *text, enum moving_mode *out, struct error *err);

/* What `limner` has to be told of movers. */
struct moving_options {
    enum moving_mode mode;
    bool light; /* in each frame; else it is baked into them where the file has them */
};

/* --mover-light baked or turning. */
bool moving_light_parse(const char *text, bool *out, struct error *err);

/* Model file -> compiled scene and objects. Refuses objects that do not fit the scene's grid. Both are the caller's to
 * free, also after a failure. */
bool moving_compile(const char *path, const struct compile_options *options, const struct moving_options *movers,
                    struct compiled *scene, struct moving *moving, struct error *err);

/* The same of a model, which becomes *moving's. */
bool moving_compile_model(const struct model *model, const struct compile_options *options,
                          const struct moving_options *movers, struct compiled *scene, struct moving *moving,
                          struct error *err);

/* moving_compile() into scene->moving, which stays NULL if nothing moves; *scene must be zero. */
bool moving_compile_own(const char *path, const struct compile_options *options, enum moving_mode mode,
                        struct compiled *scene, struct error *err);

/* Bytes of flash that all objects take, their keys included. */
size_t moving_flash_b(const struct moving *moving);

/* What the objects cost, beside the scene's report. `name`: that of the files; NULL: none are written. */
void moving_report_print(const struct moving *moving, const struct compiled *scene, const char *name);

#endif
