/* SPDX-License-Identifier: MIT
 *
 * A report as one file that anybody can run again: an uncompressed tar archive of plain files; report.txt, the first of
 * them, says what the others are. sim/DESIGN.md has the format, and what a reader refuses. */
#ifndef SIM_REPORT_FILE_H
#define SIM_REPORT_FILE_H

#include "cli/bug_report.h"
#include "outputs/outputs.h"

/* Writes the report; the files' contents are those in the folder. */
bool report_write(const struct report *report, const struct work_folder *folder, const char *path,
                  struct outputs *outputs, struct error *err);

/* Reads a report and lays its files into the folder, which is empty. *report must be zero, and is the caller's to
 * free. */
bool report_read(struct report *report, const struct work_folder *folder, const char *path, struct error *err);

#endif
