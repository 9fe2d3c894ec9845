/* SPDX-License-Identifier: MIT
 *
 * Range: a vertex is at most 131,000 * 2^reach units from the eye (lim_view_begin chooses reach so), and
 * a row of the matrix has length <= 1, so |x_qv| < 131,000 * 2^14 plus 98,304 for the rounding of
 * three entries plus 1 for the shift: below 2^31. The sum wraps on the way; its value does not.
 * A larger reach costs no accuracy: the matrix loses the bits that the distance gives back. */
#include "view.h"

#include "angle.h"
#include "eye.h"
#include "fixed.h"

#define REACH_UNITS UINT64_C(131000)

/* Fraction bits of x / z: 16, or 14 where the screen is too wide for 16 + 15 bits. */
static inline uint8_t ratio_bits(const struct lim_view *view)
{
    return LIM_WIDE && (view->w_px > LIM_NARROW_SIDE_PX || view->h_px > LIM_NARROW_SIDE_PX) ? 14 : 16;
}

/* The middle of n pixels, given that pixel centres are whole: (n/2 - 1/2), and half a unit so that
 * the final shift rounds. */
static int32_t centre_qr(int32_t half_sub, uint8_t bits)
{
    return (half_sub - LIM_SUB / 2) * ((int32_t)1 << bits) + ((int32_t)1 << (bits - 1));
}

void lim_view_init(struct lim_view *view, uint16_t w_px, uint16_t h_px, struct lim_view_cached *cache)
{
    view->w_px = w_px;
    view->h_px = h_px;
    view->half_w_sub = (int32_t)w_px * (LIM_SUB / 2);
    view->half_h_sub = (int32_t)h_px * (LIM_SUB / 2);
    view->centre_x_qr = centre_qr(view->half_w_sub, ratio_bits(view));
    view->centre_y_qr = centre_qr(view->half_h_sub, ratio_bits(view));
    view->cache = cache;
}

/* Rows right, up and ahead of the camera in the scene's axes. */
static void orientation_q30(const struct lim_camera *camera, int32_t right[3], int32_t up[3], int32_t ahead[3])
{
    const int32_t sin_yaw = lim_sin_q30(camera->yaw), cos_yaw = lim_cos_q30(camera->yaw);
    const int32_t sin_pitch = lim_sin_q30(camera->pitch), cos_pitch = lim_cos_q30(camera->pitch);
    const int32_t sin_roll = lim_sin_q30(camera->roll), cos_roll = lim_cos_q30(camera->roll);
    const int32_t level_right[3] = {cos_yaw, 0, -sin_yaw};
    const int32_t level_up[3] = {mul_q30(sin_yaw, sin_pitch), cos_pitch, mul_q30(cos_yaw, sin_pitch)};

    ahead[0] = -mul_q30(sin_yaw, cos_pitch);
    ahead[1] = sin_pitch;
    ahead[2] = -mul_q30(cos_yaw, cos_pitch);
    for (uint8_t i = 0; i < 3; i++) {
        right[i] = mul_q30(level_right[i], cos_roll) - mul_q30(level_up[i], sin_roll);
        up[i] = mul_q30(level_up[i], cos_roll) + mul_q30(level_right[i], sin_roll);
    }
}

/* The least reach at which the farthest corner of the 16-bit cube is within 131,000 * 2^reach. */
static uint8_t reach_for(const int32_t eye_q8[3])
{
    uint64_t square = 0;
    uint8_t reach = 0;

    for (uint8_t i = 0; i < 3; i++) {
        const uint64_t far = (abs_s32(eye_q8[i]) + 255) / 256 + 32768;
        square += far * far;
    }
    while (square >= (REACH_UNITS * REACH_UNITS) << (2 * reach))
        reach++;
    return reach;
}

/* The point of the 16-bit cube that is nearest to the eye. */
static void anchor_of(const int32_t eye_q8[3], int32_t anchor_q8[3])
{
    const int32_t limit_q8 = INT32_C(32768) * 256;

    for (uint8_t i = 0; i < 3; i++) {
        anchor_q8[i] = eye_q8[i] < -limit_q8 ? -limit_q8 : eye_q8[i] > limit_q8 ? limit_q8 : eye_q8[i];
    }
}

/* One row: unit vector times lens scale, and where it puts the origin. The 16-bit entries m are a
 * little off from the true row M. M (v - eye) is taken as m (v - anchor) + M (anchor - eye): the error
 * is (m - M) (v - anchor), which vanishes towards the vertices nearest to the eye. */
static void set_row(struct lim_view *view, uint8_t row, const int32_t axis_q30[3], int32_t scale_q30,
                    const int32_t eye_q8[3], const int32_t anchor_q8[3])
{
    const uint8_t dropped = (uint8_t)(30 - LIM_MATRIX_BITS + view->reach);
    int64_t inside_qv8 = 0, inside_qv23 = 0, outside_q38 = 0;

    for (uint8_t i = 0; i < 3; i++) {
        const int32_t entry_q30 = mul_q30(axis_q30[i], scale_q30);
        const int16_t entry_qv = (int16_t)shift_round_s32(entry_q30, dropped);
        view->matrix_qv[row][i] = entry_qv;
        inside_qv8 -= (int64_t)entry_qv * anchor_q8[i];
        if (LIM_SPLIT_ROWS) {
            const int32_t rest_q30 = entry_q30 - entry_qv * ((int32_t)1 << dropped);
            const int16_t low = (int16_t)shift_round_s32(rest_q30, (uint8_t)(dropped - 15));
            view->low_qv15[row][i] = low;
            inside_qv23 -= (int64_t)low * anchor_q8[i];
        }
        outside_q38 += (int64_t)entry_q30 * (anchor_q8[i] - eye_q8[i]);
    }
    view->shift_qv[row] = (int32_t)shift_round_s64(
        inside_qv8 + shift_round_s64(inside_qv23, 15) + shift_round_s64(outside_q38, dropped), 8);
}

static bool in_range(const struct lim_camera *camera)
{
    for (uint8_t i = 0; i < 3; i++) {
        if (camera->eye_q8[i] <= -LIM_EYE_MAX_Q8 || camera->eye_q8[i] >= LIM_EYE_MAX_Q8) return false;
    }
    return camera->tan_x_q28 >= LIM_TAN_MIN_Q28 && camera->tan_x_q28 <= LIM_TAN_MAX_Q28 &&
           camera->tan_y_q28 >= LIM_TAN_MIN_Q28 && camera->tan_y_q28 <= LIM_TAN_MAX_Q28 && camera->near_q8 >= 1 &&
           camera->near_q8 <= LIM_NEAR_MAX_Q8;
}

static int32_t lens_scale_q30(uint32_t zoom_q28, uint32_t tan_q28)
{
    return (int32_t)(((uint64_t)zoom_q28 << 30) / tan_q28);
}

/* The near plane in view space, where z must have 15 bits at least to divide by: camera.h says what
 * that is in units. */
static int32_t near_qv(const struct lim_camera *camera, int32_t ahead_scale_q30, uint8_t reach)
{
    const int64_t near =
        shift_round_s64((int64_t)camera->near_q8 * ahead_scale_q30, (uint8_t)(38 - LIM_MATRIX_BITS + reach));

    return near < INT32_C(1) << 15 ? INT32_C(1) << 15 : near > INT32_C(1) << 30 ? INT32_C(1) << 30 : (int32_t)near;
}

bool lim_view_begin(struct lim_view *view, const struct lim_camera *camera)
{
    int32_t right[3], up[3], ahead[3], anchor_q8[3];
    uint32_t zoom_q28 = UINT32_C(1) << 28; /* min(tan_x, tan_y, 1): the longest row has length 1 */

    if (!in_range(camera)) return false;
    if (camera->tan_x_q28 < zoom_q28) zoom_q28 = camera->tan_x_q28;
    if (camera->tan_y_q28 < zoom_q28) zoom_q28 = camera->tan_y_q28;
    orientation_q30(camera, right, up, ahead);
    for (uint8_t i = 0; i < 3; i++)
        up[i] = -up[i]; /* the screen's y runs down */
    view->reach = reach_for(camera->eye_q8);
    anchor_of(camera->eye_q8, anchor_q8);
    set_row(view, 0, right, lens_scale_q30(zoom_q28, camera->tan_x_q28), camera->eye_q8, anchor_q8);
    set_row(view, 1, up, lens_scale_q30(zoom_q28, camera->tan_y_q28), camera->eye_q8, anchor_q8);
    set_row(view, 2, ahead, (int32_t)(zoom_q28 << 2), camera->eye_q8, anchor_q8);
    view->near_qv = near_qv(camera, (int32_t)(zoom_q28 << 2), view->reach);
    for (uint8_t i = 0; i < LIM_VIEW_CACHE_ENTRIES; i++)
        view->cache[i].vertex = LIM_NONE;
    view->vertices = 0;
    return true;
}

static inline uint32_t dot(const int16_t m[3], const LIM_FLASH struct lim_vertex *vertex)
{
    return (uint32_t)((int32_t)m[0] * vertex->x) + (uint32_t)((int32_t)m[1] * vertex->y) +
           (uint32_t)((int32_t)m[2] * vertex->z);
}

static inline int32_t row_qv(const struct lim_view *view, uint8_t row, const LIM_FLASH struct lim_vertex *vertex)
{
    uint32_t sum_qv = dot(view->matrix_qv[row], vertex) + (uint32_t)view->shift_qv[row];

    if (LIM_SPLIT_ROWS) sum_qv += (uint32_t)shift_round_s32((int32_t)dot(view->low_qv15[row], vertex), 15);
    return (int32_t)sum_qv;
}

void lim_view_transform(const struct lim_view *view, const LIM_FLASH struct lim_vertex *vertex,
                        struct lim_view_point *out)
{
    out->x_qv = row_qv(view, 0, vertex);
    out->y_qv = row_qv(view, 1, vertex);
    out->z_qv = row_qv(view, 2, vertex);
}

#if LIM_SPLIT_ROWS

/* x / z in 28 bits: x at a quarter of z's normalised scale times the reciprocal. */
static inline int32_t ratio_q28(int32_t x_qv, uint8_t zeros, int32_t recip_q31)
{
    const int32_t x_scaled = zeros >= 2 ? x_qv * ((int32_t)1 << (zeros - 2)) : x_qv >> (2 - zeros);

    return mul_high_s32(x_scaled, recip_q31);
}

static inline lim_sub to_screen(int32_t ratio_q28, int32_t half_sub)
{
    const int32_t twice_sub = mul_high_s32(ratio_q28, half_sub * 32);

    return (lim_sub)(((twice_sub + 1) >> 1) + half_sub - LIM_SUB / 2);
}

struct lim_point lim_view_project(const struct lim_view *view, const struct lim_view_point *point)
{
    uint8_t zeros;
    const int32_t recip_q31 = (int32_t)recip_q31_of((uint32_t)point->z_qv, &zeros);

    return (struct lim_point){to_screen(ratio_q28(point->x_qv, zeros, recip_q31), view->half_w_sub),
                              to_screen(ratio_q28(point->y_qv, zeros, recip_q31), view->half_h_sub)};
}

#else

/* z becomes 15 bits, 2^14 .. 2^15 - 1, and x with it at most 2^16; times the reciprocal's 15 bits
 * that is x / z in Q29, at most 2^30. */
static inline int32_t ratio_qr(int32_t x_qv, uint8_t shift, uint32_t recip_q15, uint8_t bits)
{
    return shift_round_s32(shift_round_s32(x_qv, shift) * (int32_t)recip_q15, (uint8_t)(29 - bits));
}

struct lim_point lim_view_project(const struct lim_view *view, const struct lim_view_point *point)
{
    const uint8_t bits = ratio_bits(view);
    uint8_t zeros;
    const uint32_t recip_q15 = recip_q16((uint32_t)point->z_qv, &zeros) >> 1;
    const uint8_t shift = (uint8_t)(17 - zeros);
    const int32_t x_qr = ratio_qr(point->x_qv, shift, recip_q15, bits);
    const int32_t y_qr = ratio_qr(point->y_qv, shift, recip_q15, bits);

    return (struct lim_point){(lim_sub)((x_qr * view->half_w_sub + view->centre_x_qr) >> bits),
                              (lim_sub)((y_qr * view->half_h_sub + view->centre_y_qr) >> bits)};
}

#endif

/* A point behind the eye can be outside on both sides; one bit of the two is enough, because the
 * codes are only used to find a side that every vertex is outside of. */
static uint8_t codes_of(const struct lim_view *view, const struct lim_view_point *point)
{
    const int32_t z_qv = point->z_qv;
    const int32_t x_qv = (int32_t)abs_s32(point->x_qv), y_qv = (int32_t)abs_s32(point->y_qv);
    uint8_t codes = 0;

    if (z_qv < view->near_qv) codes = LIM_VIEW_NEAR | LIM_VIEW_GUARD;
    if (x_qv > z_qv) codes = (uint8_t)(codes | (point->x_qv < 0 ? LIM_VIEW_LEFT : LIM_VIEW_RIGHT));
    if (y_qv > z_qv) codes = (uint8_t)(codes | (point->y_qv < 0 ? LIM_VIEW_TOP : LIM_VIEW_BOTTOM));
    if (x_qv >> 1 > z_qv - 2 || y_qv >> 1 > z_qv - 2) codes |= LIM_VIEW_GUARD;
    return codes;
}

static void fill_cache(struct lim_view *view, const struct lim_scene *scene, uint16_t vertex,
                       struct lim_view_cached *entry)
{
    struct lim_view_point point;

    lim_view_transform(view, &scene->vertices[vertex], &point);
    entry->vertex = vertex;
    entry->codes = codes_of(view, &point);
    if (!(entry->codes & LIM_VIEW_GUARD)) entry->at = lim_view_project(view, &point);
    if (LIM_HAS_STATS) view->vertices++;
}

uint16_t lim_view_polygon(struct lim_view *view, const struct lim_scene *scene, const LIM_FLASH uint16_t *corners,
                          uint8_t n, struct lim_point *out)
{
    uint8_t any = 0, all = 0xFF;

    for (uint8_t k = 0; k < n; k++) {
        const uint16_t vertex = corners[k];
        struct lim_view_cached *entry = &view->cache[vertex % LIM_VIEW_CACHE_ENTRIES];

        if (entry->vertex != vertex) fill_cache(view, scene, vertex, entry);
        any |= entry->codes;
        all &= entry->codes;
        out[k] = entry->at;
    }
    return (uint16_t)(any | (uint16_t)(all << 8));
}
