/* SPDX-License-Identifier: MIT
 *
 * `limner replay`: unpacks a report into a folder of its own, runs it there, and compares what comes of it. */
#include "base/arguments.h"
#include "base/printable.h"
#include "cli/commands.h"
#include "cli/report_file.h"
#include "cli/report_run.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define NEW_HASHES_NAME "now.hashes"

struct replay {
    struct report *report;
    struct work_folder folder;
    struct outputs outputs;
    const char *path, *new_path;
};

static bool parse(struct replay *replay, int argc, char **argv, struct error *err)
{
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "-o") == 0) {
            if (++i == argc) return error_set(err, "-o: needs a value");
            replay->new_path = argv[i];
        } else if (argv[i][0] == '-' && argv[i][1]) {
            return error_no_option(err, argv[i]);
        } else if (replay->path) {
            return error_set(err, "replay: one report at a time, what is '%s'?", argv[i]);
        } else {
            replay->path = argv[i];
        }
    }
    return replay->path || error_set(err, "replay: needs a report");
}

/* A crash is a bug for as long as there is one; what ended in one has no frames to compare. */
static bool compare(const struct replay *replay, const struct report_result *now, struct error *err)
{
    const struct report *then = replay->report;
    if (now->outcome == REPORT_CRASHED) return error_set(err, "%s: render ends by %s", replay->path, now->reason);
    if (then->outcome == REPORT_DRAWN)
        return now->outcome == REPORT_DRAWN || error_set(err, "%s: %s", replay->path, now->reason);
    if (then->outcome == REPORT_CRASHED) return true;
    if (now->outcome == REPORT_DRAWN)
        return error_set(err, "%s: is drawn now, and was refused: %s", replay->path, then->reason);
    return strcmp(now->reason, then->reason) == 0 ||
           error_set(err, "%s: refused for another reason: %s", replay->path, now->reason);
}

/* The report with other hashes, and another outcome. */
static bool write_anew(struct replay *replay, const struct report_result *now, struct error *err)
{
    struct report *report = replay->report;
    char from[sizeof replay->folder.path + 32], to[sizeof replay->folder.path + 32];
    snprintf(from, sizeof from, "%s/%s", replay->folder.path, NEW_HASHES_NAME);
    snprintf(to, sizeof to, "%s/%s", replay->folder.path, REPORT_HASHES_NAME);
    for (size_t i = 0; i < report->file_count; i++)
        if (strcmp(report->files[i].name, REPORT_HASHES_NAME) == 0)
            memmove(&report->files[i], &report->files[i + 1], (--report->file_count - i) * sizeof *report->files);
    report->outcome = now->outcome;
    memcpy(report->reason, now->reason, sizeof report->reason);
    if (now->outcome == REPORT_DRAWN && rename(from, to) != 0) return error_set(err, "%s: %s", to, strerror(errno));
    return (now->outcome != REPORT_DRAWN || report_add(report, &replay->folder, REPORT_HASHES_NAME, err)) &&
           report_write(report, &replay->folder, replay->new_path, &replay->outputs, err) &&
           outputs_keep(&replay->outputs, err);
}

static bool run(struct replay *replay, struct error *err)
{
    struct report_result now;
    if (!work_folder_make(&replay->folder, err) || !report_read(replay->report, &replay->folder, replay->path, err))
        return false;
    const bool checks = replay->report->outcome == REPORT_DRAWN && !replay->new_path;
    if (!report_run(replay->report, &replay->folder,
                    checks ? "--check=" REPORT_HASHES_NAME : "--write-hashes=" NEW_HASHES_NAME, &now, err))
        return false;
    if (replay->new_path) return write_anew(replay, &now, err);
    if (!compare(replay, &now, err)) return false;
    printable_print(stdout, "%s: %s%s\n", replay->path,
                    now.outcome == REPORT_DRAWN ? "all frames are the same" : "refused as before: ", now.reason);
    return true;
}

int cmd_replay(int argc, char **argv)
{
    struct replay replay = {.report = calloc(1, sizeof *replay.report)};
    struct error err;
    bool ok = replay.report || error_set(&err, "out of memory");
    ok = ok && parse(&replay, argc, argv, &err) && run(&replay, &err);
    outputs_discard(&replay.outputs);
    work_folder_remove(&replay.folder);
    if (replay.report) report_free(replay.report);
    free(replay.report);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
