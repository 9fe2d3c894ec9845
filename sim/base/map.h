/* SPDX-License-Identifier: MIT
 *
 * A hash table from 64-bit keys to 32-bit values, for the compiler's "is it there already?". */
#ifndef SIM_MAP_H
#define SIM_MAP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct map_entry {
    uint64_t key;
    uint32_t value;
    bool used;
};

struct map {
    struct map_entry *entries; /* a power of two of them, or none yet */
    size_t capacity, count;
};

/* The value of `key`, to read or change; an absent key is entered with the value `absent`. The
 * pointer holds until the next call. */
uint32_t *map_at(struct map *map, uint64_t key, uint32_t absent);

/* The same without entering anything: NULL when absent. */
const uint32_t *map_find(const struct map *map, uint64_t key);

void map_free(struct map *map); /* leaves an empty map */

#endif
