/* SPDX-License-Identifier: MIT
 *
 * The importer library called in this very process: what model_import() runs in a child. Damaged
 * files can make the library crash, hang or leak; only tests call this directly. */
#ifndef SIM_IMPORT_H
#define SIM_IMPORT_H

#include "model/model.h"

/* As model_import(). */
bool import_model(const char *path, struct model *model, struct error *err);

#endif
