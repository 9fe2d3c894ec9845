/* SPDX-License-Identifier: MIT
 *
 * The boxes of a scene's tree, which visible sets have a bit each of. */
#ifndef SIM_SET_BOXES_H
#define SIM_SET_BOXES_H

#include "scene.h"

#include <stddef.h>
#include <stdint.h>

struct boxes {
    lim_index *of_node; /* the smallest box that holds it, or LIM_NO_INDEX */
    lim_index *above;   /* of each box: the next one around it, or LIM_NO_INDEX */
    size_t bits_b;      /* of a visible set, unpacked */
};

void boxes_find(struct boxes *boxes, const struct lim_scene *scene);
void boxes_free(struct boxes *boxes);

/* The box and all around it are visible. LIM_NO_INDEX: what is in no box always is. */
void boxes_show(const struct boxes *boxes, lim_index box, uint8_t *bits);

static inline bool boxes_shown(const uint8_t *bits, size_t box)
{
    return bits[box / 8] >> (box % 8) & 1;
}

#endif
