/* SPDX-License-Identifier: MIT
 *
 * A closed mesh of 3,648 triangles: a body with a head, a tail and four legs, rippled all over. It stands in the
 * benchmark for a scanned animal of as many triangles that other renderers were counted on, and that is not here. */
#ifndef BENCH_SOLID_H
#define BENCH_SOLID_H

#include <stdbool.h>
#include <stdio.h>

/* Of one material; or with texture coordinates and `materials_name`, which has the material `0`, where that is not
 * NULL. */
bool bench_solid_write(FILE *obj, const char *materials_name);

#endif
