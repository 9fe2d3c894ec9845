/* SPDX-License-Identifier: MIT
 *
 * The plan of the house: studio, library and kitchen in the north, hall, stairs, bedchamber and a
 * walled court in the south, joined into a ring by doorways; windows; daylight, sun and lamps. */
#include "demo_house.h"
#include "demo_carve.h"
#include "demo_joinery.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

static const struct space rooms[] = {
    /* from, to; floor, chequered with; wall, ceiling, dado and its height; size of panels and tiles */
    /* hall */
    {{0, 0, 5050}, {4400, 3200, 10000}, MARBLE, BASALT, WHITEWASH, OAK_DARK, GREY_BLUE, 150, 1000, {550, 550}},
    /* studio */
    {{0, 0, 0}, {5400, 3400, 4800}, PLANK, PLANK, PLASTER, OAK_DARK, GREY_BLUE, 900, 1000, {450, 1600}},
    /* library */
    {{5650, 0, 0}, {8450, 2900, 4800}, PLANK_DARK, PLANK_DARK, SAGE, CREAM, WALNUT, 900, 1000, {700, 800}},
    /* kitchen */
    {{8700, 0, 0}, {13400, 2900, 4800}, TILE, TILE_DARK, OCHRE, OAK_DARK, DELFT_WHITE, 300, 1000, {672, 686}},
    /* bedchamber */
    {{7700, 0, 5050}, {10900, 2800, 10000}, OAK_PALE, OAK_PALE, GREY_BLUE, WHITEWASH, WHITEWASH, 0, 1000, {400, 1650}},
    /* stairs, and the shaft of light above their landing */
    {{4650, 0, 5050}, {7450, 3200, 10000}, SLATE, STONE, WHITEWASH, CREAM, GREEN_PAINT, 1000, 1000, {700, 707}},
    {{6250, 3200, 5050}, {7450, 4700, 6050}, SKY, SKY, WHITEWASH, SKY, WHITEWASH, 0, 800, {0, 0}},
    /* court, the air over its walls, the air over the eaves */
    {{11250, 0, 5150}, {14700, 2200, 10000}, PAVING, PAVING_DARK, BRICK, SKY, BRICK_DARK, 0, 900, {690, 606}},
    {{11250, 2200, 5150}, {14700, 3100, 10000}, STONE, STONE, BRICK, SKY, BRICK, 0, 1700, {0, 0}},
    {{14700, 2200, 5150}, {15300, 3100, 10000}, STONE, STONE, SKY, SKY, SKY, 0, 0, {0, 0}},
    {{11250, 2200, 10000}, {15300, 3100, 11600}, STONE, STONE, SKY, SKY, SKY, 0, 0, {0, 0}},
    {{10400, 3100, 4300}, {15300, 5400, 11600}, SKY, SKY, SKY, SKY_TOP, SKY, 0, 0, {0, 0}},
    /* street in the south, gardens in the west and north */
    {{-900, -300, 10350}, {10200, 4200, 12400}, STONE, STONE, SKY, SKY_TOP, SKY, 0, 0, {0, 0}},
    {{-1900, -300, 5200}, {-350, 4200, 9800}, STONE, STONE, SKY, SKY_TOP, SKY, 0, 0, {0, 0}},
    {{600, -300, -2000}, {12300, 4200, -350}, STONE, STONE, SKY, SKY_TOP, SKY, 0, 0, {0, 0}},
    /* fireplace in the kitchen's east wall */
    {{13400, 0, 1900}, {13950, 1350, 3300}, SOOT, SOOT, BRICK_DARK, SOOT, BRICK_DARK, 0, 480, {0, 0}},
};

static const struct space doorways[] = {
    {{1550, 0, 4800}, {2450, 2150, 5050}, STONE, STONE, OAK, OAK, OAK, 0, 0, {0, 0}}, /* hall - studio */
    {{5400, 0, 2150}, {5650, 2150, 3050}, OAK, OAK, OAK, OAK, OAK, 0, 0, {0, 0}},     /* studio - library */
    {{8450, 0, 2150}, {8700, 2150, 3050}, STONE, STONE, OAK, OAK, OAK, 0, 0, {0, 0}}, /* library - kitchen */
    {{11900, 0, 4800}, {12800, 2150, 5150}, STONE, STONE, GREEN_PAINT, GREEN_PAINT, OAK, 0, 0, {0, 0}}, /* - court */
    {{10900, 0, 7050}, {11250, 2150, 7950}, STONE, STONE, GREEN_PAINT, GREEN_PAINT, OAK, 0, 0, {0, 0}}, /* - bed */
    {{7450, 0, 7050}, {7700, 2150, 7950}, OAK, OAK, OAK, OAK, OAK, 0, 0, {0, 0}},     /* bedchamber - stairs */
    {{4400, 0, 7050}, {4650, 2150, 7950}, STONE, STONE, OAK, OAK, OAK, 0, 0, {0, 0}}, /* stairs - hall */
};

const struct window house_windows[] = {
    {{1500, 900, 10000}, {2800, 2600, 10350}, SOUTH, 2, 2, true, 0.8}, /* hall */
    {{400, 2300, 10000}, {1300, 2800, 10350}, SOUTH, 2, 1, true, 1.0}, /* over the front door */
    {{-350, 900, 6850}, {0, 2500, 8150}, WEST, 2, 2, true, 0.8},       /* hall, at the end of the enfilade */
    {{-350, 900, 8700}, {0, 2500, 9600}, WEST, 2, 2, true, 0.8},       /* hall */
    {{1200, 900, -350}, {4200, 3000, 0}, NORTH, 3, 2, false, 1.0},     /* studio */
    {{6450, 1100, -350}, {7650, 2500, 0}, NORTH, 2, 2, false, 2.2},    /* library */
    {{10000, 1100, -350}, {11600, 2400, 0}, NORTH, 2, 2, false, 2.2},  /* kitchen */
    {{7950, 900, 10000}, {9050, 2400, 10350}, SOUTH, 2, 2, true, 2.2}, /* bedchamber */
    {{4950, 900, 10000}, {6050, 2600, 10350}, SOUTH, 2, 2, true, 0.8}, /* stairs */
};
const size_t house_window_count = COUNT(house_windows);

const struct opening house_skies[] = {
    /* over the court: zenith, south, east, west, north */
    {{10.4, 5.4, 4.3}, {4.9, 0, 0}, {0, 0, 7.3}, 0.2},
    {{10.4, 2.2, 11.6}, {0, 3.2, 0}, {4.9, 0, 0}, 0.2},
    {{15.3, 2.2, 4.3}, {0, 3.2, 0}, {0, 0, 7.3}, 0.2},
    {{10.4, 4.1, 4.3}, {0, 0, 7.3}, {0, 1.3, 0}, 0.2},
    {{10.4, 4.1, 4.3}, {0, 1.3, 0}, {4.9, 0, 0}, 0.2},
    /* the skylight over the stairs */
    {{6.25, 4.7, 5.05}, {1.2, 0, 0}, {0, 0, 1.0}, 1.0},
};
const size_t house_sky_count = COUNT(house_skies);

const struct vec3 house_sun = {0.42, -0.55, -0.72};

const struct lamp house_lamps[] = {
    {{13.62, 0.45, 2.6}, 0.12, {6.0, 3.3, 1.4}},  /* kitchen fire */
    {{7.55, 1.32, 0.55}, 0.06, {2.4, 1.8, 1.0}},  /* library desk */
    {{2.2, 2.45, 7.5}, 0.25, {1.2, 0.8, 0.35}},   /* hall chandelier */
    {{10.6, 1.25, 9.3}, 0.05, {0.8, 0.45, 0.15}}, /* bedchamber candle */
};
const size_t house_lamp_count = COUNT(house_lamps);

const struct vec3 house_kitchen_door[4] = {{11.9, 0, 5.15}, {12.8, 0, 5.15}, {12.8, 2.15, 5.15}, {11.9, 2.15, 5.15}};

const struct vec3 house_court_edges[2][2] = {
    {{11.25, 3.1, 10}, {11.25, 3.1, 5.15}}, /* the western eaves */
    {{14.7, 2.2, 10}, {11.25, 2.2, 10}},    /* the southern wall */
};
const struct vec3 house_court_lit = {14.7, 2.2, 5.15};

static struct space window_space(const struct window *window)
{
    struct space space = {.floor = OAK_PALE, .floor2 = OAK_PALE, .wall = WHITEWASH, .ceiling = WHITEWASH};
    for (int axis = 0; axis < 3; axis++) {
        space.lo_mm[axis] = window->lo_mm[axis];
        space.hi_mm[axis] = window->hi_mm[axis];
    }
    return space;
}

/* The hole in the wall, wider than the passage: its upright edges lie behind the posts, not on the
 * lining that joinery_doorway() adds, where nothing would keep them together. */
static struct space doorway_space(const struct space *doorway)
{
    struct space space = *doorway;
    int across = 2 - doorway_axis(doorway);
    space.lo_mm[across] -= POST_HIDES_MM;
    space.hi_mm[across] += POST_HIDES_MM;
    space.wall = LEFT_OUT;
    return space;
}

void house_build(struct soup *soup)
{
    struct space spaces[COUNT(rooms) + COUNT(doorways) + COUNT(house_windows)];
    size_t count = 0;
    for (size_t i = 0; i < COUNT(rooms); i++)
        spaces[count++] = rooms[i];
    for (size_t i = 0; i < COUNT(doorways); i++)
        spaces[count++] = doorway_space(&doorways[i]);
    for (size_t i = 0; i < COUNT(house_windows); i++)
        spaces[count++] = window_space(&house_windows[i]);
    carve(soup, spaces, count);
    for (size_t i = 0; i < COUNT(doorways); i++)
        joinery_doorway(soup, &doorways[i]);
    for (size_t i = 0; i < COUNT(house_windows); i++)
        joinery_window(soup, &house_windows[i]);
    joinery_fixtures(soup);
}
