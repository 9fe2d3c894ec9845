/* SPDX-License-Identifier: MIT
 *
 * How large the renderer's pools must be: measured with the renderer itself. */
#ifndef SIM_POOLS_H
#define SIM_POOLS_H

#include "compiled.h"

/* Sets scene->scene.limits and the image's, pools included: the most that any of 256 sampled cameras
 * but the greediest needs at this size, and an eighth on top. */
bool pools_measure(struct compiled *scene, unsigned w_px, unsigned h_px, struct error *err);

/* Bytes that lim_init() wants on a 32-bit microcontroller whose firmware is built for 341 pixels a
 * side at most (this host's structs are larger), with these limits, and at the least. */
size_t pools_mcu_mem_b(const struct lim_limits *limits, unsigned h_px);
size_t pools_mcu_mem_min_b(const struct lim_limits *limits, unsigned h_px);

#endif
