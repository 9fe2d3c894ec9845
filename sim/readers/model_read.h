/* SPDX-License-Identifier: MIT
 *
 * A model as the commands take it: imported, and turned as they were told. */
#ifndef SIM_MODEL_READ_H
#define SIM_MODEL_READ_H

#include "model/model_orientation.h"

/* model_import(), then flat_texture.h as the options have it, picture_crop() and orientation_apply(). On success the
 * caller owns *model, otherwise it is empty. */
bool model_read(const char *path, const struct orientation *orientation, struct model *model, struct error *err);

#endif
