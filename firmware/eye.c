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
        eye->reduced[i] = (int16_t)(at_q8[i] >> 8 >> eye->shift);
        sum += abs_s32(eye->reduced[i]);
    }
    eye->large_slack = LARGE_SLACK_FIXED + (int32_t)((sum + 1) >> 1);
}

static int8_t sign_s64(int64_t value)
{
    return (int8_t)((value > 0) - (value < 0));
}

/* n.c - d in 64 bits: |n| < 2^31, |c| < 2^28, |d| < 2^48, together below 3 * 2^59 + 2^56. */
static int8_t exact_side(const struct lim_eye *eye, const int32_t n[3], int64_t d)
{
    return sign_s64((int64_t)n[0] * eye->at_q8[0] + (int64_t)n[1] * eye->at_q8[1] + (int64_t)n[2] * eye->at_q8[2] -
                    d * 256);
}

static int8_t undecided_side(const struct lim_eye *eye, const struct lim_scene *scene,
                             const LIM_FLASH struct lim_plane *plane)
{
    if (plane->exact == LIM_NONE) {
        const int32_t n[3] = {plane->n[0], plane->n[1], plane->n[2]};
        return exact_side(eye, n, plane->d);
    }
    const LIM_FLASH struct lim_plane_exact *exact = &scene->exact[plane->exact];
    const int32_t n[3] = {exact->n[0], exact->n[1], exact->n[2]};
    return exact_side(eye, n, (int64_t)exact->d_hi * (INT64_C(1) << 32) + exact->d_lo);
}

static int8_t axis_side(int32_t at_q8, uint16_t plane)
{
    const int32_t plane_q8 = (int32_t)(int16_t)plane * 256;

    return (int8_t)((at_q8 > plane_q8) - (at_q8 < plane_q8));
}

static int8_t filtered_side(const struct lim_eye *eye, const struct lim_scene *scene,
                            const LIM_FLASH struct lim_node *node)
{
    const LIM_FLASH struct lim_plane *plane = &scene->planes[node->plane];
    const int32_t slack = node->kind == LIM_PLANE_LARGE ? eye->large_slack : SMALL_SLACK;
    int32_t value = (int32_t)plane->n[0] * eye->reduced[0] + (int32_t)plane->n[2] * eye->reduced[2];

    if (node->kind != LIM_PLANE_XZ) value += (int32_t)plane->n[1] * eye->reduced[1];
    value -= plane->d >> eye->shift;
    if (value >= slack) return 1;
    if (value <= -slack) return -1;
    return undecided_side(eye, scene, plane);
}

int8_t lim_eye_side(const struct lim_eye *eye, const struct lim_scene *scene, const LIM_FLASH struct lim_node *node)
{
    if (node->kind <= LIM_PLANE_Z) return axis_side(eye->at_q8[node->kind], node->plane);
    return filtered_side(eye, scene, node);
}
