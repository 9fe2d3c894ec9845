/* SPDX-License-Identifier: MIT
 *
 * Cameras from where they look. Yaw and pitch are as camera.h has them: the camera looks along
 * (-sin yaw cos pitch, sin pitch, -cos yaw cos pitch). */
#include "camera.h"

#include "math/fixed.h"

/* The longest part takes so many bits, so that what is near has as good an angle as what is far. */
enum { WAY_BITS = 30 };

/* From the eye to the target, in any unit, below 2^WAY_BITS. false: nowhere. */
static bool find_way(int32_t way[3], const int32_t eye_q8[3], const int32_t target_q8[3])
{
    uint32_t size[3], longest = 0; /* as many bits as the longest has */

    for (uint_fast8_t i = 0; i < 3; i++) {
        size[i] = target_q8[i] < eye_q8[i] ? (uint32_t)eye_q8[i] - (uint32_t)target_q8[i]
                                           : (uint32_t)target_q8[i] - (uint32_t)eye_q8[i];
        longest |= size[i];
    }
    if (!longest) return false;
    const int8_t up = (int8_t)(clz_u32(longest) - (32 - WAY_BITS));
    for (uint_fast8_t i = 0; i < 3; i++) {
        way[i] = (int32_t)(up < 0 ? size[i] >> -up : size[i] << up);
        if (target_q8[i] < eye_q8[i]) way[i] = -way[i];
    }
    return true;
}

/* The part of the way that is level, along its yaw: instead of a root. */
static int32_t level_part(const int32_t way[3], uint32_t yaw)
{
    return (int32_t)-shift_round_s64((int64_t)way[0] * lim_sin_q30(yaw) + (int64_t)way[2] * lim_cos_q30(yaw), 30);
}

void lim_look_at(struct lim_camera *camera, const int32_t eye_q8[3], const int32_t target_q8[3])
{
    LIM_ASSERT(camera && eye_q8 && target_q8);
    int32_t way[3];
    const bool goes_somewhere = find_way(way, eye_q8, target_q8);

    for (uint_fast8_t i = 0; i < 3; i++)
        camera->eye_q8[i] = eye_q8[i];
    if (!goes_somewhere) return;
    const bool is_vertical = !way[0] && !way[2];
    if (!is_vertical) camera->yaw = lim_atan2(-way[0], -way[2]);
    camera->pitch = lim_atan2(way[1], is_vertical ? 0 : level_part(way, camera->yaw));
}

static int32_t saturate_s32(int64_t x)
{
    return x > INT32_MAX ? INT32_MAX : x < INT32_MIN ? INT32_MIN : (int32_t)x;
}

void lim_orbit(struct lim_camera *camera, const int32_t target_q8[3], int32_t radius_q8, uint32_t yaw, uint32_t pitch)
{
    LIM_ASSERT(camera && target_q8);
    const int32_t level_q30 = lim_cos_q30(pitch);
    const int32_t back_q30[3] = {lim_mul_q30(lim_sin_q30(yaw), level_q30), -lim_sin_q30(pitch),
                                 lim_mul_q30(lim_cos_q30(yaw), level_q30)};

    camera->yaw = yaw;
    camera->pitch = pitch;
    for (uint_fast8_t i = 0; i < 3; i++)
        camera->eye_q8[i] = saturate_s32(target_q8[i] + shift_round_s64((int64_t)radius_q8 * back_q30[i], 30));
}
