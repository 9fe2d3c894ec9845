/* SPDX-License-Identifier: MIT
 *
 * limner.files: a line a file, its CRC-32 in eight hexadecimal digits, a blank, and its path in the folder. */
#define _XOPEN_SOURCE 700
#include "export/export_folder.h"

#include "base/c_name.h"
#include "base/grow.h"

#include <errno.h>
#include <ftw.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#define LIST "limner.files"

enum { FOLDERS_OPEN = 16, CRC_DIGITS = 8 };

struct export_file {
    char path[C_PATH_MAX_B]; /* in the folder */
    unsigned long crc;
};

static unsigned long file_crc(FILE *file)
{
    unsigned char part[4096];
    unsigned long crc = crc32(0, NULL, 0);
    for (size_t part_b; (part_b = fread(part, 1, sizeof part, file)) > 0;)
        crc = crc32(crc, part, (unsigned)part_b);
    return crc;
}

/* In the folder, and not beyond it: somebody else may have written the list. */
static bool is_inside(const char *path)
{
    bool is_up = false;
    for (const char *part = path; part && !is_up; part = strchr(part, '/') ? strchr(part, '/') + 1 : NULL)
        is_up = strcspn(part, "/") == 2 && strncmp(part, "..", 2) == 0;
    return path[0] != '/' && !is_up;
}

static void add_file(struct export_file **files, size_t *count, size_t *capacity, const char *path, unsigned long crc)
{
    *files = grow(*files, *count, capacity, sizeof **files);
    struct export_file *file = &(*files)[(*count)++];
    snprintf(file->path, sizeof file->path, "%s", path);
    file->crc = crc;
}

/* A line of the list. */
static void add_line(struct export_folder *folder, char *line)
{
    char *end;
    const unsigned long crc = strtoul(line, &end, 16);
    line[strcspn(line, "\n")] = '\0';
    if (end == line + CRC_DIGITS && *end == ' ' && strlen(end + 1) < C_PATH_MAX_B && is_inside(end + 1))
        add_file(&folder->files, &folder->count, &folder->capacity, end + 1, crc);
}

static void read_list(struct export_folder *folder)
{
    char path[C_PATH_MAX_B + sizeof LIST], line[C_PATH_MAX_B + CRC_DIGITS + 3];
    snprintf(path, sizeof path, "%s/" LIST, folder->path);
    FILE *list = fopen(path, "r");
    if (!list) return;
    while (fgets(line, sizeof line, list))
        add_line(folder, line);
    fclose(list);
}

/* nftw() hands on no context. */
static const struct export_folder *walked;
static struct error *walked_err;

static const struct export_file *find(const struct export_file *files, size_t count, const char *path)
{
    for (size_t i = 0; i < count; i++)
        if (strcmp(files[i].path, path) == 0) return &files[i];
    return NULL;
}

static bool is_unchanged(const char *path, const struct export_file *file)
{
    FILE *opened = fopen(path, "rb");
    if (!opened) return false;
    const unsigned long crc = file_crc(opened);
    fclose(opened);
    return crc == file->crc;
}

static int check_file(const char *path, const struct stat *about, int kind, struct FTW *at)
{
    (void)about;
    if (kind == FTW_D) return 0;
    if (at->level == 0) {
        error_set(walked_err, "%s: is a link, or cannot be read; name the folder itself", path);
        return 1;
    }
    const char *inside = path + strlen(walked->path) + 1;
    if (strcmp(inside, LIST) == 0) return 0;
    const struct export_file *file = kind == FTW_F ? find(walked->files, walked->count, inside) : NULL;
    if (!file) {
        error_set(walked_err, "%s: no export wrote this file; choose another folder", path);
        return 1;
    }
    if (is_unchanged(path, file)) return 0;
    error_set(walked_err, "%s: was changed since it was exported; choose another folder, or remove it", path);
    return 1;
}

bool export_folder_open(struct export_folder *folder, const char *path, struct error *err)
{
    struct stat about;
    *folder = (struct export_folder){.path = path};
    if (stat(path, &about) != 0)
        return errno == ENOENT || error_set(err, "%s: cannot be read: %s", path, strerror(errno));
    if (!S_ISDIR(about.st_mode)) return error_set(err, "%s: is a file, not a folder", path);
    read_list(folder);
    walked = folder;
    walked_err = err;
    err->text[0] = '\0';
    if (nftw(path, check_file, FOLDERS_OPEN, FTW_PHYS) == 0) return true;
    return err->text[0] ? false : error_set(err, "%s: cannot be read: %s", path, strerror(errno));
}

static bool note_file(struct export_folder *folder, FILE *file, const char *inside, FILE *list)
{
    const unsigned long crc = file_crc(file);
    fprintf(list, "%08lx %s\n", crc, inside);
    add_file(&folder->written, &folder->written_count, &folder->written_capacity, inside, crc);
    return !ferror(file);
}

bool export_folder_list(struct export_folder *folder, struct outputs *outputs, struct error *err)
{
    char path[C_PATH_MAX_B];
    const size_t count = outputs->count, folder_b = strlen(folder->path);
    if (!c_path(path, folder->path, "/" LIST, err)) return false;
    FILE *list = outputs_open(outputs, path, err);
    if (!list) return false;
    bool ok = true;
    for (size_t i = 0; ok && i < count; i++) {
        const char *written;
        FILE *file = outputs_reread(outputs, i, &written);
        if (!written) continue;
        ok = file && note_file(folder, file, written + folder_b + 1, list);
        if (file) fclose(file);
        if (!ok) error_set(err, "%s: cannot be read again: %s", written, strerror(errno));
    }
    return outputs_close(list, path, err) && ok;
}

void export_folder_tidy(const struct export_folder *folder)
{
    for (size_t i = 0; i < folder->count; i++) {
        char path[2 * C_PATH_MAX_B];
        snprintf(path, sizeof path, "%s/%s", folder->path, folder->files[i].path);
        if (find(folder->written, folder->written_count, folder->files[i].path)) continue;
        unlink(path);
        for (char *slash; (slash = strrchr(path, '/')) && (size_t)(slash - path) > strlen(folder->path);) {
            *slash = '\0';
            if (rmdir(path) != 0) break;
        }
    }
}

void export_folder_free(struct export_folder *folder)
{
    free(folder->files);
    free(folder->written);
    *folder = (struct export_folder){0};
}
