/* SPDX-License-Identifier: MIT
 *
 * Completion for bash, of the same table as the help, and of the lists of panels, methods, trees and profiles. */
#ifndef SIM_CLI_COMPLETION_H
#define SIM_CLI_COMPLETION_H

#include <stdio.h>

/* A script, to be read by bash: commands, a command's options, values that are names, else files. */
void completion_print(FILE *out);

#endif
