/* SPDX-License-Identifier: MIT
 *
 * Files that a model names: materials, pictures, buffers. A model may come from anywhere, so a file that it names must
 * lie in the model's folder or below, links followed, unless the user trusts its paths. One model at a time. */
#ifndef SIM_COMPANION_H
#define SIM_COMPANION_H

#include "base/input_file.h"
#include "model/model.h"

/* --trust-paths: `..`, absolute paths and links that lead elsewhere are followed. For all of the process. */
void companions_trust(void);

/* Paths are not trusted from here on, but `..` leads as far up as this folder, and links as well: a report's files,
 * where none but them lie. */
void companions_stay_in(const char *folder);

/* A model is about to be read; nothing has been refused of it. */
void companions_begin(const char *model_path);

/* Whether the model has named a file that it may not; err says which, and what permits it. Libraries try names and go
 * on without them, so this is asked at the end. */
bool companions_refused(struct error *err);

/* Something else about a file that the model names which ends the import. */
void companions_refuse(const struct error *err);

/* Opens what the model calls `name`, as input_open() does: relative to its folder; \ divides as / does, and %20 is a
 * blank unless a file is called so; // in front means the folder. What is not there is looked for by a name that
 * differs in capitals, and by its own name beside the model. NULL on error, with errno, and if it is refused. */
FILE *companion_open(const char *name, size_t most_b, size_t *size_b, struct error *err);

/* Whether companion_open() would find something by this very name; nothing is said of it. */
bool companion_is_there(const char *name);

/* Notes what the model calls `name` though it is not opened, if it lies where it may (inputs.h). */
void companion_note(const char *name);

/* The same as companion_open() for a path that a library has made of the model's folder and a name; the model's own is
 * opened as it is. */
FILE *companion_open_path(const char *path, size_t most_b, size_t *size_b, struct error *err);

/* Notes which files were read that are not where, or not called as, the model says. */
void companions_tell(struct model *to);

#endif
