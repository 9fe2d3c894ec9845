/* SPDX-License-Identifier: MIT
 *
 * How far long work has come: a line on standard error, if that is a terminal, and nothing else. */
#ifndef SIM_PROGRESS_H
#define SIM_PROGRESS_H

#include <stddef.h>

/* Replaces the line. */
void progress(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* The same with a bar in front: `done` of `all`. Costs little where nothing is shown, or the bar has not changed. */
void progress_bar(size_t done, size_t all, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Clears it, before anything else is printed. */
void progress_end(void);

#endif
