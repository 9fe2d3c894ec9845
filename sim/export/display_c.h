/* SPDX-License-Identifier: MIT
 *
 * NAME_display.h and NAME_display.c: scenes on a display of the project's own drivers. The .c holds the driver, and the
 * memory of scene and display; the .h is what a program calls. */
#ifndef SIM_DISPLAY_C_H
#define SIM_DISPLAY_C_H

#include "export/amalgam.h"
#include "export/export_plan.h"

bool display_c_write_header(const struct export_plan *plan, FILE *out, struct error *err);

/* *joined knows what limner.h and limner_display.h hold. */
bool display_c_write_source(const struct export_plan *plan, struct amalgam *joined, FILE *out, struct error *err);

#endif
