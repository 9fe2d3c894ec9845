/* SPDX-License-Identifier: MIT
 *
 * Which scale? View space holds 2^31, so the farther the scene's far end, the shorter the rows: scale times
 * distance stays below that. x / z does not mind the scale, but the rounding of the entries does, in a
 * way that is as good as random; so the best of some scales next to the largest is taken. */
#include "view/rows.h"

#include "eye.h"
#include "math/orientation.h"
#include "view/perspective.h"

/* With limbs a bit is left unused, so that the projection need not look for it. */
#define VIEW_LIMIT_QV ((UINT32_C(1) << (LIM_HAS_LIMBS ? 30 : 31)) - (UINT32_C(1) << 18))
_Static_assert(VIEW_LIMIT_QV + 98304 + (LIM_HAS_LIMBS ? 49152 : 0) <= PERSPECTIVE_MAX_QV, "rounding (transform.h)");

enum { SCALE_MAX = 32767, SCALES = LIM_HAS_LIMBS ? 1 : 32 };

/* Of a long lens, what is added to a distance times scale: where the rows count from the eye, rounding one moves a
 * point by sqrt(3/4) of its distance at most, turn_q32 by as much, and stretch_rows() by twice as much. That makes rows
 * longer, by less than 1/512. */
enum { TURNED_AWAY = 4, STRETCHED_MAX = SCALE_MAX - SCALE_MAX / 512 };

/* The matrix before rounding, and where the eye is beside the box that holds the scene. */
struct lens {
    int32_t entries_q30[9]; /* rows of length <= 1 */
    int32_t anchor_q8[3];   /* the point of the box that is nearest to the eye */
    const int32_t *eye_q8;
    LIM_OPTIONAL(bool, is_tele, LIM_HAS_TELE);
    LIM_OPTIONAL(uint32_t, scales, LIM_HAS_TELE * 3); /* of each row */
};

static bool rows_in_range(const struct lim_camera *camera)
{
    uint32_t away_q8 = 0; /* as many bits as the longest has */

    for (uint_fast8_t i = 0; i < 3; i++)
        away_q8 |= abs_s32(camera->eye_q8[i]);
    return away_q8 < LIM_EYE_MAX_Q8 && camera->tan_x_q28 >= LIM_TAN_MIN_Q28 && camera->tan_x_q28 <= LIM_TAN_MAX_Q28 &&
           camera->tan_y_q28 >= LIM_TAN_MIN_Q28 && camera->tan_y_q28 <= LIM_TAN_MAX_Q28 && camera->near_q8 >= 1 &&
           camera->near_q8 <= LIM_NEAR_MAX_Q8;
}

/* Whether the lens is long, and by how many bits each side of its picture is smaller than what 45 degrees show. */
static void set_zoom(struct lim_rows *rows, struct lens *lens, const struct lim_camera *camera)
{
    const uint32_t tans_q28[2] = {camera->tan_x_q28, camera->tan_y_q28};

    *lens->is_tele = tans_q28[0] < LIM_TAN_TELE_Q28 || tans_q28[1] < LIM_TAN_TELE_Q28;
    for (uint_fast8_t i = 0; i < 2; i++)
        rows->zoom_bits[i] =
            *lens->is_tele && tans_q28[i] < UINT32_C(1) << 28 ? (uint8_t)(clz_u32(tans_q28[i] - 1) - 4) : 0;
}

/* A long lens's tangents without these bits: more than 1/2. */
static inline uint32_t tan_x_q28_of(const struct lim_rows *rows, const struct lim_camera *camera)
{
    return LIM_HAS_TELE ? camera->tan_x_q28 << rows->zoom_bits[0] : camera->tan_x_q28;
}

static inline uint32_t tan_y_q28_of(const struct lim_rows *rows, const struct lim_camera *camera)
{
    return LIM_HAS_TELE ? camera->tan_y_q28 << rows->zoom_bits[1] : camera->tan_y_q28;
}

/* min(tan_x, tan_y, 1): the longest row has length 1, and the one of z this length. */
static uint32_t zoom_q28_of(const struct lim_rows *rows, const struct lim_camera *camera)
{
    uint32_t zoom_q28 = UINT32_C(1) << 28;

    if (tan_x_q28_of(rows, camera) < zoom_q28) zoom_q28 = tan_x_q28_of(rows, camera);
    if (tan_y_q28_of(rows, camera) < zoom_q28) zoom_q28 = tan_y_q28_of(rows, camera);
    return zoom_q28;
}

/* floor(a 2^30 / b) for a <= b < 2^31, bit by bit: a 64-bit division would be 700 bytes of library. One of the two that
 * a frame takes is mostly 1. */
static LIM_RARE uint32_t quotient_q30(uint32_t a, uint32_t b)
{
    uint32_t ratio_q30 = 0;

    if (a == b) return UINT32_C(1) << 30;
    for (uint_fast8_t i = 0; i < 31; i++, a <<= 1) {
        ratio_q30 <<= 1;
        if (a < b) continue;
        a -= b;
        ratio_q30++;
    }
    return ratio_q30;
}

static void scale_row(int32_t row_q30[3], uint32_t scale_q30)
{
    for (uint_fast8_t i = 0; i < 3; i++)
        row_q30[i] = lim_mul_q30(row_q30[i], (int32_t)scale_q30);
}

/* From the camera's own axes, or others. */
static void set_entries(int32_t entries_q30[9], const struct lim_rows *rows, const struct lim_camera *camera,
                        const int32_t *axes_q30, uint32_t zoom_q28, uint8_t tele_bits)
{
    if ((LIM_HAS_MOVERS || LIM_HAS_TEXTURE) && axes_q30) {
        for (uint_fast8_t i = 0; i < 9; i++)
            entries_q30[i] = axes_q30[i];
    } else {
        lim_orientation_set(entries_q30, camera);
    }
    scale_row(entries_q30, quotient_q30(zoom_q28, tan_x_q28_of(rows, camera)));
    scale_row(entries_q30 + 3, quotient_q30(zoom_q28, tan_y_q28_of(rows, camera)));
    scale_row(entries_q30 + 6, zoom_q28 << 2 << tele_bits);
}

/* The root's; a scene too small to have one gets the whole grid. */
static const LIM_FLASH struct lim_box *box_of(const struct lim_scene *scene)
{
    static const LIM_FLASH struct lim_box grid = {{0, 0, 0}, {32768, 32768, 32768}};
    const bool anywhere = LIM_HAS_MOVERS && !scene;
    const lim_index root = !anywhere && scene->node_count ? scene->nodes[0].box : LIM_NO_INDEX;

    return root == LIM_NO_INDEX ? &grid : &scene->boxes[root];
}

/* Sets the anchor. Returns what is not below the distance of the box's farthest corner. For a >= b >= c >= 0 the length
 * of (a, b, c) is at most a + (sqrt(2) - 1) b + (sqrt(3) - sqrt(2)) c: lengths are convex, and the two agree along the
 * edges (1, 0, 0), (1, 1, 0) and (1, 1, 1) of that wedge. 107/256 and 82/256 are a little more. */
static uint32_t set_anchor(struct lens *lens, const LIM_FLASH struct lim_box *box)
{
    uint32_t longest = 0, shortest = UINT32_MAX, sum = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t low_q8 = (box->centre[i] - (int32_t)box->half[i]) * 256;
        const int32_t high_q8 = (box->centre[i] + (int32_t)box->half[i]) * 256;
        const int32_t eye_q8 = lens->eye_q8[i], below_q8 = eye_q8 - low_q8, above_q8 = high_q8 - eye_q8;
        const uint32_t side = (uint32_t)((below_q8 > above_q8 ? below_q8 : above_q8) >> 8) + 1;
        int32_t anchor_q8 = eye_q8;
        if (anchor_q8 < low_q8) anchor_q8 = low_q8;
        if (anchor_q8 > high_q8) anchor_q8 = high_q8;
        if (LIM_HAS_TELE && *lens->is_tele) anchor_q8 = eye_q8;
        lens->anchor_q8[i] = anchor_q8;
        sum += side;
        if (side > longest) longest = side;
        if (side < shortest) shortest = side;
    }
    return longest + ((sum - longest - shortest) * 107 + shortest * 82) / 256 + 1;
}

/* How far rounding moves the entries at this scale: the sum of squares, in units of 2^-26. An entry counts
 * as much as it moves a vertex on the screen; the row of z was made 2^tele_bits times as long. What is not below
 * `enough` may be less than it is. */
static uint32_t rounding_at(const struct lens *lens, uint32_t scale, uint8_t tele_bits, uint32_t enough_q26)
{
    const uint32_t scale_times_4 = scale * 4;
    uint32_t sum_q26 = 0;

    LIM_UNROLLED(9)
    for (uint_fast8_t i = 0; i < 9; i++) {
        if (LIM_HAS_MOVERS && !LIM_OPTIMISE_SIZE && (i == 3 || i == 5 || i == 7) && sum_q26 >= enough_q26)
            break;                                                                /* an object each asks */
        const uint32_t rest_q32 = (uint32_t)lens->entries_q30[i] * scale_times_4; /* entry * scale, modulo 1 */
        const int32_t rest_q13 = (int32_t)rest_q32 >> (i < 6 ? 19 : 19 + tele_bits);
        sum_q26 += (uint32_t)(rest_q13 * rest_q13);
    }
    return sum_q26;
}

/* The same, from scale to scale: each takes an entry less from its rest. */
static uint32_t rounding_next(uint32_t rests_q32[9], const struct lens *lens, uint8_t tele_bits)
{
    uint32_t sum_q26 = 0;

    for (uint_fast8_t i = 0; i < 9; i++) {
        const int16_t rest_q13 = (int16_t)((int32_t)rests_q32[i] >> (i < 6 ? 0 : tele_bits) >> 16) >> 3;
        sum_q26 += (uint32_t)((int32_t)rest_q13 * rest_q13);
        rests_q32[i] -= (uint32_t)lens->entries_q30[i] * 4;
    }
    return sum_q26;
}

static uint32_t choose_scale(const struct lens *lens, uint32_t far_units, uint8_t tele_bits)
{
    const uint32_t held = VIEW_LIMIT_QV / far_units - (LIM_TURNS_ROWS && *lens->is_tele ? TURNED_AWAY : 0);
    const uint32_t fits = held < SCALE_MAX ? held : SCALE_MAX;
    const uint32_t most = LIM_TURNS_ROWS && *lens->is_tele && fits > STRETCHED_MAX ? STRETCHED_MAX : fits;
    uint32_t best = most, least_rounding = UINT32_MAX, rests_q32[9];

    if (SCALES == 1) return most;
    for (uint_fast8_t i = 0; LIM_8_BIT && i < 9; i++)
        rests_q32[i] = (uint32_t)lens->entries_q30[i] * most * 4;
    for (uint_fast8_t k = 0; k < SCALES; k++) {
        const uint32_t rounding = LIM_8_BIT ? rounding_next(rests_q32, lens, tele_bits)
                                            : rounding_at(lens, most - k, tele_bits, least_rounding);
        if (rounding >= least_rounding) continue;
        least_rounding = rounding;
        best = most - k;
    }
    return best;
}

/* From far away the scene is small beside its distance, along x (axis 0) or y (1). How many bits longer than z's that
 * row may be, so that no vertex leaves view space, with what rounding and turning move it by. */
static uint8_t spare_bits_of(const struct lim_rows *rows, const struct lens *lens, uint_fast8_t axis,
                             const LIM_FLASH struct lim_box *box, uint32_t scale)
{
    const int32_t *const entries_q30 = lens->entries_q30 + 3 * axis;
    int64_t middle_q38 = 0, half_q30 = 0;
    uint8_t bits = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
        middle_q38 += (int64_t)entries_q30[i] * (box->centre[i] * INT32_C(256) - lens->eye_q8[i]);
        half_q30 += (int64_t)abs_s32(entries_q30[i]) * box->half[i];
    }
    if (middle_q38 < 0) middle_q38 = -middle_q38;
    const uint32_t reach_units = (uint32_t)(middle_q38 >> 38) + (uint32_t)(half_q30 >> 30) + 4;
    const uint32_t held = (VIEW_LIMIT_QV - TURNED_AWAY * rows->far_units) / (reach_units + reach_units / 512 + 1);
    const uint32_t most = held < STRETCHED_MAX ? held : STRETCHED_MAX;
    while (bits < rows->zoom_bits[axis] && scale << (bits + 1) <= most)
        bits++;
    return bits;
}

/* `box`: NULL, of a long scene: a row is as long as it may be. */
static LIM_RARE void set_scales(struct lim_rows *rows, struct lens *lens, const LIM_FLASH struct lim_box *box,
                                uint32_t scale)
{
    for (uint_fast8_t i = 0; i < 3; i++) {
        const uint8_t bits = i < 2 && *lens->is_tele && box ? spare_bits_of(rows, lens, i, box, scale) : 0;
        lens->scales[i] = scale << bits;
        if (i < 2) rows->zoom_bits[i] = (uint8_t)(rows->zoom_bits[i] - bits);
    }
}

/* The entries n are a little off from the true row N. N (v - eye) is taken as n (v - anchor) + N (anchor -
 * eye): the error is (n - N) (v - anchor), which vanishes towards the vertices nearest to the eye. */
static void set_row(struct lim_row *row, const struct lens *lens, const int32_t entries_q30[3], int32_t scale)
{
    int64_t inside_qv8 = 0, inside_qv23 = 0, outside_q38 = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t anchor_q8 = lens->anchor_q8[i];
        const int64_t entry_qv30 = (int64_t)entries_q30[i] * scale;
        row->n_qv[i] = (int16_t)shift_round_s64(entry_qv30, 30);
        inside_qv8 += (int64_t)row->n_qv[i] * -anchor_q8;
#if LIM_HAS_LIMBS
        row->low_qv15[i] = (int16_t)shift_round_s64(entry_qv30 - row->n_qv[i] * (INT64_C(1) << 30), 15);
        inside_qv23 += (int64_t)row->low_qv15[i] * -anchor_q8;
#endif
#if LIM_HAS_LIMBS && LIM_LONG_MULTIPLY
        row->n_qv16[i] = ((int32_t)row->n_qv[i] * (INT32_C(1) << 15) + (int32_t)row->low_qv15[i]) * 2;
#endif
        outside_q38 += (int64_t)entries_q30[i] * (anchor_q8 - lens->eye_q8[i]);
    }
    const int64_t outside_qv23 = shift_round_s64(outside_q38, 15) * scale;
    row->shift_qv = (int32_t)shift_round_s64(inside_qv8 + shift_round_s64(inside_qv23 + outside_qv23, 15), 8);
}

/* A row's rounding turns it by an angle, which moves a point that lies ahead by a constant part of its z. All that a
 * long lens shows lies ahead but for that lens's angle, whose part is nothing to be seen. The rounding is taken along
 * the row of z's entries, so it comes out as much shorter as that row is: `length_q16` is that row's times this once
 * more. */
static LIM_RARE int32_t turn_q32_of(const struct lens *lens, const struct lim_row *row, const int32_t entries_q30[3],
                                    int32_t scale, uint32_t length_q16)
{
    int64_t turn_qv60 = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
        const int64_t rounded_qv30 = (int64_t)entries_q30[i] * scale - row->n_qv[i] * (INT64_C(1) << 30);
        turn_qv60 += rounded_qv30 * lens->entries_q30[6 + i];
    }
    const int32_t turn_qv16 = (int32_t)shift_round_s64(turn_qv60, 44);
    const int32_t size_q32 = (int32_t)(quotient_q30(abs_s32(turn_qv16), length_q16) << 2);
    return turn_qv16 < 0 ? -size_q32 : size_q32;
}

/* Of a row of z's that is `scale` times what it is for a lens of this zoom. */
static uint32_t length_q16_of(uint32_t zoom_q28, uint32_t scale)
{
    const int32_t zoom_q30 = (int32_t)(zoom_q28 << 2);

    return (uint32_t)lim_mul_q30(zoom_q30, lim_mul_q30(zoom_q30, (int32_t)(scale << 16)));
}

/* Rounding the row of z makes z too long or too short by a constant part of it. So x and y are made as much longer. */
static LIM_RARE void stretch_rows(struct lim_rows *rows, struct lens *lens, uint32_t zoom_q28, uint32_t scale)
{
    set_row(&rows->row[2], lens, lens->entries_q30 + 6, (int32_t)scale);
    const int32_t missing_q32 =
        turn_q32_of(lens, &rows->row[2], lens->entries_q30 + 6, (int32_t)scale, length_q16_of(zoom_q28, scale));
    for (uint_fast8_t i = 0; i < 6; i++)
        lens->entries_q30[i] -= mul_high_s32(lens->entries_q30[i], missing_q32);
}

static void set_turns(struct lim_rows *rows, const struct lens *lens, uint32_t zoom_q28, uint32_t scale)
{
    const uint32_t length_q16 = length_q16_of(zoom_q28, scale);

    for (uint_fast8_t i = 0; i < 2; i++)
        rows->turn_q32[i] = *lens->is_tele ? turn_q32_of(lens, &rows->row[i], lens->entries_q30 + 3 * i,
                                                         (int32_t)lens->scales[i], length_q16)
                                           : 0;
}

/* z must have some bits to divide by: camera.h says what that is in units. near <= 2^16 units, zoom <= 1 and scale
 * < 2^15 have a product below 2^31. */
static int32_t near_qv_of(const struct lim_camera *camera, uint32_t zoom_q28, uint32_t scale)
{
    const int32_t scale_q15 = lim_mul_q30((int32_t)(zoom_q28 << 2), (int32_t)(scale << 15));
    const int32_t near_qv = lim_mul_q30(scale_q15 << 1, camera->near_q8 << 6);

    if (near_qv < PERSPECTIVE_Z_MIN_QV) return PERSPECTIVE_Z_MIN_QV;
    return near_qv > INT32_C(1) << 29 ? INT32_C(1) << 29 : near_qv;
}

/* Points of a long scene come as seen from the eye, as numbers of 2^15 or less: no farther than this. */
#define LONG_FAR_UNITS UINT32_C(56757)

/* As seen from the eye. Returns how far anything may be. */
static LIM_IF_CALLED uint32_t set_long_anchor(struct lens *lens)
{
    static const int32_t here_q8[3] = {0, 0, 0};

    lens->eye_q8 = here_q8;
    for (uint_fast8_t i = 0; i < 3; i++)
        lens->anchor_q8[i] = 0;
    return LONG_FAR_UNITS;
}

static inline bool set_rows(struct lim_rows *rows, const struct lim_scene *scene, const struct lim_camera *camera,
                            const int32_t *axes_q30)
{
    const bool is_far = LIM_HAS_LONG && scene && lim_scene_long(scene); /* of many scales */
    struct lens lens;

    if (!rows_in_range(camera)) return false;
    if (LIM_HAS_LONG) rows->eye->all = NULL;
    lens.eye_q8 = camera->eye_q8;
    if (LIM_HAS_TELE) set_zoom(rows, &lens, camera);
    const uint32_t zoom_q28 = zoom_q28_of(rows, camera);
    rows->tele_bits = LIM_HAS_LIMBS ? 0 : (uint8_t)(clz_u32(zoom_q28 - 1) - 4); /* limbs have the bits anyway */
    set_entries(lens.entries_q30, rows, camera, axes_q30, zoom_q28, rows->tele_bits);
    if (is_far)
        rows->far_units = set_long_anchor(&lens);
    else
        rows->far_units = set_anchor(&lens, box_of(scene));
    const uint32_t scale = choose_scale(&lens, rows->far_units, rows->tele_bits);
    if (LIM_HAS_TELE) set_scales(rows, &lens, is_far ? NULL : box_of(scene), scale);
    if (LIM_TURNS_ROWS && *lens.is_tele) stretch_rows(rows, &lens, zoom_q28, scale);
    for (uint_fast8_t i = 0; i < 3; i++)
        set_row(&rows->row[i], &lens, lens.entries_q30 + 3 * i, (int32_t)(LIM_HAS_TELE ? lens.scales[i] : scale));
    rows->row[2].shift_qv += (1 << rows->tele_bits) >> 1; /* rounds what lim_view_transform() shifts */
    rows->near_qv = near_qv_of(camera, zoom_q28, scale);
    if (LIM_TURNS_ROWS) set_turns(rows, &lens, zoom_q28, scale);
    return true;
}

bool lim_rows_set(struct lim_rows *rows, const struct lim_scene *scene, const struct lim_camera *camera)
{
    return set_rows(rows, scene, camera, NULL);
}

#if LIM_HAS_MOVERS || LIM_HAS_TEXTURE
bool lim_rows_set_turned(struct lim_rows *rows, const struct lim_scene *scene, const struct lim_camera *camera,
                         const int32_t axes_q30[9])
{
    return set_rows(rows, scene, camera, axes_q30);
}
#endif
