/* SPDX-License-Identifier: MIT
 *
 * Which of two movers may be drawn before the other, against ways from the eye in doubles: if one precedes, no point of
 * the other lies on the way from the eye to any of its own. Boxes and octahedra, turned anyhow, side by side and in
 * each other. */
#include "limner.h"

#include "movers/mover.h"
#include "rigs/cmocka_ready.h"
#include "rigs/plain_lines.h"
#include "rigs/random_camera.h"
#include "rigs/set_rig.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 4000, SIDE_PX = 16, MOVERS = 2, ENTRIES = 16, WAYS = 150, STEPS = 24 };

struct stage {
    struct set nothing, objects[MOVERS];
    struct lim_box boxes[MOVERS];
    bool pointed[MOVERS]; /* an octahedron */
    struct lim_instance instances[MOVERS];
    struct lim lim;
    struct plain_lines lines;
    uint16_t line[SIDE_PX];
    void *mem, *mover_mem;
};

static void stage_open(struct stage *stage)
{
    const struct lim_movers_limits limits = {MOVERS, 1, ENTRIES};

    memset(stage, 0, sizeof *stage);
    set_init(&stage->nothing);
    stage->lines.pixels = stage->line;
    for (int i = 0; i < MOVERS; i++) {
        set_init(&stage->objects[i]);
        set_add(&stage->objects[i], 1, 3, (const int16_t[3][3]){{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
        stage->objects[i].scene.boxes = &stage->boxes[i];
        stage->objects[i].scene.box_count = 1;
        stage->objects[i].leaf.box = 0;
        stage->instances[i].object = &stage->objects[i].scene;
    }
    const struct lim_target target = plain_lines_target(&stage->lines, SIDE_PX, SIDE_PX, LIM_NEAREST_FIRST);
    const size_t mem_b = lim_mem_b(&stage->nothing.scene, &target);
    const size_t mover_mem_b = lim_movers_mem_b(&stage->nothing.scene, &limits);
    stage->mem = malloc(mem_b);
    stage->mover_mem = malloc(mover_mem_b);
    assert_true(stage->mem && stage->mover_mem);
    assert_int_equal(lim_init(&stage->lim, &stage->nothing.scene, &target, stage->mem, mem_b), LIM_OK);
    assert_int_equal(lim_movers_init(&stage->lim, stage->mover_mem, mover_mem_b, &limits), LIM_OK);
}

static void stage_close(struct stage *stage)
{
    free(stage->mem);
    free(stage->mover_mem);
}

/* Long, flat, or as high as wide. */
static void shape(struct stage *stage, int i, struct random *random)
{
    struct set *object = &stage->objects[i];
    struct lim_box *box = &stage->boxes[i];
    const int64_t most = random_in(random, 20, 3000);

    stage->pointed[i] = random_in(random, 0, 1);
    for (int j = 0; j < 3; j++)
        box->half[j] = (uint16_t)(random_in(random, 0, 1) ? most : random_in(random, 10, most));
    for (int k = 0; k < 8; k++) {
        int32_t at[3];
        for (int j = 0; j < 3; j++) {
            const int side = k >> j & 1 ? 1 : -1;
            at[j] = stage->pointed[i] && k % 3 != j ? 0 : side * box->half[j];
        }
        object->vertices[3 + k] = (struct lim_vertex){(int16_t)at[0], (int16_t)at[1], (int16_t)at[2]};
    }
    object->scene.vertex_count = 11;
}

static void place(struct stage *stage, struct lim_camera *camera, struct random *random)
{
    struct lim_movers *movers = stage->lim.movers;
    const int64_t apart_q8 = INT64_C(1) << random_in(random, 10, 21);

    for (int i = 0; i < MOVERS; i++) {
        const uint32_t yaw = random_angle(random), pitch = random_angle(random), roll = random_angle(random);
        shape(stage, i, random);
        lim_instance_turn(&stage->instances[i], yaw, pitch, roll);
        stage->instances[i].finer_bits = (uint8_t)random_in(random, 0, 2);
        for (int j = 0; j < 3; j++)
            stage->instances[i].at_q8[j] = (int32_t)random_in(random, -apart_q8, apart_q8);
    }
    for (int j = 0; j < 3; j++)
        camera->eye_q8[j] = (int32_t)random_in(random, -3 * apart_q8, 3 * apart_q8);
    movers->instances = stage->instances;
    movers->given = movers->count = MOVERS;
    lim_movers_pose(movers, &stage->lim.pass, camera);
    for (int i = 0; i < MOVERS; i++)
        assert_true(movers->movers[i].radius_q12 >= 0);
}

/* Of the object's own axes, from its middle, in halves of its box. */
static void own(const struct stage *stage, int i, const double at[3], double out[3])
{
    const struct lim_instance *instance = &stage->instances[i];

    for (int j = 0; j < 3; j++) {
        out[j] = 0;
        for (int k = 0; k < 3; k++)
            out[j] += (at[k] - instance->at_q8[k] / 256.0) * ldexp(instance->axes_q30[3 * j + k], -30);
        out[j] *= ldexp(1, instance->finer_bits) / stage->boxes[i].half[j];
    }
}

static double depth_in(const struct stage *stage, int i, const double at[3])
{
    double v[3];

    own(stage, i, at, v);
    return stage->pointed[i] ? fabs(v[0]) + fabs(v[1]) + fabs(v[2]) : fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

/* On its surface or within. */
static void any_point(const struct stage *stage, int i, struct random *random, double at[3])
{
    const struct lim_instance *instance = &stage->instances[i];
    double v[3], size = 0;

    for (int j = 0; j < 3; j++) {
        v[j] = 2 * random_unit(random) - 1;
        size = stage->pointed[i] ? size + fabs(v[j]) : fmax(size, fabs(v[j]));
    }
    for (int k = 0; k < 3; k++)
        at[k] = instance->at_q8[k] / 256.0;
    for (int j = 0; j < 3; j++)
        for (int k = 0; k < 3; k++)
            at[k] += v[j] / size * stage->boxes[i].half[j] * ldexp(instance->axes_q30[3 * j + k], -30) *
                     ldexp(1, -instance->finer_bits);
}

/* Whether the other one stands before any point of mover i that may be seen. */
static bool is_hidden(const struct stage *stage, int i, const struct lim_camera *camera, struct random *random)
{
    const double eye[3] = {camera->eye_q8[0] / 256.0, camera->eye_q8[1] / 256.0, camera->eye_q8[2] / 256.0};

    for (int way = 0; way < WAYS; way++) {
        double to[3], through[3], at[3];
        any_point(stage, i, random, to);
        any_point(stage, !i, random, through); /* where it is looked for: near the way past this point */
        double along = 0, square = 0;
        if (to[2] >= eye[2]) continue; /* out of view: the camera looks along -z */
        for (int k = 0; k < 3; k++) {
            along += (through[k] - eye[k]) * (to[k] - eye[k]);
            square += (to[k] - eye[k]) * (to[k] - eye[k]);
        }
        for (int step = 0; step < STEPS; step++) {
            const double t = step ? step / (double)STEPS : along / square;
            if (t <= 0 || t >= 1) continue;
            for (int k = 0; k < 3; k++)
                at[k] = eye[k] + t * (to[k] - eye[k]);
            if (depth_in(stage, !i, at) < 0.999) return true;
        }
    }
    return false;
}

static void whoever_precedes_is_not_hidden(void **state)
{
    static struct stage stage;
    struct lim_camera camera = set_camera(false);
    struct random random = {601};
    int found = 0, clear = 0;

    (void)state;
    stage_open(&stage);
    for (int round = 0; round < ROUNDS; round++) {
        place(&stage, &camera, &random);
        for (int i = 0; i < MOVERS; i++) {
            const bool precedes = lim_mover_precedes(stage.lim.movers, (uint16_t)i, (uint16_t)!i);
            if (!is_hidden(&stage, i, &camera, &random)) {
                found += precedes;
                clear++;
            } else {
                assert_false(precedes);
            }
        }
    }
    stage_close(&stage);
    print_message("# %d found to be clear of %d that are\n", found, clear);
    assert_true(clear > ROUNDS / 2 && found > clear / 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(whoever_precedes_is_not_hidden)};

    return cmocka_run_group_tests_name("precede", tests, NULL, NULL);
}
