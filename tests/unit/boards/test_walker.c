/* SPDX-License-Identifier: MIT
 *
 * Walking with buttons: the path plays until one is pressed, steps go where the view goes, select gives the camera
 * back, and what was never seen released walks nowhere. */
#include "rigs/cmocka_ready.h"

#include "board.h"
#include "eye.h"
#include "walker.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NONE = 0, ALL = BOARD_UP | BOARD_DOWN | BOARD_LEFT | BOARD_RIGHT | BOARD_SELECT, NEAR_Q8 = 69120 };
static const double TURN = 4294967296.0, FULL_CIRCLE = 6.283185307179586476925;

static struct walker walker;

/* A camera of the path, another one in each frame. */
static struct lim_camera path_camera(unsigned frame)
{
    return (struct lim_camera){.eye_q8 = {(int32_t)frame * 1000 - 5000000, 69120, 777 - (int32_t)frame * 300},
                               .yaw = frame * UINT32_C(123456789),
                               .pitch = UINT32_C(1) << 28,
                               .roll = 7,
                               .tan_x_q28 = UINT32_C(1) << 28,
                               .tan_y_q28 = UINT32_C(1) << 27,
                               .near_q8 = NEAR_Q8};
}

static struct lim_camera frame_with(unsigned frame, unsigned buttons)
{
    struct lim_camera camera = path_camera(frame);

    walker_frame(&walker, (uint8_t)buttons, &camera);
    return camera;
}

static void assert_same(struct lim_camera a, struct lim_camera b)
{
    assert_memory_equal(a.eye_q8, b.eye_q8, sizeof a.eye_q8);
    assert_int_equal(a.yaw, b.yaw);
    assert_int_equal(a.pitch, b.pitch);
    assert_int_equal(a.roll, b.roll);
    assert_int_equal(a.tan_x_q28, b.tan_x_q28);
    assert_int_equal(a.tan_y_q28, b.tan_y_q28);
    assert_int_equal(a.near_q8, b.near_q8);
}

static int at_rest(void **state)
{
    (void)state;
    memset(&walker, 0, sizeof walker);
    return 0;
}

static void the_path_plays_until_a_button_is_pressed(void **state)
{
    (void)state;
    for (unsigned frame = 0; frame < 5; frame++)
        assert_same(frame_with(frame, NONE), path_camera(frame));
    const struct lim_camera walked = frame_with(5, BOARD_LEFT);
    assert_int_equal(walked.yaw, path_camera(5).yaw + (UINT32_C(1) << 24));
    assert_same(frame_with(6, NONE), walked); /* and stays where it is */
}

static void what_was_never_released_walks_nowhere(void **state)
{
    (void)state;
    for (unsigned frame = 0; frame < 5; frame++)
        assert_same(frame_with(frame, ALL), path_camera(frame));
    assert_same(frame_with(5, BOARD_UP), path_camera(5)); /* others were released, up is stuck */
    assert_int_equal(frame_with(6, BOARD_UP | BOARD_RIGHT).yaw, path_camera(6).yaw - (UINT32_C(1) << 24));
    assert_int_equal(walker.camera.eye_q8[0], path_camera(6).eye_q8[0]);
}

/* The formula of walker.h in double precision. */
static void assert_moved(struct lim_camera before, struct lim_camera after, double steps)
{
    const double yaw = before.yaw / TURN * FULL_CIRCLE, step_q8 = steps * NEAR_Q8 / 4;

    assert_true(fabs(after.eye_q8[0] - (before.eye_q8[0] - step_q8 * sin(yaw))) <= 1);
    assert_true(fabs(after.eye_q8[2] - (before.eye_q8[2] - step_q8 * cos(yaw))) <= 1);
    assert_int_equal(after.eye_q8[1], before.eye_q8[1]);
    assert_int_equal(after.yaw, before.yaw);
    assert_int_equal(after.pitch, before.pitch);
}

static void up_and_down_go_where_the_view_goes(void **state)
{
    (void)state;
    for (unsigned frame = 0; frame < 50; frame++) {
        at_rest(NULL);
        frame_with(frame, NONE);
        const struct lim_camera forward = frame_with(frame, BOARD_UP);
        assert_moved(path_camera(frame), forward, 1);
        assert_moved(forward, frame_with(frame, BOARD_UP), 1);
        assert_moved(forward, frame_with(frame, BOARD_DOWN), 0);
    }
}

static void buttons_together_do_what_each_does(void **state)
{
    (void)state;
    frame_with(0, NONE);
    const struct lim_camera turned = frame_with(1, BOARD_RIGHT);
    const struct lim_camera both = frame_with(2, BOARD_LEFT | BOARD_UP);
    assert_int_equal(both.yaw, path_camera(1).yaw);
    assert_int_not_equal(both.eye_q8[0], turned.eye_q8[0]);
    assert_same(frame_with(3, BOARD_LEFT | BOARD_RIGHT | BOARD_UP | BOARD_DOWN), both);
}

static void a_full_turn_comes_back(void **state)
{
    (void)state;
    frame_with(0, NONE);
    for (unsigned i = 0; i < 255; i++)
        assert_int_not_equal(frame_with(3, BOARD_LEFT).yaw, path_camera(3).yaw);
    assert_same(frame_with(3, BOARD_LEFT), path_camera(3));
}

static void select_goes_back_to_the_path(void **state)
{
    (void)state;
    frame_with(0, NONE);
    frame_with(1, BOARD_UP);
    assert_same(frame_with(2, BOARD_SELECT | BOARD_UP), path_camera(2));
    assert_same(frame_with(3, NONE), path_camera(3));
    assert_moved(path_camera(4), frame_with(4, BOARD_UP), 1); /* from where the path is then */
}

static void no_step_leaves_the_range_of_the_renderer(void **state)
{
    (void)state;
    struct lim_camera camera = path_camera(0);

    frame_with(0, NONE);
    camera.eye_q8[2] = 2 * NEAR_Q8 - LIM_EYE_MAX_Q8;
    for (unsigned i = 0; i < 20; i++)
        walker_frame(&walker, BOARD_UP, &camera); /* yaw 0: along -z */
    assert_true(camera.eye_q8[2] > -LIM_EYE_MAX_Q8);
    assert_true(camera.eye_q8[2] < -LIM_EYE_MAX_Q8 + NEAR_Q8 / 4 + 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(the_path_plays_until_a_button_is_pressed, at_rest),
        cmocka_unit_test_setup(what_was_never_released_walks_nowhere, at_rest),
        cmocka_unit_test_setup(up_and_down_go_where_the_view_goes, at_rest),
        cmocka_unit_test_setup(buttons_together_do_what_each_does, at_rest),
        cmocka_unit_test_setup(a_full_turn_comes_back, at_rest),
        cmocka_unit_test_setup(select_goes_back_to_the_path, at_rest),
        cmocka_unit_test_setup(no_step_leaves_the_range_of_the_renderer, at_rest),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
