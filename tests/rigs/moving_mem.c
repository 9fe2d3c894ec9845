/* SPDX-License-Identifier: MIT */
#include "moving_mem.h"

#include "cmocka_ready.h"

#include <stdlib.h>

void moving_mem_init(struct moving_mem *mem, struct lim *lim, const struct lim_scene *scene,
                     const struct lim_target *target, const struct lim_movers_limits *limits)
{
    const size_t renderer_b = lim_mem_b(scene, target), movers_b = lim_movers_mem_b(scene, limits);

    mem->renderer = malloc(renderer_b);
    mem->movers = malloc(movers_b);
    assert_true(mem->renderer && mem->movers);
    assert_int_equal(lim_init(lim, scene, target, mem->renderer, renderer_b), LIM_OK);
    assert_int_equal(lim_movers_init(lim, mem->movers, movers_b, limits), LIM_OK);
}

void moving_mem_free(struct moving_mem *mem)
{
    free(mem->renderer);
    free(mem->movers);
    *mem = (struct moving_mem){NULL, NULL};
}
