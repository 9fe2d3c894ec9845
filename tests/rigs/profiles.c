/* SPDX-License-Identifier: MIT
 *
 * The profiles are the host's table; what has other sub-pixel bits is compiled and loaded. */
#include "profiles.h"

#include "base/work_folder.h"
#include "cmocka_ready.h"
#include "core/core.h"
#include "measure/sub_bits.h"

#include <stdlib.h>

size_t profiles_find(const struct core *found[PROFILES_MAX])
{
    size_t count = 0;

    while (cores[count] && count < PROFILES_MAX) {
        found[count] = cores[count];
        count++;
    }
    return count;
}

size_t profiles_or_sub_bits(const struct core *found[PROFILES_MAX])
{
    struct work_folder folder = {0};
    struct error err;
    size_t count = 0;

    if (!getenv("SUB_BITS")) return profiles_find(found);
    if (!work_folder_make(&folder, &err)) fail_msg("%s", err.text);
    for (; sub_bits_usual[count] && count < PROFILES_MAX; count++)
        if (!sub_bits_load(sub_bits_usual[count], folder.path, &found[count], &err)) fail_msg("%s", err.text);
    work_folder_remove(&folder);
    return count;
}
