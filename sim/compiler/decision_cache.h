/* SPDX-License-Identifier: MIT
 *
 * Decisions that are remembered, with the scenes that came of them (base/cache.h). */
#ifndef SIM_DECISION_CACHE_H
#define SIM_DECISION_CACHE_H

#include "base/cache.h"
#include "compiler/compile_options.h"
#include "scene/compiled.h"

/* The scene as decision_make() made it from such a mesh. False: it is not remembered. */
bool decision_cache_find(const uint8_t key[CACHE_KEY_B], const struct mesh *mesh, const struct compile_options *options,
                         struct compiled *out);

void decision_cache_keep(const uint8_t key[CACHE_KEY_B], const struct compiled *scene);

#endif
