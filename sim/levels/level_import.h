/* SPDX-License-Identifier: MIT
 *
 * A map of Doom or Freedoom as a model. */
#ifndef SIM_LEVEL_IMPORT_H
#define SIM_LEVEL_IMPORT_H

#include "model/model.h"

/* path: FILE.wad:MAP (level_path.h). Refused, naming file and lump: what is missing, cut short or out of range, and
 * maps of other formats. Notices: lines that cross, sectors that are not closed, textures that there are none of,
 * patches that are broken. On success the caller owns *model, otherwise it is empty. */
bool level_import(const char *path, bool is_textured, struct model *model, struct error *err);

#endif
