/* SPDX-License-Identifier: MIT
 *
 * Whether a model file has all that it promises. The importer library makes up the rest of some that were cut short:
 * PLY and STL files, whose headers count what follows, are counted here. Others it refuses, or their end is where it
 * is: an OBJ file cut between two lines is a whole one. */
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
