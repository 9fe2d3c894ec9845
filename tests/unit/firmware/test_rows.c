/* SPDX-License-Identifier: MIT
 *
 * The rows of the view matrix against their definition, in long doubles and 128-bit integers: which cameras are taken,
 * how far the scene reaches, which scale is best, and how far a vertex may be off. */
#include "camera.h"
#include "math/orientation.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"
#include "view/perspective.h"
#include "view/rows.h"
#include "view/view.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define ONE_Q28 (UINT32_C(1) << 28)
#define VIEW_MOST_QV (INT64_C(2147483648) - 262144) /* rows.c: what view space holds, less its margin */
#define EYE_LIMIT_Q8 (INT32_C(1) << 28)

enum { SCALES = 32, SCALE_MOST = 32767, BOXES = 20000, CAMERAS = 3000 };

/* -- Cameras ----------------------------------------------------------------------------------------------------------
 */

static const struct lim_camera usual = {
    .eye_q8 = {0, 0, 2560}, .tan_x_q28 = ONE_Q28, .tan_y_q28 = ONE_Q28, .near_q8 = 256};
static const struct lim_scene no_scene;

static bool is_taken(const struct lim_camera *camera)
{
    struct lim_rows rows;

    return lim_rows_set(&rows, &no_scene, camera);
}

static void eyes_are_taken_up_to_the_limit_on_every_axis_and_side(void **state)
{
    (void)state;
    for (int i = 0; i < 3; i++)
        for (int32_t sign = -1; sign <= 1; sign += 2) {
            struct lim_camera camera = usual;
            memset(camera.eye_q8, 0, sizeof camera.eye_q8);
            camera.eye_q8[i] = sign * (EYE_LIMIT_Q8 - 1);
            assert_true(is_taken(&camera));
            camera.eye_q8[i] = sign * EYE_LIMIT_Q8;
            assert_false(is_taken(&camera));
        }
    struct lim_camera least = usual;
    least.eye_q8[1] = INT32_MIN;
    assert_false(is_taken(&least));
}

static void lenses_and_near_planes_are_taken_within_their_limits_alone(void **state)
{
    (void)state;
    static const struct {
        uint32_t q28;
        bool taken;
    } tangents[] = {{0, false},          {ONE_Q28 / 2048 - 1, false}, {ONE_Q28 / 2048, true},
                    {ONE_Q28 * 4, true}, {ONE_Q28 * 4 + 1, false},    {UINT32_MAX, false}};
    static const struct {
        int32_t q8;
        bool taken;
    } nears[] = {{INT32_MIN, false}, {0, false}, {1, true}, {1 << 24, true}, {(1 << 24) + 1, false}};

    for (size_t i = 0; i < sizeof tangents / sizeof *tangents; i++) {
        struct lim_camera wide = usual, high = usual;
        wide.tan_x_q28 = high.tan_y_q28 = tangents[i].q28;
        assert_int_equal(is_taken(&wide), tangents[i].taken);
        assert_int_equal(is_taken(&high), tangents[i].taken);
    }
    for (size_t i = 0; i < sizeof nears / sizeof *nears; i++) {
        struct lim_camera camera = usual;
        camera.near_q8 = nears[i].q8;
        assert_int_equal(is_taken(&camera), nears[i].taken);
    }
}

/* -- Boxes ------------------------------------------------------------------------------------------------------------
 */

/* A scene of one node, whose box is the scene's. */
struct boxed {
    struct lim_box box;
    struct lim_node node;
    struct lim_scene scene;
};

/* Of every size down to a point, within the grid. */
static void any_box(struct boxed *boxed, struct random *random)
{
    const int64_t reach = INT64_C(1) << random_in(random, 0, 14);

    memset(boxed, 0, sizeof *boxed);
    for (int i = 0; i < 3; i++) {
        const int64_t half = random_u64(random) % 8 ? random_in(random, 0, reach) : 0;
        boxed->box.half[i] = (uint16_t)half;
        boxed->box.centre[i] = (int16_t)random_in(random, half - 32767, 32767 - half);
    }
    boxed->scene = (struct lim_scene){.nodes = &boxed->node, .boxes = &boxed->box, .node_count = 1, .box_count = 1};
}

/* Beside the box, within it, or on its border, by a few units or many. */
static void any_eye(int32_t eye_q8[3], const struct lim_box *box, struct random *random, int64_t reach_q8)
{
    for (int i = 0; i < 3; i++) {
        const int64_t side = random_in(random, -1, 1) * box->half[i];
        int64_t at_q8 = (box->centre[i] + side) * 256 + random_in(random, -reach_q8, reach_q8);
        if (at_q8 >= EYE_LIMIT_Q8) at_q8 = EYE_LIMIT_Q8 - 1;
        if (at_q8 <= -EYE_LIMIT_Q8) at_q8 = 1 - EYE_LIMIT_Q8;
        eye_q8[i] = (int32_t)at_q8;
    }
}

static __int128 square(__int128 x)
{
    return x * x;
}

/* Of the box's corner that is farthest from the eye, squared, in 2^-16 square units. */
static __int128 farthest_squared(const struct lim_box *box, const int32_t eye_q8[3])
{
    __int128 sum = 0;

    for (int i = 0; i < 3; i++) {
        const int64_t low_q8 = eye_q8[i] - (box->centre[i] - (int64_t)box->half[i]) * 256;
        const int64_t high_q8 = (box->centre[i] + (int64_t)box->half[i]) * 256 - eye_q8[i];
        sum += square(low_q8 > high_q8 ? low_q8 : high_q8);
    }
    return sum;
}

/* Nor much nearer: a + 107/256 b + 82/256 c is longer than (a, b, c) by 13.03 % at most, the length of those factors;
 * a unit a side and one at the end come from rounding. */
static void no_corner_of_the_box_is_farther_than_the_far_distance(void **state)
{
    struct random random = {19};

    (void)state;
    for (int k = 0; k < BOXES; k++) {
        struct boxed boxed;
        struct lim_camera camera = usual;
        struct lim_rows rows;
        any_box(&boxed, &random);
        any_eye(camera.eye_q8, &boxed.box, &random, INT64_C(1) << random_in(&random, 0, 28));
        assert_true(lim_rows_set(&rows, &boxed.scene, &camera));
        const __int128 squared = farthest_squared(&boxed.box, camera.eye_q8);
        assert_true(square((__int128)rows.far_units * 256) >= squared);
        assert_true(rows.far_units <= 1.1304L * sqrtl((long double)squared) / 256 + 3);
    }
}

static void a_scene_without_a_box_reaches_to_the_ends_of_the_grid(void **state)
{
    struct lim_rows rows;
    struct lim_camera camera = usual;

    (void)state;
    memset(camera.eye_q8, 0, sizeof camera.eye_q8);
    assert_true(lim_rows_set(&rows, &no_scene, &camera));
    assert_in_range(rows.far_units, 56755, 63600); /* sqrt(3) 2^15 */
}

/* -- Rows -------------------------------------------------------------------------------------------------------------
 */

/* The true rows for a camera that is turned about the upright axis, at scale 1. */
static void turned_rows(long double n[3][3], const struct lim_camera *camera)
{
    const long double turn = 6.283185307179586476925L * camera->yaw / 4294967296.0L;
    const long double tan_x = camera->tan_x_q28 / (long double)ONE_Q28,
                      tan_y = camera->tan_y_q28 / (long double)ONE_Q28;
    const long double zoom = fminl(1, fminl(tan_x, tan_y));
    const long double rows[3][3] = {{cosl(turn), 0, -sinl(turn)}, {0, -1, 0}, {-sinl(turn), 0, -cosl(turn)}};

    for (int i = 0; i < 3; i++) {
        n[0][i] = rows[0][i] * zoom / tan_x;
        n[1][i] = rows[1][i] * zoom / tan_y;
        n[2][i] = rows[2][i] * zoom;
    }
}

/* The upright entry is then as long as the scale, and nothing of it is rounded. */
static struct lim_camera turned(struct random *random, const struct boxed *boxed, int64_t reach_q8)
{
    struct lim_camera camera = usual;

    camera.yaw = (uint32_t)random_u64(random);
    camera.tan_x_q28 = (uint32_t)random_in(random, ONE_Q28, LIM_TAN_MAX_Q28);
    any_eye(camera.eye_q8, &boxed->box, random, reach_q8);
    return camera;
}

static void the_scale_is_nearly_the_largest_that_view_space_holds(void **state)
{
    struct random random = {23};

    (void)state;
    for (int k = 0; k < CAMERAS; k++) {
        struct boxed boxed;
        struct lim_rows rows;
        any_box(&boxed, &random);
        const struct lim_camera camera = turned(&random, &boxed, INT64_C(1) << random_in(&random, 0, 28));
        assert_true(lim_rows_set(&rows, &boxed.scene, &camera));
        const int64_t scale = -rows.row[1].n_qv[1];
        assert_true(scale > 0 && scale <= SCALE_MOST && scale * rows.far_units <= VIEW_MOST_QV);
        assert_true(scale + SCALES > SCALE_MOST || (scale + SCALES) * rows.far_units > VIEW_MOST_QV);
    }
}

/* The sum of squares of what rounding takes from or adds to the entries, at a scale. */
static long double rounding_at(const long double n[3][3], long double scale)
{
    long double sum = 0;

    for (int i = 0; i < 9; i++) {
        const long double entry = n[i / 3][i % 3] * scale;
        sum += (entry - roundl(entry)) * (entry - roundl(entry));
    }
    return sum;
}

/* Of all scales that were to choose from; the sum is taken with 13 fraction bits a rounding. */
static void the_scale_has_the_least_rounding(void **state)
{
    struct random random = {29};

    (void)state;
    for (int k = 0; k < CAMERAS; k++) {
        struct boxed boxed;
        struct lim_rows rows;
        long double n[3][3], least = 9;
        any_box(&boxed, &random);
        const struct lim_camera camera = turned(&random, &boxed, INT64_C(1) << random_in(&random, 0, 28));
        assert_true(lim_rows_set(&rows, &boxed.scene, &camera));
        turned_rows(n, &camera);
        const int64_t held = VIEW_MOST_QV / rows.far_units, most = held < SCALE_MOST ? held : SCALE_MOST;
        for (int64_t scale = most; scale > most - SCALES; scale--)
            least = fminl(least, rounding_at(n, (long double)scale));
        assert_true(rounding_at(n, -rows.row[1].n_qv[1]) < least + 0.003L);
    }
}

/* The definition of view.h: the row times the way from the eye. An entry is rounded by half a unit, and counts from
 * where the eye is nearest to the box; the eye itself is rounded once, and the angles' sines a little. */
static void assert_close(const struct boxed *boxed, const struct lim_camera *camera, const struct lim_vertex *vertex)
{
    struct lim_view_cached cache[LIM_VIEW_CACHE_ENTRIES];
    struct lim_view view;
    struct lim_view_point point;
    long double n[3][3], away = 0, off = 0;
    const int16_t at[3] = {vertex->x, vertex->y, vertex->z};

    lim_view_init(&view, 240, 240, cache);
    assert_true(lim_view_begin(&view, &boxed->scene, camera));
    lim_view_transform(&view, &boxed->scene, vertex, &point);
    turned_rows(n, camera);
    for (int i = 0; i < 3; i++) {
        const long double low = boxed->box.centre[i] - boxed->box.half[i],
                          high = boxed->box.centre[i] + boxed->box.half[i];
        const long double eye = camera->eye_q8[i] / 256.0L;
        off += fabsl(at[i] - fminl(fmaxl(eye, low), high));
        away += fabsl(at[i] - eye);
    }
    const int16_t scale = (int16_t)-view.rows.row[1].n_qv[1];
    for (int r = 0; r < 3; r++) {
        long double exact = 0;
        for (int i = 0; i < 3; i++)
            exact += n[r][i] * scale * (at[i] - camera->eye_q8[i] / 256.0L);
        assert_true(fabsl(point.qv[r] - exact) <= 0.5L * off + 0.51L + away * scale * 0x1p-27L);
    }
}

static struct lim_vertex corner(const struct lim_box *box, int k)
{
    const int32_t at[3] = {box->centre[0] + (k & 1 ? box->half[0] : -box->half[0]),
                           box->centre[1] + (k & 2 ? box->half[1] : -box->half[1]),
                           box->centre[2] + (k & 4 ? box->half[2] : -box->half[2])};

    return (struct lim_vertex){(int16_t)at[0], (int16_t)at[1], (int16_t)at[2]};
}

static void corners_are_where_they_belong_the_nearest_to_the_unit(void **state)
{
    struct random random = {31};

    (void)state;
    for (int k = 0; k < CAMERAS; k++) {
        struct boxed boxed;
        any_box(&boxed, &random);
        const struct lim_camera camera = turned(&random, &boxed, INT64_C(1) << random_in(&random, 0, 28));
        for (int i = 0; i < 8; i++) {
            const struct lim_vertex vertex = corner(&boxed.box, i);
            assert_close(&boxed, &camera, &vertex);
        }
    }
}

/* Where its distance is less than what has bits to divide by, it is that; and it leaves z some room. */
static void the_near_plane_is_where_it_was_asked_for(void **state)
{
    struct random random = {37};
    int asked = 0, least = 0;

    (void)state;
    for (int k = 0; k < CAMERAS; k++) {
        struct boxed boxed;
        struct lim_rows rows;
        any_box(&boxed, &random);
        struct lim_camera camera = turned(&random, &boxed, INT64_C(1) << random_in(&random, 0, 28));
        camera.near_q8 = (int32_t)random_in(&random, 1, INT64_C(1) << random_in(&random, 0, 24));
        assert_true(lim_rows_set(&rows, &boxed.scene, &camera));
        const long double exact = -rows.row[1].n_qv[1] * (camera.near_q8 / 256.0L);
        const long double expected = fminl(fmaxl(exact, PERSPECTIVE_Z_MIN_QV), 0x1p29L);
        assert_true(fabsl(rows.near_qv - expected) <= 1);
        assert_true(rows.near_qv >= PERSPECTIVE_Z_MIN_QV);
        asked += expected == exact;
        least += expected > exact;
    }
    assert_true(asked > CAMERAS / 10 && least > CAMERAS / 10);
}

/* -- Long lenses ------------------------------------------------------------------------------------------------------
 */

static struct lim_camera long_camera(struct random *random, const struct boxed *boxed)
{
    struct lim_camera camera = usual;

    camera.yaw = (uint32_t)random_u64(random);
    camera.pitch = (uint32_t)random_u64(random);
    camera.roll = (uint32_t)random_u64(random);
    camera.tan_x_q28 = (uint32_t)random_in(random, LIM_TAN_MIN_Q28, INT64_C(1) << random_in(random, 18, 25)) - 1;
    if (camera.tan_x_q28 < LIM_TAN_MIN_Q28) camera.tan_x_q28 = LIM_TAN_MIN_Q28;
    camera.tan_y_q28 = camera.tan_x_q28 << random_in(random, 0, 5);
    any_eye(camera.eye_q8, &boxed->box, random, INT64_C(1) << random_in(random, 0, 26));
    return camera;
}

/* Puts the eye where the lens shows the vertex, anywhere in the picture, from near by or far away. */
static void look_at_vertex(struct random *random, struct lim_camera *camera, const int32_t axes_q30[9],
                           const struct lim_vertex *vertex)
{
    const double ahead = ldexp(1 + random_unit(random), (int)random_in(random, 3, 18));
    const double right = ahead * ldexp(camera->tan_x_q28, -28) * (2 * random_unit(random) - 1),
                 down = ahead * ldexp(camera->tan_y_q28, -28) * (2 * random_unit(random) - 1);
    const int16_t at[3] = {vertex->x, vertex->y, vertex->z};

    for (int i = 0; i < 3; i++) {
        const double way = (right * axes_q30[i] + down * axes_q30[3 + i] + ahead * axes_q30[6 + i]) / (1 << 30);
        camera->eye_q8[i] = (int32_t)round((at[i] - way) * 256);
    }
}

/* The way from the eye along an axis of the camera. */
static long double along(const struct lim_camera *camera, const int32_t axis_q30[3], const struct lim_vertex *vertex)
{
    const int16_t at[3] = {vertex->x, vertex->y, vertex->z};
    long double sum = 0;

    for (int i = 0; i < 3; i++)
        sum += axis_q30[i] * 0x1p-30L * (at[i] - camera->eye_q8[i] / 256.0L);
    return sum;
}

static long double length_of(const struct lim_row *row)
{
    long double sum = 0;

    for (int i = 0; i < 3; i++)
        sum += (long double)row->n_qv[i] * row->n_qv[i];
    return sqrtl(sum);
}

/* A row's entries are off by half a unit each. A long lens would show that many times over, if it were not for what is
 * added of z; that leaves as much as any other lens shows. */
static void what_a_long_lens_sees_is_where_it_belongs(void **state)
{
    struct lim_view_cached cache[LIM_VIEW_CACHE_ENTRIES];
    struct random random = {41};
    int seen = 0;

    (void)state;
    for (int k = 0; k < 20 * CAMERAS; k++) {
        struct boxed boxed;
        struct lim_view view;
        struct lim_vertex vertex;
        struct lim_view_point point;
        int32_t axes_q30[9];
        any_box(&boxed, &random);
        struct lim_camera camera = long_camera(&random, &boxed);
        const uint32_t tans_q28[2] = {camera.tan_x_q28, camera.tan_y_q28};
        lim_orientation_set(axes_q30, &camera);
        vertex = corner(&boxed.box, (int)random_in(&random, 0, 7));
        look_at_vertex(&random, &camera, axes_q30, &vertex);
        lim_view_init(&view, 240, 240, cache);
        if (!lim_view_begin(&view, &boxed.scene, &camera)) continue; /* too far away */
        lim_view_transform(&view, &boxed.scene, &vertex, &point);
        const long double ahead = along(&camera, axes_q30 + 6, &vertex);
        for (uint_fast8_t i = 0; i < 2 && point.z_qv >= view.rows.near_qv; i++) {
            const long double zoomed_qv = ldexpl(point.z_qv, -view.rows.zoom_bits[i]);
            const long double tangent = tans_q28[i] / (long double)ONE_Q28;
            const long double exact = along(&camera, axes_q30 + 3 * i, &vertex) / ahead / tangent;
            const long double wide = fmaxl(fabsl(exact), camera.tan_y_q28 / (long double)camera.tan_x_q28);
            const long double most = 1.75L * (1 + wide) / length_of(&view.rows.row[i]) + 1.6L / zoomed_qv;
            assert_true(fabsl(point.qv[i] / zoomed_qv - exact) <= most);
            seen++;
        }
    }
    assert_true(seen > CAMERAS);
}

/* z has all of its bits, whatever the lens. */
static void the_near_plane_of_a_long_lens_is_as_near_as_that_of_others(void **state)
{
    struct random random = {43};

    (void)state;
    for (int k = 0; k < CAMERAS; k++) {
        struct boxed boxed;
        struct lim_rows rows;
        any_box(&boxed, &random);
        struct lim_camera camera = long_camera(&random, &boxed);
        camera.near_q8 = 1;
        assert_true(lim_rows_set(&rows, &boxed.scene, &camera));
        const long double near = rows.near_qv / length_of(&rows.row[2]);
        assert_true(near <= fmaxl(2.1L, 2.1L * rows.far_units / 65536));
    }
}

/* They may be all that there is: nine. */
static void axes_that_are_the_cameras_give_its_rows(void **state)
{
    int32_t *axes_q30 = malloc(9 * sizeof *axes_q30);
    struct random random = {29};

    (void)state;
    assert_non_null(axes_q30);
    for (int k = 0; k < CAMERAS; k++) {
        struct lim_rows rows, turned;
        struct boxed boxed;
        any_box(&boxed, &random);
        struct lim_camera camera = usual;
        any_eye(camera.eye_q8, &boxed.box, &random, INT64_C(1) << 20);
        camera.yaw = (uint32_t)random_u64(&random);
        camera.pitch = (uint32_t)random_u64(&random);
        camera.roll = (uint32_t)random_u64(&random);
        lim_orientation_set(axes_q30, &camera);
        assert_true(lim_rows_set(&rows, &boxed.scene, &camera));
        assert_true(lim_rows_set_turned(&turned, &boxed.scene, &camera, axes_q30));
        assert_int_equal(turned.far_units, rows.far_units);
        assert_int_equal(turned.near_qv, rows.near_qv);
        for (int i = 0; i < 9; i++)
            assert_int_equal(turned.row[i / 3].n_qv[i % 3], rows.row[i / 3].n_qv[i % 3]);
        for (int i = 0; i < 3; i++)
            assert_int_equal(turned.row[i].shift_qv, rows.row[i].shift_qv);
    }
    free(axes_q30);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(eyes_are_taken_up_to_the_limit_on_every_axis_and_side),
        cmocka_unit_test(lenses_and_near_planes_are_taken_within_their_limits_alone),
        cmocka_unit_test(no_corner_of_the_box_is_farther_than_the_far_distance),
        cmocka_unit_test(a_scene_without_a_box_reaches_to_the_ends_of_the_grid),
        cmocka_unit_test(the_scale_is_nearly_the_largest_that_view_space_holds),
        cmocka_unit_test(the_scale_has_the_least_rounding),
        cmocka_unit_test(corners_are_where_they_belong_the_nearest_to_the_unit),
        cmocka_unit_test(the_near_plane_is_where_it_was_asked_for),
        cmocka_unit_test(what_a_long_lens_sees_is_where_it_belongs),
        cmocka_unit_test(the_near_plane_of_a_long_lens_is_as_near_as_that_of_others),
        cmocka_unit_test(axes_that_are_the_cameras_give_its_rows),
    };

    return cmocka_run_group_tests_name("rows", tests, NULL, NULL);
}
