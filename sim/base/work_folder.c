/* SPDX-License-Identifier: MIT
 *
 * Made by mkdtemp(), removed from the leaves to the root without following links. */
#define _XOPEN_SOURCE 700
#include "base/work_folder.h"

#include "base/ending.h"

#include <errno.h>
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { OPEN_FOLDERS = 16 };

bool work_folder_make(struct work_folder *folder, struct error *err)
{
    const char *parent = getenv("TMPDIR");
    if (!parent || parent[0] != '/') parent = "/tmp";
    const int length = snprintf(folder->path, sizeof folder->path, "%s/limner-XXXXXX", parent);
    ending_hold();
    const bool made = length < (int)sizeof folder->path && mkdtemp(folder->path);
    folder->leftover = made ? ending_add(LEFTOVER_TREE, folder->path) : NULL;
    ending_release();
    if (made) return true;
    folder->path[0] = '\0';
    return error_set(err, "%s: cannot make a folder in it: %s", parent, strerror(errno));
}

bool work_folder_place(const struct work_folder *folder, const char *name, char *path, size_t path_b, struct error *err)
{
    const size_t folder_b = strlen(folder->path) + 1;
    if (snprintf(path, path_b, "%s/%s", folder->path, name) >= (int)path_b)
        return error_set(err, "%s: the path is too long", name);
    for (char *slash = strchr(path + folder_b, '/'); slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        const bool ok = mkdir(path, 0700) == 0 || errno == EEXIST;
        *slash = '/';
        if (!ok) return error_set(err, "%s: cannot make a folder for it: %s", name, strerror(errno));
    }
    return true;
}

static int remove_entry(const char *path, const struct stat *status, int kind, struct FTW *place)
{
    (void)status, (void)kind, (void)place;
    return remove(path);
}

void work_folder_remove(struct work_folder *folder)
{
    if (folder->path[0]) nftw(folder->path, remove_entry, OPEN_FOLDERS, FTW_DEPTH | FTW_PHYS);
    ending_forget(folder->leftover);
    folder->leftover = NULL;
    folder->path[0] = '\0';
}
