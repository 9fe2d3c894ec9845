/* SPDX-License-Identifier: MIT
 *
 * Sources joined into one file. A header comes where it is needed first, and once; conditions that are known are
 * decided (conditions.h), and files of which nothing is left are left out. Comments stay. */
#ifndef SIM_AMALGAM_H
#define SIM_AMALGAM_H

#include "base/error.h"
#include "export/conditions.h"

#include <stdio.h>

struct amalgam {
    struct conditions conditions;
    const char *const *folders; /* where headers are looked for, beside the file that wants them; ends with NULL */
    const char *const *aliases; /* pairs: a header's name, and which one comes in its place; ends with NULL */
    char **joined;              /* headers that came already: paths, and names in <> */
    size_t count, capacity;
};

/* Adds a file of the program's own (embedded.h). What cannot be joined is an error: no such file, an #include that
 * names none, a header under a condition that is not known, an #endif too many or too few. */
bool amalgam_add(struct amalgam *amalgam, const char *path, FILE *out, struct error *err);

/* The same with a text that no file has; `path` stands for it in errors, and its folder is looked in for headers. */
bool amalgam_add_text(struct amalgam *amalgam, const char *path, const char *text, FILE *out, struct error *err);

void amalgam_free(struct amalgam *amalgam);

#endif
