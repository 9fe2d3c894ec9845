/* SPDX-License-Identifier: MIT
 *
 * How a map is named where a model is: FILE.wad:MAP, or IWAD.wad+PWAD.wad:MAP. */
#ifndef SIM_LEVEL_PATH_H
#define SIM_LEVEL_PATH_H

#include "levels/wad.h"

struct level_path {
    char files[WAD_PATH_B]; /* for wad_open() */
    char map[WAD_NAME_B];   /* in capitals; empty: none is named */
};

/* Whether a model's path names WADs, with a map or without. *out (NULL: nobody wants it) is set then. */
bool level_path_parse(const char *path, struct level_path *out);

/* What a model is called by its path: a map's name, or the file's without folder and suffix. As snprintf() does, it
 * returns how many characters that has. */
int level_path_stem(const char *path, char *name, size_t size_b);

/* inputs_note_name() of all files that a model's path names. */
void level_path_note(const char *path);

/* What is behind the WADs of such a path: ":MAP", or nothing; of other paths nothing. */
const char *level_path_tail(const char *path);

#endif
