/* SPDX-License-Identifier: MIT
 *
 * Formats that the project reads by itself, where the importer library drops what they say of colours: PLY, OFF, STL
 * and 3MF. */
#ifndef SIM_OWN_FORMATS_H
#define SIM_OWN_FORMATS_H

#include "formats/model_build.h"

/* NULL: the file is for the importer library. */
model_builder *own_format_of(const char *path);

bool import_ply(struct model_build *build);
bool import_off(struct model_build *build);
bool import_stl(struct model_build *build);
bool import_3mf(struct model_build *build);

#endif
