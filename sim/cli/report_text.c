/* SPDX-License-Identifier: MIT
 *
 * Keys: scene, option, outcome, file; the others, which say with what it was made, are for people. */
#include "cli/report_text.h"

#include "base/versions.h"
#include "cli/options.h"
#include "levels/level_path.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

static const char FIRST_LINE[] = "limner report 1";
static const char *const OUTCOMES[] = {
    [REPORT_DRAWN] = "drawn", [REPORT_REFUSED] = "refused", [REPORT_CRASHED] = "crashed"};

/* Making -------------------------------------------------------------------------------------- */

static void print(const struct report *report, FILE *out)
{
    fprintf(out, "%s\n", FIRST_LINE);
    versions_print(out);
    fprintf(out, "scene: %s\n", report->scene);
    for (size_t i = 0; i < report->argument_count; i++)
        fprintf(out, "option: %s\n", report->arguments[i]);
    fprintf(out, "outcome: %s%s%s\n", OUTCOMES[report->outcome], report->reason[0] ? " " : "", report->reason);
    for (size_t i = 0; i < report->file_count; i++)
        fprintf(out, "file: %" PRIu32 " %08" PRIx32 " %s\n", report->files[i].size_b, report->files[i].crc32,
                report->files[i].name);
}

bool report_text_make(const struct report *report, char **text, size_t *text_b, struct error *err)
{
    FILE *out = open_memstream(text, text_b);
    if (!out) return error_set(err, "%s: out of memory", REPORT_TEXT_NAME);
    print(report, out);
    if (fclose(out) != 0) return error_set(err, "%s: out of memory", REPORT_TEXT_NAME);
    return *text_b <= REPORT_TEXT_B || error_set(err, "%s: longer than 1 MB", REPORT_TEXT_NAME);
}

/* Parsing ------------------------------------------------------------------------------------- */

static bool is_listed(const struct report *report, const char *name)
{
    for (size_t i = 0; i < report->file_count; i++)
        if (strcmp(report->files[i].name, name) == 0) return true;
    return false;
}

static bool parse_file(struct report *report, const char *value, struct error *err)
{
    struct report_file file = {.size_b = 0};
    int at = 0;
    if (report->file_count == REPORT_FILES_MAX) return error_set(err, "more than %d files", REPORT_FILES_MAX);
    if (sscanf(value, "%9" SCNu32 " %8" SCNx32 " %n", &file.size_b, &file.crc32, &at) != 2 || !at ||
        !report_name_is_allowed(value + at) || strcmp(value + at, REPORT_TEXT_NAME) == 0 ||
        is_listed(report, value + at))
        return error_set(err, "'file: %s' says nothing", value);
    snprintf(file.name, sizeof file.name, "%s", value + at);
    report->files[report->file_count++] = file;
    return true;
}

static bool parse_outcome(struct report *report, const char *value, struct error *err)
{
    for (size_t i = 0; i < sizeof OUTCOMES / sizeof *OUTCOMES; i++) {
        const size_t length = strlen(OUTCOMES[i]);
        if (strncmp(value, OUTCOMES[i], length) != 0 || (value[length] && value[length] != ' ')) continue;
        report->outcome = (enum report_outcome)i;
        snprintf(report->reason, sizeof report->reason, "%s", value + length + (value[length] == ' '));
        return true;
    }
    return error_set(err, "'outcome: %s': there are drawn, refused and crashed", value);
}

/* A file, or a map of several. */
static bool is_scene(const struct report *report, const char *value,
                     bool (*is_good)(const struct report *, const char *))
{
    struct level_path level;
    char path[WAD_PATH_B];
    if (!level_path_parse(value, &level)) return is_good(report, value);
    for (size_t i = 0; wad_path_at(level.files, i, path); i++)
        if (!is_good(report, path)) return false;
    return true;
}

static bool is_allowed(const struct report *report, const char *name)
{
    (void)report;
    return report_name_is_allowed(name);
}

static bool parse_line(struct report *report, const char *key, const char *value, struct error *err)
{
    if (strcmp(key, "file") == 0) return parse_file(report, value, err);
    if (strcmp(key, "outcome") == 0) return parse_outcome(report, value, err);
    if (strcmp(key, "option") == 0) return report_add_argument(report, value, err);
    if (strcmp(key, "scene") != 0) return true;
    if (!is_scene(report, value, is_allowed)) return error_set(err, "'scene: %s' is not in the report", value);
    snprintf(report->scene, sizeof report->scene, "%s", value);
    return true;
}

/* Whoever replays a report did not choose its options: of files, they may name the report's own. */
static bool check_argument(const struct report *report, char *argument, struct error *err)
{
    char command[] = "render", *argv[] = {command, argument, NULL};
    struct given_option *given = NULL;
    const char *scene = NULL;
    size_t count = 0;
    if (strcmp(argument, "--trust-paths") == 0)
        return error_set(err, "'option: %s': a report trusts no paths", argument);
    if (model_options_knows(argument)) return true;
    bool ok = options_split(2, argv, &given, &count, &scene, err);
    if (ok && (count != 1 || scene)) ok = error_set(err, "'option: %s' is none", argument);
    if (ok && given->files == OPTION_READS_CAMERAS && strcmp(given->value, REPORT_CAMERAS_NAME) == 0)
        ok = is_listed(report, REPORT_CAMERAS_NAME) || error_set(err, "%s: is not in the report", REPORT_CAMERAS_NAME);
    else if (ok && given->files != OPTION_NAMES_NONE && strcmp(argument, REPORT_IDS_OPTION) != 0)
        ok = error_set(err, "'option: %s': a report names no files but its own", argument);
    free(given);
    return ok;
}

/* Cuts the next line off, or returns NULL. */
static char *next_line(char **text)
{
    char *line = *text;
    if (!*line) return NULL;
    const size_t length = strcspn(line, "\n");
    *text += length + (line[length] == '\n');
    line[length] = '\0';
    return line;
}

bool report_text_parse(struct report *report, char *text, size_t text_b, struct error *err)
{
    char *next = text;
    if (strlen(text) != text_b) return error_set(err, "%s: no text", REPORT_TEXT_NAME);
    const char *first = next_line(&next);
    if (!first || strcmp(first, FIRST_LINE) != 0)
        return error_set(err, "%s: does not begin with '%s'", REPORT_TEXT_NAME, FIRST_LINE);
    for (char *line; (line = next_line(&next));) {
        char *colon = strstr(line, ": ");
        if (!colon) continue;
        *colon = '\0';
        if (!parse_line(report, line, colon + 2, err)) return error_prefix(err, REPORT_TEXT_NAME);
    }
    bool ok = is_scene(report, report->scene, is_listed) || error_set(err, "its scene is not in the report");
    ok = ok && (report->outcome != REPORT_DRAWN || is_listed(report, REPORT_HASHES_NAME) ||
                error_set(err, "the frames' hashes are not in the report"));
    for (size_t i = 0; ok && i < report->argument_count; i++)
        ok = check_argument(report, report->arguments[i], err);
    return ok || error_prefix(err, REPORT_TEXT_NAME);
}
