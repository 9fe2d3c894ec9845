/* SPDX-License-Identifier: MIT
 *
 * Which extensions of glTF 2.0 are read, and what becomes of the others. */
#ifndef SIM_GLTF_EXTENSIONS_H
#define SIM_GLTF_EXTENSIONS_H

#include "gltf/gltf_file.h"
#include "model/model.h"

/* Refuses, by its name, an extension that the file requires and that is not read. What changes the picture and is not
 * drawn gets a note in the model, a line for each kind. */
bool gltf_extensions_check(const char *path, const struct gltf_file *file, struct model *model, struct error *err);

/* For a list of them all (cli/cmd_formats.c), in the order of their names. words: NULL if it is drawn, or unseen. NULL:
 * there are no more. */
const char *gltf_extension_at(size_t index, bool *is_drawn, const char **words);

#endif
