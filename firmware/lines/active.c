/* SPDX-License-Identifier: MIT
 *
 * More room for polygons that cross a line, where there is some. */
#include "lines/active.h"

#if LIM_HAS_SPANS

/* Bits of an address that are 0 where an active polygon may lie. */
enum { SPARE_MASK = LIM_ALIGNOF(struct lim_active) - 1 };

struct lim_active *lim_active_spare(struct lim_actives *actives, const struct lim_retained *retained)
{
    uint8_t *at = (uint8_t *)(((uintptr_t)&retained->cells[retained->used] + SPARE_MASK) & ~(uintptr_t)SPARE_MASK);
    const uint8_t *end = (const uint8_t *)&retained->cells[retained->end];
    struct lim_active *first = NULL;

    if (actives->spares) return NULL;
    actives->spares = true;
    for (; at < end && (size_t)(end - at) >= sizeof(struct lim_active); at += sizeof(struct lim_active)) {
        struct lim_active *spare = (void *)at;
        spare->next = first;
        first = spare;
    }
    if (first) actives->free = first->next;
    return first;
}

#endif
