/* SPDX-License-Identifier: MIT
 *
 * Whether cameras see anything of a model but backs, which are not drawn. */
#ifndef SIM_FACING_H
#define SIM_FACING_H

#include "cameras/camera_path.h"
#include "model/model.h"

/* Whether any face that can be seen turns its front, or has two of them, to the eye of any frame. */
bool facing_any(const struct model *model, const struct camera_path *path);

#endif
