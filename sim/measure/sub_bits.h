/* SPDX-License-Identifier: MIT
 *
 * Renderers of a profile with other sub-pixel bits than its own, for measurements: fast_4 is fast with 4 bits. This
 * program has none of them. Each is compiled when it is asked for, from the source tree that the program is from, and
 * loaded. */
#ifndef SIM_SUB_BITS_H
#define SIM_SUB_BITS_H

#include "base/error.h"
#include "core/core.h"

enum { SUB_BITS_NAME_B = 16 };

/* Those of `limner measure --sub-bits`; NULL behind the last. */
extern const char *const sub_bits_usual[];

/* Whether the name is PROFILE_BITS, of bits that firmware may have and the profile has not; else err says why. */
bool sub_bits_check_name(const char *name, struct error *err);

/* Whether there is what it takes to compile one. */
bool sub_bits_check_tools(struct error *err);

/* Compiles that renderer in a folder for such files, and loads it. *out stays until the process ends. */
bool sub_bits_load(const char *name, const char *folder, const struct core **out, struct error *err);

#endif
