/* SPDX-License-Identifier: MIT
 *
 * Boxes that are moved at random through scenes of every tree: where they end, and on the way there, they are in no
 * polygon, as GMP has it; what stopped them was in their way, by a linear program in double precision; and what slides
 * comes on. */
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "unit/collide/solid_stage.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What a box is moved in. */
struct sweeps {
    struct solid_stage stage;
    bool *in; /* of each polygon, whether the box was in it before */
    int32_t half_q8[3];
};

struct tally {
    size_t moves, stopped, in_walls, through, early, elsewhere, slid_q8; /* elsewhere: not where its part says */
};

/* Its stage has begun. */
static void sweeps_begin(struct sweeps *sweeps)
{
    sweeps->in = calloc(sweeps->stage.list.count, sizeof *sweeps->in);
}

static void sweeps_end(struct sweeps *sweeps)
{
    free(sweeps->in);
    solid_stage_end(&sweeps->stage);
}

static bool is_in_front(const struct solid_polygon *polygon, const int32_t at_q8[3])
{
    const __int128 value = solid_value(polygon, at_q8);

    return polygon->back ? value <= 0 : value >= 0;
}

/* In how many polygons the box is; which ones, is noted. */
static size_t note_in(struct sweeps *sweeps, const int32_t at_q8[3])
{
    size_t count = 0;

    for (size_t k = 0; k < sweeps->stage.list.count; k++)
        count += sweeps->in[k] =
            solid_overlaps(&sweeps->stage.list, &sweeps->stage.list.polygons[k], at_q8, sweeps->half_q8);
    return count;
}

/* Whether it is in a polygon there that it was not in before, and in front of which it was. */
static bool is_in_wall(const struct sweeps *sweeps, const int32_t before_q8[3], const int32_t at_q8[3], bool backs)
{
    for (size_t k = 0; k < sweeps->stage.list.count; k++) {
        const struct solid_polygon *polygon = &sweeps->stage.list.polygons[k];
        if (!sweeps->in[k] && (backs || is_in_front(polygon, before_q8)) &&
            solid_overlaps(&sweeps->stage.list, polygon, at_q8, sweeps->half_q8))
            return true;
    }
    return false;
}

/* The least t in 0..1 with g x <= b for x = (u, v, t), from the corners of what is admitted; 2 if that is nothing. */
enum { CONSTRAINTS = 11 };
static double least_t(double g[CONSTRAINTS][3], const double b[CONSTRAINTS])
{
    double least = 2;

    for (int i = 0; i < CONSTRAINTS; i++)
        for (int j = i + 1; j < CONSTRAINTS; j++)
            for (int k = j + 1; k < CONSTRAINTS; k++) {
                const double *p = g[i], *q = g[j], *r = g[k];
                const double cross[3] = {q[1] * r[2] - q[2] * r[1], q[2] * r[0] - q[0] * r[2],
                                         q[0] * r[1] - q[1] * r[0]};
                const double det = p[0] * cross[0] + p[1] * cross[1] + p[2] * cross[2];
                double x[3];
                bool is_admitted = fabs(det) > 1e-12;
                for (int a = 0; a < 3 && is_admitted; a++) {
                    const int c = (a + 1) % 3, d = (a + 2) % 3;
                    x[a] = (b[i] * cross[a] + b[j] * (r[c] * p[d] - r[d] * p[c]) + b[k] * (p[c] * q[d] - p[d] * q[c])) /
                           det;
                }
                for (int n = 0; n < CONSTRAINTS && is_admitted; n++)
                    is_admitted = g[n][0] * x[0] + g[n][1] * x[1] + g[n][2] * x[2] <=
                                  b[n] + 1e-7 * (1 + fabs(g[n][0]) + fabs(g[n][1]) + fabs(g[n][2]));
                if (is_admitted && x[2] < least) least = x[2];
            }
    return least;
}

/* When a box first touches a triangle on its way. */
static double triangle_at(const double corners[3][3], const double from[3], const double way[3], const double half[3])
{
    double g[CONSTRAINTS][3] = {{-1, 0, 0}, {0, -1, 0}, {1, 1, 0}, {0, 0, -1}, {0, 0, 1}};
    double b[CONSTRAINTS] = {0, 0, 1, 0, 1};

    for (int i = 0; i < 3; i++)
        for (int side = 0; side < 2; side++) {
            const double sign = side ? -1 : 1;
            double *row = g[5 + 2 * i + side];
            row[0] = sign * (corners[1][i] - corners[0][i]);
            row[1] = sign * (corners[2][i] - corners[0][i]);
            row[2] = -sign * way[i];
            b[5 + 2 * i + side] = half[i] - sign * (corners[0][i] - from[i]);
        }
    return least_t(g, b);
}

/* Whether the polygon comes within 3 units of the box as early as the box was stopped by it. */
static bool was_in_the_way(const struct sweeps *sweeps, const int32_t from_q8[3], const int32_t to_q8[3],
                           const struct lim_hit *hit)
{
    double from[3], way[3], half[3], into = 0, sizes = 0, least = 2;

    for (int i = 0; i < 3; i++) {
        from[i] = from_q8[i] / 256.0;
        way[i] = (to_q8[i] - from_q8[i]) / 256.0;
        half[i] = sweeps->half_q8[i] / 256.0 + 3;
        into -= way[i] * hit->normal[i];
        sizes += abs(hit->normal[i]);
    }
    if (into <= 0) return false; /* it went out of it */
    for (size_t k = 0; k < sweeps->stage.list.count; k++) {
        const struct solid_polygon *polygon = &sweeps->stage.list.polygons[k];
        for (size_t c = 2; polygon->record == hit->record && c < polygon->count; c++) {
            const size_t of[3] = {0, c - 1, c};
            double corners[3][3];
            for (int p = 0; p < 3; p++) {
                const struct lim_vertex *v = &sweeps->stage.scene.scene.vertices[polygon->corners[of[p]]];
                corners[p][0] = v->x, corners[p][1] = v->y, corners[p][2] = v->z;
            }
            least = fmin(least, triangle_at(corners, from, way, half));
        }
    }
    const double skin = (LIM_SKIN_Q8 / 256.0 + 0.1) * sizes / into;
    return least <= hit->part_q30 / 1073741824.0 + skin + 1e-6;
}

static void try_sweep(struct sweeps *sweeps, const int32_t from_q8[3], const int32_t to_q8[3], uint8_t flags,
                      struct lim_hit *hit, struct tally *tally)
{
    const int stopped = lim_sweep(&sweeps->stage.solid, sweeps->half_q8, from_q8, to_q8, flags, hit);
    const struct solid_ray ray = solid_trace(&sweeps->stage.list, from_q8, hit->at_q8, flags & LIM_STOP_BACKS);

    assert_true(stopped >= 0);
    tally->moves++;
    tally->stopped += (size_t)stopped;
    /* a ray meets what is half a unit beside it, a box of less may pass there */
    if (sweeps->half_q8[0] > 128 && sweeps->half_q8[1] > 128 && sweeps->half_q8[2] > 128)
        tally->through += ray.hit && ray.num && ray.num < ray.den;
    for (int part = 1; part <= 4; part++) {
        int32_t at_q8[3];
        for (int i = 0; i < 3; i++)
            at_q8[i] = from_q8[i] + (int32_t)((int64_t)(hit->at_q8[i] - from_q8[i]) * part / 4);
        if (part < 4) /* rounded: a little less of it */
            for (int i = 0; i < 3; i++)
                sweeps->half_q8[i]--;
        tally->in_walls += is_in_wall(sweeps, from_q8, at_q8, flags & LIM_STOP_BACKS);
        if (part < 4)
            for (int i = 0; i < 3; i++)
                sweeps->half_q8[i]++;
    }
    for (int i = 0; i < 3; i++) { /* each try rounds it */
        const double gone_q8 = ((double)to_q8[i] - from_q8[i]) * hit->part_q30 / 1073741824.0;
        tally->elsewhere += fabs(hit->at_q8[i] - from_q8[i] - gone_q8) > 16;
    }
    if (stopped)
        tally->early += !was_in_the_way(sweeps, from_q8, to_q8, hit);
    else
        assert_memory_equal(hit->at_q8, to_q8, sizeof hit->at_q8);
}

static void any_half(struct sweeps *sweeps)
{
    static const int32_t most_q8[] = {1, 300, 40000, 300000};
    const int32_t most = most_q8[random_u64(&sweeps->stage.random) % 4];

    for (int i = 0; i < 3; i++)
        sweeps->half_q8[i] = (int32_t)random_in(&sweeps->stage.random, 1, most);
}

/* A random walk of sweeps: each goes on from where the last one ended. */
static void sweep_about(struct sweeps *sweeps, int whole)
{
    struct tally tally = {0};

    for (int k = 0; k < effort(whole); k++) {
        int32_t at_q8[3];
        any_half(sweeps);
        solid_stage_in_bounds(&sweeps->stage, 256, at_q8);
        for (int move = 0; move < 10; move++) {
            const int64_t far_q8 = random_u64(&sweeps->stage.random) % 2 ? 20000 : 2000000;
            const uint8_t flags = k % 4 == 3 ? LIM_STOP_BACKS : 0;
            struct lim_hit hit;
            int32_t to_q8[3];
            for (int i = 0; i < 3; i++)
                to_q8[i] = at_q8[i] + (random_u64(&sweeps->stage.random) % 4
                                           ? (int32_t)random_in(&sweeps->stage.random, -far_q8, far_q8)
                                           : 0);
            note_in(sweeps, at_q8);
            try_sweep(sweeps, at_q8, to_q8, flags, &hit, &tally);
            memcpy(at_q8, hit.at_q8, sizeof at_q8);
        }
    }
    printf("# %s: %zu moves, %zu stopped, %zu in walls, %zu through, %zu too early\n", sweeps->stage.name, tally.moves,
           tally.stopped, tally.in_walls, tally.through, tally.early);
    assert_int_equal(tally.in_walls, 0);
    assert_int_equal(tally.through, 0);
    assert_int_equal(tally.early, 0);
    assert_int_equal(tally.elsewhere, 0);
    assert_true(tally.stopped > tally.moves / 20);
}

static void sweep_model(const char *path, enum tree_kind tree, int whole)
{
    struct sweeps sweeps = {0};

    solid_stage_model(&sweeps.stage, path, tree, MESH_LEAVES_NONE);
    sweeps_begin(&sweeps);
    sweep_about(&sweeps, whole);
    sweeps_end(&sweeps);
}

static void boxes_end_in_no_wall(void **state)
{
    (void)state;
    sweep_model("sim/scenes/rooms.obj", TREE_BSP, 600);
    sweep_model("sim/scenes/rooms.obj", TREE_OCTREE, 300);
    sweep_model("sim/scenes/teapot.obj", TREE_CLUSTERS, 400);
    sweep_model("sim/scenes/knot.obj", TREE_BSP, 400);
    sweep_model(SOLID_E1M1, TREE_BSP, 300);
}

static void boxes_end_in_no_wall_of_random_buildings(void **state)
{
    struct random random = {99};

    (void)state;
    for (int k = 0; k < 8; k++) {
        struct sweeps sweeps = {0};
        solid_stage_building(&sweeps.stage, &random, (uint64_t)k);
        sweeps_begin(&sweeps);
        sweep_about(&sweeps, 100);
        sweeps_end(&sweeps);
    }
}

/* In a closed room there is no polygon that a box may be in, whatever it is in front of. */
static void what_slides_stays_in_a_closed_room(void **state)
{
    struct random random = {3};
    size_t moves = 0, in = 0, stops = 0;
    double asked = 0, gone = 0;

    (void)state;
    for (int k = 0; k < effort(12); k++) {
        struct closed_scene closed;
        struct sweeps sweeps = {0};
        solid_stage_closed(&sweeps.stage, &closed, &random, (uint64_t)k);
        sweeps_begin(&sweeps);
        for (int walk = 0; walk < 20; walk++) {
            const struct viewpoint view = closed_scene_viewpoint(&closed, &random);
            int32_t at_q8[3], way_q8[3] = {0, 0, 0};
            solid_place_q8(&sweeps.stage.scene, view.eye_m, at_q8);
            for (int a = 0; a < 3; a++)
                sweeps.half_q8[a] = (int32_t)random_in(&random, 1, 100000);
            if (note_in(&sweeps, at_q8)) continue;
            for (int move = 0; move < 100; move++) {
                const int32_t before_q8[3] = {at_q8[0], at_q8[1], at_q8[2]};
                for (int a = 0; a < 3 && move % 20 == 0; a++)
                    way_q8[a] = (int32_t)random_in(&random, -150000, 150000);
                const int stopped = lim_slide(&sweeps.stage.solid, sweeps.half_q8, at_q8, way_q8, 0);
                assert_true(stopped >= 0 && stopped <= LIM_SLIDES);
                moves++;
                stops += stopped > 0;
                in += note_in(&sweeps, at_q8) > 0;
                if (!stopped) continue;
                asked +=
                    sqrt((double)way_q8[0] * way_q8[0] + (double)way_q8[1] * way_q8[1] + (double)way_q8[2] * way_q8[2]);
                gone += sqrt(pow(at_q8[0] - before_q8[0], 2) + pow(at_q8[1] - before_q8[1], 2) +
                             pow(at_q8[2] - before_q8[2], 2));
            }
        }
        sweeps_end(&sweeps);
        closed_scene_free(&closed);
    }
    printf("# %zu moves, %zu in walls, %zu stopped, of whose ways %.0f %% was gone\n", moves, in, stops,
           100 * gone / asked);
    assert_int_equal(in, 0);
    assert_true(stops > moves / 10);
    assert_true(gone > 0.2 * asked);
}

static void what_is_out_of_range_is_refused(void **state)
{
    const int32_t half_q8[3] = {1, LIM_HALF_MAX_Q8, 7}, none_q8[3] = {1, 0, 1},
                  large_q8[3] = {LIM_HALF_MAX_Q8 + 1, 1, 1}, at_q8[3] = {0, 0, 0}, far_q8[3] = {0, 0, -LIM_BODY_MAX_Q8};
    int32_t here_q8[3] = {LIM_BODY_MAX_Q8 - 1, 0, 0};
    struct solid_stage stage = {0};
    struct lim_hit hit;

    (void)state;
    solid_stage_model(&stage, "sim/scenes/knot.obj", TREE_BSP, MESH_LEAVES_NONE);
    assert_true(lim_sweep(&stage.solid, half_q8, at_q8, at_q8, 0, &hit) >= 0);
    assert_int_equal(lim_sweep(&stage.solid, none_q8, at_q8, at_q8, 0, &hit), LIM_ERR_CAMERA);
    assert_int_equal(lim_sweep(&stage.solid, large_q8, at_q8, at_q8, 0, &hit), LIM_ERR_CAMERA);
    assert_int_equal(lim_sweep(&stage.solid, half_q8, at_q8, far_q8, 0, &hit), LIM_ERR_CAMERA);
    assert_int_equal(lim_sweep(&stage.solid, half_q8, far_q8, at_q8, 0, &hit), LIM_ERR_CAMERA);
    assert_int_equal(lim_slide(&stage.solid, half_q8, here_q8, (const int32_t[3]){1, 0, 0}, 0), LIM_ERR_CAMERA);
    assert_int_equal(here_q8[0], LIM_BODY_MAX_Q8 - 1);
    assert_int_equal(lim_slide(&stage.solid, half_q8, here_q8, (const int32_t[3]){INT32_MAX, 0, 0}, 0), LIM_ERR_CAMERA);
    here_q8[0] = INT32_MIN;
    assert_int_equal(lim_slide(&stage.solid, half_q8, here_q8, (const int32_t[3]){-1, 0, 0}, 0), LIM_ERR_CAMERA);
    solid_stage_end(&stage);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(boxes_end_in_no_wall),
        cmocka_unit_test(boxes_end_in_no_wall_of_random_buildings),
        cmocka_unit_test(what_slides_stays_in_a_closed_room),
        cmocka_unit_test(what_is_out_of_range_is_refused),
    };

    return cmocka_run_group_tests_name("box sweeps", tests, NULL, NULL);
}
