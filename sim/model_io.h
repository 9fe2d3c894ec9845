/* SPDX-License-Identifier: MIT
 *
 * How the importer library reads files: whole, into memory, and OBJ files without their object
 * and group lines. */
#ifndef SIM_MODEL_IO_H
#define SIM_MODEL_IO_H

#include "error.h"

#include <assimp/cfileio.h>

/* Refuses what is no model file by its looks: missing, a folder, empty, or larger than 1 GiB. */
bool model_io_check(const char *path, struct error *err);

/* For aiImportFileEx(). It holds no state: any number of imports may share it.
 *
 * Why lines are dropped: the importer gathers an OBJ file's faces by object, so a file that comes
 * back to an earlier object would have its faces renumbered. Objects and groups mean nothing here;
 * without them the faces stay in the file's order, materials switching as they may. */
struct aiFileIO model_io(void);

#endif
