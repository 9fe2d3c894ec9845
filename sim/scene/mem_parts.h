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

/* Bytes of flash of a scene's textures: texels, palettes, and the structs that name them; not where polygons show them.
 * What --texture-budget is for. */
size_t texture_memory_b(const struct lim_scene *scene);

#endif
