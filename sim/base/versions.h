/* SPDX-License-Identifier: MIT
 *
 * What this program was made of, and what it runs on: for reports. */
#ifndef SIM_VERSIONS_H
#define SIM_VERSIONS_H

#include <stdio.h>

/* Lines `key: value`: the sources, the compiler, each library as it is loaded, the system; no names of machine or
 * user. */
void versions_print(FILE *out);

/* The program's version, and what `git describe` said of its sources, if anything: "0.1.0 v0.1.0-5-gabcdef". */
const char *versions_program(void);

#endif
