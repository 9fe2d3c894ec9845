/* SPDX-License-Identifier: MIT
 *
 * The planes of polygons whose corners change, against the exact ones. */
#include "eye.h"
#include "movers/deform.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"

#include <math.h>
#include <stdlib.h>

static const lim_index TRIANGLE[] = {3, 0, 0, 1, 2};

static int16_t any_coordinate(struct random *random)
{
    static const int16_t ENDS[] = {INT16_MIN, INT16_MAX, 0, 1, -1};
    const int64_t which = random_in(random, 0, 9);
    return (int16_t)(which < 5 ? ENDS[which] : random_in(random, INT16_MIN, INT16_MAX));
}

/* Corners anywhere in their type, its ends most of all; or close together. */
static void any_triangle(struct random *random, struct lim_vertex corners[3])
{
    const bool is_small = random_in(random, 0, 3) == 0;
    for (int k = 0; k < 3; k++)
        corners[k] = (struct lim_vertex){any_coordinate(random), any_coordinate(random), any_coordinate(random)};
    for (int k = 1; k < 3 && is_small; k++)
        corners[k] = (struct lim_vertex){(int16_t)(corners[0].x / 2 + random_in(random, -9, 9)),
                                         (int16_t)(corners[0].y / 2 + random_in(random, -9, 9)),
                                         (int16_t)(corners[0].z / 2 + random_in(random, -9, 9))};
}

static void exact_normal(const struct lim_vertex v[3], int64_t n[3])
{
    const int64_t a[3] = {v[1].x - v[0].x, v[1].y - v[0].y, v[1].z - v[0].z};
    const int64_t b[3] = {v[2].x - v[0].x, v[2].y - v[0].y, v[2].z - v[0].z};
    for (int i = 0; i < 3; i++)
        n[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* Each component is a power of two's part of the exact one, rounded down, and the first corner lies on the plane. */
static void a_plane_is_the_exact_one_rounded(void **state)
{
    struct random random = {41};
    (void)state;

    for (int round = 0; round < 50000; round++) {
        struct lim_vertex corners[3];
        struct lim_plane_unpacked plane;
        const struct lim_scene object = {.vertices = corners};
        int64_t n[3], d = 0, sum = 0;
        int shift = 0;
        any_triangle(&random, corners);
        exact_normal(corners, n);
        const bool is_plane = lim_deform_plane(&plane, &object, TRIANGLE);
        assert_int_equal(is_plane, n[0] || n[1] || n[2]);
        while (llabs(n[0]) >> shift >= 1 << 29 || llabs(n[1]) >> shift >= 1 << 29 || llabs(n[2]) >> shift >= 1 << 29)
            shift++;
        const int64_t at[3] = {corners[0].x, corners[0].y, corners[0].z};
        for (int i = 0; i < 3; i++) {
            assert_int_equal(plane.n[i], floor((double)n[i] / (double)(1 << shift)));
            d += plane.n[i] * at[i];
            sum += llabs(plane.n[i]);
        }
        assert_int_equal(plane.d, d);
        assert_int_equal(plane.slack, sum);
    }
}

/* From anywhere that an eye may be; shortening takes a 2^-28th of a normal, and the eye is within 2^21 units. */
static void a_polygon_is_seen_from_its_front(void **state)
{
    struct random random = {43};
    int seen = 0;
    (void)state;

    for (int round = 0; round < 50000; round++) {
        struct lim_vertex corners[3];
        const struct lim_scene object = {.vertices = corners};
        struct lim_eye eye = {.scene = &object};
        int64_t n[3];
        double value = 0, doubt = 0;
        any_triangle(&random, corners);
        exact_normal(corners, n);
        const int64_t at[3] = {corners[0].x, corners[0].y, corners[0].z};
        for (int i = 0; i < 3; i++) {
            const int64_t end = round % 3 ? LIM_EYE_MAX_Q8 - 1 : 1 << 16;
            eye.at_q8[i] = (int32_t)random_in(&random, -end, end);
            const double away = eye.at_q8[i] / 256.0 - (double)at[i];
            value += (double)n[i] * away;
            doubt += fabs(away) * 128;
        }
        if (fabs(value) <= doubt) continue;
        assert_int_equal(lim_deform_is_seen(&eye, TRIANGLE), value > 0);
        seen += value > 0;
    }
    assert_in_range(seen, 20000, 30000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_plane_is_the_exact_one_rounded),
        cmocka_unit_test(a_polygon_is_seen_from_its_front),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
