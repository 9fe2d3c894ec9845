/* SPDX-License-Identifier: MIT
 *
 * Arrays that grow while the compiler fills them. Like GMP, they end the program when memory runs
 * out: a scene that fits a microcontroller never gets there. */
#ifndef SIM_GROW_H
#define SIM_GROW_H

#include <stddef.h>

/* Room for one more: returns `items`, moved if `count` items fill the capacity. `items` may be
 * NULL with capacity 0; free() it at the end. */
void *grow(void *items, size_t count, size_t *capacity, size_t item_b);

/* calloc() that never returns NULL, not even for no items. */
void *grow_zeroed(size_t count, size_t item_b);

#endif
