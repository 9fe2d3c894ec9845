/* SPDX-License-Identifier: MIT
 *
 * The first pass over an OBJ text: how much there is of what, and libraries of materials, wherever they are named. */
#ifndef SIM_OBJ_SURVEY_H
#define SIM_OBJ_SURVEY_H

#include "readers/obj.h"

/* An error is a library's. `path` must stay. */
bool obj_survey(struct obj *obj, const char *path, const char *bytes, size_t size_b, struct error *err);

#endif
