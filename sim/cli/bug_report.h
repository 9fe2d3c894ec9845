/* SPDX-License-Identifier: MIT
 *
 * What a report is about: what `limner render` was given, and what came of it. */
#ifndef SIM_BUG_REPORT_H
#define SIM_BUG_REPORT_H

#include "base/error.h"
#include "base/work_folder.h"

#include <stddef.h>
#include <stdint.h>

enum {
    REPORT_FILES_MAX = 1000,
    REPORT_ARGUMENTS_MAX = 100,
    REPORT_NAME_B = 200,
    REPORT_TEXT_B = 1 << 20, /* of report.txt */
    REPORT_TOTAL_B = 1 << 28 /* of all files */
};
#define REPORT_TEXT_NAME "report.txt"
#define REPORT_HASHES_NAME "frames.hashes"
#define REPORT_CAMERAS_NAME "cameras.cam"
#define REPORT_IDS_OPTION "--ids=faces.ids" /* what --ids becomes: faces keep their numbers with it */
#define REPORT_SCENE_FOLDER "scene/"
#define REPORT_UP_FOLDER "up/" /* what stands for each folder above the model's that a name of its leads to */

struct report_file {
    char name[REPORT_NAME_B]; /* within the report */
    uint32_t size_b, crc32;   /* zlib's */
};

enum report_outcome { REPORT_DRAWN, REPORT_REFUSED, REPORT_CRASHED };

struct report {
    struct report_file files[REPORT_FILES_MAX]; /* all but report.txt */
    size_t file_count, total_b;
    char *arguments[REPORT_ARGUMENTS_MAX]; /* of render, but for the scene's name */
    size_t argument_count;
    char scene[REPORT_NAME_B]; /* a name among the files */
    enum report_outcome outcome;
    char reason[sizeof((struct error *)0)->text]; /* how it was refused, or ended */
};

/* Whether a file may have that name in a report: one of the names above, or scene/ and a path that goes no way up. */
bool report_name_is_allowed(const char *name);

/* Takes a file of the work folder into the list. */
bool report_add(struct report *report, const struct work_folder *folder, const char *name, struct error *err);

/* Takes one of render's options into the list: a line of text. */
bool report_add_argument(struct report *report, const char *text, struct error *err);

void report_free(struct report *report);

#endif
