/* SPDX-License-Identifier: MIT
 *
 * The ball that holds a mover, against its corners in doubles: none is outside, and the ball is no larger than the box
 * around them asks for; whether corners are the object's or, where it deforms, anywhere. */
#include "core/core.h"
#include "golden/golden_stage.h"
#include "limner.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random_camera.h"

#include <math.h>
#include <string.h>

enum { MOVERS_GLTF = 5, ROUNDS = 400, CORNERS_MAX = 64 };

/* A mover's corners, of whose box we know the middle and the halves, in its own units. */
struct extent {
    double corners[CORNERS_MAX][3], middle[3], half[3];
    size_t count;
};

static void measure(struct extent *extent)
{
    for (int i = 0; i < 3; i++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t k = 0; k < extent->count; k++) {
            low = fmin(low, extent->corners[k][i]);
            high = fmax(high, extent->corners[k][i]);
        }
        extent->middle[i] = (low + high) / 2;
        extent->half[i] = (high - low) / 2;
    }
}

static void set_corners(struct extent *extent, const struct lim_scene *object)
{
    extent->count = object->vertex_count < CORNERS_MAX ? object->vertex_count : CORNERS_MAX;
    for (size_t k = 0; k < extent->count; k++) {
        extent->corners[k][0] = object->vertices[k].x;
        extent->corners[k][1] = object->vertices[k].y;
        extent->corners[k][2] = object->vertices[k].z;
    }
    measure(extent);
}

/* Where a point of the object is in the static scene. */
static void place(const struct lim_instance *instance, const double v[3], double at[3])
{
    for (int i = 0; i < 3; i++) {
        at[i] = instance->at_q8[i] / 256.0;
        for (int j = 0; j < 3; j++)
            at[i] += ldexp(instance->axes_q30[3 * j + i], -30) * ldexp(v[j], -instance->finer_bits);
    }
}

static double distance(const double a[3], const double b[3])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

static void check_ball(const struct lim_mover *mover, const struct lim_instance *instance, const struct extent *extent)
{
    const double unit = ldexp(1, -instance->finer_bits), radius = mover->radius_q12 / 4096.0;
    const double centre[3] = {mover->centre_q12[0] / 4096.0, mover->centre_q12[1] / 4096.0,
                              mover->centre_q12[2] / 4096.0};
    const double longest = fmax(extent->half[0], fmax(extent->half[1], extent->half[2]));
    const double others = extent->half[0] + extent->half[1] + extent->half[2] - longest;
    double middle[3], farthest = 0;

    place(instance, extent->middle, middle);
    assert_true(distance(centre, middle) <= 0.87 * unit + 0.001);
    for (size_t k = 0; k < extent->count; k++) {
        double at[3];
        place(instance, extent->corners[k], at);
        assert_true(distance(at, centre) <= radius);
        farthest = fmax(farthest, distance(at, centre));
    }
    /* A root is rounded up, by 2 at most, as is each way along an axis, to 14 bits. */
    assert_true(radius <= farthest * (1 + ldexp(2, -13)) + 5 * unit + 1.001);
    /* Halves are rounded up, by 3/2 at most; the ball by 1, and once more by a unit of the scene. */
    const double most = longest + 1.5 + (others + 3) * 107 / 256 + 1;
    assert_true(radius <= most * unit + 1.001);
}

/* Corners anywhere within a box that is anywhere. */
static void deform(struct lim_vertex *vertices, size_t count, struct random *random)
{
    int64_t low[3], high[3];

    for (int i = 0; i < 3; i++) {
        low[i] = random_in(random, -20000, 20000);
        high[i] = low[i] + random_in(random, 0, INT64_C(1) << random_in(random, 0, 13));
    }
    for (size_t k = 0; k < count; k++) {
        vertices[k].x = (int16_t)random_in(random, low[0], high[0]);
        vertices[k].y = (int16_t)random_in(random, low[1], high[1]);
        vertices[k].z = (int16_t)random_in(random, low[2], high[2]);
    }
}

static void turn_anyhow(struct lim_instance *instance, struct random *random)
{
    const uint32_t yaw = random_angle(random), pitch = random_angle(random), roll = random_angle(random);

    lim_instance_turn(instance, yaw, pitch, roll);
    instance->finer_bits = (uint8_t)random_in(random, 0, 3);
    for (int i = 0; i < 3; i++)
        instance->at_q8[i] += (int32_t)random_in(random, -9000, 9000);
}

static void every_ball_holds_its_mover_closely(void **state)
{
    static struct golden_stage stage;
    static struct extent extent;
    struct lim_vertex vertices[CORNERS_MAX];
    struct random random = {401};
    struct simulator simulator;
    unsigned deformed = 0, whole = 0;
    struct error err;

    (void)state;
    assert_true(golden_open(&stage, MOVERS_GLTF));
    assert_true(golden_begin(&simulator, &stage, &core_fast, &golden_ways[0], 32, 24));
    const struct lim *lim = simulator.lim; /* as it is here: both are of profile fast */
    assert_int_equal(core_fast.lim_b, sizeof *lim);
    for (unsigned round = 0; round < ROUNDS; round++) {
        struct lim_instance *one = &stage.moving.instances[round % stage.moving.count];
        const struct lim_instance kept = *one;
        struct lim_scene copy = *one->object;
        struct lim_camera camera;
        if (copy.vertex_count > CORNERS_MAX) continue;
        if (!camera_path_to_camera(&stage.path, round % GOLDEN_FRAMES, &stage.lens, &stage.scene.grid, &camera, &err))
            fail_msg("%s", err.text);
        memcpy(vertices, copy.vertices, copy.vertex_count * sizeof *vertices);
        one->deforms = round & 1;
        if (one->deforms) deform(vertices, copy.vertex_count, &random);
        copy.vertices = vertices;
        one->object = &copy;
        turn_anyhow(one, &random);
        set_corners(&extent, &copy);
        assert_int_equal(simulator_draw(&simulator, &camera), LIM_OK);
        const struct lim_mover *mover = &lim->movers->movers[round % stage.moving.count];
        assert_true(mover->radius_q12 >= 0);
        check_ball(mover, one, &extent);
        deformed += one->deforms;
        whole += !one->deforms;
        *one = kept;
    }
    assert_true(deformed > ROUNDS / 4 && whole > ROUNDS / 4);
    simulator_free(&simulator);
    golden_close(&stage);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_ball_holds_its_mover_closely)};

    return cmocka_run_group_tests_name("mover_balls", tests, NULL, NULL);
}
