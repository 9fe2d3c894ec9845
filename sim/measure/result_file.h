/* SPDX-License-Identifier: MIT
 *
 * What one `limner measure` of a sweep found, in a file: a head of lines `KEY VALUE` - the program's version, the
 * model, the method that was asked for, and of each file that was read its SHA-256 and path -, an empty line, and
 * measure_table_csv(). */
#ifndef SIM_RESULT_FILE_H
#define SIM_RESULT_FILE_H

#include "measure/measure_table.h"
#include "outputs/outputs.h"

enum { RESULT_TEXT_B = 1024 };

/* With the files that inputs_note() has got. */
bool result_file_put(const struct measure_table *table, const char *model, const char *method, const char *path,
                     struct outputs *outputs, struct error *err);

struct result_file {
    char version[RESULT_TEXT_B], model[RESULT_TEXT_B], method[64];
    char *text;         /* all of it, owned */
    const char *inputs; /* the lines of files in it; they end with an empty one */
    const char *csv;    /* the table in it */
};

/* Refuses what is no whole result. */
bool result_file_read(const char *path, struct result_file *out, struct error *err);

/* Whether the files are what they were when it was measured. */
bool result_file_check_inputs(const struct result_file *result, const char *path, struct error *err);

void result_file_free(struct result_file *result);

#endif
