/* SPDX-License-Identifier: MIT
 *
 * Runs `limner render` on a report's files, in a process of its own: what crashes there does not crash here. */
#ifndef SIM_REPORT_RUN_H
#define SIM_REPORT_RUN_H

#include "cli/report_file.h"

struct report_result {
    enum report_outcome outcome;
    char reason[sizeof((struct error *)0)->text];
};

/* Runs it in the folder, with one option more (--check=... or --write-hashes=...). false: it could not be started. */
bool report_run(const struct report *report, const struct work_folder *folder, const char *option,
                struct report_result *result, struct error *err);

#endif
