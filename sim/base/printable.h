/* SPDX-License-Identifier: MIT
 *
 * Text that came from somewhere else, a file, a library, a device, a command line, and is to be shown: on a terminal it
 * must neither move the cursor nor turn what is beside it round. */
#ifndef SIM_PRINTABLE_H
#define SIM_PRINTABLE_H

#include <stddef.h>
#include <stdio.h>

enum printable_kind {
    PRINTABLE,
    PRINTABLE_CONTROL, /* of C0 or C1, DEL, line and paragraph separators, marks of writing direction */
    PRINTABLE_INVALID  /* no UTF-8: one byte */
};

/* The character at `at`, which is not the end; *length: its bytes. */
enum printable_kind printable_at(const char *at, size_t *length);

/* Makes one line of the text, in place: a blank for each control character, a question mark for each byte that is no
 * UTF-8. Returns it. */
char *printable(char *text);

/* As fprintf(), of text that is made printable so; a newline at the format's end stays. */
void printable_print(FILE *out, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
