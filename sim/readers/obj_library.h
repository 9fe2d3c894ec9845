/* SPDX-License-Identifier: MIT
 *
 * Files of materials that an OBJ file names, and how an importer library gets what they say. */
#ifndef SIM_OBJ_LIBRARY_H
#define SIM_OBJ_LIBRARY_H

#include "files/whole_file.h"
#include "readers/obj.h"

/* What stands behind an mtllib: one name with blanks, or several. A file that is not there is noted; one that may not
 * be read, or is damaged, is an error. */
bool obj_libraries_read(struct obj *obj, struct word names, struct error *err);

/* All materials as a text that says what is drawn and nothing else: OBJ_MATERIALS. */
struct whole_file obj_materials_text(const struct obj *obj);

#endif
