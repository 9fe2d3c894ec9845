/* SPDX-License-Identifier: MIT
 *
 * Open addressing with linear probing, at most half full. */
#include "base/map.h"

#include "base/grow.h"

#include <stdlib.h>

/* Fibonacci hashing: the product by 2^64 / golden ratio spreads the key into the upper bits. */
static size_t map_home(const struct map *map, uint64_t key)
{
    uint64_t mixed = (key ^ (key >> 32)) * UINT64_C(0x9E3779B97F4A7C15);
    return (size_t)(mixed >> 32) & (map->capacity - 1);
}

static struct map_entry *map_slot(const struct map *map, uint64_t key)
{
    size_t at = map_home(map, key);
    while (map->entries[at].used && map->entries[at].key != key)
        at = (at + 1) & (map->capacity - 1);
    return &map->entries[at];
}

static void map_double(struct map *map)
{
    struct map old = *map;
    map->capacity = old.capacity ? 2 * old.capacity : 64;
    map->entries = grow_zeroed(map->capacity, sizeof *map->entries);
    for (size_t i = 0; i < old.capacity; i++)
        if (old.entries[i].used) *map_slot(map, old.entries[i].key) = old.entries[i];
    free(old.entries);
}

uint32_t *map_at(struct map *map, uint64_t key, uint32_t absent)
{
    if (2 * map->count >= map->capacity) map_double(map);
    struct map_entry *slot = map_slot(map, key);
    if (!slot->used) {
        *slot = (struct map_entry){key, absent, true};
        map->count++;
    }
    return &slot->value;
}

const uint32_t *map_find(const struct map *map, uint64_t key)
{
    if (map->count == 0) return NULL;
    const struct map_entry *slot = map_slot(map, key);
    return slot->used ? &slot->value : NULL;
}

void map_free(struct map *map)
{
    free(map->entries);
    *map = (struct map){0};
}
