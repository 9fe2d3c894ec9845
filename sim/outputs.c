/* SPDX-License-Identifier: MIT
 *
 * All-or-nothing output by temporary names in the same folder, so that the final rename cannot
 * fail for want of space; what the command made is remembered in order and undone in reverse. */
#include "outputs.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char PART_SUFFIX[] = ".part";

struct output_path {
    char *path; /* final name */
    char *part; /* name while being written; NULL: a folder */
};

static void outputs_free(struct outputs *outputs)
{
    for (size_t i = 0; i < outputs->count; i++) {
        free(outputs->paths[i].path);
        free(outputs->paths[i].part);
    }
    free(outputs->paths);
    *outputs = (struct outputs){0};
}

static bool outputs_remember(struct outputs *outputs, const char *path, bool is_folder, struct error *err)
{
    struct output_path *paths = realloc(outputs->paths, (outputs->count + 1) * sizeof *paths);
    if (!paths) return error_set(err, "%s: out of memory", path);
    outputs->paths = paths;
    size_t part_size = strlen(path) + sizeof PART_SUFFIX;
    struct output_path made = {strdup(path), is_folder ? NULL : malloc(part_size)};
    if (made.part) snprintf(made.part, part_size, "%s%s", path, PART_SUFFIX);
    paths[outputs->count++] = made;
    return (made.path && (is_folder || made.part)) || error_set(err, "%s: out of memory", path);
}

/* Makes the folders that lead to path, and remembers those that were not there. */
static bool make_folders(struct outputs *outputs, const char *path, struct error *err)
{
    char *folder = strdup(path);
    bool ok = folder || error_set(err, "%s: out of memory", path);
    for (char *slash = ok ? strchr(folder + 1, '/') : NULL; ok && slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        if (mkdir(folder, 0777) == 0)
            ok = outputs_remember(outputs, folder, true, err);
        else if (errno != EEXIST)
            ok = error_set(err, "%s: cannot make the folder: %s", folder, strerror(errno));
        *slash = '/';
    }
    free(folder);
    return ok;
}

static bool is_taken(const struct outputs *outputs, const char *path)
{
    for (size_t i = 0; i < outputs->count; i++)
        if (strcmp(outputs->paths[i].path, path) == 0) return true;
    return false;
}

static FILE *open_or_complain(const char *name, const char *path, struct error *err)
{
    FILE *file = fopen(name, "wb");
    if (!file) error_set(err, "%s: cannot be written: %s", path, strerror(errno));
    return file;
}

FILE *outputs_open(struct outputs *outputs, const char *path, struct error *err)
{
    struct stat status;
    bool exists = path[0] && stat(path, &status) == 0;
    const char *reason = NULL;
    if (!path[0]) reason = "a file name is empty";
    if (exists && S_ISDIR(status.st_mode)) reason = "cannot be written: it is a folder";
    if (is_taken(outputs, path)) reason = "named for two outputs";
    if (reason) {
        error_set(err, "%s: %s", path, reason);
        return NULL;
    }
    if (exists && !S_ISREG(status.st_mode)) return open_or_complain(path, path, err);
    if (!make_folders(outputs, path, err) || !outputs_remember(outputs, path, false, err)) return NULL;
    return open_or_complain(outputs->paths[outputs->count - 1].part, path, err);
}

bool outputs_close(FILE *file, const char *path, struct error *err)
{
    bool failed_before = ferror(file) != 0;
    errno = 0;
    if (fclose(file) == 0 && !failed_before) return true;
    return error_set(err, "%s: cannot be written: %s", path, errno ? strerror(errno) : "output error");
}

bool outputs_keep(struct outputs *outputs, struct error *err)
{
    for (size_t i = 0; i < outputs->count; i++) {
        const struct output_path *made = &outputs->paths[i];
        if (!made->part || rename(made->part, made->path) == 0) continue;
        error_set(err, "%s: cannot be written: %s", made->path, strerror(errno));
        outputs_discard(outputs);
        return false;
    }
    outputs_free(outputs);
    return true;
}

void outputs_discard(struct outputs *outputs)
{
    for (size_t i = outputs->count; i-- > 0;) {
        const struct output_path *made = &outputs->paths[i];
        if (made->part)
            unlink(made->part);
        else if (made->path)
            rmdir(made->path);
    }
    outputs_free(outputs);
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

bool output_pattern_path(const char *pattern, size_t number, char *path, size_t size, struct error *err)
{
    struct pattern_field field;
    if (!find_field(pattern, &field)) return output_pattern_check(pattern, err);
    int start = (int)(field.start - pattern);
    int length = snprintf(path, size, field.zeros ? "%.*s%0*zu%s" : "%.*s%*zu%s", start, pattern, field.width, number,
                          field.end);
    return (length >= 0 && (size_t)length < size) || error_set(err, "-o '%s': the path is too long", pattern);
}
