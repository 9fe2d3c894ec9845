/* SPDX-License-Identifier: MIT
 *
 * What a decision hangs on, as a key: the mesh, which is all that a model's file and those that it names come to; the
 * reference's faces; the options. */
#ifndef SIM_DECISION_KEY_H
#define SIM_DECISION_KEY_H

#include "base/cache.h"
#include "compiler/compile_options.h"
#include "model/mesh.h"

void decision_key(uint8_t key[CACHE_KEY_B], const struct mesh *mesh, const struct mesh *fine,
                  const struct compile_options *options);

#endif
