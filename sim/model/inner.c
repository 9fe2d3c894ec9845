/* SPDX-License-Identifier: MIT
 *
 * A map from both ends to what is known. Edges that it does not have are drawn. */
#include "model/inner.h"

enum { UNKNOWN, INNER, OUTER };

static uint64_t key_of(uint32_t a, uint32_t b)
{
    return a < b ? (uint64_t)b << 32 | a : (uint64_t)a << 32 | b;
}

void inner_add(struct mesh *mesh, uint32_t a, uint32_t b)
{
    uint32_t *known = map_at(&mesh->inner, key_of(a, b), UNKNOWN);
    if (*known == UNKNOWN) *known = INNER;
}

void inner_remove(struct mesh *mesh, uint32_t a, uint32_t b)
{
    if (inner_has(mesh, a, b)) *map_at(&mesh->inner, key_of(a, b), OUTER) = OUTER;
}

bool inner_has(const struct mesh *mesh, uint32_t a, uint32_t b)
{
    const uint32_t *known = map_find(&mesh->inner, key_of(a, b));
    return known && *known == INNER;
}

void inner_divide(struct mesh *mesh, uint32_t a, uint32_t middle, uint32_t b)
{
    if (!inner_has(mesh, a, b)) return;
    inner_add(mesh, a, middle);
    inner_add(mesh, middle, b);
}
