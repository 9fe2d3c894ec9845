/* SPDX-License-Identifier: MIT
 *
 * The renderers there are. */
#include "core/core.h"

#include "base/choice.h"

#include <string.h>

const struct core *const cores[] = {&core_draft, &core_fast, &core_fine, &core_exact, NULL};

const struct core *core_find(const char *name)
{
    for (size_t i = 0; cores[i]; i++)
        if (choice_is(name, strlen(name), cores[i]->name)) return cores[i];
    return NULL;
}
