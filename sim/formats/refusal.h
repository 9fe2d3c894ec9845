/* SPDX-License-Identifier: MIT
 *
 * Why the library does not read a file, in words that help: its own reasons are of whichever of its readers came last.
 */
#ifndef SIM_REFUSAL_H
#define SIM_REFUSAL_H

#include "base/error.h"

/* Always false. `reason`: the library's, or WORDS_NO_FACES. */
bool refusal_set(const char *path, const char *reason, struct error *err);

#endif
