/* SPDX-License-Identifier: MIT
 *
 * The names of a scene in C, from the path of its files. */
#ifndef SIM_C_NAME_H
#define SIM_C_NAME_H

#include "base/error.h"

enum { C_NAME_MAX_B = 64, C_PATH_MAX_B = 1024 };

struct c_name {
    const char *file;          /* last part of the path */
    char symbol[C_NAME_MAX_B]; /* "hall" */
    char macro[C_NAME_MAX_B];  /* "HALL" */
};

/* `path` is without suffix and outlives *name. Every character that C does not allow becomes '_';
 * "scene_" comes before a name without a letter in front, and before one that begins with lim_ as the renderer's do.
 * Refuses a folder, and what is too long. */
bool c_name_init(struct c_name *name, const char *path, struct error *err);

/* Makes a file of the path one that `#include "..."` can name wherever C is compiled, in place: of its last part,
 * quotes, backslashes, question marks (trigraphs), and what cannot be shown, become '_'. Whether there was such a
 * thing. */
bool c_name_map(char *path);

/* PATH and a suffix; refuses what is too long. */
bool c_path(char out[C_PATH_MAX_B], const char *path, const char *suffix, struct error *err);

#endif
