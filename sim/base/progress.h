/* SPDX-License-Identifier: MIT
 *
 * How far long work has come: a line on standard error if that is a terminal. On a pipe a line each 10 seconds, or as
 * many as LIMNER_PROGRESS in the environment says; 0: none. */
#ifndef SIM_PROGRESS_H
#define SIM_PROGRESS_H

#include <stddef.h>

/* Replaces the line. */
void progress(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* The same with a bar in front: `done` of `all`. Costs little where nothing is shown, or the bar has not changed. */
void progress_bar(size_t done, size_t all, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* To be called in all that may take long, and by deadline_passed(): on a pipe it tells again what is being done. */
void progress_beat(void);

/* Clears it, before anything else is printed. */
void progress_end(void);

#endif
