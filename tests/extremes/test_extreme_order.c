/* SPDX-License-Identifier: MIT
 *
 * Polygons that no order can sort whole: rings that cover one another in a circle, and polygons that pass
 * through each other. The compiler has to split them, and the order is exact afterwards. */
#include "extreme.h"
#include "rigs/boxes.h"
#include "rigs/cmocka_ready.h"
#include "rigs/tiny_model.h"

#include <math.h>

static void add_two_sided(struct model *model, const double corners_m[4][3])
{
    tiny_add(model, 4, corners_m);
    model->faces[model->face_count - 1].two_sided = true;
}

/* A parallelogram, flat whatever its corners are rounded to. */
static void add_plate(struct model *model, const double at_m[3], const double u_m[3], const double v_m[3])
{
    double corners_m[4][3];

    for (int i = 0; i < 3; i++) {
        const double at = round(at_m[i]), u = round(u_m[i]), v = round(v_m[i]);
        corners_m[0][i] = at;
        corners_m[1][i] = at + u;
        corners_m[2][i] = at + u + v;
        corners_m[3][i] = at + v;
    }
    add_two_sided(model, (const double(*)[3])corners_m);
}

/* Bars along the sides of a regular polygon, each longer than its side, rising from behind the bar before
 * to before the bar after. */
static void add_ring(struct model *model, int bars, const double centre_m[3], double radius_m)
{
    const double half_turn = 3.14159265358979 / bars, rise_m = radius_m / 8;

    for (int k = 0; k < bars; k++) {
        const double angle = 2 * half_turn * k, length = 2 * radius_m * sin(half_turn);
        const double along[3] = {-sin(angle + half_turn), cos(angle + half_turn), 0};
        const double across[3] = {cos(angle + half_turn), sin(angle + half_turn), 0};
        const double from[3] = {radius_m * cos(angle), radius_m * sin(angle), -rise_m};
        double at_m[3], u_m[3], v_m[3];
        for (int i = 0; i < 3; i++) {
            at_m[i] = centre_m[i] + from[i] - along[i] * 0.25 * length;
            u_m[i] = along[i] * 1.5 * length + (i == 2 ? 3 * rise_m : 0);
            v_m[i] = across[i] * 0.2 * length;
        }
        at_m[2] -= 0.5 * rise_m;
        add_plate(model, at_m, u_m, v_m);
    }
}

static void build_rings(struct model *model)
{
    static const int bars[] = {3, 4, 5, 7};

    boxes_add_world(model);
    for (int k = 0; k < 4; k++) {
        const double centre_m[3] = {k % 2 ? 9000 : -9000, k / 2 ? 9000 : -9000, 3000 * k};
        add_ring(model, bars[k], centre_m, 5000);
    }
}

static void build_crossing(struct model *model)
{
    struct random random = {73};

    boxes_add_world(model);
    for (int k = 0; k < 24; k++) {
        double centre_m[3], u_m[3], v_m[3], at_m[3];
        boxes_random_point(&random, 3000, 1, centre_m);
        boxes_random_point(&random, 12000, 1, u_m);
        boxes_random_point(&random, 12000, 1, v_m);
        for (int i = 0; i < 3; i++)
            at_m[i] = centre_m[i] - floor((u_m[i] + v_m[i]) / 2);
        add_plate(model, at_m, u_m, v_m);
    }
}

static void look_from_around(struct extreme *extreme, struct random *random)
{
    double eye_m[3], target_m[3];

    boxes_random_point(random, 30000, 1, eye_m);
    boxes_random_point(random, 9000, 1, target_m);
    extreme_frame(extreme, eye_m, target_m);
}

static void look_from_before(struct extreme *extreme, struct random *random)
{
    double eye_m[3], target_m[3];

    boxes_random_point(random, 20000, 1, eye_m);
    boxes_random_point(random, 12000, 1, target_m);
    eye_m[2] = random_u64(random) % 2 ? 30000 : -30000;
    target_m[2] = 0;
    extreme_frame(extreme, eye_m, target_m);
}

/* A tree without a split would have them in some order, and some pixels wrong. */
static void assert_split(const struct extreme_plan *plan)
{
    const struct core *profiles[PROFILES_MAX];
    struct extreme extreme;
    struct model model = {0};

    profiles_find(profiles);
    plan->build(&model);
    extreme_open(&extreme, &model, profiles[0], &plan->picture);
    assert_true(extreme.scene.report.splits > 0);
    extreme_close(&extreme);
    model_free(&model);
}

static void rings_of_polygons_that_cover_one_another(void **state)
{
    const struct extreme_plan plan = {"cyclic",
                                      "Bars cover one another in rings, so that no order of whole faces is right",
                                      {160, 160, 60, 4},
                                      build_rings,
                                      look_from_before,
                                      200,
                                      true};

    (void)state;
    assert_split(&plan);
    extreme_run(&plan);
}

static void polygons_through_one_another(void **state)
{
    const struct extreme_plan plan = {"interpenetrating",
                                      "Plates pass through one another",
                                      {160, 160, 60, 4},
                                      build_crossing,
                                      look_from_around,
                                      200,
                                      true};

    (void)state;
    assert_split(&plan);
    extreme_run(&plan);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rings_of_polygons_that_cover_one_another),
        cmocka_unit_test(polygons_through_one_another),
    };

    return cmocka_run_group_tests_name("extremes of order", tests, NULL, NULL);
}
