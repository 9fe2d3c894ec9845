/* SPDX-License-Identifier: MIT
 *
 * The generators behind scales_models.h. */
#include "scales_models.h"

#include "rigs/tiny_model.h"

#include <math.h>

static const double FULL_TURN = 6.283185307179586;

static double between(struct random *random, double low, double high)
{
    return low + (high - low) * random_unit(random);
}

/* Evenly by their logarithms. */
static double of_scale(struct random *random, double low, double high)
{
    return low * pow(high / low, random_unit(random));
}

/* Bit i of a corner's number: the high end of axis i. Sides are counter-clockwise seen from outside. */
void scales_add_box(struct model *model, const struct scales_box *box)
{
    static const int sides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

    for (int side = 0; side < 6; side++) {
        double corners_m[4][3];
        for (int k = 0; k < 4; k++) {
            const int corner = sides[side][box->inside ? 3 - k : k];
            const double x = (corner & 1 ? 0.5 : -0.5) * box->size_m[0], z = (corner & 4 ? 0.5 : -0.5) * box->size_m[2];
            corners_m[k][0] = box->foot_m[0] + x * cos(box->turn) + z * sin(box->turn);
            corners_m[k][1] = box->foot_m[1] + (corner & 2 ? box->size_m[1] : 0);
            corners_m[k][2] = box->foot_m[2] + z * cos(box->turn) - x * sin(box->turn);
        }
        tiny_add(model, 4, (const double(*)[3])corners_m);
    }
}

static void look_at(const double eye_m[3], const double target_m[3], double out_eye_m[3], double out_target_m[3])
{
    memcpy(out_eye_m, eye_m, 3 * sizeof *eye_m);
    memcpy(out_target_m, target_m, 3 * sizeof *target_m);
}

/* Somewhere around a place, that far away along the ground, and that high. */
static void look_from_around(struct random *random, const double place_m[3], double away_m, double high_m,
                             double eye_m[3], double target_m[3])
{
    const double around = FULL_TURN * random_unit(random);
    const double from_m[3] = {place_m[0] + away_m * cos(around), place_m[1] + high_m,
                              place_m[2] + away_m * sin(around)};

    look_at(from_m, place_m, eye_m, target_m);
}

/* A ground of 240 km, 40 boxes of 0.6 m on it, and 20 of some kilometres far away ------------------------------- */

enum { GROUND_BOXES = 40, GROUND_HILLS = 20 };

static void ground_build(struct model *model)
{
    struct random random = {171};

    TINY(model, {-120000, 0, 120000}, {120000, 0, 120000}, {120000, 0, -120000}, {-120000, 0, -120000});
    for (int k = 0; k < GROUND_BOXES; k++) {
        const struct scales_box box = {
            {between(&random, -12, 12), 0, between(&random, -12, 12)}, {0.6, 0.6, 0.6}, k % 4 ? 0 : k, false};
        scales_add_box(model, &box);
    }
    for (int k = 0; k < GROUND_HILLS; k++) {
        const double side_m = between(&random, 300, 4000), away_m = between(&random, 5000, 90000);
        const double around = FULL_TURN * random_unit(&random);
        const struct scales_box box = {{away_m * cos(around), 0, away_m * sin(around)},
                                       {side_m, side_m * between(&random, 0.3, 2), side_m},
                                       k % 2 ? 0 : k,
                                       false};
        scales_add_box(model, &box);
    }
}

static void ground_look(struct random *random, double eye_m[3], double target_m[3])
{
    const double middle_m[3] = {between(random, -3, 3), 0.3, between(random, -3, 3)};
    const bool is_high = random_u64(random) % 4 == 0;

    look_from_around(random, middle_m, is_high ? of_scale(random, 50, 2000) : between(random, 2, 18),
                     is_high ? of_scale(random, 20, 2000) : between(random, 0.8, 2.3), eye_m, target_m);
}

/* A planet, whose surface is rings that get smaller towards a pole, with a house on it -------------------------- */

enum { PLANET_SIDES = 24 };
static const double PLANET_RADIUS_M = 6371000, PLANET_FIRST_RING = 2e-6, PLANET_RING_GROWTH = 2.2;

static void planet_point(double ring, int side, double out_m[3])
{
    const double around = FULL_TURN * side / PLANET_SIDES;

    out_m[0] = PLANET_RADIUS_M * sin(ring) * cos(around);
    out_m[1] = -2 * PLANET_RADIUS_M * sin(ring / 2) * sin(ring / 2);
    out_m[2] = PLANET_RADIUS_M * sin(ring) * sin(around);
}

/* From one ring to the next; the first and the last are points. */
static void planet_add_ring(struct model *model, double from, double to)
{
    const double pi = FULL_TURN / 2;

    for (int side = 0; side < PLANET_SIDES; side++) {
        double corners_m[4][3];
        planet_point(from, side, corners_m[0]);
        planet_point(from, (side + 1) % PLANET_SIDES, corners_m[1]);
        planet_point(to, (side + 1) % PLANET_SIDES, corners_m[2]);
        planet_point(to, side, corners_m[3]);
        if (from <= 0)
            tiny_add(model, 3, (const double(*)[3])corners_m + 1);
        else
            tiny_add(model, to >= pi ? 3 : 4, (const double(*)[3])corners_m);
    }
}

static void planet_build(struct model *model)
{
    static const struct scales_box house = {{0, 0, 0}, {8, 5, 6}, 0, false};
    static const struct scales_box door = {{1, 0, 3}, {0.9, 2, 0.2}, 0, false}; /* a tenth of a metre before the wall */
    static const struct scales_box chest = {{-2, 0, 3.7}, {1, 0.76, 1}, 0.3, false};
    double from = 0;

    for (double to = PLANET_FIRST_RING; to < FULL_TURN / 2; to *= PLANET_RING_GROWTH) {
        planet_add_ring(model, from, to);
        from = to;
    }
    planet_add_ring(model, from, FULL_TURN / 2);
    scales_add_box(model, &house);
    scales_add_box(model, &door);
    scales_add_box(model, &chest);
}

/* No eye near the house is within half a metre of a ring's plane: there it would be less than 1/64 pixel high, which
 * the reference does not see. */
static void planet_look(struct random *random, double eye_m[3], double target_m[3])
{
    static const double house_m[3] = {0, 2, 0}, middle_m[3] = {0, -6371000, 0};

    switch (random_u64(random) % 4) {
    case 0:
        look_from_around(random, house_m, of_scale(random, 100, 400000), of_scale(random, 50, 300000), eye_m, target_m);
        break;
    case 1:
        look_from_around(random, middle_m, PLANET_RADIUS_M * between(random, 1.3, 1.6), PLANET_RADIUS_M / 2, eye_m,
                         target_m);
        break;
    default:
        look_from_around(random, house_m, between(random, 8, 18), between(random, 0.6, 4), eye_m, target_m);
    }
}

/* A room of 10 m, and on the table in it cubes of a micrometre --------------------------------------------------- */

enum { MICRO_CUBES = 25 };
static const double MICRO_TOP_M[3] = {2, 0.75, 1};

static void micro_build(struct model *model)
{
    static const struct scales_box room = {{0, 0, 0}, {10, 3, 8}, 0, true};
    static const struct scales_box table = {{2, 0, 1}, {1.4, 0.75, 0.8}, 0, false};
    struct random random = {173};

    scales_add_box(model, &room);
    scales_add_box(model, &table);
    for (int k = 0; k < MICRO_CUBES; k++) {
        const struct scales_box cube = {{MICRO_TOP_M[0] + between(&random, -2e-5, 2e-5), MICRO_TOP_M[1],
                                         MICRO_TOP_M[2] + between(&random, -2e-5, 2e-5)},
                                        {1e-6, 1e-6, 1e-6},
                                        k,
                                        false};
        scales_add_box(model, &cube);
    }
}

static void micro_look(struct random *random, double eye_m[3], double target_m[3])
{
    const double away_m = of_scale(random, 2.5e-5, 0.5);
    const double from_m[3] = {between(random, -4, 0), between(random, 1, 2), between(random, -3, 3)};

    if (random_u64(random) % 4 == 0)
        look_at(from_m, MICRO_TOP_M, eye_m, target_m);
    else
        look_from_around(random, MICRO_TOP_M, away_m, away_m / 2, eye_m, target_m);
}

/* A corridor of 100 km, and boxes in it ---------------------------------------------------------------------------- */

enum { CORRIDOR_BOXES = 60, CORRIDOR_SMALL = 6 };
static const double CORRIDOR_M = 100000;

static void corridor_build(struct model *model)
{
    const struct scales_box corridor = {{0, 0, -CORRIDOR_M / 2}, {3, 2.5, CORRIDOR_M + 10}, 0, true};
    struct random random = {174};

    scales_add_box(model, &corridor);
    for (int k = 0; k < CORRIDOR_BOXES; k++) {
        const struct scales_box box = {{between(&random, 0.5, 1.2) * (k % 2 ? 1 : -1), 0, -of_scale(&random, 6, 99000)},
                                       {0.3, between(&random, 0.2, 1.5), 0.3},
                                       k,
                                       false};
        scales_add_box(model, &box);
    }
    for (int k = 0; k < CORRIDOR_SMALL; k++) {
        const struct scales_box box = {{between(&random, -0.5, 0.5), 0, -5 - k}, {0.05, 0.05, 0.05}, 0, false};
        scales_add_box(model, &box);
    }
}

static void corridor_look(struct random *random, double eye_m[3], double target_m[3])
{
    const double at_m = random_u64(random) % 3 ? between(random, -20, 3) : -of_scale(random, 20, CORRIDOR_M - 10);
    const double ahead_m = random_u64(random) % 4 ? -1 : 1;
    const double from_m[3] = {between(random, -0.2, 0.2), between(random, 0.8, 2), at_m};
    const double to_m[3] = {between(random, -0.5, 0.5), between(random, 0, 1.2),
                            at_m + ahead_m * of_scale(random, 3, 50)};

    look_at(from_m, to_m, eye_m, target_m);
}

/* A city block, another one 20 km away, and one 1000 km away, all below one sky
 * ----------------------------------------------------------
 */

enum { CITY_HOUSES = 30, CITY_BLOCKS = 3 };
static const double CITY_BLOCK_M[CITY_BLOCKS][3] = {{0, 0, 0}, {20000, 0, 0}, {1000000, 0, 300000}};

static void city_build(struct model *model)
{
    const struct scales_box sky = {{500000, -600000, 100000}, {1200000, 1200000, 1200000}, 0, true};
    struct random random = {175};

    scales_add_box(model, &sky);
    for (int block = 0; block < CITY_BLOCKS; block++) {
        const double *at_m = CITY_BLOCK_M[block];
        const struct scales_box ground = {{at_m[0], -1, at_m[2]}, {60, 1, 60}, 0, false};
        scales_add_box(model, &ground);
        for (int k = 0; k < CITY_HOUSES; k++) {
            const struct scales_box house = {
                {at_m[0] + between(&random, -22, 22), 0, at_m[2] + between(&random, -22, 22)},
                {between(&random, 2, 5), between(&random, 3, 12), between(&random, 2, 5)},
                between(&random, 0, 3),
                false};
            scales_add_box(model, &house);
        }
    }
}

static void city_look(struct random *random, double eye_m[3], double target_m[3])
{
    const double *at_m = CITY_BLOCK_M[random_u64(random) % CITY_BLOCKS];
    const double middle_m[3] = {at_m[0], 3, at_m[2]};
    const double away_m = random_u64(random) % 4 ? between(random, 27, 50) : of_scale(random, 50, 500);

    look_from_around(random, middle_m, away_m, between(random, -1, 9), eye_m, target_m);
}

/* Circles of boxes, each with a tenth as large a circle in its middle -------------------------------------------------
 */

enum { NESTED_LEVELS = 7, NESTED_BOXES = 14 };
static const double NESTED_M = 1000;

static void nested_build(struct model *model)
{
    const struct scales_box ground = {{0, -500, 0}, {2 * NESTED_M, 500, 2 * NESTED_M}, 0, false};
    struct random random = {176};

    scales_add_box(model, &ground);
    for (int level = 0; level < NESTED_LEVELS; level++) {
        const double scale_m = NESTED_M * pow(10, -level);
        for (int k = 0; k < NESTED_BOXES; k++) {
            const double around = FULL_TURN * k / NESTED_BOXES + level, away_m = scale_m * between(&random, 0.25, 0.8);
            const struct scales_box box = {{away_m * cos(around), 0, away_m * sin(around)},
                                           {scale_m * 0.08, scale_m * between(&random, 0.05, 0.25), scale_m * 0.08},
                                           k,
                                           false};
            scales_add_box(model, &box);
        }
    }
}

static void nested_look(struct random *random, double eye_m[3], double target_m[3])
{
    static const double middle_m[3] = {0, 0, 0};
    const double scale_m = NESTED_M * pow(10, -(double)random_in(random, 0, NESTED_LEVELS - 1));

    look_from_around(random, middle_m, scale_m * between(random, 0.9, 1.1), scale_m * 0.3, eye_m, target_m);
}

const struct scales scales_all[SCALES_COUNT] = {
    {"scales-ground", "Boxes of 0.6 m stand on a ground of 240 km", 0.1, ground_build, ground_look},
    {"scales-planet", "A house with a door stands on a planet", 0.1, planet_build, planet_look},
    {"scales-micro", "Cubes of a micrometre lie on a table in a room of 10 m", 2e-6, micro_build, micro_look},
    {"scales-corridor", "Boxes of 5 to 30 cm stand in a corridor of 100 km", 0.1, corridor_build, corridor_look},
    {"scales-city", "City blocks are 20 and 1000 km apart", 0.1, city_build, city_look},
    {"scales-nested", "Circles of boxes stand in circles ten times as large, seven of them", 1e-4, nested_build,
     nested_look},
};
