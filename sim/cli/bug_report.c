/* SPDX-License-Identifier: MIT
 *
 * Nothing that a report names leads out of its folder, whoever made the list. */
#include "cli/bug_report.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum { PATH_MAX_B = 1024, BLOCK_B = 1 << 16 };

static bool is_plain_path(const char *path)
{
    if (!*path) return false;
    for (const char *part = path; part; part = strchr(part, '/') ? strchr(part, '/') + 1 : NULL) {
        const size_t length = strcspn(part, "/");
        if (length == 0 || (length == 1 && part[0] == '.') || (length == 2 && strncmp(part, "..", 2) == 0))
            return false;
    }
    for (const char *c = path; *c; c++)
        if ((unsigned char)*c < ' ' || *c == 0x7F || *c == '\\') return false;
    return true;
}

bool report_name_is_allowed(const char *name)
{
    if (strlen(name) >= REPORT_NAME_B) return false;
    if (strncmp(name, REPORT_SCENE_FOLDER, strlen(REPORT_SCENE_FOLDER)) == 0)
        return is_plain_path(name + strlen(REPORT_SCENE_FOLDER));
    return strcmp(name, REPORT_TEXT_NAME) == 0 || strcmp(name, REPORT_HASHES_NAME) == 0 ||
           strcmp(name, REPORT_CAMERAS_NAME) == 0;
}

static bool measure_file(const char *path, struct report_file *file, struct error *err)
{
    unsigned char block[BLOCK_B];
    size_t got_b, size_b = 0;
    uLong crc = crc32(0, NULL, 0);
    FILE *stream = fopen(path, "rb");
    if (!stream) return error_set(err, "%s: %s", file->name, strerror(errno));
    while ((got_b = fread(block, 1, sizeof block, stream)) > 0 && size_b <= REPORT_TOTAL_B) {
        crc = crc32(crc, block, (uInt)got_b);
        size_b += got_b;
    }
    const bool ok = !ferror(stream) || error_set(err, "%s: cannot be read", file->name);
    fclose(stream);
    file->size_b = (uint32_t)size_b;
    file->crc32 = (uint32_t)crc;
    return ok;
}

bool report_add(struct report *report, const struct work_folder *folder, const char *name, struct error *err)
{
    char path[PATH_MAX_B];
    if (!report_name_is_allowed(name)) return error_set(err, "%s: no name that a report can hold", name);
    if (report->file_count == REPORT_FILES_MAX)
        return error_set(err, "%s: a report holds %d files at most", name, REPORT_FILES_MAX);
    struct report_file *file = &report->files[report->file_count];
    snprintf(file->name, sizeof file->name, "%s", name);
    if (!work_folder_place(folder, name, path, sizeof path, err) || !measure_file(path, file, err)) return false;
    if (file->size_b > REPORT_TOTAL_B - report->total_b)
        return error_set(err, "%s: a report holds %d MB at most", name, REPORT_TOTAL_B >> 20);
    report->total_b += file->size_b;
    report->file_count++;
    return true;
}

bool report_add_argument(struct report *report, const char *text, struct error *err)
{
    if (report->argument_count == REPORT_ARGUMENTS_MAX)
        return error_set(err, "%s: a report holds %d options at most", text, REPORT_ARGUMENTS_MAX);
    const int line = (int)strcspn(text, "\n");
    if (text[line]) return error_set(err, "%.*s: a report holds options of one line", line, text);
    char *copy = strdup(text);
    if (!copy) return error_set(err, "%s: out of memory", text);
    report->arguments[report->argument_count++] = copy;
    return true;
}

void report_free(struct report *report)
{
    for (size_t i = 0; i < report->argument_count; i++)
        free(report->arguments[i]);
    report->argument_count = 0;
}
