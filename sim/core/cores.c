/* SPDX-License-Identifier: MIT
 *
 * The renderers there are. */
#include "core/core.h"

#include <string.h>

extern const struct core core_fast_4, core_fast_5, core_fast_8, core_fine_6;

const struct core *const cores[] = {&core_draft,  &core_fast,   &core_fine,   &core_exact, &core_fast_4,
                                    &core_fast_5, &core_fast_8, &core_fine_6, NULL};

const struct core *core_find(const char *name)
{
    for (size_t i = 0; cores[i]; i++)
        if (strcmp(cores[i]->name, name) == 0) return cores[i];
    return NULL;
}
