/* SPDX-License-Identifier: MIT
 *
 * The demo scene as a Wavefront OBJ file with its materials. */
#ifndef DEMO_WRITE_H
#define DEMO_WRITE_H

#include "demo_soup.h"

#include <stdbool.h>
#include <stdio.h>

/* Sorts the polygons by colour; call before writing. */
void write_prepare(struct soup *soup);
bool write_obj(FILE *file, const struct soup *soup);
bool write_mtl(FILE *file, const struct soup *soup);

#endif
