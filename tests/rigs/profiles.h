/* SPDX-License-Identifier: MIT
 *
 * The precision profiles, for tests that make a promise for each. */
#ifndef TESTS_PROFILES_H
#define TESTS_PROFILES_H

#include "core/core.h"

enum { PROFILES_MAX = 4 };

/* From the coarsest to the most exact, and their number. */
size_t profiles_find(const struct core *found[PROFILES_MAX]);

/* For promises that hold whatever the sub-pixel bits are: the profiles, or, if $SUB_BITS is set, those with other bits
 * (measure/sub_bits.h), which are compiled first. */
size_t profiles_or_sub_bits(const struct core *found[PROFILES_MAX]);

#endif
