/* SPDX-License-Identifier: MIT
 *
 * The camera: where the eye is, where it looks, and how wide. */
#ifndef LIM_CAMERA_H
#define LIM_CAMERA_H

#include "config.h"

LIM_C_BEGIN

#define LIM_TAN_MIN_Q28 (UINT32_C(1) << 22) /* 1/64 */
#define LIM_TAN_MAX_Q28 (UINT32_C(1) << 30) /* 4: half an angle of 152 degrees */
#define LIM_NEAR_MAX_Q8 (INT32_C(1) << 24)

/* A constant number of units, with 8 fraction bits, rounded to nearest. */
#define LIM_UNITS_Q8(units) ((int32_t)((units) < 0 ? (units)*256.0 - 0.5 : (units)*256.0 + 0.5))

/* A full turn is 2^32. Yaw 0 looks along -z, a quarter turn along -x: counter-clockwise from above;
 * pitch raises the view; roll turns the picture counter-clockwise. Nothing is accumulated: a stored
 * angle cannot drift. */
struct lim_camera {
    int32_t eye_q8[3]; /* units with 8 fraction bits, |eye_q8| < 2^28 */
    uint32_t yaw, pitch, roll;
    uint32_t tan_x_q28, tan_y_q28; /* tangents of the half-angles of view, 1/64..4 */
    /* Distance of the near plane, units: 1..2^24 (1/256 to 65536). The one in use is never nearer than
     * 2^-16 / min(1, tan_x, tan_y) of the distance of the scene's far end, nor than 1 unit: less than 2 units
     * for an eye within the grid and a lens of 90 degrees. Nearer by, z has too few bits to divide by. */
    int32_t near_q8;
};

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
 * must stay under half a turn). Returns LIM_ERR_CAMERA when one leaves 1/64..4. */
LIM_MUST_CHECK int lim_camera_set_fov(struct lim_camera *camera, uint32_t fov_y, uint16_t w_px, uint16_t h_px);

LIM_C_END

#endif
