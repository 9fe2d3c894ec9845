/* SPDX-License-Identifier: MIT
 *
 * Random closed worlds of many scales: a room, and in it heaps of boxes and tetrahedra, through one another, each heap
 * some powers of two smaller than the room. From near each of them nothing may be seen through or in the wrong order.
 */
#include "extremes/extreme.h"
#include "rigs/boxes.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"

#include <math.h>
#include <stdio.h>

enum { WORLDS = 16, WORLD_FRAMES = 60, HEAPS = 6, HEAP_SOLIDS = 5, WORLD_PX = 96, FACES_MOST = 6 };
enum {
    THIN_PX = 1000000
}; /* in so many pixels one may show a face that is thinner than what the reference looks for */
static const double ROOM_M = 1; /* from the middle to each wall */

struct side {
    double at_m[3], normal[3];
};

/* Convex: what is behind all of its planes. */
struct solid {
    struct side planes[FACES_MOST];
    int count;
};

struct heap {
    double middle_m[3], size_m;
    struct solid solids[HEAP_SOLIDS];
};

struct world {
    struct model model;
    struct heap heaps[HEAPS];
};

static double any(struct random *random)
{
    return 2 * random_unit(random) - 1;
}

/* Of the faces that were added last. */
static void take_planes(const struct model *model, int faces, struct solid *out)
{
    out->count = faces;
    for (int k = 0; k < faces; k++) {
        const struct model_face *face = &model->faces[model->face_count - (size_t)(faces - k)];
        const uint32_t *corners = &model->corners[face->first];
        const double *a = model->points[corners[0]], *b = model->points[corners[1]], *c = model->points[corners[2]];
        double length = 0;
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, l = (i + 2) % 3;
            out->planes[k].at_m[i] = a[i];
            out->planes[k].normal[i] = (b[j] - a[j]) * (c[l] - a[l]) - (b[l] - a[l]) * (c[j] - a[j]);
            length += out->planes[k].normal[i] * out->planes[k].normal[i];
        }
        for (int i = 0; i < 3; i++)
            out->planes[k].normal[i] /= sqrt(length);
    }
}

static double above_m(const struct side *plane, const double at_m[3])
{
    double sum = 0;

    for (int i = 0; i < 3; i++)
        sum += plane->normal[i] * (at_m[i] - plane->at_m[i]);
    return sum;
}

static void add_box(struct world *world, struct random *random, const struct heap *heap, struct solid *solid)
{
    double low_m[3], high_m[3];

    for (int i = 0; i < 3; i++) {
        low_m[i] = heap->middle_m[i] + heap->size_m * any(random);
        high_m[i] = low_m[i] + heap->size_m * (0.3 + random_unit(random));
    }
    boxes_add_solid(&world->model, low_m, high_m);
    take_planes(&world->model, 6, solid);
}

/* One corner near each of four that are far apart. */
static void add_tetrahedron(struct world *world, struct random *random, const struct heap *heap, struct solid *solid)
{
    static const double about[4][3] = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
    double corners_m[4][3], way_m[3];

    for (int i = 0; i < 3; i++)
        way_m[i] = heap->middle_m[i] + heap->size_m * any(random);
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++)
            corners_m[k][i] = way_m[i] + heap->size_m * (about[k][i] + 0.4 * any(random));
    boxes_add_tetrahedron(&world->model, (const double(*)[3])corners_m, false);
    take_planes(&world->model, 4, solid);
}

/* Heap k is 2^-bits as large as the room, from 2^-2 down to 2^-most_bits. */
static void world_make(struct world *world, struct random *random, int most_bits)
{
    const double low_m[3] = {-ROOM_M, -ROOM_M, -ROOM_M}, high_m[3] = {ROOM_M, ROOM_M, ROOM_M};

    *world = (struct world){.model = {0}};
    boxes_add_room(&world->model, low_m, high_m);
    for (int k = 0; k < HEAPS; k++) {
        struct heap *heap = &world->heaps[k];
        heap->size_m = ldexp(ROOM_M, -(3 + (most_bits - 3) * k / (HEAPS - 1)));
        for (int i = 0; i < 3; i++)
            heap->middle_m[i] = (ROOM_M - 4 * heap->size_m) * any(random);
        for (int s = 0; s < HEAP_SOLIDS; s++)
            (s % 2 ? add_tetrahedron : add_box)(world, random, heap, &heap->solids[s]);
    }
}

/* Outside of all solids, and of the walls, by that much. */
static bool is_free(const struct world *world, const double at_m[3], double margin_m)
{
    for (int i = 0; i < 3; i++)
        if (fabs(at_m[i]) > ROOM_M - margin_m) return false;
    for (int k = 0; k < HEAPS; k++)
        for (int s = 0; s < HEAP_SOLIDS; s++) {
            const struct solid *solid = &world->heaps[k].solids[s];
            bool outside = false;
            for (int f = 0; f < solid->count; f++)
                outside |= above_m(&solid->planes[f], at_m) > margin_m;
            if (!outside) return false;
        }
    return true;
}

/* Moves the eye into the plane of one of the heap's faces, or a hair off it. */
static void graze(struct random *random, const struct heap *heap, double eye_m[3])
{
    const struct solid *solid = &heap->solids[random_u64(random) % HEAP_SOLIDS];
    const struct side *plane = &solid->planes[random_u64(random) % (uint64_t)solid->count];
    const double off_m = above_m(plane, eye_m) + (random_u64(random) % 2 ? 1e-4 * heap->size_m * any(random) : 0);

    for (int i = 0; i < 3; i++)
        eye_m[i] -= off_m * plane->normal[i];
}

/* Around a heap, near enough for its things to be seen, and of what is in its middle or anywhere. */
static void look(struct extreme *extreme, const struct world *world, struct random *random)
{
    const struct heap *heap = &world->heaps[random_u64(random) % HEAPS];
    const double unit_m = 1 / extreme->scene.grid.units_per_m;
    const double near_m = fmin(fmax(0.02 * heap->size_m, 2.1 * unit_m), 10000 * unit_m);
    double eye_m[3], target_m[3];

    do {
        for (int i = 0; i < 3; i++)
            eye_m[i] = heap->middle_m[i] + 5 * heap->size_m * any(random);
        if (random_u64(random) % 2) graze(random, heap, eye_m);
    } while (!is_free(world, eye_m, 2 * near_m));
    for (int i = 0; i < 3; i++)
        target_m[i] = random_u64(random) % 4 ? heap->middle_m[i] + heap->size_m * any(random) : ROOM_M * any(random);
    extreme->lens.near_m = near_m;
    extreme_frame(extreme, eye_m, target_m);
}

/* In percent. */
static double most_wrong(const struct core *profile)
{
    return profile->profile == LIM_PROFILE_FAST ? 0.1 : profile->profile == LIM_PROFILE_FINE ? 0.05 : 0.01;
}

static void draw_world(const struct world *world, uint64_t seed, const struct core *profile, struct holes *sum)
{
    const struct extreme_picture picture = {WORLD_PX, WORLD_PX, 70, 1e-9};
    struct random random = {seed};
    struct extreme extreme;

    extreme_open_long(&extreme, &world->model, profile, &picture);
    for (int f = 0; f < effort(WORLD_FRAMES); f++)
        look(&extreme, world, &random);
    sum->pixels += extreme.sum.pixels;
    sum->frames += extreme.sum.frames;
    sum->wrong += extreme.sum.wrong;
    sum->misplaced += extreme.sum.misplaced;
    sum->holes += extreme.sum.holes;
    extreme_close(&extreme);
}

/* The smallest heap is 2^-most_bits as large as half of the room. */
static void worlds_are_closed_and_in_order(int most_bits)
{
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);
    struct holes sums[PROFILES_MAX] = {{0}};
    struct random random = {191};
    size_t failed = 0;

    for (int w = 0; w < WORLDS; w++) {
        static struct world world;
        world_make(&world, &random, most_bits);
        const uint64_t seed = random_u64(&random) | 1;
        for (size_t k = 0; k < count; k++)
            draw_world(&world, seed, profiles[k], &sums[k]);
        model_free(&world.model);
    }
    for (size_t k = 0; k < count; k++) {
        const struct holes *sum = &sums[k];
        printf("# long-worlds 2^-%d %s: %zu pixels of %zu frames, %zu holes, %zu misplaced, %.4f %% wrong\n", most_bits,
               profiles[k]->name, sum->pixels, sum->frames, sum->holes, sum->misplaced, holes_wrong_percent(sum));
        failed += sum->holes > 0;
        if (profiles[k]->sub_bits > 0)
            failed += sum->misplaced > sum->pixels / THIN_PX || holes_wrong_percent(sum) > most_wrong(profiles[k]);
    }
    assert_int_equal(failed, 0);
}

static void worlds_of_2_10(void **state)
{
    (void)state;
    worlds_are_closed_and_in_order(10);
}

static void worlds_of_2_16(void **state)
{
    (void)state;
    worlds_are_closed_and_in_order(16);
}

static void worlds_of_2_22(void **state)
{
    (void)state;
    worlds_are_closed_and_in_order(22);
}

/* Things of some two units, whose vertices have fractions: half a unit is no tolerance there. */
static void worlds_of_2_28(void **state)
{
    (void)state;
    worlds_are_closed_and_in_order(28);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(worlds_of_2_10),
        cmocka_unit_test(worlds_of_2_16),
        cmocka_unit_test(worlds_of_2_22),
        cmocka_unit_test(worlds_of_2_28),
    };

    return cmocka_run_group_tests_name("closed worlds of many scales", tests, NULL, NULL);
}
