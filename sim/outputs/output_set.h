/* SPDX-License-Identifier: MIT
 *
 * A command's complete outputs take their places: all of them, or what was there stays. */
#ifndef SIM_OUTPUT_SET_H
#define SIM_OUTPUT_SET_H

#include "base/ending.h"
#include "base/error.h"
#include "outputs/output_run.h"

#include <stddef.h>

/* A file or folder that the command made. */
struct output_path {
    char *path; /* final name, no link */
    char *part; /* name while being written; NULL: a folder */
    char *old;  /* of what was in its place, while the others take theirs; NULL: a folder */
    bool is_aside, is_placed;
    struct leftover *leftover;
};

/* Renames each part to its path. On an error, what was in a place is back there, and the parts that are left keep their
 * names. */
bool output_set_place(struct output_path *paths, size_t count, struct output_run *run, struct error *err);

#endif
