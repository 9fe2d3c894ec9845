/* SPDX-License-Identifier: MIT
 *
 * `limner report-bug`: copies what render would read into a folder, runs it there, and packs the folder: so a report
 * that is written is one that can be run again. */
#include "base/inputs.h"
#include "base/printable.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/report_file.h"
#include "cli/report_run.h"
#include "levels/level_path.h"
#include "model/model.h"
#include "readers/model_import.h"
#include "scene/scene_files.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { PATH_MAX_B = 4096, BLOCK_B = 1 << 16 };
static const char DEFAULT_PATH[] = "limner-report.tar";

struct packing {
    struct report *report;
    struct work_folder folder;
    struct outputs outputs;
    const char *scene_path, *camera_path, *report_path;
    size_t folder_b; /* of scene_path, with its slash */
    size_t up;       /* how many folders above it the files that it names lie, at most */
};

/* Options ------------------------------------------------------------------------------------ */

static bool add_option(struct report *report, const char *name, const char *value, struct error *err)
{
    char text[REPORT_NAME_B];
    const int length = snprintf(text, sizeof text, "--%s%s%s", name, value ? "=" : "", value ? value : "");
    return length < (int)sizeof text ? report_add_argument(report, text, err)
                                     : error_set(err, "--%s: its value is too long", name);
}

/* Where outputs would go means nothing to what is drawn; that there are face numbers does, faces are not merged then.
 */
static bool take_option(struct packing *packing, const struct given_option *given, struct error *err)
{
    if (strcmp(given->name, "o") == 0) {
        packing->report_path = given->value;
        return true;
    }
    if (strcmp(given->name, "path") == 0)
        return error_set(err,
                         "--path: a report holds one list of cameras, those of --camera; leave it out, or name what "
                         "was chosen by --method and --tree");
    if (strcmp(given->name, "ids") == 0) return report_add_argument(packing->report, REPORT_IDS_OPTION, err);
    if (given->files == OPTION_NAMES_FILE) return true;
    const char *value = given->value;
    if (given->files == OPTION_READS_CAMERAS) {
        packing->camera_path = value;
        value = REPORT_CAMERAS_NAME;
    }
    return add_option(packing->report, given->name, value, err);
}

/* What render would not take at all is a mistake, not a bug to be reported. */
static bool check_command(struct packing *packing, struct error *err)
{
    char *argv[REPORT_ARGUMENTS_MAX + 3], command[] = "report-bug", scene[PATH_MAX_B];
    int argc = 0;
    struct options options;
    snprintf(scene, sizeof scene, "%s", packing->scene_path);
    argv[argc++] = command;
    for (size_t i = 0; i < packing->report->argument_count; i++)
        argv[argc++] = packing->report->arguments[i];
    argv[argc++] = scene;
    argv[argc] = NULL;
    return options_parse(argc, argv, OPTIONS_RENDER, &options, err);
}

/* What was taken out of the command line before. */
static bool add_model_options(struct report *report, struct error *err)
{
    const struct model_options *given = model_options_given();
    for (size_t i = 0; i < given->count; i++)
        if (!add_option(report, given->items[i].name, given->items[i].value, err)) return false;
    return true;
}

static bool parse(struct packing *packing, int argc, char **argv, struct error *err)
{
    struct given_option *given = NULL;
    size_t count = 0;
    bool ok = options_split(argc, argv, &given, &count, &packing->scene_path, err);
    packing->report_path = DEFAULT_PATH;
    for (size_t i = 0; ok && i < count; i++)
        ok = take_option(packing, &given[i], err);
    free(given);
    if (ok && !packing->scene_path) return error_set(err, "report-bug: needs a model or a .lim file");
    return ok && check_command(packing, err) && add_model_options(packing->report, err);
}

/* Files --------------------------------------------------------------------------------------- */

static bool copy_stream(FILE *from, FILE *to)
{
    char block[BLOCK_B];
    size_t got_b, total_b = 0;
    while ((got_b = fread(block, 1, sizeof block, from)) > 0 && total_b <= REPORT_TOTAL_B) {
        if (fwrite(block, 1, got_b, to) != got_b) return false;
        total_b += got_b;
    }
    return !ferror(from);
}

static bool copy_file(const char *path, const struct work_folder *folder, const char *name, struct error *err)
{
    char place[PATH_MAX_B];
    struct stat status;
    if (stat(path, &status)) return error_set(err, "%s: %s", path, strerror(errno));
    if (!S_ISREG(status.st_mode)) return error_set(err, "%s: is not a regular file", path);
    if (status.st_size > REPORT_TOTAL_B)
        return error_set(err, "%s: a report holds %d MB at most", path, REPORT_TOTAL_B >> 20);
    if (!work_folder_place(folder, name, place, sizeof place, err)) return false;
    FILE *from = fopen(path, "rb"), *to = fopen(place, "wb");
    bool ok = from && to && copy_stream(from, to);
    if (!ok) error_set(err, "%s: cannot be copied: %s", path, strerror(errno));
    if (to && fclose(to) != 0 && ok) ok = error_set(err, "%s: cannot be copied: %s", path, strerror(errno));
    if (from) fclose(from);
    return ok;
}

/* What a path says behind the model's folder; NULL: it does not begin with that. *up: how many folders it goes up
 * first.
 */
static const char *behind_folder(const struct packing *packing, const char *path, size_t *up)
{
    *up = 0;
    if (strncmp(path, packing->scene_path, packing->folder_b) != 0 || (!packing->folder_b && path[0] == '/'))
        return NULL;
    for (path += packing->folder_b;;) {
        const size_t length = strcspn(path, "/");
        const bool goes_up = length == 2 && path[0] == '.' && path[1] == '.';
        const bool is_step = path[length] && (length == 0 || (length == 1 && *path == '.'));
        if (!goes_up && !is_step) return path;
        *up += goes_up;
        path += length + (path[length] == '/');
    }
}

/* A path becomes a name in the report: folders above the model's have no name of their own there; steps that go nowhere
 * are left out. */
static bool name_in_report(const struct packing *packing, const char *path, char name[PATH_MAX_B], struct error *err)
{
    size_t up, at = (size_t)snprintf(name, PATH_MAX_B, "%s", REPORT_SCENE_FOLDER);
    const char *part = behind_folder(packing, path, &up);
    if (!part)
        return error_set(err, "%s: is not named by its way from the model's folder; in a report it could not be found",
                         path);
    const bool is_ours = packing->up && strncmp(part, REPORT_UP_FOLDER, strlen(REPORT_UP_FOLDER)) == 0;
    for (; up < packing->up && at < REPORT_NAME_B; up++)
        at += (size_t)snprintf(name + at, PATH_MAX_B - at, "%s", REPORT_UP_FOLDER);
    while (*part) {
        const size_t length = strcspn(part, "/");
        const bool is_step = length == 0 || (length == 1 && *part == '.');
        if (at + length + 2 > PATH_MAX_B) return error_set(err, "%s: the path is too long", path);
        if (!is_step)
            at += (size_t)snprintf(name + at, PATH_MAX_B - at, "%.*s%s", (int)length, part, part[length] ? "/" : "");
        part += length + (part[length] == '/');
    }
    return (!is_ours && report_name_is_allowed(name)) || error_set(err, "%s: its name cannot be in a report", path);
}

static bool pack_input(struct packing *packing, const char *path, struct error *err)
{
    char name[PATH_MAX_B];
    if (!name_in_report(packing, path, name, err)) return false;
    for (size_t i = 0; i < packing->report->file_count; i++)
        if (strcmp(packing->report->files[i].name, name) == 0) return true;
    return copy_file(path, &packing->folder, name, err) && report_add(packing->report, &packing->folder, name, err);
}

/* What it reads until it ends, well or not: then inputs.h has it. */
static void read_inputs(const struct packing *packing)
{
    struct model model;
    struct error ignored;
    if (!lim_file_is_named(packing->scene_path) && model_import(packing->scene_path, &model, &ignored))
        model_free(&model);
}

static void look_up(struct packing *packing, const char *path)
{
    size_t up;
    behind_folder(packing, path, &up);
    if (up > packing->up) packing->up = up;
}

/* A map's WADs, and as what the report's scene is named then. */
static bool pack_wads(struct packing *packing, const struct level_path *level, struct error *err)
{
    char *scene = packing->report->scene, path[WAD_PATH_B], name[PATH_MAX_B];
    size_t at = 0;
    for (size_t i = 0; wad_path_at(level->files, i, path); i++) {
        if (!pack_input(packing, path, err) || !name_in_report(packing, path, name, err)) return false;
        at += (size_t)snprintf(scene + at, REPORT_NAME_B - at, "%s%s", i ? "+" : "", name);
        if (at >= REPORT_NAME_B) return error_set(err, "%s: the path is too long", packing->scene_path);
    }
    at += (size_t)snprintf(scene + at, REPORT_NAME_B - at, "%s", level_path_tail(packing->scene_path));
    return at < REPORT_NAME_B || error_set(err, "%s: the path is too long", packing->scene_path);
}

static bool pack_scene(struct packing *packing, struct error *err)
{
    struct level_path level;
    if (level_path_parse(packing->scene_path, &level)) return pack_wads(packing, &level, err);
    if (!pack_input(packing, packing->scene_path, err)) return false;
    snprintf(packing->report->scene, sizeof packing->report->scene, "%s", packing->report->files[0].name);
    return true;
}

/* Of several files, the first one's. */
static size_t folder_length(const char *scene_path)
{
    char path[WAD_PATH_B];
    wad_path_at(scene_path, 0, path);
    const char *slash = strrchr(path, '/');
    return slash ? (size_t)(slash - path) + 1 : 0;
}

static bool pack_inputs(struct packing *packing, struct error *err)
{
    packing->folder_b = folder_length(packing->scene_path);
    read_inputs(packing);
    for (size_t i = 0; i < inputs_count(); i++)
        look_up(packing, inputs_path(i));
    bool ok = pack_scene(packing, err);
    for (size_t i = 0; ok && i < inputs_count(); i++)
        ok = pack_input(packing, inputs_path(i), err);
    return ok;
}

static bool pack_cameras(struct packing *packing, struct error *err)
{
    return !packing->camera_path || (copy_file(packing->camera_path, &packing->folder, REPORT_CAMERAS_NAME, err) &&
                                     report_add(packing->report, &packing->folder, REPORT_CAMERAS_NAME, err));
}

/* The report ---------------------------------------------------------------------------------- */

static void print_contents(const struct packing *packing)
{
    const struct report *report = packing->report;
    printable_print(stdout, "%s: %s%s\n", packing->report_path,
                    report->outcome == REPORT_DRAWN     ? "all frames are drawn"
                    : report->outcome == REPORT_REFUSED ? "render says: "
                                                        : "render ends by ",
                    report->reason);
    printf(
        "It holds versions, options and these files, and no names of folders, users or machines but those in them:\n");
    for (size_t i = 0; i < report->file_count; i++)
        printable_print(stdout, "%10lu bytes  %s\n", (unsigned long)report->files[i].size_b, report->files[i].name);
    printable_print(stdout, "`tar -tf` lists it, `limner replay %s` runs it again.\n", packing->report_path);
}

static bool pack(struct packing *packing, struct error *err)
{
    struct report *report = packing->report;
    struct report_result result;
    if (!work_folder_make(&packing->folder, err) || !pack_inputs(packing, err) || !pack_cameras(packing, err) ||
        !report_run(report, &packing->folder, "--write-hashes=" REPORT_HASHES_NAME, &result, err))
        return false;
    report->outcome = result.outcome;
    memcpy(report->reason, result.reason, sizeof report->reason);
    return (result.outcome != REPORT_DRAWN || report_add(report, &packing->folder, REPORT_HASHES_NAME, err)) &&
           report_write(report, &packing->folder, packing->report_path, &packing->outputs, err) &&
           outputs_keep(&packing->outputs, err);
}

int cmd_report_bug(int argc, char **argv)
{
    struct packing packing = {.report = calloc(1, sizeof *packing.report)};
    struct error err;
    bool ok = packing.report || error_set(&err, "out of memory");
    ok = ok && parse(&packing, argc, argv, &err) && pack(&packing, &err);
    if (ok) print_contents(&packing);
    outputs_discard(&packing.outputs);
    work_folder_remove(&packing.folder);
    if (packing.report) report_free(packing.report);
    free(packing.report);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
