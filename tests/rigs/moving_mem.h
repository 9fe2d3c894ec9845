/* SPDX-License-Identifier: MIT
 *
 * A renderer for tests of what moves, and just the memory that it and its movers ask for. */
#ifndef TESTS_MOVING_MEM_H
#define TESTS_MOVING_MEM_H

#include "limner.h"

struct moving_mem {
    void *renderer, *movers;
};

/* Scene and target must outlive `lim`; moving_mem_free() gives the memory back. */
void moving_mem_init(struct moving_mem *mem, struct lim *lim, const struct lim_scene *scene,
                     const struct lim_target *target, const struct lim_movers_limits *limits);
void moving_mem_free(struct moving_mem *mem);

#endif
