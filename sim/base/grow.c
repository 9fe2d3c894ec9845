/* SPDX-License-Identifier: MIT
 *
 * Growth by doubling, so that n additions cost O(n). */
#include "base/grow.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static void *checked(void *memory)
{
    if (memory) return memory;
    fputs("limner: out of memory\n", stderr);
    exit(EXIT_FAILURE);
}

void *grow(void *items, size_t count, size_t *capacity, size_t item_b)
{
    if (count < *capacity) return items;
    size_t wanted = *capacity ? 2 * *capacity : 16;
    if (wanted > SIZE_MAX / item_b) return checked(NULL);
    *capacity = wanted;
    return checked(realloc(items, wanted * item_b));
}

void *grow_zeroed(size_t count, size_t item_b)
{
    return checked(calloc(count ? count : 1, item_b));
}
