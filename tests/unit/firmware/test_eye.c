/* SPDX-License-Identifier: MIT
 *
 * The side of the eye against GMP: adversarial cases, most of them within a hair of the plane, for
 * every kind of node, with the eye inside the scene, at its border, and far outside. */
#include "eye.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"
#include "scene/plane.h"

#include <gmp.h>
#include <stdio.h>
#include <stdlib.h>

enum { CASES_PER_KIND = 750000 };

struct oracle {
    mpz_t sum, term;
};

static void set_s64(mpz_t out, int64_t value)
{
    mpz_set_si(out, (long)value); /* 64 bits wherever GMP's host tests run */
}

/* The sign of n . eye - d, eye in 1/256 units. */
static int oracle_side(struct oracle *o, const int64_t n[3], int64_t d, const int32_t eye_q8[3])
{
    mpz_set_ui(o->sum, 0);
    for (int i = 0; i < 3; i++) {
        set_s64(o->term, n[i]);
        mpz_mul_si(o->term, o->term, eye_q8[i]);
        mpz_add(o->sum, o->sum, o->term);
    }
    set_s64(o->term, d);
    mpz_mul_ui(o->term, o->term, 256);
    return mpz_cmp(o->sum, o->term) > 0 ? 1 : mpz_cmp(o->sum, o->term) < 0 ? -1 : 0;
}

struct fixture {
    enum plane_kind kind;
    struct lim_plane_ref ref;
    struct lim_plane planes[3];      /* the last is the node's */
    struct lim_plane_exact exact[2]; /* likewise */
    int64_t n[3], d;
};

/* Often a small or an extreme number, else anything in -limit .. limit. */
static int64_t component(struct random *random, int64_t limit)
{
    switch (random_u64(random) % 8) {
    case 0:
        return 0;
    case 1:
        return limit;
    case 2:
        return -limit;
    case 3:
        return random_in(random, -3, 3);
    default:
        return random_in(random, -limit, limit);
    }
}

static int64_t dot_with_grid_point(struct random *random, const int64_t n[3])
{
    int64_t sum = 0;

    for (int i = 0; i < 3; i++)
        sum += n[i] * random_in(random, -32768, 32767);
    return sum;
}

static void make_axis(struct random *random, struct fixture *f)
{
    const int16_t offset = (int16_t)component(random, 32767);

    f->ref.plane = LIM_PLANE_X + (lim_index)f->kind;
    f->ref.offset = offset;
    for (int i = 0; i < 3; i++)
        f->n[i] = i == (int)f->kind;
    f->d = offset;
}

static void make_small(struct random *random, struct fixture *f)
{
    do {
        for (int i = 0; i < 3; i++)
            f->n[i] = component(random, 16383);
        if (f->kind == PLANE_XZ) f->n[1] = 0;
        f->d = dot_with_grid_point(random, f->n);
    } while (llabs(f->n[0]) + llabs(f->n[1]) + llabs(f->n[2]) > 32767 || llabs(f->d) > LIM_PLANE_D_MAX);
    f->planes[2] = plane_record(f->n, f->d);
}

static void make_large(struct random *random, struct fixture *f)
{
    do {
        for (int i = 0; i < 3; i++)
            f->n[i] = component(random, INT64_C(1) << 30);
    } while (!f->n[0] && !f->n[1] && !f->n[2]);
    f->d = dot_with_grid_point(random, f->n);
    f->planes[2] = plane_filter(f->n, f->d, 1);
    f->exact[1] = (struct lim_plane_exact){
        {(int32_t)f->n[0], (int32_t)f->n[1], (int32_t)f->n[2]}, (int32_t)(f->d >> 32), (uint32_t)f->d};
}

static int32_t clamp_eye(int64_t at_q8)
{
    const int64_t limit = LIM_EYE_MAX_Q8 - 1;

    return (int32_t)(at_q8 > limit ? limit : at_q8 < -limit ? -limit : at_q8);
}

/* Anywhere within `range`; then, mostly, moved along one axis onto the plane, give or take a bit. */
static void make_eye(struct random *random, const struct fixture *f, int64_t range_q8, int32_t eye_q8[3])
{
    const int axis = (int)(random_u64(random) % 3);
    __int128 rest = (__int128)f->d * 256;

    for (int i = 0; i < 3; i++)
        eye_q8[i] = clamp_eye(random_in(random, -range_q8, range_q8));
    if (f->n[axis] == 0 || random_u64(random) % 8 == 0) return;
    for (int i = 0; i < 3; i++)
        rest -= i == axis ? 0 : (__int128)f->n[i] * eye_q8[i];
    const __int128 on_plane_q8 = rest / f->n[axis] + random_in(random, -2, 2);
    if (on_plane_q8 > -LIM_EYE_MAX_Q8 && on_plane_q8 < LIM_EYE_MAX_Q8) eye_q8[axis] = clamp_eye((int64_t)on_plane_q8);
}

static int sign_of(int32_t side)
{
    return (side > 0) - (side < 0);
}

/* With the filter and without it. */
static void no_side_is_decided_wrongly(enum plane_kind kind, uint64_t seed)
{
    static const int64_t ranges_q8[] = {32767 * 256, 40000 * 256, 200000 * 256, (INT64_C(1) << 28) - 1};
    struct random random = {seed};
    struct fixture f = {.kind = kind, .ref = {2 * LIM_PLANE_WORDS, 0}};
    const struct lim_scene scene = {.planes = f.planes, .exact = f.exact};
    struct oracle oracle;
    size_t wrong = 0, on = 0;

    mpz_inits(oracle.sum, oracle.term, NULL);
    for (int k = 0; k < CASES_PER_KIND; k++) {
        struct lim_eye eye;
        int32_t eye_q8[3];
        if (kind <= PLANE_Z)
            make_axis(&random, &f);
        else if (kind <= PLANE_SMALL)
            make_small(&random, &f);
        else
            make_large(&random, &f);
        make_eye(&random, &f, ranges_q8[k % 4], eye_q8);
        lim_eye_set(&eye, &scene, eye_q8);
        const int expected = oracle_side(&oracle, f.n, f.d, eye_q8);
        const int32_t side = lim_eye_side(&eye, &f.ref);
        wrong += sign_of(side) != expected;
        if (kind > PLANE_Z) wrong += sign_of(lim_eye_close_side(&eye, &f.ref)) != expected;
        on += expected == 0;
    }
    mpz_clears(oracle.sum, oracle.term, NULL);
    printf("# kind %d: %d cases, %zu with the eye exactly on the plane, %zu wrong\n", (int)kind, CASES_PER_KIND, on,
           wrong);
    assert_int_equal(wrong, 0);
    assert_true(on > 1000);
}

static void axis_planes_are_decided_rightly(void **state)
{
    (void)state;
    no_side_is_decided_wrongly(PLANE_X, 11);
    no_side_is_decided_wrongly(PLANE_Y, 12);
    no_side_is_decided_wrongly(PLANE_Z, 13);
}

static void upright_planes_are_decided_rightly(void **state)
{
    (void)state;
    no_side_is_decided_wrongly(PLANE_XZ, 14);
}

static void small_planes_are_decided_rightly(void **state)
{
    (void)state;
    no_side_is_decided_wrongly(PLANE_SMALL, 15);
}

static void large_planes_are_decided_rightly(void **state)
{
    (void)state;
    no_side_is_decided_wrongly(PLANE_LARGE, 16);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(axis_planes_are_decided_rightly),
        cmocka_unit_test(upright_planes_are_decided_rightly),
        cmocka_unit_test(small_planes_are_decided_rightly),
        cmocka_unit_test(large_planes_are_decided_rightly),
    };

    return cmocka_run_group_tests_name("eye", tests, NULL, NULL);
}
