/* SPDX-License-Identifier: MIT
 *
 * The memory that a scene wants on a 32-bit MCU. This host's structs are larger. */
#ifndef SIM_MCU_MEM_H
#define SIM_MCU_MEM_H

#include "scene/compiled.h"

#include <stddef.h>

struct core;
struct moving;

/* Bytes that lim_init() wants on a 32-bit MCU for the panel, the precision and the method of scene->report,
 * and the least that it takes. */
size_t mcu_mem_b(const struct compiled *scene);
size_t mcu_mem_min_b(const struct compiled *scene);

/* A polygon that crosses a line, nearest first or by scan lines. */
size_t mcu_active_b(const struct core *core, const struct lim_scene *scene, bool antialias, bool moves);

/* Likewise for lim_movers_init(): NAME_MOVERS_MEM_B of the generated header, or a little more. */
size_t mcu_movers_mem_b(const struct compiled *scene, const struct moving *moving);

#endif
