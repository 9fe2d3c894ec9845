/* SPDX-License-Identifier: MIT
 *
 * Which dense parts are mesh leaves, for people. */
#ifndef SIM_LEAF_REPORT_H
#define SIM_LEAF_REPORT_H

#include "scene/compiled.h"

/* One line, or none where there is none and nobody tried. `object`: the name of what moves, or NULL. */
void leaf_report_print(const struct leaf_report *leaves, const char *object);

#endif
