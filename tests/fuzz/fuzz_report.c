/* SPDX-License-Identifier: MIT
 *
 * Any bytes as a report. Behind "raw" they are the file; else each part up to a byte 0xFF is an entry of a tar archive:
 * a byte that says of what kind it is, a name up to a newline, and its contents. The first entry's lines `list` become
 * the list of the others with their sizes and checksums. It is refused in one line, with nothing outside of its folder;
 * or what was read is written and read again, and is the same. */
#include "cli/report_file.h"
#include "fuzz.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

enum { MARK = 0xFF, ENTRIES_MAX = 8, BLOCK_B = 512, FILE_MAX_B = 1 << 16, NAME_MAX_B = 100 };

struct entry {
    char name[NAME_MAX_B];
    char kind; /* of tar: a digit */
    const uint8_t *bytes;
    size_t size_b;
};

struct archive_file {
    uint8_t bytes[FILE_MAX_B];
    size_t size_b;
};

/* POSIX.1-1988, ustar: octal numbers, and a sum of all bytes with blanks where it goes itself. */
static void add_entry(struct archive_file *file, const struct entry *entry)
{
    const size_t padded_b = (entry->size_b + BLOCK_B - 1) / BLOCK_B * BLOCK_B;
    char *head = (char *)file->bytes + file->size_b;
    unsigned sum = 0;

    if (file->size_b + BLOCK_B + padded_b > FILE_MAX_B) return;
    memset(head, 0, BLOCK_B + padded_b);
    memcpy(head, entry->name, strlen(entry->name));
    memcpy(head + 100, "0000644", 7);
    snprintf(head + 124, 12, "%011zo", entry->size_b);
    memcpy(head + 136, "00000000000", 11);
    memcpy(head + 148, "        ", 8);
    head[156] = entry->kind;
    if (entry->kind == '1' || entry->kind == '2') memcpy(head + 157, "report.txt", 10);
    memcpy(head + 257, "ustar\00000", 8);
    for (int i = 0; i < BLOCK_B; i++)
        sum += (uint8_t)head[i];
    snprintf(head + 148, 8, "%06o", sum);
    if (entry->size_b) memcpy(head + BLOCK_B, entry->bytes, entry->size_b);
    file->size_b += BLOCK_B + padded_b;
}

static struct entry next_entry(struct fuzz_bytes *bytes)
{
    struct fuzz_bytes part = fuzz_part(bytes, MARK);
    const uint8_t kind = fuzz_u8(&part);
    struct entry entry = {.kind = kind >= '1' && kind <= '7' ? (char)kind : '0'};
    const struct fuzz_bytes name = fuzz_part(&part, '\n');

    if (name.left_b) memcpy(entry.name, name.at, name.left_b < NAME_MAX_B ? name.left_b : NAME_MAX_B - 1);
    entry.bytes = part.at;
    entry.size_b = part.left_b;
    return entry;
}

/* Its text with the list in place of the lines `list`; to be freed. */
static char *listed_text(struct entry entries[], size_t count)
{
    char *text = NULL;
    size_t text_b = 0;
    FILE *out = open_memstream(&text, &text_b);
    struct fuzz_bytes left = {entries[0].bytes, entries[0].size_b};

    if (!out) abort();
    while (left.left_b) {
        const struct fuzz_bytes line = fuzz_part(&left, '\n');
        const bool is_list = line.left_b == 4 && memcmp(line.at, "list", 4) == 0;
        if (!is_list) fprintf(out, "%.*s\n", (int)line.left_b, (const char *)line.at);
        for (size_t i = 1; i < count && is_list; i++)
            fprintf(out, "file: %zu %08lx %s\n", entries[i].size_b,
                    crc32(0, entries[i].size_b ? entries[i].bytes : (const uint8_t *)"", (uInt)entries[i].size_b),
                    entries[i].name);
    }
    if (fclose(out) != 0) abort();
    entries[0].bytes = (const uint8_t *)text;
    entries[0].size_b = text_b;
    return text;
}

static void make_archive(struct archive_file *file, struct fuzz_bytes bytes)
{
    struct entry entries[ENTRIES_MAX];
    size_t count = 0;

    file->size_b = 0;
    for (; count < ENTRIES_MAX && (bytes.left_b || !count); count++)
        entries[count] = next_entry(&bytes);
    char *text = listed_text(entries, count);
    for (size_t i = 0; i < count; i++)
        add_entry(file, &entries[i]);
    free(text);
    if (file->size_b + 2 * BLOCK_B <= FILE_MAX_B) {
        memset(file->bytes + file->size_b, 0, 2 * BLOCK_B);
        file->size_b += 2 * BLOCK_B;
    }
}

/* Promises -------------------------------------------------------------------------------------- */

static const char *check_files(const struct report *report, const struct work_folder *folder)
{
    for (size_t i = 0; i < report->file_count; i++) {
        char path[1024];
        struct stat status;
        snprintf(path, sizeof path, "%s/%s", folder->path, report->files[i].name);
        if (lstat(path, &status) != 0 || !S_ISREG(status.st_mode)) return "a file of the report is no plain file";
        if ((size_t)status.st_size != report->files[i].size_b) return "a file of the report has another size";
        if (strncmp(report->files[i].name, "../", 3) == 0 || strstr(report->files[i].name, "/../")) return "a way up";
    }
    return report->scene[0] ? NULL : "a report without a scene";
}

static bool are_same(const struct report *a, const struct report *b)
{
    bool same = a->file_count == b->file_count && a->argument_count == b->argument_count && a->outcome == b->outcome &&
                strcmp(a->scene, b->scene) == 0 && strcmp(a->reason, b->reason) == 0;
    for (size_t i = 0; same && i < a->file_count; i++)
        same = strcmp(a->files[i].name, b->files[i].name) == 0 && a->files[i].crc32 == b->files[i].crc32;
    for (size_t i = 0; same && i < a->argument_count; i++)
        same = strcmp(a->arguments[i], b->arguments[i]) == 0;
    return same;
}

static const char *read_in(struct report *report, struct work_folder *folder, const char *path, bool *ok)
{
    char outside[sizeof folder->path + 16];
    struct error err;

    if (!work_folder_make(folder, &err)) abort();
    *ok = report_read(report, folder, path, &err);
    snprintf(outside, sizeof outside, "%s/../escaped", folder->path);
    if (access(outside, F_OK) == 0) return "a file outside of the folder";
    return *ok ? check_files(report, folder) : fuzz_check_refusal(err.text, path);
}

static const char *check_again(const struct report *report, const struct work_folder *folder)
{
    struct report *again = calloc(1, sizeof *again);
    struct work_folder second = {.path = ""};
    struct outputs outputs = {0};
    struct error err;
    char path[512];
    bool ok = false;

    if (!again) abort();
    snprintf(path, sizeof path, "%s", fuzz_as_named_file("again.report", NULL, 0));
    const char *broken = NULL;
    if (!report_write(report, folder, path, &outputs, &err) || !outputs_keep(&outputs, &err))
        broken = "a report that was read cannot be written";
    else
        broken = read_in(again, &second, path, &ok);
    if (!broken && !(ok && are_same(report, again))) broken = "a report was written otherwise than it was read";
    outputs_discard(&outputs);
    work_folder_remove(&second);
    report_free(again);
    free(again);
    return broken;
}

static const char *run(const uint8_t *bytes, size_t size_b)
{
    static struct archive_file file;
    struct report *report = calloc(1, sizeof *report);
    struct work_folder folder = {.path = ""};
    bool ok, is_raw = size_b >= 3 && memcmp(bytes, "raw", 3) == 0;

    if (!report) abort();
    if (!is_raw) make_archive(&file, (struct fuzz_bytes){bytes, size_b});
    const char *path = is_raw ? fuzz_as_file(bytes + 3, size_b - 3) : fuzz_as_file(file.bytes, file.size_b);
    const char *broken = read_in(report, &folder, path, &ok);
    if (!broken && ok) broken = check_again(report, &folder);
    work_folder_remove(&folder);
    report_free(report);
    free(report);
    return broken;
}

const struct fuzz_target fuzz_report = {"report", run, NULL};
