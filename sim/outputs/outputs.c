/* SPDX-License-Identifier: MIT
 *
 * All-or-nothing output by temporary names in the same folder, so that the final rename cannot fail for want of space;
 * what the command made is remembered in order and undone in reverse. A temporary's name has a random word in it, and
 * must be new: two runs, or a link that somebody has put there, never share it (output_run.h). */
#include "outputs/outputs.h"

#include "base/ending.h"
#include "base/grow.h"
#include "base/inputs.h"
#include "base/streams.h"
#include "outputs/output_run.h"
#include "outputs/output_set.h"
#include "outputs/written.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
    PATH_SIZE_B = 4096,
    LINKS_MAX = 40 /* as the kernel follows */
};

/* Where the file is to be: links in the place of the file are followed to their end, as fopen() does. */
struct place {
    char path[PATH_SIZE_B];
    bool exists, as_it_is; /* a device, a pipe, or an open file by its number */
    mode_t mode;
};

static void path_free(struct output_path *path)
{
    ending_forget(path->leftover);
    free(path->path);
    free(path->part);
    free(path->old);
}

static void outputs_free(struct outputs *outputs)
{
    for (size_t i = 0; i < outputs->count; i++)
        path_free(&outputs->paths[i]);
    free(outputs->paths);
    output_run_end(outputs->run);
    *outputs = (struct outputs){0};
}

/* What has just been made, whose strings become the list's; its errors undo it. */
static bool outputs_remember(struct outputs *outputs, struct output_path made, struct error *err)
{
    struct output_path *paths = realloc(outputs->paths, (outputs->count + 1) * sizeof *paths);
    if (paths) outputs->paths = paths;
    if (made.path)
        made.leftover = ending_add(made.part ? LEFTOVER_FILE : LEFTOVER_FOLDER, made.part ? made.part : made.path);
    if (paths && made.leftover) {
        paths[outputs->count++] = made;
        return true;
    }
    error_set(err, "%s: out of memory", made.path ? made.path : "an output");
    if (made.part)
        unlink(made.part);
    else if (made.path)
        rmdir(made.path);
    path_free(&made);
    return false;
}

/* Places ------------------------------------------------------------------------------------- */

static size_t folder_length(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? (size_t)(slash - path) + 1 : 0;
}

/* Puts the link's target in its place. */
static bool follow(char path[PATH_SIZE_B])
{
    char target[PATH_SIZE_B];
    const ssize_t length = readlink(path, target, sizeof target - 1);
    const size_t folder_b = length > 0 && target[0] == '/' ? 0 : folder_length(path);
    if (length < 0) return false;
    errno = ENAMETOOLONG;
    if (folder_b + (size_t)length >= PATH_SIZE_B) return false;
    memcpy(path + folder_b, target, (size_t)length);
    path[folder_b + (size_t)length] = '\0';
    return true;
}

/* Names of open files: a link whose target is no name. */
static bool is_open_file(const char *path)
{
    return strncmp(path, "/proc/", 6) == 0 || strncmp(path, "/dev/fd/", 8) == 0;
}

static bool place_find(const char *path, struct place *place)
{
    struct stat status;
    *place = (struct place){0};
    errno = ENAMETOOLONG;
    if (strlen(path) >= sizeof place->path) return false;
    memcpy(place->path, path, strlen(path) + 1);
    for (int links = 0; !(place->as_it_is = is_open_file(place->path)); links++) {
        if (lstat(place->path, &status) != 0 || !S_ISLNK(status.st_mode)) break;
        errno = ELOOP;
        if (links == LINKS_MAX || !follow(place->path)) return false;
    }
    place->exists = stat(place->path, &status) == 0;
    place->mode = place->exists ? status.st_mode : 0;
    place->as_it_is |= place->exists && !S_ISREG(status.st_mode);
    return true;
}

/* Makes the folders that lead to path, and remembers those that were not there. */
static bool make_folders(struct outputs *outputs, const char *path, struct error *err)
{
    char *folder = strdup(path);
    bool ok = folder || error_set(err, "%s: out of memory", path);
    for (char *slash = ok ? strchr(folder + 1, '/') : NULL; ok && slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        ending_hold();
        if (mkdir(folder, 0777) == 0)
            ok = outputs_remember(outputs, (struct output_path){.path = strdup(folder)}, err);
        else if (errno != EEXIST)
            ok = error_set(err, "%s: cannot make the folder: %s", folder, strerror(errno));
        ending_release();
        *slash = '/';
    }
    free(folder);
    return ok;
}

/* Of the folder that holds path, which is there. */
static bool folder_status(const char *path, struct stat *status)
{
    char folder[PATH_SIZE_B];
    snprintf(folder, sizeof folder, "%.*s.", (int)folder_length(path), path);
    return stat(folder, status) == 0;
}

/* However it is spelled. */
static bool is_taken(const struct outputs *outputs, const char *path)
{
    struct stat mine, other;
    const bool known = folder_status(path, &mine);
    for (size_t i = 0; i < outputs->count; i++) {
        const char *taken = outputs->paths[i].path;
        if (!outputs->paths[i].part) continue;
        if (strcmp(taken + folder_length(taken), path + folder_length(path)) != 0) continue;
        if (strcmp(taken, path) == 0) return true;
        if (known && folder_status(taken, &other) && mine.st_dev == other.st_dev && mine.st_ino == other.st_ino)
            return true;
    }
    return false;
}

/* Read ---------------------------------------------------------------------------------------- */

static const char THE_SAME[] = "the same command reads it";

static bool is_read(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 && inputs_have(&status);
}

bool outputs_check(const struct outputs *outputs, struct error *err)
{
    for (size_t i = 0; i < outputs->count; i++)
        if (outputs->paths[i].part && is_read(outputs->paths[i].path))
            return error_set(err, "%s: cannot be written: %s", outputs->paths[i].path, THE_SAME);
    return true;
}

/* Files -------------------------------------------------------------------------------------- */

/* With the permissions that fopen() would give, or leave, the file. */
static int part_open(const struct place *place, const char *part)
{
    const int descriptor = open(part, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor >= 0 && place->exists) (void)!fchmod(descriptor, place->mode & 0777);
    return descriptor;
}

/* Listed before it is there: if the process is killed in between, nothing is left that nobody knows of. */
static int part_begin(struct outputs *outputs, const struct place *place, struct error *err)
{
    if (!outputs->run) outputs->run = output_run_begin(place->path);
    if (!outputs->run) return -1;
    const size_t number = output_run_add(outputs->run, place->path);
    struct output_path made = {.path = strdup(place->path),
                               .part = output_run_name(outputs->run, place->path, number, OUTPUT_PART),
                               .old = output_run_name(outputs->run, place->path, number, OUTPUT_OLD)};
    const int descriptor = made.path && made.part && made.old ? part_open(place, made.part) : -1;
    if (descriptor < 0) {
        path_free(&made);
        return -1;
    }
    if (outputs_remember(outputs, made, err)) return descriptor;
    close(descriptor);
    errno = ENOMEM;
    return -1;
}

static int place_open(struct outputs *outputs, const struct place *place, struct error *err)
{
    if (place->as_it_is) return stream_open(place->path, O_WRONLY);
    ending_hold();
    const int descriptor = part_begin(outputs, place, err), reason = errno;
    ending_release();
    errno = reason;
    return descriptor;
}

FILE *outputs_open(struct outputs *outputs, const char *path, struct error *err)
{
    struct place place;
    const bool found = place_find(path, &place);
    const char *reason = found ? NULL : strerror(errno);
    const size_t folder_b = found ? folder_length(place.path) : 0;
    const bool is_folder = found && (S_ISDIR(place.mode) || (folder_b && !place.path[folder_b]));
    if (found && place.exists && access(place.path, W_OK) != 0) reason = strerror(errno);
    if (is_folder) reason = "it is a folder";
    if (found && is_read(place.path)) reason = THE_SAME;
    if (!path[0]) {
        error_set(err, "%s: a file name is empty", path);
        return NULL;
    }
    if (!reason && !place.as_it_is) {
        if (!make_folders(outputs, place.path, err)) return NULL;
        if (is_taken(outputs, place.path)) {
            error_set(err, "%s: named for two outputs", path);
            return NULL;
        }
    }
    const int descriptor = reason ? -1 : place_open(outputs, &place, err);
    FILE *file = descriptor >= 0 ? fdopen(descriptor, "wb") : NULL;
    if (!file) error_set(err, "%s: cannot be written: %s", path, reason ? reason : strerror(errno));
    if (!file && descriptor >= 0) close(descriptor);
    return file;
}

bool outputs_close(FILE *file, const char *path, struct error *err)
{
    bool failed_before = ferror(file) != 0;
    errno = 0;
    if (fclose(file) == 0 && !failed_before) return true;
    return error_set(err, "%s: cannot be written: %s", path, errno ? strerror(errno) : "output error");
}

FILE *outputs_reread(const struct outputs *outputs, size_t index, const char **path)
{
    const struct output_path *output = &outputs->paths[index];
    *path = output->part ? output->path : NULL;
    return output->part ? fopen(output->part, "rb") : NULL;
}

/* All ---------------------------------------------------------------------------------------- */

/* Of the first file; NULL: there is none. */
static char *first_folder(const struct outputs *outputs)
{
    for (size_t i = 0; i < outputs->count; i++)
        if (outputs->paths[i].part) return output_folder_of(outputs->paths[i].path);
    return NULL;
}

static bool place_all(struct outputs *outputs, struct error *err)
{
    char *folder = first_folder(outputs);
    const int lock = folder ? output_folder_lock(folder) : -1;
    const bool ok = outputs_check(outputs, err) && output_set_place(outputs->paths, outputs->count, outputs->run, err);
    if (lock >= 0) close(lock);
    free(folder);
    return ok;
}

static void files_text(const struct outputs *outputs, char text[WRITTEN_B])
{
    const char **files = grow_zeroed(outputs->count + 1, sizeof *files);
    size_t count = 0;
    for (size_t i = 0; i < outputs->count; i++)
        if (outputs->paths[i].part) files[count++] = outputs->paths[i].path;
    written_text(files, count, text);
    free(files);
}

bool outputs_keep_untold(struct outputs *outputs, char *text, struct error *err)
{
    ending_hold();
    const bool ok = place_all(outputs, err);
    files_text(outputs, text);
    if (ok)
        outputs_free(outputs);
    else
        outputs_discard(outputs);
    ending_release();
    return ok;
}

bool outputs_keep(struct outputs *outputs, struct error *err)
{
    char text[WRITTEN_B];
    const bool ok = outputs_keep_untold(outputs, text, err);
    if (ok) written_say(text);
    return ok;
}

/* The folders become empty last. */
void outputs_discard(struct outputs *outputs)
{
    ending_hold();
    for (size_t i = outputs->count; i-- > 0;)
        if (outputs->paths[i].part) unlink(outputs->paths[i].part);
    output_run_end(outputs->run);
    outputs->run = NULL;
    for (size_t i = outputs->count; i-- > 0;)
        if (!outputs->paths[i].part) rmdir(outputs->paths[i].path);
    outputs_free(outputs);
    ending_release();
}

/* Numbered names ----------------------------------------------------------------------------- */

struct pattern_field {
    const char *start, *end;
    int width;
    bool zeros;
};

/* The first %[0][width]d of a pattern; the pattern is never handed to printf. */
static bool find_field(const char *pattern, struct pattern_field *field)
{
    field->start = strchr(pattern, '%');
    if (!field->start) return false;
    const char *at = field->start + 1;
    field->zeros = *at == '0';
    field->width = 0;
    while (*at >= '0' && *at <= '9' && field->width < 10)
        field->width = field->width * 10 + (*at++ - '0');
    field->end = at + 1;
    return *at == 'd' && !strchr(field->end, '%');
}

bool output_pattern_check(const char *pattern, struct error *err)
{
    struct pattern_field field;
    if (find_field(pattern, &field)) return true;
    return error_set(err, "-o '%s': needs exactly one %%d for the frame's number, as in 'out/%%03d.png'", pattern);
}

bool output_is_one(const char *pattern)
{
    return *pattern && !strchr(pattern, '%');
}

bool output_pattern_path(const char *pattern, size_t number, char *path, size_t size, struct error *err)
{
    struct pattern_field field;
    if (number == 0 && output_is_one(pattern))
        return (size_t)snprintf(path, size, "%s", pattern) < size ||
               error_set(err, "-o '%s': the path is too long", pattern);
    if (!find_field(pattern, &field)) return output_pattern_check(pattern, err);
    int start = (int)(field.start - pattern);
    int length = snprintf(path, size, field.zeros ? "%.*s%0*zu%s" : "%.*s%*zu%s", start, pattern, field.width, number,
                          field.end);
    return (length >= 0 && (size_t)length < size) || error_set(err, "-o '%s': the path is too long", pattern);
}
