/* SPDX-License-Identifier: MIT
 *
 * Each has memory of its own. */
#include "renderer_pair.h"

#include "cmocka_ready.h"

#include <stdlib.h>
#include <string.h>

void renderer_pair_start(struct renderer_pair *pair, int i, const struct lim_scene *scene,
                         const struct lim_target *target, bool least)
{
    const size_t mem_b = least ? lim_mem_min_b(scene, target) : lim_mem_b(scene, target);

    pair->mem[i] = malloc(mem_b);
    assert_non_null(pair->mem[i]);
    memset(&pair->lim[i], 0xA5, sizeof pair->lim[i]);
    assert_int_equal(lim_init(&pair->lim[i], scene, target, pair->mem[i], mem_b), LIM_OK);
}

void renderer_pair_end(struct renderer_pair *pair)
{
    free(pair->mem[0]);
    free(pair->mem[1]);
}

void renderer_pair_round(uint16_t w_px, uint16_t h_px, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px)
{
    const uint16_t cut = (uint16_t)abs((int)y_px - h_px / 2);

    *x0_px = (uint16_t)(cut + 3);
    *x1_px = (uint16_t)(w_px - cut);
}
