/* SPDX-License-Identifier: MIT
 *
 * report.txt: a line a thing, `key: value`, after a first line that says what it is. */
#ifndef SIM_REPORT_TEXT_H
#define SIM_REPORT_TEXT_H

#include "cli/bug_report.h"

/* The caller frees *text. */
bool report_text_make(const struct report *report, char **text, size_t *text_b, struct error *err);

/* `text` ends with a zero, and is changed. Refuses what does not describe a command line of render within the report's
 * own files. */
bool report_text_parse(struct report *report, char *text, size_t text_b, struct error *err);

#endif
