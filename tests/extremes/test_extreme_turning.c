/* SPDX-License-Identifier: MIT
 *
 * A million frames of rotation. Angles are stored, as 32-bit fractions of a turn, and every frame's
 * matrix is made from them anew, so nothing can drift; what turning a stored matrix by a small step would
 * have come to instead is measured beside it. And the four quadrants of every angle. */
#include "camera.h"
#include "extreme.h"
#include "rigs/boxes.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FRAMES = 1 << 20, SIDE_PX = 8, QUADRANT_STEPS = 1 << 22 };

/* Steps of an odd multiple of 2^32 / frames: after them the angle is the first one again, and no other has come twice.
 * Where less effort is asked for, there are fewer. */
static uint32_t frames_of_a_round(void)
{
    uint32_t frames = FRAMES;

    while (frames > (uint32_t)effort(FRAMES))
        frames /= 2;
    return frames;
}

static const double TURN = 6.283185307179586;

static double radians(uint32_t angle)
{
    return TURN * angle / 4294967296.0;
}

/* Stored angles ------------------------------------------------------------------------------- */

static void no_drift_in(const struct core *profile)
{
    static const struct extreme_picture picture = {SIDE_PX, SIDE_PX, 60, 4};
    static const double eye_m[3] = {1000, -3000, 7000}, target_m[3] = {0, 0, 0};
    const size_t bytes = SIDE_PX * SIDE_PX * sizeof(uint32_t);
    uint32_t first[SIDE_PX * SIDE_PX];
    size_t background = 0, differ = 0;
    struct model model = {0};
    struct extreme extreme;

    boxes_add_jumble(&model);
    extreme_open(&extreme, &model, profile, &picture);
    struct lim_camera camera = extreme_aim(&extreme, eye_m, target_m);
    extreme_camera(&extreme, &camera);
    memcpy(first, extreme.ids.faces, bytes);
    const uint32_t frames = frames_of_a_round(), step = 977 * (UINT32_MAX / frames + 1);
    for (uint32_t frame = 0; frame < frames; frame++) {
        camera.yaw += step;
        camera.pitch += step;
        camera.roll += step;
        background += extreme_camera(&extreme, &camera);
    }
    extreme_show(&extreme, "rotation-stored-angles");
    for (size_t i = 0; i < SIDE_PX * SIDE_PX; i++)
        differ += first[i] != extreme.ids.faces[i];
    extreme_row("rotation-stored-angles", profile->name, "0 drift, 0 holes",
                "%zu pixels of the last frame differ from the first, %zu holes in %u frames", differ, background,
                frames);
    extreme_close(&extreme);
    model_free(&model);
    assert_int_equal(differ, 0);
    assert_int_equal(background, 0);
}

static void a_million_frames_of_stored_angles_do_not_drift(void **state)
{
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);

    (void)state;
    extreme_about("rotation-stored-angles", "The camera turns a million times, by angles that are stored");
    for (size_t k = 0; k < count; k++)
        no_drift_in(profiles[k]);
}

/* Stored matrices ------------------------------------------------------------------------------ */

/* Two of a matrix's rows, fraction bits as the row of the table says: enough for a rotation in a plane. */
struct stored {
    int bits;
    bool renormalised; /* every frame, by one Newton step */
    int64_t cosine, sine;
};

static int64_t scaled(const struct stored *m, double value)
{
    return llround(ldexp(value, m->bits));
}

static int64_t shifted(const struct stored *m, int64_t product)
{
    return (product + (INT64_C(1) << (m->bits - 1))) >> m->bits;
}

static void turn_on(struct stored *m, double step)
{
    const int64_t c = scaled(m, cos(step)), s = scaled(m, sin(step));
    const int64_t cosine = shifted(m, m->cosine * c - m->sine * s), sine = shifted(m, m->sine * c + m->cosine * s);

    m->cosine = cosine;
    m->sine = sine;
    if (!m->renormalised) return;
    const int64_t one = INT64_C(1) << m->bits, square = shifted(m, cosine * cosine + sine * sine);
    const int64_t factor = one + (one - square) / 2;
    m->cosine = shifted(m, cosine * factor);
    m->sine = shifted(m, sine * factor);
}

/* How far off, at the rim of a picture of 240 pixels and 60 degrees, the matrix puts a point by its
 * angle or its length. */
static double error_px(const struct stored *m, uint32_t angle)
{
    const double cosine = ldexp((double)m->cosine, -m->bits), sine = ldexp((double)m->sine, -m->bits);
    const double truth_c = cos(radians(angle)), truth_s = sin(radians(angle));
    const double along = truth_c * cosine + truth_s * sine, across = truth_c * sine - truth_s * cosine;

    return fmax(fabs(across), fabs(along - 1)) * 120 / tan(TURN / 12);
}

static void warn_of(const char *name, struct stored m)
{
    uint32_t angle = 0, lost = 0;
    double worst_px = 0;

    m.cosine = INT64_C(1) << m.bits;
    const uint32_t step = 977 * (UINT32_MAX / FRAMES + 1);
    for (uint32_t frame = 1; frame <= FRAMES; frame++) {
        angle += step;
        turn_on(&m, radians(step));
        const double px = error_px(&m, angle);
        if (!lost && px > 1) lost = frame;
        if (px > worst_px) worst_px = px;
    }
    if (lost)
        extreme_row("rotation-stored-matrix", name, "nothing: not used", "a pixel off after %u frames, %.3g px in %d",
                    lost, worst_px, FRAMES);
    else
        extreme_row("rotation-stored-matrix", name, "nothing: not used", "%.3g px off in %d frames", worst_px, FRAMES);
    assert_true(worst_px > 0.001); /* stored angles: 0 */
}

static void stored_matrices_would_drift(void **state)
{
    (void)state;
    extreme_about("rotation-stored-matrix", "The camera would turn a million times by a matrix that is stored");
    warn_of("Q14", (struct stored){.bits = 14});
    warn_of("Q16", (struct stored){.bits = 16});
    warn_of("Q30", (struct stored){.bits = 30});
    warn_of("Q30-renormalised", (struct stored){.bits = 30, .renormalised = true});
}

/* Quadrants ------------------------------------------------------------------------------------ */

static void sine_and_cosine_are_symmetric_to_the_bit(void **state)
{
    const uint32_t quarter = LIM_ANGLE_QUARTER, half = 2 * LIM_ANGLE_QUARTER;
    size_t broken = 0;
    double worst = 0;

    (void)state;
    extreme_about("quadrants", "Angles lie at and around every eighth of a turn");
    for (uint32_t k = 0; k < QUADRANT_STEPS; k++) {
        /* An odd step reaches all residues; every 16th one lies within a few units of a quarter turn. */
        const uint32_t angle = k % 16 ? k * UINT32_C(2654435761) : (k / 16 % 4) * quarter + k / 64 % 64 - 32;
        const int32_t sine = lim_sin_q30(angle), cosine = lim_cos_q30(angle);
        broken += lim_sin_q30(0 - angle) != -sine || lim_cos_q30(0 - angle) != cosine;
        broken += lim_sin_q30(half - angle) != sine || lim_cos_q30(half - angle) != -cosine;
        broken += lim_sin_q30(half + angle) != -sine || lim_cos_q30(half + angle) != -cosine;
        broken += lim_sin_q30(quarter + angle) != cosine || lim_cos_q30(quarter + angle) != -sine;
        worst = fmax(worst, fabs(ldexp(sine, -30) - sin(radians(angle))));
    }
    extreme_row("quadrants", "all", "symmetric to the bit, within 2^-28",
                "%zu asymmetries of %d angles, worst error 2^%.1f", broken, QUADRANT_STEPS, log2(worst));
    assert_int_equal(broken, 0);
    assert_true(worst < ldexp(1, -28));
}

/* Every quarter turn and a few steps around it, in all three angles. */
static void no_hole_in_any_quadrant(const struct core *profile)
{
    static const struct extreme_picture picture = {32, 32, 60, 4};
    static const double eye_m[3] = {1000, -3000, 7000}, target_m[3] = {0, 0, 0};
    size_t background = 0, frames = 0;
    struct model model = {0};
    struct extreme extreme;

    boxes_add_jumble(&model);
    extreme_open(&extreme, &model, profile, &picture);
    struct lim_camera camera = extreme_aim(&extreme, eye_m, target_m);
    for (uint32_t k = 0; k < (uint32_t)effort(8 * 8 * 8 * 27); k++, frames++) {
        camera.yaw = (k % 8 << 29) + k / 512 % 3 - 1;
        camera.pitch = (k / 8 % 8 << 29) + k / 512 / 3 % 3 - 1;
        camera.roll = (k / 64 % 8 << 29) + k / 512 / 9 - 1;
        background += extreme_camera(&extreme, &camera);
    }
    extreme_show(&extreme, "quadrants");
    extreme_row("quadrants", profile->name, "0 holes", "%zu holes in %zu frames at and around every eighth of a turn",
                background, frames);
    extreme_close(&extreme);
    model_free(&model);
    assert_int_equal(background, 0);
}

static void every_quadrant_of_every_angle_shows_no_hole(void **state)
{
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);

    (void)state;
    for (size_t k = 0; k < count; k++)
        no_hole_in_any_quadrant(profiles[k]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_million_frames_of_stored_angles_do_not_drift),
        cmocka_unit_test(stored_matrices_would_drift),
        cmocka_unit_test(sine_and_cosine_are_symmetric_to_the_bit),
        cmocka_unit_test(every_quadrant_of_every_angle_shows_no_hole),
    };

    return cmocka_run_group_tests_name("extremes of turning", tests, NULL, NULL);
}
