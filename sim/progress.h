/* SPDX-License-Identifier: MIT
 *
 * How far long work has come: a line on standard error, if that is a terminal, and nothing else. */
#ifndef SIM_PROGRESS_H
#define SIM_PROGRESS_H

/* Replaces the line. */
void progress(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Clears it, before anything else is printed. */
void progress_end(void);

#endif
