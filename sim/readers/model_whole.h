/* SPDX-License-Identifier: MIT
 *
 * Whether a model file has all that it promises. The importer library makes up the rest of an OBJ file that was cut
 * within a line; cut between two lines it is a whole one. Of other formats the library finds out, or our own readers.
 */
#ifndef SIM_MODEL_WHOLE_H
#define SIM_MODEL_WHOLE_H

#include "base/error.h"

#include <stddef.h>

/* Refuses a file that ends before it may. What is of other formats, or damaged in other ways, is the library's. */
bool model_is_whole(const char *path, struct error *err);

/* Refuses an OBJ or MTL text with a line of more than 1 MB, of which the library would hold several copies, or with NUL
 * bytes, which it takes for this or that. */
bool model_text_fits(const char *path, const char *text, size_t size_b, struct error *err);

#endif
