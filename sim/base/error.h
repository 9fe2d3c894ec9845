/* SPDX-License-Identifier: MIT
 *
 * How host code reports what it cannot do: one line that names the thing and the reason.
 * Functions that can fail take a `struct error *`, return false, and leave nothing half-done. */
#ifndef SIM_ERROR_H
#define SIM_ERROR_H

#include <stdbool.h>

enum { ERROR_B = 1024 };

struct error {
    char text[ERROR_B]; /* one line, no newline, no program name in front */
};

/* Sets the text, printf-style, and returns false, so that callers can `return error_set(...)`.
 * What cannot be shown is replaced (printable.h): the text stays one line. */
bool error_set(struct error *err, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Puts "thing: " in front of the text, for callers who know the file where the callee did not.
 * Returns false. */
bool error_prefix(struct error *err, const char *thing);

/* A command does not have what it was given. Returns false. */
bool error_no_option(struct error *err, const char *given);

#endif
