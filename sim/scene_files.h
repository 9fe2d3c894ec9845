/* SPDX-License-Identifier: MIT
 *
 * The files of a compiled scene, each as part of a set of outputs that is kept or discarded as a
 * whole. */
#ifndef SIM_SCENE_FILES_H
#define SIM_SCENE_FILES_H

#include "compiled.h"
#include "outputs.h"

/* NAME.lim, at the path given. */
bool lim_file_put(const struct compiled *scene, const char *path, struct outputs *outputs, struct error *err);

/* NAME.c and NAME.h, at the path given without its suffix. */
bool c_source_put(const struct compiled *scene, const char *name, struct outputs *outputs, struct error *err);

/* Keeps the outputs if `ok`, discards them otherwise; whether both went well. */
bool scene_files_finish(struct outputs *outputs, bool ok, struct error *err);

#endif
