/* SPDX-License-Identifier: MIT
 *
 * A folder for files that nobody is to see, in $TMPDIR or /tmp. It goes when the process ends, by a signal too. */
#ifndef SIM_WORK_FOLDER_H
#define SIM_WORK_FOLDER_H

#include "base/error.h"

#include <stddef.h>

struct leftover;

struct work_folder {
    char path[512]; /* empty: there is none */
    struct leftover *leftover;
};

bool work_folder_make(struct work_folder *folder, struct error *err);

/* Where a file of that name goes, folders that lead to it made. */
bool work_folder_place(const struct work_folder *folder, const char *name, char *path, size_t path_b,
                       struct error *err);

/* With all that is in it. */
void work_folder_remove(struct work_folder *folder);

#endif
