/* SPDX-License-Identifier: MIT
 *
 * What a scene's bytes go into, in flash and in RAM, on a 32-bit MCU. */
#ifndef SIM_MEM_PARTS_H
#define SIM_MEM_PARTS_H

#include "scene/compiled.h"

#include <stddef.h>

struct mem_part {
    const char *name;
    size_t size_b, count; /* count: of what it holds; 0: nothing that is counted */
};

enum { FLASH_PARTS_MAX = 10, RAM_PARTS_MAX = 9 };

/* The arrays, without the struct that names them. Returns how many there are. */
size_t flash_parts(const struct compiled *scene, struct mem_part parts[FLASH_PARTS_MAX]);

/* What mcu_mem_b() is the sum of. */
size_t ram_parts(const struct compiled *scene, struct mem_part parts[RAM_PARTS_MAX]);

#endif
