/* SPDX-License-Identifier: MIT
 *
 * The camera: where the eye is, where it looks, and how wide. And binary angles: a full turn is 2^32, so angles wrap by
 * themselves and a stored one never drifts. */
#ifndef LIM_CAMERA_H
#define LIM_CAMERA_H

#include "config.h"

LIM_C_BEGIN

#define LIM_ANGLE_QUARTER (UINT32_C(1) << 30)

/* An angle from degrees, which are a constant, whole or not: LIM_DEGREES(-22.5). Within -360..360, to a ten-thousandth
 * of a degree: so far all compilers agree, also those whose double has 32 bits. It is computed by the compiler; of a
 * variable the processor would have to compute it in floating point. */
#define LIM_DEGREES(degrees) LIM_ANGLE_OF_E4((degrees) < 0 ? (degrees)*1e4 - 0.5 : (degrees)*1e4 + 0.5)
#define LIM_ANGLE_OF_E4(degrees_e4)                                                                                    \
    LIM_CAST(uint32_t, ((LIM_CAST(int32_t, degrees_e4) + INT64_C(3600000)) * (INT64_C(1) << 32) + 1800000) / 3600000)

/* Within -1..1, and within 3.3 units of 2^-30 of the truth over all angles; exact at multiples of a quarter
 * turn. Antisymmetric to the bit. */
int32_t lim_sin_q30(uint32_t angle);
int32_t lim_cos_q30(uint32_t angle);

/* The angle of the vector (x, y), from the x axis towards the y axis: within 2 units of 2^-32 of a turn (2e-7 degrees)
 * of the truth, exact at multiples of an eighth of a turn, and 0 of (0, 0). lim_atan2(-y, x) is -lim_atan2(y, x). */
uint32_t lim_atan2(int32_t y, int32_t x);

/* Of a lens that is narrower than LIM_TAN_TELE_Q28 in either direction z has more bits than x and y, and corners are
 * where they belong, if LIM_HAS_TELE is 1. If it is 0, the picture is shifted in profiles draft and fast, by up to half
 * a pixel of 240 at 1/64, the near plane is farther away, and what is below 1/64 is refused. `limner compile` sets it
 * to 1 for a --fov of less than 14 degrees and else to 0; limner itself draws as if it were 1. */
#define LIM_TAN_MIN_Q28 (UINT32_C(1) << (LIM_HAS_TELE ? 17 : 22)) /* 1/2048, or 1/64 */
#define LIM_TAN_TELE_Q28 (UINT32_C(1) << 25)                      /* 1/8: an angle of 14 degrees */
#define LIM_TAN_MAX_Q28 (UINT32_C(1) << 30)                       /* 4: half an angle of 152 degrees */
#define LIM_NEAR_MAX_Q8 (INT32_C(1) << 24)

/* A constant number of units, with 8 fraction bits, rounded to nearest. */
#define LIM_UNITS_Q8(units) LIM_CAST(int32_t, (units) < 0 ? (units)*256.0 - 0.5 : (units)*256.0 + 0.5)
#define LIM_UNITS(units) LIM_CAST(int32_t, (units) < 0 ? (units)-0.5 : (units) + 0.5) /* whole ones */

/* A full turn is 2^32. Yaw 0 looks along -z, a quarter turn along -x: counter-clockwise from above;
 * pitch raises the view; roll turns the picture counter-clockwise. Nothing is accumulated: a stored
 * angle cannot drift. */
LIM_OPTIONAL_BEGIN
struct lim_camera {
    int32_t eye_q8[3]; /* units with 8 fraction bits, |eye_q8| < 2^28 */
    uint32_t yaw, pitch, roll;
    uint32_t tan_x_q28, tan_y_q28; /* tangents of the half-angles of view, LIM_TAN_MIN_Q28..LIM_TAN_MAX_Q28 */
    /* Distance of the near plane, units: 1..2^24 (1/256 to 65536). The one in use is never nearer than
     * 2^-16 / min(1, tan_x, tan_y) of the distance of the scene's far end, nor than 1 unit: less than 2 units
     * for an eye within the grid and a lens of 90 degrees. Nearer by, z has too few bits to divide by. Of lenses below
     * LIM_TAN_TELE_Q28, with LIM_HAS_TELE, it may be as near as 2^-15 of that distance, and 2 units. In a scene of many
     * scales it is 14000 units away at most (long.h). */
    int32_t near_q8;
    /* In a scene of many scales (long.h): where eye_q8 counts from, units; eye and origin together are below 2^30. */
    LIM_OPTIONAL(int32_t, origin, 3 * LIM_HAS_LONG);
};
LIM_OPTIONAL_END

/* What ends a camera's initializer, in whichever build: `{{1, 2, 3}, yaw, ..., LIM_CAMERA_END(near_q8, 0, 0, 0)}`. */
#define LIM_CAMERA_END(near_q8, x, y, z) LIM_CAMERA_END_IF(LIM_HAS_LONG, near_q8, x, y, z)
#define LIM_CAMERA_END_IF(has, near_q8, x, y, z) LIM_CAMERA_END_IF_(has, near_q8, x, y, z)
#define LIM_CAMERA_END_IF_(has, near_q8, x, y, z) LIM_CAMERA_END_IF_##has(near_q8, x, y, z)
#define LIM_CAMERA_END_IF_0(near, x, y, z) LIM_LAST_VALUE(near_q8, near)
#define LIM_CAMERA_END_IF_1(near, x, y, z)                                                                             \
    near,                                                                                                              \
    {                                                                                                                  \
        x, y, z                                                                                                        \
    }

/* Where an eye is in such a scene: |at| < 2^30 units, and what is left of one. */
struct lim_long;
struct lim_long_eye {
    const struct lim_long *all; /* the scene's arrays; NULL: it is none of 32 bits, and the rest is not set */
    int32_t at[3];
    uint8_t fraction_q8[3];
    int8_t unit; /* of an object that moves in the scene: its units are 2^unit of the scene's; 0 of the scene */
};

/* lim_look_at() and lim_orbit() in a scene of many scales: eye, target and radius in whole units, below 2^30. The eye
 * is where they put it, to a unit; it is in origin, and eye_q8 is 0. */
void lim_look_at_far(struct lim_camera *camera, const int32_t eye[3], const int32_t target[3]);
void lim_orbit_far(struct lim_camera *camera, const int32_t target[3], int32_t radius, uint32_t yaw, uint32_t pitch);

/* In a scene of many scales: whole units go from eye_q8 to origin, where there is room for more. After each step of a
 * camera that goes far. */
void lim_camera_carry(struct lim_camera *camera);

/* Puts the camera at the eye and turns it to the target, upright; roll and lens stay as they are. Both in units with 8
 * fraction bits, anywhere in 32 bits; but lim_frame() refuses eyes that are out of range. The target is in the middle
 * of the picture, within 4 units of 2^-32 of a turn. Straight up or down yaw stays what it was; and if the target is
 * the eye, pitch, too. eye_q8 may be camera->eye_q8. */
void lim_look_at(struct lim_camera *camera, const int32_t eye_q8[3], const int32_t target_q8[3]);

/* Sets yaw and pitch, and puts the camera so that it looks at the target from a distance of radius_q8 units with 8
 * fraction bits; roll and lens stay as they are. A camera that looks down on its target has a negative pitch. The eye
 * is within a unit of the last place of where it should be, and 2^-28 of the radius. A negative radius puts the target
 * behind the camera. Eyes that leave 32 bits stay at their ends, and lim_frame() refuses them. */
void lim_orbit(struct lim_camera *camera, const int32_t target_q8[3], int32_t radius_q8, uint32_t yaw, uint32_t pitch);

/* Sets both tangents for square pixels from the vertical angle of view (a full turn is 2^32; it
 * must stay under half a turn). Returns LIM_ERR_CAMERA when one leaves LIM_TAN_MIN_Q28..LIM_TAN_MAX_Q28. */
LIM_MUST_CHECK int lim_camera_set_fov(struct lim_camera *camera, uint32_t fov_y, uint16_t w_px, uint16_t h_px);

LIM_C_END

#endif
