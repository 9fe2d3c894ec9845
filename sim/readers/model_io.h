/* SPDX-License-Identifier: MIT
 *
 * How the importer library reads files: whole, into memory. */
#ifndef SIM_MODEL_IO_H
#define SIM_MODEL_IO_H

#include "files/whole_file.h"

#include <assimp/cfileio.h>

/* Refuses what is no model file by its looks: missing, a folder, empty, a pipe, or larger than 256 MB. */
bool model_io_check(const char *path, struct error *err);

/* What the library gets when it asks for the model, or for materials: vertex_numbers.h. */
struct model_io_instead {
    const char *path;
    const char *bytes; /* NULL: the file itself */
    size_t size_b;
    bool is_noted;                      /* the file that it stands for is noted already (inputs.h) */
    const struct whole_file *materials; /* of any path that ends with OBJ_MATERIALS */
};

/* For aiImportFileEx(). `instead` must outlive the import. */
struct aiFileIO model_io(const struct model_io_instead *instead);

#endif
