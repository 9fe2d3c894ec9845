/* SPDX-License-Identifier: MIT
 *
 * Which polygons of a list can hide which (cluster.h), as a matrix of bits: found once, and whoever divides the list or
 * puts parts of it in order looks at no plane again. A polygon has a bit of its own, neighbours in space near to one
 * another, so that sets of them take few words of a row. */
#ifndef SIM_HIDING_H
#define SIM_HIDING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct bsp;

struct hiding {
    uint64_t *hides, *hidden_by; /* row p has the polygons that p can hide, or that can hide p */
    uint32_t *bit_of;            /* of each polygon of the mesh; HIDING_NONE: not in the list */
    size_t words, count;         /* of a row; of rows */
};

#define HIDING_NONE UINT32_MAX

/* Of the polygons that the pieces list[0 .. count) belong to, whole as the tree's first pieces have them. Time grows
 * with the square of their number, at some 2 ns a pair; memory with a quarter of a byte a pair. */
void hiding_find(struct hiding *hiding, const struct bsp *bsp, const uint32_t *list, size_t count);

/* Whether p can hide q, as far as they are whole: if not, then no piece of p hides one of q. */
static inline bool hiding_holds(const struct hiding *hiding, uint32_t p, uint32_t q)
{
    const uint32_t hidden = hiding->bit_of[q];
    return hiding->hides[hiding->bit_of[p] * hiding->words + hidden / 64] >> hidden % 64 & 1;
}

static inline void hiding_add(const struct hiding *hiding, uint64_t *set, uint32_t polygon)
{
    set[hiding->bit_of[polygon] / 64] |= UINT64_C(1) << hiding->bit_of[polygon] % 64;
}

static inline bool hiding_has(const struct hiding *hiding, const uint64_t *set, uint32_t polygon)
{
    return set[hiding->bit_of[polygon] / 64] >> hiding->bit_of[polygon] % 64 & 1;
}

void hiding_free(struct hiding *hiding);

#endif
