/* SPDX-License-Identifier: MIT
 *
 * The help: all of it, or that of one command. */
#ifndef SIM_CLI_USAGE_H
#define SIM_CLI_USAGE_H

#include <stdbool.h>
#include <stdio.h>

void usage_print(FILE *out);

/* What the command does, its options and an example. False: there is no such command, and nothing was printed. */
bool usage_print_command(const char *name, FILE *out);

#endif
