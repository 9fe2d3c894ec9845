/* SPDX-License-Identifier: MIT
 *
 * model_import(): the importer library runs in a child process with limits on time and memory,
 * which can do nothing but read (confine.h), because on damaged files it may crash or never come back, or worse. The
 * child leaves the model in an unnamed temporary file, which the parent reads once the child has ended well, and the
 * names of what it has opened in another one, which is read however it has ended. */
#include "readers/model_import.h"

#include "base/child.h"
#include "base/ending.h"
#include "base/inputs.h"
#include "base/names.h"
#include "base/progress.h"
#include "levels/level_path.h"
#include "readers/confine.h"
#include "readers/import.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum {
    LEAST_CPU_S = 3,     /* for any file */
    CPU_B_A_S = 2000000, /* a second more for so many bytes */
    MEMORY_B_A_B = 64,   /* the library's worst measured need, by byte of the file, is about 40 */
};
/* A file of a few bytes may not ask for much: a picture, the largest, takes 64 MB and as much again while it is
 * decoded. An address sanitizer's memory, which begins with terabytes, is the sanitizer's own affair. */
static const rlim_t LEAST_MEMORY_B = (rlim_t)192 << 20, SANITIZED_B = (rlim_t)1 << 40;
#ifndef __has_feature
#define __has_feature(name) 0 /* clang's way to tell */
#endif
#if defined(__SANITIZE_ADDRESS__) || __has_feature(address_sanitizer)
enum { IS_SANITIZED = true };
#else
enum { IS_SANITIZED = false };
#endif

struct result {
    bool ok;
    size_t point_count, corner_count, face_count, alpha_clamped, picture_count;
    bool has_uvs;
    double lattice_m;
    bool is_interior, is_stopped, says_z_up;
    size_t mover_count, key_count;
    char notice[sizeof((struct model *)0)->notice];
    struct error err;
};

/* All addresses; 0 where the system does not tell. */
static rlim_t memory_in_use_b(void)
{
    unsigned long pages = 0;
    FILE *statm = fopen("/proc/self/statm", "r");
    if (!statm) return 0;
    if (fscanf(statm, "%lu", &pages) != 1) pages = 0;
    fclose(statm);
    return (rlim_t)pages * (rlim_t)sysconf(_SC_PAGESIZE);
}

static rlim_t cpu_limit_s(rlim_t file_b)
{
    return LEAST_CPU_S + file_b / CPU_B_A_S;
}

static void limit(int resource, rlim_t soft)
{
    struct rlimit now;
    if (getrlimit(resource, &now) || soft >= now.rlim_cur) return;
    now.rlim_cur = soft;
    setrlimit(resource, &now);
}

/* Where the addresses in use are not told, what is written to is limited, of which less than was in memory is in use.
 */
static void limit_memory(rlim_t more_b)
{
    const rlim_t in_use_b = memory_in_use_b();
    struct rusage usage;
    if (in_use_b && in_use_b < SANITIZED_B) limit(RLIMIT_AS, in_use_b + more_b);
    if (in_use_b || IS_SANITIZED || getrusage(RUSAGE_SELF, &usage) != 0) return;
    limit(RLIMIT_DATA, (rlim_t)usage.ru_maxrss * 1024 + more_b);
}

static void limit_child(rlim_t file_b)
{
    limit_memory(LEAST_MEMORY_B + MEMORY_B_A_B * file_b);
    limit(RLIMIT_CPU, cpu_limit_s(file_b));
    limit(RLIMIT_CORE, 0);
}

static bool write_all(FILE *out, const void *items, size_t count, size_t item_b)
{
    return count == 0 || fwrite(items, item_b, count, out) == count;
}

static size_t pixel_count(const struct picture *picture)
{
    return (size_t)picture->w_px * picture->h_px;
}

static bool write_pictures(FILE *out, const struct model *model)
{
    bool written = !model->uvs || write_all(out, model->uvs, model->point_count, sizeof *model->uvs);
    written = written && write_all(out, model->pictures, model->picture_count, sizeof *model->pictures);
    for (size_t i = 0; written && i < model->picture_count; i++)
        written = write_all(out, model->pictures[i].pixels, pixel_count(&model->pictures[i]), sizeof(uint32_t));
    return written;
}

static bool write_result(FILE *out, const struct result *result, const struct model *model)
{
    bool written = write_all(out, result, 1, sizeof *result);
    if (written && result->ok)
        written = write_all(out, model->points, model->point_count, sizeof *model->points) &&
                  write_all(out, model->corners, model->corner_count, sizeof *model->corners) &&
                  write_all(out, model->faces, model->face_count, sizeof *model->faces) &&
                  write_all(out, model->movers, model->mover_count, sizeof *model->movers) &&
                  write_all(out, model->keys, model->key_count, sizeof *model->keys) && write_pictures(out, model);
    return written && fflush(out) == 0;
}

_Noreturn static void run_child(const char *path, rlim_t file_b, FILE *read, FILE *out)
{
    struct model model;
    struct result result;
    memset(&result, 0, sizeof result); /* padding too: it goes to the file */
    limit_child(file_b);
    inputs_send_to(fileno(read));
    if (!freopen("/dev/null", "w", stderr) || !freopen("/dev/null", "w", stdout)) _exit(EXIT_FAILURE);
    confine_to_reading();
    result.ok = import_model(path, &model, &result.err);
    result.point_count = model.point_count;
    result.corner_count = model.corner_count;
    result.face_count = model.face_count;
    result.alpha_clamped = model.alpha_clamped;
    result.picture_count = model.picture_count;
    result.has_uvs = model.uvs != NULL;
    result.lattice_m = model.lattice_m;
    result.is_interior = model.is_interior;
    result.says_z_up = model.says_z_up;
    result.is_stopped = model.is_stopped;
    result.mover_count = model.mover_count;
    result.key_count = model.key_count;
    memcpy(result.notice, model.notice, sizeof result.notice);
    _exit(write_result(out, &result, &model) ? EXIT_SUCCESS : EXIT_FAILURE);
}

static void *read_all(FILE *in, size_t count, size_t item_b)
{
    void *items = calloc(count ? count : 1, item_b);
    if (!items || fread(items, item_b, count, in) == count) return items;
    free(items);
    return NULL;
}

static bool read_pictures(FILE *in, const struct result *result, struct model *model)
{
    model->uvs = result->has_uvs ? read_all(in, model->point_count, sizeof *model->uvs) : NULL;
    if (result->has_uvs && !model->uvs) return false;
    model->pictures = result->picture_count ? read_all(in, result->picture_count, sizeof *model->pictures) : NULL;
    if (!model->pictures) return result->picture_count == 0;
    for (size_t i = 0; i < result->picture_count; i++)
        model->pictures[i].pixels = NULL, model->pictures[i].alpha = NULL; /* what the child had is not ours */
    model->picture_count = result->picture_count;
    for (size_t i = 0; i < model->picture_count; i++) {
        const size_t count = pixel_count(&model->pictures[i]);
        if (count && !(model->pictures[i].pixels = read_all(in, count, sizeof(uint32_t)))) return false;
    }
    return true;
}

static bool read_result(const char *path, FILE *in, struct model *model, struct error *err)
{
    struct result result;
    rewind(in);
    if (fread(&result, sizeof result, 1, in) != 1) return error_set(err, "%s: the importer left no result", path);
    if (!result.ok) {
        *err = result.err;
        return false;
    }
    model->point_count = result.point_count;
    model->corner_count = result.corner_count;
    model->face_count = result.face_count;
    model->alpha_clamped = result.alpha_clamped;
    model->lattice_m = result.lattice_m;
    model->is_interior = result.is_interior;
    model->says_z_up = result.says_z_up;
    model->is_stopped = result.is_stopped;
    model->mover_count = result.mover_count;
    model->key_count = result.key_count;
    memcpy(model->notice, result.notice, sizeof model->notice);
    model->points = read_all(in, model->point_count, sizeof *model->points);
    model->corners = read_all(in, model->corner_count, sizeof *model->corners);
    model->faces = read_all(in, model->face_count, sizeof *model->faces);
    model->movers = read_all(in, model->mover_count, sizeof *model->movers);
    model->keys = read_all(in, model->key_count, sizeof *model->keys);
    if (model->points && model->corners && model->faces && model->movers && model->keys &&
        read_pictures(in, &result, model))
        return true;
    model_free(model);
    return error_set(err, "%s: not enough memory", path);
}

/* What it crashes at may be another file than the model: `last` is the one that the child opened last, or NULL. */
static bool has_failed(const char *path, const char *last, const char *how, struct error *err)
{
    if (!last || strcmp(last, path) == 0) return error_set(err, "%s: the importer cannot read it (%s)", path, how);
    return error_set(err, "%s: the importer cannot read it (%s); the last that it opened is %s", path, how,
                     name_end(last).text);
}

static bool wait_for_child(const char *path, pid_t child, rlim_t file_b, FILE *read, struct error *err)
{
    int status = 0;
    const size_t before = inputs_count();
    const bool has_ended = child_wait(child, "the importer was still reading", &status, err);
    inputs_receive(read);
    if (!has_ended) return error_prefix(err, path);
    if (WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS) return true;
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
        return error_set(err, "%s: damaged, truncated or too much: the importer finds no end in it (%lu s)", path,
                         (unsigned long)cpu_limit_s(file_b));
    const char *how = WIFSIGNALED(status) ? strsignal(WTERMSIG(status)) : "out of memory or disk space";
    return has_failed(path, inputs_count() > before ? inputs_path(inputs_count() - 1) : NULL, how, err);
}

/* The child says what is wrong with a file. */
static rlim_t size_of(const char *path)
{
    struct stat file = {0};
    (void)stat(path, &file);
    return (rlim_t)file.st_size;
}

/* Of a map, all of its WADs. */
static rlim_t input_size(const char *path)
{
    struct level_path level;
    char wad[WAD_PATH_B];
    rlim_t size_b = 0;
    if (!level_path_parse(path, &level)) return size_of(path);
    for (size_t i = 0; wad_path_at(level.files, i, wad); i++)
        size_b += size_of(wad);
    return size_b;
}

/* `read` gets the names of the files that the child opens, `out` the model. */
static bool import_in_child(const char *path, FILE *read, FILE *out, struct model *model, struct error *err)
{
    const rlim_t size_b = input_size(path);
    progress("reading %s", path);
    pid_t child = ending_fork();
    if (child == 0) run_child(path, size_b, read, out);
    bool ok = child > 0 ? wait_for_child(path, child, size_b, read, err)
                        : error_set(err, "%s: no process for the importer: %s", path, strerror(errno));
    ok = ok && read_result(path, out, model, err);
    progress_end();
    return ok;
}

bool model_import(const char *path, struct model *model, struct error *err)
{
    *model = (struct model){0};
    FILE *read = tmpfile(), *out = tmpfile();
    const bool ok = read && out ? import_in_child(path, read, out, model, err)
                                : error_set(err, "%s: no temporary file: %s", path, strerror(errno));
    if (read) fclose(read);
    if (out) fclose(out);
    return ok;
}
