/* SPDX-License-Identifier: MIT
 *
 * A ray through a pixel is r = ahead + X right + Y down. It meets the plane n . p = d at z with 1 / z = A / E, where
 * A = -n . r, and E = n . eye - d is how far in front of the plane the eye is, both times the normal's length. */
#include "movers/near_plane.h"

#include "movers/mover.h"
#include "movers/mover_long.h"
#include "view/pass.h"

#if LIM_HAS_MOVERS

#define NORMAL_END (INT64_C(1) << 29)
enum { CORNER_BITS = LIM_HAS_FRACTIONS ? 8 : 0 };

/* What tells how many bits the longest of them has. */
static uint32_t all_bits_of(const int64_t n[3])
{
    return abs_s32((int32_t)n[0]) | abs_s32((int32_t)n[1]) | abs_s32((int32_t)n[2]);
}

/* Newell's normal: twice the areas that the polygon has along each axis. Differences have 25 bits, products 50. Of 28
 * or 29 bits in any case, as what is made of it is rounded. */
void lim_corners_plane(struct lim_plane_unpacked *plane, const struct lim_scene *scene,
                       const LIM_FLASH lim_index *record)
{
    const LIM_FLASH lim_index *const corners = record + LIM_POLYGON_HEAD_WORDS;
    const uint_fast8_t n = record[0] & LIM_POLYGON_COUNT;
    int32_t first[3], last[3], next[3];
    int64_t sum[4];

    sum[0] = sum[1] = sum[2] = sum[3] = 0;
    lim_corner_load(first, scene, corners[0]);
    lim_corner_load(last, scene, corners[1]);
    for (uint_fast8_t k = 2; k < n; k++) {
        lim_corner_load(next, scene, corners[k]);
        for (uint_fast8_t i = 0; i < 3; i++) {
            const uint_fast8_t a = lim_axis_after(i), b = lim_axis_after(a);
            sum[i] += (int64_t)(last[a] - first[a]) * (next[b] - first[b]) -
                      (int64_t)(last[b] - first[b]) * (next[a] - first[a]);
        }
        for (uint_fast8_t i = 0; i < 3; i++)
            last[i] = next[i];
    }
    shorten_s64(sum, NORMAL_END);
    const uint8_t up = (uint8_t)(clz_u32(all_bits_of(sum) | 1) - 3);
    plane->d = plane->slack = 0;
    for (uint_fast8_t i = 0; i < 3; i++) {
        plane->n[i] = (int32_t)sum[i] * (INT32_C(1) << up);
        plane->d += (int64_t)plane->n[i] * first[i];
        plane->slack += abs_s32(plane->n[i]);
    }
    plane->d >>= CORNER_BITS;
    plane->narrow = false;
    plane->axis = LIM_NO_AXIS;
    if (LIM_HAS_LONG) *plane->along = LIM_NO_AXIS;
}

void lim_still_plane(struct lim_plane_unpacked *plane, const struct lim_pass *pass, lim_index polygon, lim_index node)
{
    const LIM_FLASH lim_index *const record = &pass->scene->polygons[polygon];
    const bool has_own = LIM_HAS_LEAVES && record[0] & LIM_POLYGON_PLANE;

    if (LIM_HAS_FAR_MOVERS && lim_scene_long(pass->scene))
        lim_plane_unpack_far(plane, &pass->walk->eye,
                             has_own ? lim_record_plane(record) : &pass->scene->nodes[node].split);
    else
        lim_corners_plane(plane, pass->scene, record);
}

/* |a| < 2^62, as 32 bits of it: what they are times 2^*shift. */
static uint32_t leading_u32(uint64_t a, int *shift)
{
    const uint32_t above = (uint32_t)(a >> 32);
    const uint8_t down = above ? (uint8_t)(32 - clz_u32(above)) : 0;

    *shift += down;
    return (uint32_t)(a >> down);
}

/* a factor 2^shift, modulo what a word holds. */
static lim_near_word near_scaled(int64_t a, uint32_t factor, int shift)
{
    const uint64_t product = (uint64_t)leading_u32(a < 0 ? 0 - (uint64_t)a : (uint64_t)a, &shift) * factor;
    const uint64_t result = shift <= -64 || shift >= 64 ? 0 : shift >= 0 ? product << shift : product >> -shift;

    return (lim_near_word)(a < 0 ? 0 - result : result);
}

/* tan / (half of so many pixels), Q28. */
static int64_t pixel_q28(uint32_t tan_q28, uint16_t side_px)
{
    return 2 * tan_q28 / side_px;
}

/* n . axis, of 29 and 30 bits. */
static int64_t axis_along(const int32_t axis_q30[3], const int32_t n[3])
{
    int64_t sum = 0;

    for (uint_fast8_t i = 0; i < 3; i++)
        sum += (int64_t)axis_q30[i] * n[i];
    return sum >> 30;
}

/* Frames are drawn from a near plane of a unit or more (rows.c). */
static uint32_t near_q8_of(const struct lim_camera *camera)
{
    return camera->near_q8 > 256 ? (uint32_t)camera->near_q8 : 256;
}

/* A plane in units of 2^exponent of the scene's, from the eye on if the scene is long. */
static void set_over_screen(struct lim_near_plane *out, const struct lim_movers *movers, const struct lim_pass *pass,
                            const struct lim_plane_unpacked *plane, int8_t exponent)
{
    const struct lim_camera *camera = &movers->camera;
    const uint16_t w_px = pass->target.w_px, h_px = pass->target.h_px;
    const bool is_far = LIM_HAS_FAR_MOVERS && lim_movers_are_far(movers); /* the eye is at 0, in whole units */
    const int64_t away =
        is_far ? -plane->d : lim_plane_value(plane, camera->eye_q8[0], camera->eye_q8[1], camera->eye_q8[2], 256);
    const int64_t side = away < 0 ? 1 : -1; /* so that A is positive where the polygon is */
    const int64_t x_q8 = side * axis_along(movers->axes_q30, plane->n) * pixel_q28(camera->tan_x_q28, w_px) >> 20;
    const int64_t y_q8 = side * axis_along(movers->axes_q30 + 3, plane->n) * pixel_q28(camera->tan_y_q28, h_px) >> 20;
    const int64_t first_q8 =
        side * axis_along(movers->axes_q30 + 6, plane->n) * 256 - ((w_px - 1) * x_q8 + (h_px - 1) * y_q8) / 2;
    int away_shift = 0, shift = 0;
    uint8_t zeros;

    const uint32_t leading = leading_u32(away < 0 ? 0 - (uint64_t)away : (uint64_t)away, &away_shift);
    const uint32_t recip_q31 = recip_q31_of(leading ? leading : 1, &zeros); /* 2^(zeros - 62) of it is 1 / leading */
    const uint32_t factor = leading_u32((uint64_t)near_q8_of(camera) * recip_q31, &shift) >> 1;
    shift += 1 + (is_far ? 14 + LIM_NEAR_FAR_BITS : 22) + zeros - 62 - away_shift - exponent;
    out->at_q30 = near_scaled(first_q8, factor, shift);
    out->x_q30 = near_scaled(x_q8, factor, shift);
    out->y_q30 = near_scaled(y_q8, factor, shift);
}

void lim_near_plane_set(struct lim_near_plane *out, const struct lim_movers *movers, const struct lim_pass *pass,
                        const struct lim_met_polygon *polygon)
{
    struct lim_plane_unpacked plane;
    int8_t exponent = 0;

    if (polygon->owner >= LIM_STILL_MET) {
        lim_still_plane(&plane, pass, polygon->record, polygon->node);
    } else {
        const struct lim_scene *const object = movers->instances[polygon->owner].object;
        lim_corners_plane(&plane, object, &object->polygons[polygon->record]);
        lim_mover_turn(movers, polygon->owner, &plane);
        if (LIM_HAS_FAR_MOVERS && lim_movers_are_far(movers)) exponent = lim_mover_exponent(movers, polygon->owner);
    }
    set_over_screen(out, movers, pass, &plane, exponent);
}

/* How much nearer the first of two is at pixel x. */
static lim_near_difference near_difference(const struct lim_near_row *a, const struct lim_near_row *b, int32_t x)
{
    return (lim_near_difference)(a->at_q30 - b->at_q30 + (a->x_q30 - b->x_q30) * (uint32_t)x);
}

static bool is_within_tie(const struct lim_near_row *a, lim_near_difference difference, int32_t x)
{
    return lim_near_size(difference) <= (a->at_q30 + a->x_q30 * (uint32_t)x) >> LIM_NEAR_TIE_BITS;
}

/* The difference is linear in whole numbers, so the column where it changes its sign is exact, and any part of the runs
 * has the same. */
struct lim_near_share lim_near_share(const struct lim_near_row *a, const struct lim_near_row *b, bool b_wins_ties,
                                     struct lim_near_share both)
{
    const struct lim_near_share none = {both.x0, both.x0};
    const lim_near_difference first = near_difference(a, b, both.x0), last = near_difference(a, b, both.x1 - 1);
    const lim_near_word step = lim_near_size((lim_near_difference)(a->x_q30 - b->x_q30));

    if (is_within_tie(a, first, both.x0) && is_within_tie(a, last, both.x1 - 1)) return b_wins_ties ? both : none;
    if ((first ^ last) >= 0) return first < 0 ? both : none;
    if (first >= 0)
        both.x0 += (int32_t)((lim_near_word)first / step) + 1;
    else
        both.x1 = both.x0 + (int32_t)((lim_near_size(first) - 1) / step) + 1;
    return both;
}

#endif
