/* SPDX-License-Identifier: MIT
 *
 * The precision profiles that the host can draw with, for tests that make a promise for each. The
 * sub-pixel variants of a profile are none: they are there to be measured. */
#ifndef TESTS_PROFILES_H
#define TESTS_PROFILES_H

#include "core/core.h"

enum { PROFILES_MAX = 4 };

/* From the coarsest to the most exact, and their number. */
size_t profiles_find(const struct core *found[PROFILES_MAX]);

#endif
