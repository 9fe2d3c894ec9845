/* SPDX-License-Identifier: MIT
 *
 * A folder that exports own: limner.files in it lists what they wrote, each with a checksum. So the next export may
 * replace it, and what somebody put there, or changed, is never lost. */
#ifndef SIM_EXPORT_FOLDER_H
#define SIM_EXPORT_FOLDER_H

#include "outputs/outputs.h"

struct export_folder {
    const char *path;
    struct export_file *files, *written; /* what the last export wrote, and what this one does */
    size_t count, capacity, written_count, written_capacity;
};

/* Refuses a folder with anything in it that no export wrote, or that was changed since. */
bool export_folder_open(struct export_folder *folder, const char *path, struct error *err);

/* limner.files, of all outputs so far, which are closed. */
bool export_folder_list(struct export_folder *folder, struct outputs *outputs, struct error *err);

/* When the outputs are in their places: removes what the last export wrote and this one did not. */
void export_folder_tidy(const struct export_folder *folder);

void export_folder_free(struct export_folder *folder);

#endif
