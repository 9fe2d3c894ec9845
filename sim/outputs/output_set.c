/* SPDX-License-Identifier: MIT
 *
 * What is in a place gets a second name first, so that there is no moment without a file; where the file system has no
 * such names, it is renamed. One file alone needs neither: a rename is all or nothing. */
#include "outputs/output_set.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool cannot(const struct output_path *made, struct error *err)
{
    return error_set(err, "%s: cannot be written: %s", made->path, strerror(errno));
}

static size_t file_count(const struct output_path *paths, size_t count)
{
    size_t files = 0;
    for (size_t i = 0; i < count; i++)
        files += paths[i].part != NULL;
    return files;
}

static bool set_aside(struct output_path *made, struct error *err)
{
    struct stat status;
    if (lstat(made->path, &status) != 0) return errno == ENOENT || cannot(made, err);
    made->is_aside = link(made->path, made->old) == 0 || rename(made->path, made->old) == 0;
    return made->is_aside || cannot(made, err);
}

static bool place(struct output_path *made, struct error *err)
{
    made->is_placed = rename(made->part, made->path) == 0;
    return made->is_placed || cannot(made, err);
}

/* Renaming one of a file's two names to the other does nothing. */
static void take_back(struct output_path *made, struct error *err)
{
    const struct error reason = *err;
    if (!made->is_aside) {
        if (made->is_placed) unlink(made->path);
    } else if (rename(made->old, made->path) == 0) {
        unlink(made->old);
    } else {
        error_set(err, "%s; what was there before is %s now", reason.text, made->old);
    }
    made->is_aside = made->is_placed = false;
}

bool output_set_place(struct output_path *paths, size_t count, struct output_run *run, struct error *err)
{
    bool ok = true;
    const bool is_set = file_count(paths, count) > 1;
    for (size_t i = 0; ok && is_set && i < count; i++)
        ok = !paths[i].part || set_aside(&paths[i], err);
    if (ok && is_set) output_run_is_complete(run);
    for (size_t i = 0; ok && i < count; i++)
        ok = !paths[i].part || place(&paths[i], err);
    for (size_t i = count; !ok && i-- > 0;)
        take_back(&paths[i], err);
    for (size_t i = 0; i < count; i++)
        if (paths[i].is_aside) unlink(paths[i].old);
    return ok;
}
