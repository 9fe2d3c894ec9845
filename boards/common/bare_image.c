/* SPDX-License-Identifier: MIT
 *
 * Memory of a bare image: initial values, and the functions that the compiler calls on its own
 * account, since there is no C library in the image. */
#include "bare_image.h"

#include <stddef.h>

extern uint32_t image_data_start[], image_data_end[], image_bss_start[], image_bss_end[];
extern const uint32_t image_data_load[];

void *memcpy(void *restrict to, const void *restrict from, size_t size_b);
void *memset(void *to, int value, size_t size_b);

/* Loops must not be turned into calls of what they implement. */
#define LOOPS_AS_WRITTEN __attribute__((optimize("no-tree-loop-distribute-patterns")))

LOOPS_AS_WRITTEN void image_memory_init(void)
{
    const uint32_t *load = image_data_load;
    for (uint32_t *word = image_data_start; word < image_data_end; word++)
        *word = *load++;
    for (uint32_t *word = image_bss_start; word < image_bss_end; word++)
        *word = 0;
}

LOOPS_AS_WRITTEN void *memcpy(void *restrict to, const void *restrict from, size_t size_b)
{
    for (size_t i = 0; i < size_b; i++)
        ((uint8_t *)to)[i] = ((const uint8_t *)from)[i];
    return to;
}

LOOPS_AS_WRITTEN void *memset(void *to, int value, size_t size_b)
{
    for (size_t i = 0; i < size_b; i++)
        ((uint8_t *)to)[i] = (uint8_t)value;
    return to;
}
