/* SPDX-License-Identifier: MIT
 *
 * The host's table has the profiles first, then their variants. */
#include "profiles.h"

#include "core/core.h"

size_t profiles_find(const struct core *found[PROFILES_MAX])
{
    size_t count = 0;

    for (size_t i = 0; cores[i] && count < PROFILES_MAX; i++)
        if (cores[i]->is_profile) found[count++] = cores[i];
    return count;
}
