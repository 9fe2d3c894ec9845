/* SPDX-License-Identifier: MIT
 *
 * A module as C, for firmware that names its panel when it is built: a header of what a program has to know of it, and
 * a source that sets its driver up on the pins of a board (boards/common/board.h). */
#ifndef SIM_MODULE_C_H
#define SIM_MODULE_C_H

#include "displays/module_choice.h"
#include "outputs/outputs.h"

#include <stdio.h>

/* PATH.h and PATH.c. Refuses what the panel's driver does. */
bool module_c_put(const struct module_choice *choice, const char *path, struct outputs *outputs, struct error *err);

/* The same into files that are open: NAME.h and NAME.c. */
bool module_c_write(const struct module_choice *choice, const char *name, FILE *header, FILE *source,
                    struct error *err);

#endif
