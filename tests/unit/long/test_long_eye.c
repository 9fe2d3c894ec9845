/* SPDX-License-Identifier: MIT
 *
 * The side of the eye in long scenes against 128 bits: planes of every size, eyes on them and a hair off; and boxes as
 * they are seen from the eye. */
#include "eye.h"
#include "long.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/random.h"

#include <stdio.h>

enum { SIDES = 3000000, AXIS_SIDES = 1000000, LONG_BOXES = 1000000, NORMAL_END = 1 << 30 };

/* A plane, its vertex and an eye. */
struct side_case {
    struct lim_long_vertex vertex;
    struct lim_long_plane plane;
    struct lim_plane_ref ref;
    int64_t eye_q8[3];
};

/* Ends, small numbers, powers of two and their neighbours, and anything of any size. */
static int64_t number_up_to(struct random *random, int64_t end)
{
    const int64_t sign = random_u64(random) % 2 ? 1 : -1;

    switch (random_u64(random) % 8) {
    case 0:
        return sign * end;
    case 1:
        return 0;
    case 2:
        return random_in(random, -3, 3);
    case 3: {
        const int64_t at = (INT64_C(1) << random_in(random, 2, 30)) + random_in(random, -1, 1);
        return at > end ? sign * (end - 1) : sign * at;
    }
    case 4:
        return random_in(random, -end, end);
    default:
        return random_in(random, -end, end) >> random_in(random, 0, 29);
    }
}

/* Of eyes: whole units end at 2^30 - 1, and a fraction goes upwards from there. */
static const int64_t EYE_LEAST_Q8 = -(INT64_C(1) << 38) + 256, EYE_MOST_Q8 = (INT64_C(1) << 38) - 1;

static int64_t eye_clamped_q8(int64_t at_q8)
{
    return at_q8 > EYE_MOST_Q8 ? EYE_MOST_Q8 : at_q8 < EYE_LEAST_Q8 ? EYE_LEAST_Q8 : at_q8;
}

/* The plane's value at the eye, times 256. */
static __int128 value_q8(const struct side_case *of)
{
    __int128 sum = -(__int128)of->plane.rest * 256;

    for (int i = 0; i < 3; i++)
        sum += (__int128)of->plane.n[i] * (of->eye_q8[i] - (int64_t)of->vertex.at[i] * 256);
    return sum;
}

/* Moves the eye along an axis to where the plane's value is least, give or take a few 1/256 units. */
static void put_eye_on_plane(struct random *random, struct side_case *out, int axis)
{
    const int64_t n = out->plane.n[axis];

    if (!n) return;
    const __int128 at_q8 = out->eye_q8[axis] - value_q8(out) / n;
    if (at_q8 < EYE_LEAST_Q8 || at_q8 > EYE_MOST_Q8) return;
    out->eye_q8[axis] = eye_clamped_q8((int64_t)at_q8 + random_in(random, -2, 2));
}

static void make_eye(struct random *random, struct side_case *out)
{
    const int64_t reach_q8 = INT64_C(1) << random_in(random, 0, 38);
    const bool is_near = random_u64(random) % 2;

    for (int i = 0; i < 3; i++) {
        int64_t at_q8 = random_in(random, -reach_q8, reach_q8) + (is_near ? (int64_t)out->vertex.at[i] * 256 : 0);
        if (random_u64(random) % 16 == 0) at_q8 = random_u64(random) % 2 ? EYE_MOST_Q8 : EYE_LEAST_Q8;
        out->eye_q8[i] = eye_clamped_q8(at_q8);
    }
}

static void make_slanted(struct random *random, struct side_case *out)
{
    const int axis = (int)(random_u64(random) % 3);

    do {
        for (int i = 0; i < 3; i++)
            out->plane.n[i] = (int32_t)number_up_to(random, NORMAL_END);
    } while (!out->plane.n[0] && !out->plane.n[1] && !out->plane.n[2]);
    if (random_u64(random) % 3 == 0) out->plane.n[axis] = random_u64(random) % 2 ? 1 : -1; /* it can be met exactly */
    for (int i = 0; i < 3; i++)
        out->vertex.at[i] = (int32_t)number_up_to(random, LIM_LONG_END);
    switch (random_u64(random) % 6) {
    case 0:
        out->plane.rest = INT32_MIN;
        break;
    case 1:
        out->plane.rest = INT32_MAX;
        break;
    case 2:
        out->plane.rest = (int32_t)random_in(random, INT32_MIN, INT32_MAX);
        break;
    default:
        out->plane.rest = (int32_t)random_in(random, -2, 2);
    }
    out->ref = (struct lim_plane_ref){0, 0};
    make_eye(random, out);
    if (random_u64(random) % 8) put_eye_on_plane(random, out, axis);
}

/* Whole units in the origin and all that is left in eye_q8, or some other way that adds up. */
static struct lim_camera camera_at(struct random *random, const int64_t eye_q8[3])
{
    struct lim_camera camera = {.tan_x_q28 = 1 << 28, .tan_y_q28 = 1 << 28, .near_q8 = 256};

    for (int i = 0; i < 3; i++) {
        const int64_t whole = eye_q8[i] >> 8;
        int64_t origin = random_u64(random) % 2 ? whole : whole + random_in(random, -(1 << 19), 1 << 19);
        if (origin >= LIM_LONG_EYE_END) origin = LIM_LONG_EYE_END - 1;
        if (origin <= -LIM_LONG_EYE_END) origin = 1 - LIM_LONG_EYE_END;
        camera.origin[i] = (int32_t)origin;
        camera.eye_q8[i] = (int32_t)(eye_q8[i] - origin * 256);
    }
    return camera;
}

static int sign_of_side(const struct side_case *of, struct random *random)
{
    const struct lim_long all = {.vertices = &of->vertex, .planes = &of->plane};
    const struct lim_scene scene = {.of_32_bits = {&all}, .vertex_count = 1, .plane_count = 1};
    const struct lim_camera camera = camera_at(random, of->eye_q8);
    struct lim_eye eye;

    assert_true(lim_eye_begin(&eye, &scene, &camera));
    const int32_t side = lim_eye_side(&eye, &of->ref);
    return (side > 0) - (side < 0);
}

static void no_side_of_a_slanted_plane_is_decided_wrongly(void **state)
{
    struct random random = {141};
    size_t wrong = 0, on = 0, near = 0;

    (void)state;
    for (int k = 0; k < effort(SIDES); k++) {
        struct side_case made;
        make_slanted(&random, &made);
        made.plane.vertex = 0;
        const __int128 value = value_q8(&made);
        wrong += sign_of_side(&made, &random) != (value > 0) - (value < 0);
        on += value == 0;
        near += value && value > -((__int128)1 << 45) && value < (__int128)1 << 45;
    }
    printf("# slanted: %d cases, %zu with the eye on the plane, %zu with it near by, %zu wrong\n", effort(SIDES), on,
           near, wrong);
    assert_int_equal(wrong, 0);
    assert_true(on > (size_t)effort(SIDES) / 100 && near > (size_t)effort(SIDES) / 3);
}

static void no_side_of_an_axis_plane_is_decided_wrongly(void **state)
{
    struct random random = {142};
    size_t wrong = 0, on = 0;

    (void)state;
    for (int k = 0; k < effort(AXIS_SIDES); k++) {
        const int axis = k % 3;
        struct side_case made = {.ref = {LIM_PLANE_X + (lim_index)axis, 0}};
        for (int i = 0; i < 3; i++)
            made.vertex.at[i] = (int32_t)number_up_to(&random, LIM_LONG_END);
        make_eye(&random, &made);
        const int64_t plane_q8 = (int64_t)made.vertex.at[axis] * 256;
        if (random_u64(&random) % 4) made.eye_q8[axis] = plane_q8 + random_in(&random, -2, 2) * (k % 2 ? 1 : 128);
        const int64_t value = made.eye_q8[axis] - plane_q8;
        wrong += sign_of_side(&made, &random) != (value > 0) - (value < 0);
        on += value == 0;
    }
    printf("# axis planes: %d cases, %zu with the eye on the plane, %zu wrong\n", effort(AXIS_SIDES), on, wrong);
    assert_int_equal(wrong, 0);
    assert_true(on > (size_t)effort(AXIS_SIDES) / 20);
}

/* An eye at the very end is one unit and no more within it. */
static void eyes_beyond_2_30_units_are_refused(void **state)
{
    static const int32_t outside[][2] = {{1 << 30, 0},   {-(1 << 30), 0}, {(1 << 30) - 1, 256}, {1 - (1 << 30), -256},
                                         {INT32_MIN, 0}, {INT32_MAX, 0},  {1 - (1 << 30), -1},  {(1 << 30) - 1, 512}};
    static const int32_t within[][2] = {
        {(1 << 30) - 1, 255}, {1 - (1 << 30), 0}, {(1 << 30) - 2, 511}, {2 - (1 << 30), -256}};
    const struct lim_long_vertex vertex = {{0, 0, 0}};
    const struct lim_long all = {.vertices = &vertex};
    const struct lim_scene scene = {.of_32_bits = {&all}, .vertex_count = 1};
    struct lim_eye eye;

    (void)state;
    for (int axis = 0; axis < 3; axis++) {
        for (size_t i = 0; i < sizeof outside / sizeof *outside; i++) {
            struct lim_camera camera = {.near_q8 = 256};
            camera.origin[axis] = outside[i][0];
            camera.eye_q8[axis] = outside[i][1];
            assert_false(lim_eye_begin(&eye, &scene, &camera));
        }
        for (size_t i = 0; i < sizeof within / sizeof *within; i++) {
            struct lim_camera camera = {.near_q8 = 256};
            camera.origin[axis] = within[i][0];
            camera.eye_q8[axis] = within[i][1];
            assert_true(lim_eye_begin(&eye, &scene, &camera));
        }
    }
}

static void a_camera_that_is_carried_stays_where_it_is(void **state)
{
    struct random random = {143};

    (void)state;
    for (int k = 0; k < 100000; k++) {
        struct side_case made = {.ref = {0, 0}};
        make_eye(&random, &made);
        struct lim_camera camera = camera_at(&random, made.eye_q8);
        lim_camera_carry(&camera);
        for (int i = 0; i < 3; i++) {
            assert_int_equal((int64_t)camera.origin[i] * 256 + camera.eye_q8[i], made.eye_q8[i]);
            assert_in_range(camera.eye_q8[i], 0, 255);
        }
    }
}

/* Whether what was given out, in units of 2^shift, holds the box as it is seen from the eye along an axis. */
static bool axis_is_held(const struct lim_box *out, const struct lim_long_box *box, const struct side_case *of,
                         int axis, int shift)
{
    const int64_t unit_q8 = INT64_C(256) << shift, way_q8 = (int64_t)box->centre[axis] * 256 - of->eye_q8[axis];
    const int64_t low_q8 = (out->centre[axis] - (int64_t)out->half[axis]) * unit_q8;
    const int64_t high_q8 = (out->centre[axis] + (int64_t)out->half[axis]) * unit_q8;

    return low_q8 <= way_q8 - (int64_t)box->half[axis] * 256 && high_q8 >= way_q8 + (int64_t)box->half[axis] * 256;
}

/* It is not much larger than that. */
static bool axis_is_tight(const struct lim_box *out, const struct lim_long_box *box, int axis, int shift)
{
    return ((int64_t)out->half[axis] << shift) <= (int64_t)box->half[axis] + (INT64_C(4) << shift);
}

static void make_long_box(struct random *random, struct lim_long_box *box, struct side_case *of)
{
    for (int i = 0; i < 3; i++) {
        of->vertex.at[i] = box->centre[i] = (int32_t)number_up_to(random, LIM_LONG_END);
        const int64_t half = number_up_to(random, 1 << 30);
        box->half[i] = (uint32_t)(half < 0 ? -half : half);
    }
    make_eye(random, of);
}

/* Such a unit there is, whichever was taken, and it leaves the box in 15 bits: what culling has room for. */
static void a_box_as_seen_from_the_eye_holds_the_box(void **state)
{
    struct random random = {144};
    size_t around = 0;

    (void)state;
    for (int k = 0; k < effort(LONG_BOXES); k++) {
        struct side_case made = {.ref = {0, 0}};
        struct lim_long_box box;
        struct lim_box out;
        struct lim_eye eye;
        bool found = false, is_around = true;
        make_long_box(&random, &box, &made);
        const struct lim_long all = {.vertices = &made.vertex};
        const struct lim_scene scene = {.of_32_bits = {&all}, .vertex_count = 1};
        const struct lim_camera camera = camera_at(&random, made.eye_q8);
        assert_true(lim_eye_begin(&eye, &scene, &camera));
        lim_eye_long_box(&eye, &box, &out);
        for (int shift = 0; shift <= 18 && !found; shift++) {
            found = true;
            for (int i = 0; i < 3; i++)
                found &= axis_is_held(&out, &box, &made, i, shift) && axis_is_tight(&out, &box, i, shift);
        }
        if (!found) fail_msg("case %d", k);
        for (int i = 0; i < 3; i++) {
            assert_true((out.centre[i] < 0 ? -out.centre[i] : out.centre[i]) + out.half[i] <= (1 << 14) + 4);
            is_around &= out.half[i] > (out.centre[i] < 0 ? -out.centre[i] : out.centre[i]);
        }
        around += is_around;
    }
    printf("# boxes: %d, the eye in %zu\n", effort(LONG_BOXES), around);
    assert_true(around > (size_t)effort(LONG_BOXES) / 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_side_of_a_slanted_plane_is_decided_wrongly),
        cmocka_unit_test(no_side_of_an_axis_plane_is_decided_wrongly),
        cmocka_unit_test(eyes_beyond_2_30_units_are_refused),
        cmocka_unit_test(a_camera_that_is_carried_stays_where_it_is),
        cmocka_unit_test(a_box_as_seen_from_the_eye_holds_the_box),
    };

    return cmocka_run_group_tests_name("eyes of long scenes", tests, NULL, NULL);
}
