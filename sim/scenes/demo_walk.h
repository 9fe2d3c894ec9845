/* SPDX-License-Identifier: MIT
 *
 * The camera's walk round the demo house. */
#ifndef DEMO_WALK_H
#define DEMO_WALK_H

#include <stdbool.h>
#include <stdio.h>

/* A line a frame: eye and target in metres. False if writing fails. */
bool walk_write(FILE *file);

#endif
