/* SPDX-License-Identifier: MIT
 *
 * The filter and its bounds. Let c be the eye, k = shift, s = floor(c / 2^k), so c / 2^k = s + f
 * with 0 <= f < 1 in each component; let t = n.s - floor(d / 2^k), 32 bits by scene.h's bounds.
 *
 * An exact plane (XZ, SMALL): (n.c - d) / 2^k = t + n.f - g with 0 <= g < 1, and |n.f| is below
 * |n0|+|n1|+|n2| <= 32767. Hence |t| >= 32768 shares its sign with n.c - d.
 *
 * A LARGE plane N, D is filtered by n = N s - e and d = D s - u, all |e|, |u| <= 1/2. The scaled
 * truth is t + n.f - g + e.(s + f) - u / 2^k, off from t by less than (3 * 8191) + 1 +
 * (|s0|+|s1|+|s2| + 3) / 2 + 1/2: `large_slack`, rounded up. */
#include "eye.h"

#include "fixed.h"

#define SMALL_SLACK INT32_C(32768)
#define LARGE_SLACK_FIXED INT32_C(24577) /* 3 * 8191 + 1 + 3/2 + 1/2, rounded up */

/* An int16_t holds the reduced eye when every component is in -2^15 .. 2^15 - 1. */
static bool fits_s16(const int32_t at_q8[3], uint8_t shift)
{
    for (uint8_t i = 0; i < 3; i++) {
        const int32_t whole = at_q8[i] >> 8 >> shift;
        if (whole < -32768 || whole > 32767) return false;
    }
    return true;
}

void lim_eye_set(struct lim_eye *eye, const int32_t at_q8[3])
{
    uint32_t sum = 0;

    eye->shift = 0;
    while (!fits_s16(at_q8, eye->shift))
        eye->shift++;
    for (uint8_t i = 0; i < 3; i++) {
        eye->at_q8[i] = at_q8[i];
        eye->reduced[i] = (at_q8[i] >> 8 >> eye->shift);
        sum += abs_s32(eye->reduced[i]);
    }
    eye->near_kind = eye->shift ? LIM_PLANE_Z : LIM_PLANE_SMALL;
    eye->large_slack = LARGE_SLACK_FIXED + (int32_t)((sum + 1) >> 1);
}

/*@ assigns \nothing;
    ensures (\result > 0 <==> value > 0) && (\result < 0 <==> value < 0); */
static int16_t sign_s64(int64_t value)
{
    return (int16_t)((value > 0) - (value < 0));
}

/* n.c - d in 64 bits: |n| < 2^31, |c| < 2^28, |d| < 2^48, together below 3 * 2^59 + 2^56. */
/*@ requires \valid_read(eye) && \valid_read(n + (0 .. 2)) && -281474976710656 < d < 281474976710656;
    requires \forall integer i; 0 <= i < 3 ==> -2147483648 < n[i] && -268435456 < eye->at_q8[i] < 268435456;
    assigns \nothing;
    ensures \let side = n[0] * eye->at_q8[0] + n[1] * eye->at_q8[1] + n[2] * eye->at_q8[2] - d * 256;
            (\result > 0 <==> side > 0) && (\result < 0 <==> side < 0); */
static int16_t exact_side(const struct lim_eye *eye, const int32_t n[3], int64_t d)
{
    return sign_s64((int64_t)n[0] * eye->at_q8[0] + (int64_t)n[1] * eye->at_q8[1] + (int64_t)n[2] * eye->at_q8[2] -
                    d * 256);
}

/*@ requires \valid_read(eye) && \valid_read(plane) && -1073741824 < plane->d < 1073741824;
    requires \forall integer i; 0 <= i < 3 ==> -268435456 < eye->at_q8[i] < 268435456;
    assigns \nothing; */
static LIM_RARE int16_t near_undecided(const struct lim_eye *eye, const LIM_FLASH struct lim_plane *plane)
{
    const int32_t n[3] = {plane->n[0], plane->n[1], plane->n[2]};

    return exact_side(eye, n, plane->d);
}

static LIM_RARE int16_t large_undecided(const struct lim_eye *eye, const LIM_FLASH struct lim_plane_exact *exact)
{
    const int32_t n[3] = {exact->n[0], exact->n[1], exact->n[2]};

    return exact_side(eye, n, (int64_t)exact->d_hi * (INT64_C(1) << 32) + exact->d_lo);
}

/* What a shift leaves of a decided value is neither 0 nor -1: that takes |value| >= 2^16, more than the slack, and
 * leaves 16 bits. */
/*@ requires \valid_read(eye) && \valid_read(plane) && -1073741824 < plane->d < 1073741824;
    requires \forall integer i; 0 <= i < 3 ==> -268435456 < eye->at_q8[i] < 268435456;
    requires \forall integer i; 0 <= i < 3 ==> -32768 <= eye->reduced[i] <= 32767;
    requires -32767 <= plane->n[0] <= 32767 && -32767 <= plane->n[1] <= 32767 && -32767 <= plane->n[2] <= 32767;
    assigns \nothing; */
int16_t lim_eye_near_side(const struct lim_eye *eye, const LIM_FLASH struct lim_plane *plane)
{
    const int32_t value =
        plane->n[0] * eye->reduced[0] + plane->n[1] * eye->reduced[1] + plane->n[2] * eye->reduced[2] - plane->d;
    const int32_t side = value >> 16;

    return (uint32_t)(side + 1) <= 1 ? near_undecided(eye, plane) : (int16_t)side;
}

int16_t lim_eye_far_side(const struct lim_eye *eye, const struct lim_scene *scene,
                         const LIM_FLASH struct lim_plane *plane)
{
    const bool is_large = LIM_HAS_LARGE && plane->exact != LIM_NONE;
    const int32_t slack = is_large ? eye->large_slack : SMALL_SLACK;
    const int32_t value = plane->n[0] * eye->reduced[0] + plane->n[1] * eye->reduced[1] +
                          plane->n[2] * eye->reduced[2] - (plane->d >> eye->shift);

    if (value >= slack) return 1;
    if (value <= -slack) return -1;
    return is_large ? large_undecided(eye, &scene->exact[plane->exact]) : near_undecided(eye, plane);
}
