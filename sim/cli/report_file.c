/* SPDX-License-Identifier: MIT
 *
 * libarchive reads and writes tar; what of it a report may be is checked here, before anything is written. Nothing
 * leads out of the folder: names are checked, only plain files are made, and each is new. */
#include "cli/report_file.h"

#include "cli/report_text.h"

#include <archive.h>
#include <archive_entry.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { PATH_MAX_B = 1024, BLOCK_B = 1 << 16 };

/* Writing --------------------------------------------------------------------------------------- */

/* Owner, time and the machine's name are left out. */
static bool write_entry(struct archive *archive, const char *name, const void *bytes, size_t size_b, struct error *err)
{
    struct archive_entry *entry = archive_entry_new();
    if (!entry) return error_set(err, "%s: out of memory", name);
    archive_entry_set_pathname(entry, name);
    archive_entry_set_filetype(entry, AE_IFREG);
    archive_entry_set_perm(entry, 0644);
    archive_entry_set_size(entry, (la_int64_t)size_b);
    archive_entry_set_mtime(entry, 0, 0);
    const bool ok = archive_write_header(archive, entry) == ARCHIVE_OK &&
                    archive_write_data(archive, bytes, size_b) == (la_ssize_t)size_b;
    archive_entry_free(entry);
    return ok || error_set(err, "%s: %s", name, archive_error_string(archive));
}

static bool write_file(struct archive *archive, const struct work_folder *folder, const struct report_file *file,
                       struct error *err)
{
    char path[PATH_MAX_B];
    if (!work_folder_place(folder, file->name, path, sizeof path, err)) return false;
    FILE *stream = fopen(path, "rb");
    char *bytes = malloc(file->size_b + (size_t)1);
    bool ok = stream && bytes && fread(bytes, 1, file->size_b, stream) == file->size_b;
    if (!ok) error_set(err, "%s: cannot be read", file->name);
    ok = ok && write_entry(archive, file->name, bytes, file->size_b, err);
    free(bytes);
    if (stream) fclose(stream);
    return ok;
}

static bool write_entries(struct archive *archive, const struct report *report, const struct work_folder *folder,
                          struct error *err)
{
    char *text = NULL;
    size_t text_b = 0;
    bool ok =
        report_text_make(report, &text, &text_b, err) && write_entry(archive, REPORT_TEXT_NAME, text, text_b, err);
    for (size_t i = 0; ok && i < report->file_count; i++)
        ok = write_file(archive, folder, &report->files[i], err);
    free(text);
    return ok;
}

bool report_write(const struct report *report, const struct work_folder *folder, const char *path,
                  struct outputs *outputs, struct error *err)
{
    FILE *file = outputs_open(outputs, path, err);
    if (!file) return false;
    struct archive *archive = archive_write_new();
    bool ok = archive && archive_write_set_format_ustar(archive) == ARCHIVE_OK &&
              archive_write_set_bytes_in_last_block(archive, 1) == ARCHIVE_OK &&
              archive_write_open_FILE(archive, file) == ARCHIVE_OK;
    if (!ok) error_set(err, "%s: %s", path, archive ? archive_error_string(archive) : "out of memory");
    ok = ok && write_entries(archive, report, folder, err);
    if (archive && archive_write_free(archive) != ARCHIVE_OK && ok) ok = error_set(err, "%s: cannot be written", path);
    return outputs_close(file, path, err) && ok;
}

/* Reading --------------------------------------------------------------------------------------- */

static bool copy_data(struct archive *archive, FILE *to, uint64_t size_b, const char *name, struct error *err)
{
    char block[BLOCK_B];
    la_ssize_t got_b;
    uint64_t at_b = 0;
    while ((got_b = archive_read_data(archive, block, sizeof block)) > 0) {
        at_b += (uint64_t)got_b;
        if (at_b > size_b) return error_set(err, "%s: longer than it says", name);
        if (fwrite(block, 1, (size_t)got_b, to) != (size_t)got_b)
            return error_set(err, "%s: %s", name, strerror(errno));
    }
    if (got_b < 0) return error_set(err, "%s: %s", name, archive_error_string(archive));
    return at_b == size_b || error_set(err, "%s: shorter than it says", name);
}

static bool lay_file(struct archive *archive, const struct work_folder *folder, const char *name, uint64_t size_b,
                     struct error *err)
{
    char path[PATH_MAX_B];
    if (!work_folder_place(folder, name, path, sizeof path, err)) return false;
    const int descriptor = open(path, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, 0600);
    if (descriptor < 0) return error_set(err, "%s: %s", name, errno == EEXIST ? "there twice" : strerror(errno));
    FILE *file = fdopen(descriptor, "wb");
    if (!file) return close(descriptor), error_set(err, "%s: %s", name, strerror(errno));
    const bool ok = copy_data(archive, file, size_b, name, err);
    return (fclose(file) == 0 || error_set(err, "%s: %s", name, strerror(errno))) && ok;
}

static bool check_entry(struct archive_entry *entry, bool is_first, uint64_t room_b, struct error *err)
{
    const char *name = archive_entry_pathname(entry);
    if (!name) return error_set(err, "a file without a name");
    if (!report_name_is_allowed(name) || is_first != (strcmp(name, REPORT_TEXT_NAME) == 0))
        return error_set(err, "%s: no file that a report has %s", name, is_first ? "first" : "there");
    if (archive_entry_filetype(entry) != AE_IFREG || archive_entry_hardlink(entry) || archive_entry_symlink(entry))
        return error_set(err, "%s: not a plain file", name);
    const la_int64_t size_b = archive_entry_size(entry);
    if (!archive_entry_size_is_set(entry) || size_b < 0 || (uint64_t)size_b > room_b)
        return error_set(err, "%s: too large; a report holds %d MB at most", name, REPORT_TOTAL_B >> 20);
    return !is_first || size_b <= REPORT_TEXT_B || error_set(err, "%s: longer than 1 MB", name);
}

static bool read_entries(struct archive *archive, const struct work_folder *folder, size_t *count, struct error *err)
{
    struct archive_entry *entry;
    uint64_t total_b = 0;
    int got;
    for (*count = 0; (got = archive_read_next_header(archive, &entry)) == ARCHIVE_OK; ++*count) {
        if (*count > REPORT_FILES_MAX) return error_set(err, "more than %d files", REPORT_FILES_MAX);
        if (!check_entry(entry, *count == 0, REPORT_TOTAL_B - total_b, err)) return false;
        const uint64_t size_b = (uint64_t)archive_entry_size(entry);
        if (!lay_file(archive, folder, archive_entry_pathname(entry), size_b, err)) return false;
        total_b += size_b;
    }
    if (got != ARCHIVE_EOF) return error_set(err, "no report: %s", archive_error_string(archive));
    return *count > 0 || error_set(err, "no report: it is empty");
}

/* What report.txt lists is what is there. */
static bool check_list(const struct report *listed, const struct work_folder *folder, size_t entries, struct error *err)
{
    if (entries != listed->file_count + 1)
        return error_set(err, "%zu files beside report.txt, %zu are listed there", entries - 1, listed->file_count);
    struct report *found = calloc(1, sizeof *found);
    bool ok = found || error_set(err, "out of memory");
    for (size_t i = 0; ok && i < listed->file_count; i++) {
        const struct report_file *file = &listed->files[i];
        ok = report_add(found, folder, file->name, err) &&
             ((found->files[i].size_b == file->size_b && found->files[i].crc32 == file->crc32) ||
              error_set(err, "%s: damaged, it is not what report.txt lists", file->name));
    }
    free(found);
    return ok;
}

static bool read_text(struct report *report, const struct work_folder *folder, struct error *err)
{
    char path[PATH_MAX_B];
    if (!work_folder_place(folder, REPORT_TEXT_NAME, path, sizeof path, err)) return false;
    FILE *file = fopen(path, "rb");
    char *text = malloc(REPORT_TEXT_B + 1);
    const size_t size_b = file && text ? fread(text, 1, REPORT_TEXT_B, file) : 0;
    bool ok = file && text ? true : error_set(err, "%s: cannot be read", REPORT_TEXT_NAME);
    if (ok) text[size_b] = '\0';
    ok = ok && report_text_parse(report, text, size_b, err);
    free(text);
    if (file) fclose(file);
    return ok;
}

static bool check_is_file(const char *path, struct error *err)
{
    struct stat status;
    if (stat(path, &status)) return error_set(err, "%s", strerror(errno));
    if (!S_ISREG(status.st_mode)) return error_set(err, "is not a regular file");
    return status.st_size <= 2 * (off_t)REPORT_TOTAL_B || error_set(err, "too large for a report");
}

bool report_read(struct report *report, const struct work_folder *folder, const char *path, struct error *err)
{
    size_t entries = 0;
    if (!check_is_file(path, err)) return error_prefix(err, path);
    struct archive *archive = archive_read_new();
    bool ok = archive && archive_read_support_format_tar(archive) == ARCHIVE_OK;
    if (!ok) return archive_read_free(archive), error_set(err, "%s: out of memory", path);
    ok = archive_read_open_filename(archive, path, BLOCK_B) == ARCHIVE_OK ||
         error_set(err, "no report: %s", archive_error_string(archive));
    ok = ok && read_entries(archive, folder, &entries, err) && read_text(report, folder, err) &&
         check_list(report, folder, entries, err);
    archive_read_free(archive);
    return ok || error_prefix(err, path);
}
