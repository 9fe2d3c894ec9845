/* SPDX-License-Identifier: MIT
 *
 * Which files the process has opened to read, its importer's child process included: no output takes the place of one
 * (outputs.h), and reports pack those that belong to a model. */
#ifndef SIM_INPUTS_H
#define SIM_INPUTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <sys/stat.h>

/* Notes a file of a model that has been opened: its path, and what inputs_note_file() notes. */
void inputs_note(const char *path);

/* Notes which file has been opened, whatever its name. Regular files alone count. */
void inputs_note_file(const struct stat *status);

/* The same of a file that is not opened, or later; one that is not there is none. */
void inputs_note_name(const char *path);

/* In a child process: what inputs_note() and inputs_note_name() get goes to this descriptor; if it cannot be written
 * the child ends with EXIT_FAILURE. The parent notes it from the stream's beginning, once the child has ended, well or
 * not. */
void inputs_send_to(int descriptor);
void inputs_receive(FILE *stream);

/* Whether it is one of those noted, by whatever name. */
bool inputs_have(const struct stat *status);

/* The paths that inputs_note() has got so far: the one of index < inputs_count(). */
size_t inputs_count(void);
const char *inputs_path(size_t index);

/* As if none had been opened. */
void inputs_forget(void);

#endif
