/* SPDX-License-Identifier: MIT
 *
 * Vertices in double precision, and what stands for them while a library that has float32 carries them: three small
 * integers, which float32 holds exactly. */
#ifndef SIM_VERTEX_TABLE_H
#define SIM_VERTEX_TABLE_H

#include <stdbool.h>
#include <stddef.h>

struct vertex_table {
    double (*points)[3]; /* as the file has them; NULL: the format is not among those that are numbered */
    size_t count, capacity;
};

/* What stands for a texture coordinate that a corner does not have, and for one that is no number. Beyond the middle
 * between, it is the former; below half of the latter, neither: the library rounds. */
#define PLACE_NONE 3e38
#define PLACE_NO_NUMBER 2e38

enum { VERTEX_TABLE_MOST = 1 << 26 };

/* Enters a vertex, of VERTEX_TABLE_MOST at most, and gives what is to be written in its place. */
void vertex_table_add(struct vertex_table *table, const double point[3], unsigned stand_in[3]);

/* The vertex that a library gave back as x, y, z. NULL: it is none that the table handed out. */
const double *vertex_table_find(const struct vertex_table *table, double x, double y, double z);

void vertex_table_free(struct vertex_table *table);

#endif
