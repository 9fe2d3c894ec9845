/* SPDX-License-Identifier: MIT
 *
 * Furniture and household things as tables of boxes and turned solids. What stands on something
 * touches it: a gap of a millimetre is a crack thinner than a pixel. Nothing begins or ends at 1500,
 * the height of the walk's eye, where edges at different distances meet on one line of the picture. */
#include "demo_things.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))
#define BOXES(array) .boxes = array, .box_count = COUNT(array)
#define TURNED(array) .turned = array, .turned_count = COUNT(array)

/* A table under a carpet that hangs down on all sides, as the masters had it. */
static const struct box table_boxes[] = {
    {{-540, 0, -290}, {-460, 480, -210}, OAK_DARK, LEG, 0},
    {{460, 0, -290}, {540, 480, -210}, OAK_DARK, LEG, 0},
    {{-540, 0, 210}, {-460, 480, 290}, OAK_DARK, LEG, 0},
    {{460, 0, 210}, {540, 480, 290}, OAK_DARK, LEG, 0},
    {{-500, 90, -30}, {500, 150, 30}, OAK_DARK, 0, 0},
    {{-620, 480, -370}, {620, 560, 370}, YELLOW_CLOTH, NO_TOP, 0},
    {{-620, 560, -370}, {620, 640, 370}, BLUE_CLOTH, LEG, 0},
    {{-620, 640, -370}, {620, 770, 370}, RED_CLOTH, NO_BOTTOM, 0},
};

static const struct box side_table_boxes[] = {
    {{-270, 0, -220}, {-220, 690, -170}, OAK, LEG, 0}, {{220, 0, -220}, {270, 690, -170}, OAK, LEG, 0},
    {{-270, 0, 170}, {-220, 690, 220}, OAK, LEG, 0},   {{220, 0, 170}, {270, 690, 220}, OAK, LEG, 0},
    {{-320, 690, -270}, {320, 730, 270}, OAK, 0, 0},
};

static const struct box long_table_boxes[] = {
    {{-780, 0, -320}, {-690, 710, -230}, OAK, LEG, 0}, {{690, 0, -320}, {780, 710, -230}, OAK, LEG, 0},
    {{-780, 0, 230}, {-690, 710, 320}, OAK, LEG, 0},   {{690, 0, 230}, {780, 710, 320}, OAK, LEG, 0},
    {{-740, 120, -40}, {740, 190, 40}, OAK, 0, 0},     {{-880, 710, -410}, {880, 770, 410}, OAK_PALE, 0, 0},
};

static const struct box chair_boxes[] = {
    {{-220, 0, 165}, {-175, 430, 210}, WALNUT, LEG, 0},
    {{175, 0, 165}, {220, 430, 210}, WALNUT, LEG, 0},
    {{-220, 0, -210}, {-175, 1000, -165}, WALNUT, STANDING, 0},
    {{175, 0, -210}, {220, 1000, -165}, WALNUT, STANDING, 0},
    {{-230, 430, -160}, {230, 470, 220}, WALNUT, LEG, 0},
    {{-230, 470, -160}, {230, 470, 220}, RED_CLOTH, ~NO_TOP, 0},
    {{-175, 660, -188}, {175, 940, -188}, RED_CLOTH, NO_ENDS | LEG, 0}, /* cloth alone, seen from both sides */
};

static const struct box armchair_boxes[] = {
    {{-330, 0, -300}, {330, 330, 320}, RED_DARK, STANDING, 0},
    {{-220, 330, -180}, {220, 440, 330}, RED_CLOTH, NO_BOTTOM | NO_ENDS | NO_BACK, 0},
    {{-330, 330, -300}, {330, 1000, -180}, RED_DARK, NO_BOTTOM, 30},
    {{-330, 330, -180}, {-220, 600, 300}, RED_DARK, NO_BOTTOM | NO_BACK, 0},
    {{220, 330, -180}, {330, 600, 300}, RED_DARK, NO_BOTTOM | NO_BACK, 0},
};

static const struct turned stool_turned[] = {
    {-120, -120, OAK, 3, 2, true, {{32, 0}, {24, 420}}},
    {120, -120, OAK, 3, 2, true, {{32, 0}, {24, 420}}},
    {0, 140, OAK, 3, 2, true, {{32, 0}, {24, 420}}},
    {0, 0, OAK_PALE, 7, 2, false, {{190, 420}, {200, 465}}},
};

static const struct box bench_boxes[] = {
    {{-650, 0, -150}, {-580, 410, 150}, OAK, LEG, 0},
    {{580, 0, -150}, {650, 410, 150}, OAK, LEG, 0},
    {{-720, 410, -180}, {720, 455, 180}, OAK_PALE, 0, 0},
};

static const struct box chest_boxes[] = {
    {{-500, 50, -250}, {500, 460, 250}, OAK, NO_BACK, 0},
    {{-530, 460, -265}, {530, 540, 280}, OAK_DARK, NO_BACK, 0},
    {{-520, 0, -250}, {520, 50, 265}, OAK_DARK, NO_BACK | STANDING, 0},
    {{-430, 110, 250}, {-40, 400, 256}, OAK_DARK, ~NO_FRONT, 0},
    {{40, 110, 250}, {430, 400, 256}, OAK_DARK, ~NO_FRONT, 0},
};

static const struct box desk_boxes[] = {
    {{-620, 0, -290}, {-280, 720, 270}, WALNUT, LEG, 0},     {{280, 0, -290}, {620, 720, 270}, WALNUT, LEG, 0},
    {{-660, 720, -310}, {660, 765, 310}, OAK, 0, 0},         {{-580, 420, 270}, {-320, 660, 276}, OAK, ~NO_FRONT, 0},
    {{-580, 100, 270}, {-320, 360, 276}, OAK, ~NO_FRONT, 0}, {{320, 420, 270}, {580, 660, 276}, OAK, ~NO_FRONT, 0},
    {{320, 100, 270}, {580, 360, 276}, OAK, ~NO_FRONT, 0},
};

static const struct box cupboard_boxes[] = {
    {{-600, 0, -230}, {600, 120, 250}, EBONY, STANDING | NO_BACK, 0},
    {{-570, 120, -230}, {570, 1750, 220}, OAK, LEG | NO_BACK, 0},
    {{-660, 1750, -230}, {660, 1900, 300}, OAK_DARK, NO_BACK, 0},
    {{-500, 200, 220}, {-40, 850, 228}, OAK_DARK, ~NO_FRONT, 0},
    {{40, 200, 220}, {500, 850, 228}, OAK_DARK, ~NO_FRONT, 0},
    {{-500, 950, 220}, {-40, 1660, 228}, OAK_DARK, ~NO_FRONT, 0},
    {{40, 950, 220}, {500, 1660, 228}, OAK_DARK, ~NO_FRONT, 0},
};

/* Head at the left; the front side open to the room. */
static const struct box bed_boxes[] = {
    {{-1050, 0, -620}, {-970, 2050, -540}, OAK_DARK, LEG, 0},
    {{970, 0, -620}, {1050, 2050, -540}, OAK_DARK, LEG, 0},
    {{-1050, 0, 540}, {-970, 2050, 620}, OAK_DARK, LEG, 0},
    {{970, 0, 540}, {1050, 2050, 620}, OAK_DARK, LEG, 0},
    {{-1100, 2050, -670}, {1100, 2190, 670}, OAK, 0, 0},
    {{-970, 180, -600}, {970, 420, 600}, OAK, 0, 0},
    {{-970, 420, -580}, {-940, 1200, 580}, OAK, STANDING, 0},
    {{-935, 420, -560}, {960, 560, 560}, LINEN, NO_BOTTOM, 0},
    {{-450, 560, -540}, {950, 610, 575}, RED_CLOTH, NO_BOTTOM, 25},
    {{-620, 560, -540}, {-450, 600, 575}, LINEN, NO_BOTTOM | NO_RIGHT, 15},
    {{-920, 560, -480}, {-650, 700, -40}, LINEN, NO_BOTTOM, 45},
    {{-920, 560, 40}, {-650, 700, 480}, LINEN, NO_BOTTOM, 45},
};

static const struct box clock_boxes[] = {
    {{-230, 0, -140}, {230, 440, 140}, WALNUT, STANDING | NO_BACK, 0},
    {{-170, 440, -140}, {170, 1480, 100}, WALNUT, LEG | NO_BACK, 0},
    {{-100, 620, 100}, {100, 1380, 106}, OAK, ~NO_FRONT, 0},
    {{-230, 1480, -140}, {230, 2000, 130}, OAK_DARK, NO_BACK | NO_TOP, 0},
    {{-270, 2000, -140}, {270, 2120, 170}, WALNUT, NO_BACK, 70},
    {{-165, 1590, 130}, {165, 1920, 136}, BRASS, ~NO_FRONT, 0},
    {{-120, 1635, 130}, {120, 1875, 140}, PAPER, ~NO_FRONT, 0},
    {{-8, 1750, 130}, {8, 1850, 144}, EBONY, ~NO_FRONT, 0},
    {{8, 1748, 130}, {80, 1764, 144}, EBONY, ~NO_FRONT, 0},
};

static const struct turned barrel_turned[] = {
    {0, 0, OAK, 7, 2, true, {{215, 0}, {250, 200}}},    {0, 0, EBONY, 7, 2, true, {{250, 200}, {258, 260}}},
    {0, 0, OAK, 7, 2, true, {{258, 260}, {258, 440}}},  {0, 0, EBONY, 7, 2, true, {{258, 440}, {250, 500}}},
    {0, 0, OAK, 7, 2, false, {{250, 500}, {215, 700}}},
};

static const struct box dresser_boxes[] = {
    {{-750, 0, -220}, {750, 820, 220}, GREEN_PAINT, LEG | NO_BACK, 0},
    {{-790, 820, -220}, {790, 860, 250}, OAK_PALE, NO_BACK, 0},
    {{-690, 80, 220}, {-40, 760, 226}, OAK, ~NO_FRONT, 0},
    {{40, 80, 220}, {690, 760, 226}, OAK, ~NO_FRONT, 0},
    {{-750, 860, -220}, {-715, 1900, 20}, GREEN_PAINT, LEG | NO_BACK, 0},
    {{715, 860, -220}, {750, 1900, 20}, GREEN_PAINT, LEG | NO_BACK, 0},
    {{-715, 860, -230}, {715, 1900, -200}, OAK_DARK, ~NO_FRONT, 0},
    {{-715, 1180, -200}, {715, 1210, 10}, GREEN_PAINT, NO_BACK | NO_ENDS, 0},
    {{-715, 1530, -200}, {715, 1560, 10}, GREEN_PAINT, NO_BACK | NO_ENDS, 0},
    {{-790, 1900, -220}, {790, 1970, 60}, OAK_PALE, NO_BACK, 0},
};

/* 1500 wide, shelves at 90, 560, 1030 and 1515; the books are set in by the room. */
static const struct box bookcase_boxes[] = {
    {{-750, 0, -150}, {-715, 2000, 150}, WALNUT, LEG | NO_BACK, 0},
    {{715, 0, -150}, {750, 2000, 150}, WALNUT, LEG | NO_BACK, 0},
    {{-715, 90, -150}, {715, 2000, -130}, OAK_DARK, ~NO_FRONT, 0},
    {{-715, 0, -130}, {715, 90, 140}, WALNUT, NO_ENDS | NO_BACK | STANDING, 0},
    {{-715, 530, -130}, {715, 560, 140}, WALNUT, NO_ENDS | NO_BACK, 0},
    {{-715, 1000, -130}, {715, 1030, 140}, WALNUT, NO_ENDS | NO_BACK, 0},
    {{-715, 1485, -130}, {715, 1515, 140}, WALNUT, NO_ENDS | NO_BACK, 0},
    {{-780, 2000, -150}, {780, 2080, 180}, WALNUT, NO_BACK, 0},
};

/* Leaning back, in a frame already leaning; the canvas rests on the ledge at 800. */
static const struct box easel_boxes[] = {
    {{-420, 70, -40}, {-360, 1900, 0}, OAK, 0, 0},       {{360, 70, -40}, {420, 1900, 0}, OAK, 0, 0},
    {{-360, 480, -35}, {360, 540, -5}, OAK, NO_ENDS, 0}, {{-360, 1780, -35}, {360, 1840, -5}, OAK, NO_ENDS, 0},
    {{-520, 760, 0}, {520, 800, 90}, OAK_PALE, 0, 0},
};

static const struct turned chandelier_turned[] = {
    {0, 0, BRASS, 6, 3, false, {{0, -180}, {100, -60}, {20, 120}}},
    {0, 0, BRASS, 3, 2, true, {{18, 120}, {18, 570}}},
    {300, 0, LINEN, 3, 2, true, {{24, 36}, {24, 150}}},
    {-300, 0, LINEN, 3, 2, true, {{24, 36}, {24, 150}}},
    {0, 300, LINEN, 3, 2, true, {{24, 36}, {24, 150}}},
    {0, -300, LINEN, 3, 2, true, {{24, 36}, {24, 150}}},
    {300, 0, FLAME, 3, 2, false, {{24, 150}, {0, 250}}},
    {-300, 0, FLAME, 3, 2, false, {{24, 150}, {0, 250}}},
    {0, 300, FLAME, 3, 2, false, {{24, 150}, {0, 250}}},
    {0, -300, FLAME, 3, 2, false, {{24, 150}, {0, 250}}},
};
static const struct box chandelier_boxes[] = {
    {{-330, 10, -24}, {-70, 36, 24}, BRASS, NO_RIGHT, 0},
    {{70, 10, -24}, {330, 36, 24}, BRASS, NO_LEFT, 0},
    {{-24, 10, -330}, {24, 36, -70}, BRASS, NO_FRONT, 0},
    {{-24, 10, 70}, {24, 36, 330}, BRASS, NO_BACK, 0},
};

static const struct turned globe_turned[] = {
    {0, 0, OAK_DARK, 4, 4, true, {{240, 0}, {50, 60}, {40, 420}, {120, 520}}},
    {0, 0, BLUE_PALE, 7, 3, true, {{70, 520}, {190, 590}, {256, 690}}},
    {0, 0, PAINT_SAND, 7, 2, true, {{256, 690}, {258, 800}}},
    {0, 0, PAINT_GREEN, 7, 3, false, {{258, 800}, {190, 930}, {0, 1010}}},
};

static const struct turned desk_lamp_turned[] = {
    {0, 0, BRASS, 6, 3, true, {{90, 0}, {18, 40}, {18, 300}}},
    {0, 0, LAMPGLASS, 6, 2, true, {{30, 300}, {50, 382}}},
    {0, 0, GREEN_CLOTH, 8, 2, false, {{170, 380}, {60, 500}}},
};

static const struct turned candle_turned[] = {
    {0, 0, BRASS, 5, 3, false, {{70, 0}, {16, 30}, {24, 150}}},
    {0, 0, LINEN, 4, 2, true, {{18, 150}, {18, 320}}},
    {0, 0, FLAME, 4, 2, false, {{18, 320}, {0, 400}}},
};

static const struct turned jug_turned[] = {
    {0, 0, DELFT_WHITE, 6, 3, true, {{60, 0}, {110, 90}, {98, 190}}},
    {0, 0, DELFT_BLUE, 6, 3, false, {{98, 190}, {48, 280}, {66, 350}}},
};

static const struct turned bowl_turned[] = {
    {0, 0, POTTERY, 7, 2, false, {{80, 0}, {175, 100}}},
    {-60, 30, APPLE, 4, 2, false, {{60, 100}, {30, 175}}},
    {65, 20, LEMON, 4, 2, false, {{58, 100}, {20, 180}}},
    {0, -80, ORANGE, 4, 2, false, {{60, 100}, {25, 185}}},
};

static const struct turned vase_turned[] = {
    {0, 0, BLUE_CLOTH, 6, 3, false, {{60, 0}, {110, 120}, {45, 320}}},
    {0, 0, LEAF, 5, 2, false, {{30, 320}, {140, 450}}},
    {-70, 40, RED_CLOTH, 4, 3, false, {{0, 450}, {75, 520}, {0, 590}}},
    {70, 0, YELLOW_CLOTH, 4, 3, false, {{0, 450}, {70, 540}, {0, 630}}},
};

static const struct turned pot_plant_turned[] = {
    {0, 0, CLAY, 6, 2, true, {{130, 0}, {205, 320}}},
    {0, 0, EARTH, 6, 1, false, {{205, 320}}},
    {0, 0, LEAF_DARK, 6, 3, true, {{60, 320}, {270, 520}, {90, 860}}},
    {0, 0, LEAF, 6, 3, false, {{90, 860}, {190, 900}, {0, 1150}}},
};

static const struct turned tub_tree_turned[] = {
    {0, 0, OAK_PALE, 7, 2, true, {{190, 0}, {240, 400}}},
    {0, 0, EARTH, 7, 1, false, {{240, 400}}},
    {0, 0, OAK_DARK, 4, 2, true, {{45, 400}, {35, 1010}}},
    {0, 0, LEAF_DARK, 7, 3, true, {{60, 1000}, {360, 1150}, {430, 1400}}},
    {0, 0, LEAF, 7, 3, false, {{430, 1400}, {330, 1700}, {0, 1900}}},
};

static const struct box bust_boxes[] = {{{-110, 0, -90}, {110, 60, 90}, STONE, NO_BOTTOM, 0}};
static const struct turned bust_turned[] = {
    {0, 0, LINEN, 6, 3, true, {{60, 60}, {165, 190}, {55, 290}}},
    {0, 0, LINEN, 6, 3, false, {{55, 290}, {100, 400}, {45, 550}}},
};

static const struct turned bottles_turned[] = {
    {-260, 0, GREEN_CLOTH, 5, 3, false, {{55, 0}, {55, 130}, {18, 240}}},
    {-110, 20, BLUE_CLOTH, 5, 2, false, {{60, 0}, {35, 140}}},
    {60, -10, CLAY, 6, 2, false, {{80, 0}, {40, 170}}},
};

static const struct turned brushes_turned[] = {
    {0, 0, CLAY, 5, 2, false, {{50, 0}, {60, 130}}},
    {-20, 10, OAK_PALE, 3, 2, false, {{8, 130}, {10, 300}}},
    {20, -15, RED_CLOTH, 3, 2, false, {{8, 130}, {10, 330}}},
};

static const struct box paints_boxes[] = {
    {{-230, 0, -140}, {230, 14, 140}, OAK_PALE, NO_BOTTOM, 0}, {{-190, 14, 40}, {-120, 18, 110}, RED_CLOTH, ~NO_TOP, 0},
    {{-80, 14, 50}, {-10, 18, 115}, LEMON, ~NO_TOP, 0},        {{30, 14, 45}, {100, 18, 110}, BLUE_CLOTH, ~NO_TOP, 0},
    {{130, 14, 10}, {195, 18, 80}, LEAF, ~NO_TOP, 0},          {{-180, 14, -70}, {-110, 18, 0}, LINEN, ~NO_TOP, 0},
    {{-60, 14, -80}, {10, 18, -15}, BRICK, ~NO_TOP, 0},
};

static const struct turned loaf_turned[] = {{0, 0, BREAD, 7, 3, false, {{150, 0}, {165, 60}, {80, 120}}}};

/* On the dresser's two upper shelves and on its top; plates stand on edge as thin boxes. */
static const struct box plates_boxes[] = {
    {{-600, 1210, -170}, {-330, 1480, -165}, DELFT_WHITE, ~NO_FRONT, 0},
    {{-230, 1210, -170}, {40, 1480, -165}, DELFT_BLUE, ~NO_FRONT, 0},
    {{140, 1210, -170}, {410, 1480, -165}, DELFT_WHITE, ~NO_FRONT, 0},
    {{-520, 1560, -170}, {-280, 1800, -165}, DELFT_BLUE, ~NO_FRONT, 0},
    {{-160, 1560, -170}, {80, 1800, -165}, DELFT_WHITE, ~NO_FRONT, 0},
    {{200, 1560, -170}, {440, 1800, -165}, DELFT_BLUE, ~NO_FRONT, 0},
};
static const struct turned plates_turned[] = {
    {550, -90, PEWTER, 6, 2, false, {{75, 1210}, {45, 1390}}},
    {-450, 40, COPPER, 6, 2, false, {{80, 860}, {120, 1010}}},
    {380, 30, CLAY, 6, 2, false, {{100, 860}, {60, 1070}}},
};

static const struct box pump_boxes[] = {
    {{-320, 0, -60}, {320, 400, 420}, STONE, STANDING, 0},
    {{-260, 400, 0}, {260, 405, 360}, PAINT_SEA, ~NO_TOP, 0},
    {{-110, 0, -200}, {110, 1540, -62}, OAK_DARK, STANDING, 0},
    {{-25, 760, -62}, {25, 820, 140}, PEWTER, NO_BACK, 0},
    {{112, 640, -150}, {150, 1260, -110}, PEWTER, 0, 0},
};

static const struct turned bucket_turned[] = {
    {0, 0, OAK_PALE, 7, 2, true, {{110, 0}, {145, 260}}},
    {0, 0, PAINT_SEA_DARK, 7, 1, false, {{145, 260}}},
};

static const struct turned tree_turned[] = {
    {0, 0, OAK_DARK, 4, 2, true, {{130, 0}, {90, 500}}},
    {0, 0, LEAF_DARK, 7, 3, true, {{150, 450}, {800, 700}, {950, 1100}}},
    {0, 0, LEAF, 7, 3, false, {{950, 1100}, {700, 1800}, {0, 2200}}},
};

static const struct box open_book_boxes[] = {
    {{-205, 0, -135}, {0, 45, 135}, PAPER, NO_BOTTOM, 14},
    {{0, 0, -135}, {205, 45, 135}, PAPER, NO_BOTTOM, 14},
};

/* A rail with copper pans, for a wall; the frame stands at the rail's middle. */
static const struct box pans_boxes[] = {
    {{-520, 0, 0}, {520, 45, 30}, OAK_DARK, NO_BACK, 0},     {{-410, -160, 30}, {-385, 40, 45}, EBONY, ~NO_FRONT, 0},
    {{-20, -120, 30}, {5, 40, 45}, EBONY, ~NO_FRONT, 0},     {{350, -180, 30}, {375, 40, 45}, EBONY, ~NO_FRONT, 0},
    {{-530, -420, 5}, {-265, -160, 55}, COPPER, NO_BACK, 0}, {{-110, -320, 5}, {95, -120, 55}, BRASS, NO_BACK, 0},
    {{220, -460, 5}, {505, -180, 55}, COPPER, NO_BACK, 0},
};

static const struct box mirror_boxes[] = {
    {{-260, 0, 0}, {260, 640, 40}, EBONY, NO_BACK, 0},
    {{-200, 60, 0}, {200, 580, 44}, BLUE_PALE, ~NO_FRONT, 0},
};

static const struct box cat_boxes[] = {{{-22, 0, -330}, {22, 40, -95}, HAIR, NO_FRONT | NO_BOTTOM, 0}};
static const struct turned cat_turned[] = {
    {0, 0, HAIR, 6, 3, false, {{105, 0}, {112, 70}, {58, 235}}},
    {0, 20, HAIR, 6, 3, false, {{50, 235}, {76, 275}, {44, 335}}},
    {-22, 20, HAIR, 3, 2, false, {{18, 335}, {0, 385}}},
    {22, 20, HAIR, 3, 2, false, {{18, 335}, {0, 385}}},
};

const struct thing things[THINGS] = {
    [TABLE] = {BOXES(table_boxes)},
    [SIDE_TABLE] = {BOXES(side_table_boxes)},
    [LONG_TABLE] = {BOXES(long_table_boxes)},
    [CHAIR] = {BOXES(chair_boxes)},
    [ARMCHAIR] = {BOXES(armchair_boxes)},
    [STOOL] = {TURNED(stool_turned)},
    [BENCH] = {BOXES(bench_boxes)},
    [CHEST] = {BOXES(chest_boxes)},
    [DESK] = {BOXES(desk_boxes)},
    [CUPBOARD] = {BOXES(cupboard_boxes)},
    [BED] = {BOXES(bed_boxes)},
    [CLOCK] = {BOXES(clock_boxes)},
    [BARREL] = {TURNED(barrel_turned)},
    [DRESSER] = {BOXES(dresser_boxes)},
    [BOOKCASE] = {BOXES(bookcase_boxes)},
    [EASEL_STAND] = {BOXES(easel_boxes)},
    [CHANDELIER] = {BOXES(chandelier_boxes), TURNED(chandelier_turned)},
    [GLOBE] = {TURNED(globe_turned)},
    [DESK_LAMP] = {TURNED(desk_lamp_turned)},
    [CANDLE] = {TURNED(candle_turned)},
    [JUG] = {TURNED(jug_turned)},
    [BOWL] = {TURNED(bowl_turned)},
    [VASE] = {TURNED(vase_turned)},
    [POT_PLANT] = {TURNED(pot_plant_turned)},
    [TUB_TREE] = {TURNED(tub_tree_turned)},
    [BUST] = {BOXES(bust_boxes), TURNED(bust_turned)},
    [BOTTLES] = {TURNED(bottles_turned)},
    [BRUSHES] = {TURNED(brushes_turned)},
    [PAINTS] = {BOXES(paints_boxes)},
    [LOAF] = {TURNED(loaf_turned)},
    [PLATES] = {BOXES(plates_boxes), TURNED(plates_turned)},
    [PUMP] = {BOXES(pump_boxes)},
    [BUCKET] = {TURNED(bucket_turned)},
    [TREE] = {TURNED(tree_turned)},
    [OPEN_BOOK] = {BOXES(open_book_boxes)},
    [PANS] = {BOXES(pans_boxes)},
    [MIRROR] = {BOXES(mirror_boxes)},
    [CAT] = {BOXES(cat_boxes), TURNED(cat_turned)},
};

void thing_build(struct soup *soup, const struct frame *frame, enum thing_id id)
{
    const struct thing *thing = &things[id];
    for (size_t i = 0; i < thing->box_count; i++)
        shape_box(soup, frame, &thing->boxes[i]);
    for (size_t i = 0; i < thing->turned_count; i++)
        shape_turned(soup, frame, &thing->turned[i]);
}
