/* SPDX-License-Identifier: MIT
 *
 * Vertex n, from 1, goes as its upper bits, its lower 13 bits and a check of both, which is never 0: what a library
 * makes up, or computes with, is found out. */
#include "gltf/vertex_table.h"

#include "base/grow.h"

#include <stdlib.h>
#include <string.h>

enum { LOW_BITS = 13, LOW = (1 << LOW_BITS) - 1 };

static unsigned check_of(unsigned high, unsigned low)
{
    return (high ^ low) + 1;
}

void vertex_table_add(struct vertex_table *table, const double point[3], unsigned stand_in[3])
{
    table->points = grow(table->points, table->count, &table->capacity, sizeof *table->points);
    memcpy(table->points[table->count++], point, sizeof *table->points);
    stand_in[0] = (unsigned)(table->count >> LOW_BITS);
    stand_in[1] = (unsigned)(table->count & LOW);
    stand_in[2] = check_of(stand_in[0], stand_in[1]);
}

/* Written so that it is false for NaN, too. */
static bool is_whole(double x, double most)
{
    return x >= 0 && x <= most && x == (double)(unsigned)x;
}

const double *vertex_table_find(const struct vertex_table *table, double x, double y, double z)
{
    if (!is_whole(x, VERTEX_TABLE_MOST) || !is_whole(y, LOW) || !is_whole(z, VERTEX_TABLE_MOST)) return NULL;
    const unsigned high = (unsigned)x, low = (unsigned)y;
    const size_t number = ((size_t)high << LOW_BITS) + low;
    if (number < 1 || number > table->count || (unsigned)z != check_of(high, low)) return NULL;
    return table->points[number - 1];
}

void vertex_table_free(struct vertex_table *table)
{
    free(table->points);
    *table = (struct vertex_table){0};
}
