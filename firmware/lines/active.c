/* SPDX-License-Identifier: MIT
 *
 * More room for polygons that cross a line, where there is some. */
#include "lines/active.h"

#if LIM_HAS_SPANS

bool lim_actives_add_spares(struct lim_actives *actives, const struct lim_retained *retained)
{
    const uintptr_t mask = LIM_ALIGNOF(struct lim_active) - 1;
    uint8_t *at = (uint8_t *)(((uintptr_t)&retained->cells[retained->used] + mask) & ~mask);
    const uint8_t *end = (const uint8_t *)&retained->cells[retained->end];

    if (actives->spares) return false;
    actives->spares = true;
    for (; at < end && (size_t)(end - at) >= sizeof(struct lim_active); at += sizeof(struct lim_active)) {
        struct lim_active *spare = (void *)at;
        spare->next = actives->free;
        actives->free = spare;
    }
    return actives->free != NULL;
}

#endif
