/* SPDX-License-Identifier: MIT
 *
 * Furniture and household things of the demo scene, each in its own frame: it stands on y = 0,
 * its front towards +z. */
#ifndef DEMO_THINGS_H
#define DEMO_THINGS_H

#include "demo_shape.h"

#include <stddef.h>

enum thing_id {
    TABLE,
    SIDE_TABLE,
    LONG_TABLE,
    CHAIR,
    ARMCHAIR,
    STOOL,
    BENCH,
    CHEST,
    DESK,
    CUPBOARD,
    BED,
    CLOCK,
    BARREL,
    DRESSER,
    BOOKCASE,
    EASEL_STAND,
    CHANDELIER,
    GLOBE,
    DESK_LAMP,
    CANDLE,
    JUG,
    BOWL,
    VASE,
    POT_PLANT,
    TUB_TREE,
    BUST,
    BOTTLES,
    BRUSHES,
    PAINTS,
    LOAF,
    PLATES,
    PUMP,
    BUCKET,
    TREE,
    OPEN_BOOK,
    PANS,
    MIRROR,
    CAT,
    THINGS
};

/* Solids, in millimetres. */
struct thing {
    const struct box *boxes;
    size_t box_count;
    const struct turned *turned;
    size_t turned_count;
};

extern const struct thing things[THINGS];

void thing_build(struct soup *soup, const struct frame *frame, enum thing_id id);

#endif
