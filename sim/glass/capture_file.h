/* SPDX-License-Identifier: MIT
 *
 * Files of captures: which kind one is, and reading it. */
#ifndef SIM_CAPTURE_FILE_H
#define SIM_CAPTURE_FILE_H

#include "glass/capture.h"

#include <stdio.h>

/* Whether the file, which is at its start, is a capture; else it is text that somebody else reads. Its first blank
 * lines are skipped, and counted. */
enum capture_kind { CAPTURE_NONE, CAPTURE_VCD, CAPTURE_SIGROK };
enum capture_kind capture_kind_of(FILE *file, size_t *lines);

/* Reads all of it, or until on_frame() wants no more. An error names the file, and a line or the time. */
bool capture_read(struct capture *capture, enum capture_kind kind, FILE *file, struct error *err);

#endif
