/* SPDX-License-Identifier: MIT
 *
 * Ties: a mesh whose every vertex projects exactly on a pixel's centre, so that every edge runs through
 * centres and each of these must fall to one of the two neighbours, whatever way up the picture is.
 *
 * SIDE_PX is a power of two and the tangent of the half-angle 1: the lattice of odd numbers of metres at
 * a distance of SIDE_PX metres is that of the pixels' centres, and z a power of two to divide by. */
#include "extreme.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/tiny_model.h"

#include <math.h>

enum { SIDE_PX = 256, COVERED_PX = (SIDE_PX - 1) * (SIDE_PX - 1), MESHES = 40, DEPTH = 9 };

static void add_triangle(struct model *model, const int a[2], const int b[2], const int c[2])
{
    const double corners_m[3][3] = {{a[0], a[1], -SIDE_PX}, {b[0], b[1], -SIDE_PX}, {c[0], c[1], -SIDE_PX}};

    tiny_add(model, 3, corners_m);
}

/* low..high, odd numbers, along an axis; or -1 where there is none between them. */
static int odd_between(struct random *random, int low, int high)
{
    return high - low < 4 ? low : low + 2 * (int)random_in(random, 1, (high - low) / 2 - 1);
}

/* A rectangle cut at random into rectangles that meet in T-junctions, those into triangles, and some of
 * these at a point inside. */
static void tile(struct model *model, struct random *random, const int low[2], const int high[2], int depth)
{
    const int axis = (int)(random_u64(random) % 2), at = odd_between(random, low[axis], high[axis]);

    if (depth > 0 && at > low[axis]) {
        int end[2] = {high[0], high[1]}, start[2] = {low[0], low[1]};
        end[axis] = start[axis] = at;
        tile(model, random, low, end, depth - 1);
        tile(model, random, start, high, depth - 1);
        return;
    }
    const int corners[4][2] = {{low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}};
    const int x = odd_between(random, low[0], high[0]), y = odd_between(random, low[1], high[1]);
    if (x > low[0] && y > low[1]) {
        for (int k = 0; k < 4; k++)
            add_triangle(model, corners[k], corners[(k + 1) % 4], (const int[]){x, y});
    } else {
        const int first = (int)(random_u64(random) % 2);
        add_triangle(model, corners[first], corners[first + 1], corners[first + 2]);
        add_triangle(model, corners[first], corners[first + 2], corners[(first + 3) % 4]);
    }
}

static size_t shown(const struct extreme *extreme)
{
    size_t count = 0;

    for (size_t i = 0; i < (size_t)SIDE_PX * SIDE_PX; i++)
        count += extreme->ids.faces[i] != 0;
    return count;
}

/* Pixels that polygons write when each is drawn whole: more than are shown if neighbours overlap. */
static size_t painted(const struct extreme *extreme, const struct lim_camera *camera)
{
    const struct simulator_setup setup = {
        .w_px = SIDE_PX, .h_px = SIDE_PX, .method = LIM_PAINTER, .panel = SIMULATOR_MEMORY, .core = extreme->profile};
    struct simulator simulator;
    struct error err;

    if (!simulator_init(&simulator, &extreme->scene.scene, &setup, &err) || !simulator_frame(&simulator, camera, &err))
        fail_msg("%s", err.text);
    const size_t count = simulator_stats(&simulator)->pixels_painted;
    simulator_free(&simulator);
    return count;
}

struct ties {
    size_t triangles, pixels, missed, doubled;
};

static void count_ties(const struct core *profile, struct random *random, struct ties *ties)
{
    static const struct extreme_picture picture = {SIDE_PX, SIDE_PX, 90, 1};
    static const double eye_m[3] = {0, 0, 0}, ahead_m[3] = {0, 0, -1};
    const int low[2] = {1 - SIDE_PX, 1 - SIDE_PX}, high[2] = {SIDE_PX - 1, SIDE_PX - 1};
    struct model model = {0};
    struct extreme extreme;

    tile(&model, random, low, high, DEPTH);
    extreme_open(&extreme, &model, profile, &picture);
    assert_true(extreme.scene.grid.units_per_m == 128); /* a power of two: nothing is rounded */
    struct lim_camera camera = extreme_aim(&extreme, eye_m, ahead_m);
    camera.tan_x_q28 = camera.tan_y_q28 = UINT32_C(1) << 28;
    for (uint32_t quarter = 0; quarter < 4; quarter++) {
        camera.roll = quarter << 30;
        extreme_camera(&extreme, &camera);
        extreme_show(&extreme, "tie-flips");
        const size_t once = shown(&extreme), times = painted(&extreme, &camera);
        ties->pixels += COVERED_PX;
        ties->missed += once < COVERED_PX ? COVERED_PX - once : 0;
        ties->doubled += times > COVERED_PX ? times - COVERED_PX : 0;
    }
    ties->triangles += model.face_count;
    extreme_close(&extreme);
    model_free(&model);
}

static void a_pixel_centre_on_an_edge_falls_to_one_of_two_neighbours(void **state)
{
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);

    (void)state;
    extreme_about("tie-flips", "Every edge runs through the centres of pixels");
    for (size_t k = 0; k < count; k++) {
        struct random random = {74};
        struct ties ties = {0};
        for (int m = 0; m < effort(MESHES); m++)
            count_ties(profiles[k], &random, &ties);
        extreme_row("tie-flips", profiles[k]->name, "0 missed, 0 twice",
                    "%zu missed, %zu twice in %zu pixels of %zu triangles", ties.missed, ties.doubled, ties.pixels,
                    ties.triangles);
        assert_int_equal(ties.missed, 0);
        assert_int_equal(ties.doubled, 0);
        assert_true(ties.triangles > (size_t)effort(MESHES) * 100);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pixel_centre_on_an_edge_falls_to_one_of_two_neighbours),
    };

    return cmocka_run_group_tests_name("extremes of ties", tests, NULL, NULL);
}
