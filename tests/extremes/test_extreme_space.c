/* SPDX-License-Identifier: MIT
 *
 * Extremes of the model: vertices at the ends of the grid, a scale that no grid can hold, slivers of
 * one unit, faces that share a plane or nearly do. */
#include "compiler/compile.h"
#include "extreme.h"
#include "rigs/boxes.h"
#include "rigs/cmocka_ready.h"
#include "rigs/tiny_model.h"

#include <math.h>
#include <stdio.h>

/* The ends of the grid ----------------------------------------------------------------------- */

/* A solid in every corner of the cube, up to its very ends, and a tetrahedron across all of it. */
static void build_ends(struct model *model)
{
    static const double across[4][3] = {{-BOXES_END_M, -BOXES_END_M, -BOXES_END_M},
                                        {BOXES_END_M, BOXES_END_M, -BOXES_END_M},
                                        {BOXES_END_M, BOXES_END_M - 9000, -BOXES_END_M},
                                        {0, 0, BOXES_END_M}};

    boxes_add_world(model);
    for (int k = 0; k < 8; k++) {
        double low_m[3], high_m[3];
        for (int i = 0; i < 3; i++) {
            const double size_m = 5000 + 3001 * ((k + i) % 3);
            low_m[i] = k >> i & 1 ? BOXES_END_M - size_m : -BOXES_END_M;
            high_m[i] = k >> i & 1 ? BOXES_END_M : -BOXES_END_M + size_m;
        }
        boxes_add_solid(model, low_m, high_m);
    }
    boxes_add_tetrahedron(model, across, false);
}

static void look_from_anywhere(struct extreme *extreme, struct random *random)
{
    double eye_m[3], target_m[3];

    boxes_random_point(random, BOXES_END_M, 1.0 / 256, eye_m);
    boxes_random_point(random, BOXES_END_M, 1, target_m);
    if (random_u64(random) % 4 == 0) /* in the corner of the cube */
        for (int i = 0; i < 3; i++)
            eye_m[i] = copysign(BOXES_END_M - (double)random_in(random, 0, 12), eye_m[i]);
    extreme_frame(extreme, eye_m, target_m);
}

static void vertices_at_the_ends_of_the_grid(void **state)
{
    const struct extreme_plan plan = {"grid-ends",
                                      "Solids fill the very corners of the 16-bit grid",
                                      {160, 160, 60, 4},
                                      build_ends,
                                      look_from_anywhere,
                                      150,
                                      true};

    (void)state;
    extreme_run(&plan);
}

/* A scale that no grid holds ------------------------------------------------------------------ */

static void build_100_km(struct model *model)
{
    static const double low_m[3] = {10, 0, 10}, high_m[3] = {10.01, 0.01, 10.01};

    TINY(model, {-50000, 0, -50000}, {-50000, 0, 50000}, {50000, 0, 50000}, {50000, 0, -50000});
    boxes_add_solid(model, low_m, high_m);
}

/* 16 bits make units of 1.5 m of 100 km: the object would be nothing, and a scene without it is not what the
 * model shows. */
static void a_centimetre_on_a_hundred_kilometres_wants_more_than_16_bits(void **state)
{
    struct model model = {0};
    struct compile_options options = {.tolerance_units = 0.5, .splitter = "auto", .coordinates = COORDINATES_16};
    struct compiled scene = {0};
    struct error err = {"accepted"};

    (void)state;
    build_100_km(&model);
    extreme_about("scale-100-km-1-cm", "A box of a centimetre stands on a plain of 100 km: no 16-bit grid holds both");
    const bool accepted = compile_part(&model, NULL, &options, &scene, &err);
    extreme_row("scale-100-km-1-cm", "all", "refused, a face named", "%s: %s", accepted ? "accepted" : "refused",
                err.text);
    compiled_free(&scene);
    assert_false(accepted);
    assert_non_null(strstr(err.text, "face "));
    options.coordinates = COORDINATES_AUTO;
    if (!compile_part(&model, NULL, &options, &scene, &err)) fail_msg("%s", err.text);
    assert_true(scene.grid.is_long);
    assert_int_equal(scene.report.left_out, 0);
    compiled_free(&scene);
    model_free(&model);
}

/* Slivers ------------------------------------------------------------------------------------- */

enum { SLIVERS = 120, CURTAIN_M = 4000, SLANT_M = 37 };

/* A corner of the curtain: k units along its foot, slanting upwards. */
static void curtain_point(int k, bool top, double z_m, double out_m[3])
{
    out_m[0] = k - SLIVERS / 2 + (top ? SLANT_M : 0);
    out_m[1] = top ? CURTAIN_M : -CURTAIN_M;
    out_m[2] = z_m;
}

static void add_curtain_quad(struct model *model, const int k[4], const bool top[4], const double z_m[4])
{
    double corners[4][3];

    for (int i = 0; i < 4; i++)
        curtain_point(k[i], top[i], z_m[i], corners[i]);
    tiny_add(model, 4, (const double(*)[3])corners);
}

/* A closed solid whose front is made of slivers of a unit's width, thousands long, every third one
 * cut into needles, and whose top and bottom have all of their ends in one edge. */
static void build_slivers(struct model *model)
{
    const double front = 30, back = -30;

    boxes_add_world(model);
    for (int k = 0; k < SLIVERS; k++) {
        double a[3], b[3], c[3], d[3];
        curtain_point(k, false, front, a);
        curtain_point(k + 1, false, front, b);
        curtain_point(k + 1, true, front, c);
        curtain_point(k, true, front, d);
        const double quad[4][3] = {{a[0], a[1], a[2]}, {b[0], b[1], b[2]}, {c[0], c[1], c[2]}, {d[0], d[1], d[2]}};
        const double needles[2][3][3] = {{{a[0], a[1], a[2]}, {b[0], b[1], b[2]}, {c[0], c[1], c[2]}},
                                         {{a[0], a[1], a[2]}, {c[0], c[1], c[2]}, {d[0], d[1], d[2]}}};
        if (k % 3) {
            tiny_add(model, 4, quad);
        } else {
            tiny_add(model, 3, needles[0]);
            tiny_add(model, 3, needles[1]);
        }
    }
    add_curtain_quad(model, (int[]){SLIVERS, 0, 0, SLIVERS}, (bool[]){false, false, true, true},
                     (double[]){back, back, back, back});
    add_curtain_quad(model, (int[]){0, 0, 0, 0}, (bool[]){false, false, true, true},
                     (double[]){back, front, front, back});
    add_curtain_quad(model, (int[]){SLIVERS, SLIVERS, SLIVERS, SLIVERS}, (bool[]){false, false, true, true},
                     (double[]){front, back, back, front});
    add_curtain_quad(model, (int[]){0, SLIVERS, SLIVERS, 0}, (bool[]){true, true, true, true},
                     (double[]){front, front, back, back});
    add_curtain_quad(model, (int[]){0, SLIVERS, SLIVERS, 0}, (bool[]){false, false, false, false},
                     (double[]){back, back, front, front});
}

/* From where a sliver is tens of pixels wide to where a hundred of them are one. */
static void look_at_slivers(struct extreme *extreme, struct random *random)
{
    const double far_m = ldexp(1 + random_unit(random), (int)random_in(random, 3, 13));
    const double around = (random_unit(random) - 0.5) * 3;
    const double target_m[3] = {(double)random_in(random, -SLIVERS / 2, SLIVERS / 2),
                                (double)random_in(random, -CURTAIN_M, CURTAIN_M), 30};
    const double eye_m[3] = {target_m[0] + far_m * sin(around), target_m[1] + far_m * (random_unit(random) - 0.5),
                             target_m[2] + far_m * cos(around)};

    extreme_frame(extreme, eye_m, target_m);
}

static void slivers_of_one_unit(void **state)
{
    const struct extreme_plan plan = {"slivers-1-unit",
                                      "A curtain is made of slivers one unit wide and thousands long",
                                      {160, 160, 60, 4},
                                      build_slivers,
                                      look_at_slivers,
                                      200,
                                      false};

    (void)state;
    extreme_run(&plan);
}

/* Coplanar faces ------------------------------------------------------------------------------- */

/* Pictures on a wall, in its very plane and over one another: the first in the file is on top. What is
 * left to be seen of any of them is wide. */
static void build_coplanar(struct model *model)
{
    enum { STEP_M = 1000 };
    static const double low_m[3] = {-9000, -7000, -2000}, high_m[3] = {9000, 7000, 0};
    struct random random = {72};

    for (int k = 0; k < 40; k++) {
        const double x = STEP_M * (double)random_in(&random, -8, 6), y = STEP_M * (double)random_in(&random, -6, 4);
        const double w = STEP_M * (double)random_in(&random, 1, 2), h = STEP_M * (double)random_in(&random, 1, 2);
        TINY(model, {x, y, 0}, {x + w, y, 0}, {x + w, y + h, 0}, {x, y + h, 0});
    }
    boxes_add_world(model);
    boxes_add_solid(model, low_m, high_m);
}

static void look_at_wall(struct extreme *extreme, struct random *random)
{
    const double eye_m[3] = {(double)random_in(random, -9000, 9000), (double)random_in(random, -7000, 7000),
                             (double)random_in(random, 1500, 20000)};
    const double target_m[3] = {(double)random_in(random, -6000, 6000), (double)random_in(random, -5000, 5000), 0};

    extreme_frame(extreme, eye_m, target_m);
}

static void coplanar_faces(void **state)
{
    const struct extreme_plan plan = {"coplanar",
                                      "Pictures lie in the very plane of a wall, over one another",
                                      {160, 160, 60, 4},
                                      build_coplanar,
                                      look_at_wall,
                                      150,
                                      true};

    (void)state;
    extreme_run(&plan);
}

/* Sheets a unit apart, each smaller than the one behind it, and before them sheets that rise by one unit
 * over thousands. */
static void build_nearly_coplanar(struct model *model)
{
    boxes_add_world(model);
    for (int k = 0; k < 10; k++) {
        const double x = 9000 - 700 * k, y = 7000 - 600 * k;
        TINY(model, {-x, -y, k}, {x, -y, k}, {x, y, k}, {-x, y, k});
    }
    TINY(model, {-1800, -1200, 10}, {1800, -1200, 11}, {1800, 1200, 11}, {-1800, 1200, 10});
    TINY(model, {-900, -800, 12}, {900, -800, 12}, {900, 800, 13}, {-900, 800, 13});
}

static void nearly_coplanar_faces(void **state)
{
    const struct extreme_plan plan = {"nearly-coplanar",
                                      "Sheets are a unit apart, and some rise by one unit over thousands",
                                      {160, 160, 60, 4},
                                      build_nearly_coplanar,
                                      look_at_wall,
                                      150,
                                      true};

    (void)state;
    extreme_run(&plan);
}

/* The end of the scene straight ahead, as far from the eye as anything can be: z is all but 2^31. */
static void build_corridor(struct model *model)
{
    const double low_m[3] = {-300, -300, -BOXES_END_M}, high_m[3] = {300, 300, BOXES_END_M};

    boxes_add_room(model, low_m, high_m);
}

static void look_along(struct extreme *extreme, struct random *random)
{
    const double end_m = random_u64(random) % 2 ? BOXES_END_M : -BOXES_END_M;
    const double eye_m[3] = {random_unit(random) * 20 - 10, random_unit(random) * 20 - 10, end_m * 0.9998};
    const double target_m[3] = {0, 0, -end_m};

    extreme_frame(extreme, eye_m, target_m);
}

static void the_far_end_of_a_corridor(void **state)
{
    const struct extreme_plan plan = {"corridor-end",
                                      "The end of a corridor is as far away as anything can be",
                                      {320, 320, 90, 4},
                                      build_corridor,
                                      look_along,
                                      20,
                                      true};

    (void)state;
    extreme_run(&plan);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vertices_at_the_ends_of_the_grid),
        cmocka_unit_test(a_centimetre_on_a_hundred_kilometres_wants_more_than_16_bits),
        cmocka_unit_test(slivers_of_one_unit),
        cmocka_unit_test(coplanar_faces),
        cmocka_unit_test(nearly_coplanar_faces),
        cmocka_unit_test(the_far_end_of_a_corridor),
    };

    return cmocka_run_group_tests_name("extremes of the model", tests, NULL, NULL);
}
