/* SPDX-License-Identifier: MIT
 *
 * What the demo scene is made of. */
#ifndef DEMO_MATERIAL_H
#define DEMO_MATERIAL_H

#include <stdint.h>

enum material_id {
    WHITEWASH,
    CREAM,
    SAGE,
    GREY_BLUE,
    OCHRE,
    PLASTER,
    OAK,
    OAK_DARK,
    OAK_PALE,
    WALNUT,
    PLANK,
    PLANK_DARK,
    EBONY,
    MARBLE,
    BASALT,
    TILE,
    TILE_DARK,
    BRICK,
    BRICK_DARK,
    PAVING,
    PAVING_DARK,
    SLATE,
    SOOT,
    STONE,
    ROOFING,
    DELFT_WHITE,
    DELFT_BLUE,
    POTTERY,
    CLAY,
    RED_CLOTH,
    RED_DARK,
    BLUE_CLOTH,
    BLUE_PALE,
    GREEN_CLOTH,
    GREEN_PAINT,
    YELLOW_CLOTH,
    LINEN,
    ROSE,
    BRASS,
    COPPER,
    PEWTER,
    GILT,
    WINE,
    BREAD,
    APPLE,
    LEMON,
    ORANGE,
    PAPER,
    LEAF,
    LEAF_DARK,
    LEAF_LIGHT,
    EARTH,
    SKIN,
    HAIR,
    BOOK_RED,
    BOOK_BLUE,
    BOOK_GREEN,
    BOOK_BROWN,
    BOOK_TAN,
    BOOK_GOLD,
    PAINT_SKY,
    PAINT_CLOUD,
    PAINT_SEA,
    PAINT_SEA_DARK,
    PAINT_SUN,
    PAINT_SAND,
    PAINT_DARK,
    PAINT_GREEN,
    /* these shine */
    SKY,
    SKY_LOW,
    SKY_TOP,
    SKY_CLOUD,
    FAR_HOUSE,
    FAR_HOUSE2,
    FAR_ROOF,
    FAR_TREE,
    FAR_HEDGE,
    FLAME,
    EMBER,
    LAMPGLASS,
    MATERIALS
};

struct material {
    uint32_t colour; /* 0xRRGGBB, sRGB */
    double grain;    /* how far boards and bricks differ in brightness, share of it */
    double emission; /* above 0: shines with its colour times this, is drawn unlit, casts no shadow */
};

extern const struct material materials[MATERIALS];

#endif
