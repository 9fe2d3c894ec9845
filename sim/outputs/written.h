/* SPDX-License-Identifier: MIT
 *
 * What a command says of the files that it has written. */
#ifndef SIM_WRITTEN_H
#define SIM_WRITTEN_H

#include <stddef.h>

enum { WRITTEN_B = 1024 };

/* One line, without a newline, that names the files in their order; of three and more whose names differ in numbers
 * alone the first and the last. Empty if there are none. Control characters become spaces, and a line that would be
 * too long ends in dots. */
void written_text(const char *const *paths, size_t count, char text[WRITTEN_B]);

/* Puts such a line on standard output, if that is a terminal: what a script reads has nothing else in it. */
void written_say(const char *text);

#endif
