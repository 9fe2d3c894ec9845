/* SPDX-License-Identifier: MIT
 *
 * The filter and its bounds. Let c be the eye, k = shift, s = floor(c / 2^k), so c / 2^k = s + f
 * with 0 <= f < 1 in each component; let t = n.s - floor(d / 2^k), 32 bits by scene.h's bounds.
 *
 * An exact plane: (n.c - d) / 2^k = t + n.f - g with 0 <= g < 1, and |n.f| is below |n0|+|n1|+|n2| <= 32767.
 * Hence |t| >= 32768 shares its sign with n.c - d.
 *
 * A LARGE plane N, D is filtered by n = N s - e and d = D s - u, all |e|, |u| <= 1/2. The scaled
 * truth is t + n.f - g + e.(s + f) - u / 2^k, off from t by less than (3 * 8191) + 1 +
 * (|s0|+|s1|+|s2| + 3) / 2 + 1/2: `large_slack`, rounded up.
 *
 * LIM_PLANE_SLACK does for all, but for eyes in the cube's farthest corners, where large_slack is more. With it in d's
 * place, d / 2^k is rounded up instead of down: g changes its sign, and no bound. */
#include "eye.h"

#include "math/fixed.h"

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

/* What the filter sees of the eye. */
static void reduce(struct lim_eye *eye)
{
    uint32_t sum = 0;

    eye->shift = 0;
    while (!fits_s16(eye->at_q8, eye->shift))
        eye->shift++;
    for (uint8_t i = 0; i < 3; i++) {
        eye->reduced[i] = (lim_eye_reduced)(eye->at_q8[i] >> 8 >> eye->shift);
        sum += abs_s32(eye->reduced[i]);
    }
    eye->large_slack = LARGE_SLACK_FIXED + (int32_t)((sum + 1) >> 1);
    eye->slack_rest = LIM_PLANE_SLACK - (LIM_PLANE_SLACK >> eye->shift);
    eye->near_end = (LIM_8_BIT && eye->shift) || eye->large_slack > LIM_PLANE_SLACK ? 0 : LIM_PLANE_X;
}

void lim_eye_set(struct lim_eye *eye, const struct lim_scene *scene, const int32_t at_q8[3])
{
    eye->scene = scene;
    eye->planes = scene->planes;
    for (uint8_t i = 0; i < 3; i++)
        eye->at_q8[i] = at_q8[i];
    if (LIM_HAS_FILTER) reduce(eye);
    if (LIM_HAS_LONG) eye->far->all = NULL;
}

/*@ assigns \nothing;
    ensures (\result > 0 <==> value > 0) && (\result < 0 <==> value < 0); */
static int32_t sign_s64(int64_t value)
{
    return (value > 0) - (value < 0);
}

/* n.c - d in 64 bits: |n| < 2^31, |c| < 2^28, |d| < 2^48, together below 3 * 2^59 + 2^56. */
/*@ requires \valid_read(eye) && \valid_read(n + (0 .. 2)) && -281474976710656 < d < 281474976710656;
    requires \forall integer i; 0 <= i < 3 ==> -2147483648 < n[i] && -268435456 < eye->at_q8[i] < 268435456;
    assigns \nothing;
    ensures \let side = n[0] * eye->at_q8[0] + n[1] * eye->at_q8[1] + n[2] * eye->at_q8[2] - d * 256;
            (\result > 0 <==> side > 0) && (\result < 0 <==> side < 0); */
static int32_t exact_side(const struct lim_eye *eye, const int32_t n[3], int64_t d)
{
    return sign_s64((int64_t)n[0] * eye->at_q8[0] + (int64_t)n[1] * eye->at_q8[1] + (int64_t)n[2] * eye->at_q8[2] -
                    d * 256);
}

int32_t lim_eye_close_side(const struct lim_eye *eye, const LIM_FLASH struct lim_plane_ref *ref)
{
    const LIM_FLASH struct lim_plane *plane = lim_plane_at(eye->planes, ref->plane);

    if (LIM_HAS_LARGE && lim_plane_exact(plane) != LIM_NO_INDEX) {
        const LIM_FLASH struct lim_plane_exact *exact = &eye->scene->exact[lim_plane_exact(plane)];
        const int32_t n[3] = {exact->n[0], exact->n[1], exact->n[2]};
        return exact_side(eye, n, (int64_t)exact->d_hi * (INT64_C(1) << 32) + exact->d_lo);
    }
    const int32_t n[3] = {lim_plane_x(plane), lim_plane_y(plane), lim_plane_z(plane)};
    return exact_side(eye, n, lim_plane_d(plane));
}

/*@ requires \valid_read(eye) && \valid_read(plane) && 0 <= eye->shift <= 31;
    requires -1073676289 <= plane->slack_less_d - 65536 <= 1073676289;
    requires -32768 <= eye->reduced[0] <= 32767 && -32768 <= eye->reduced[1] <= 32767;
    requires -32768 <= eye->reduced[2] <= 32767;
    requires size((int16_t)plane->n_yx) + size(plane->n_yx >> 16) + size(plane->n_z_exact >> 16) <= 32767;
    assigns \nothing; */
static int32_t far_value(const struct lim_eye *eye, const LIM_FLASH struct lim_plane *plane)
{
    const int32_t d = lim_plane_d(plane) >> eye->shift;

    //@ assert -1073676289 <= d <= 1073676289;
    return lim_eye_dot(eye, plane) - d;
}

int32_t lim_eye_far_side(const struct lim_eye *eye, const LIM_FLASH struct lim_plane_ref *ref)
{
    const LIM_FLASH struct lim_plane *plane = lim_plane_at(eye->planes, ref->plane);
    const bool is_large = LIM_HAS_LARGE && lim_plane_exact(plane) != LIM_NO_INDEX;
    const int32_t slack = is_large ? eye->large_slack : SMALL_SLACK;
    const int32_t value = far_value(eye, plane);

    return value >= slack || value <= -slack ? value : lim_eye_close_side(eye, ref);
}
