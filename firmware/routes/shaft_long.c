/* SPDX-License-Identifier: MIT
 *
 * Shafts in a long scene: in the frame of the mover that they are of, where boxes and polygons are asked for. */
#include "routes/shaft.h"

#include "movers/mover_long.h"

#if LIM_HAS_FAR_MOVERS

void lim_shaft_end_far(struct lim_shaft *shaft, const struct lim_plane_unpacked *plane, bool in_front)
{
    const uint8_t along = *plane->along;

    if (along == LIM_NO_AXIS) return;
    const int32_t end = (int32_t)(plane->d >> 28);
    if (in_front)
        shaft->low[along] = end;
    else
        shaft->high[along] = end + 1;
}

void lim_shaft_unpack_far(struct lim_plane_unpacked *plane, const struct lim_shaft *shaft,
                          const LIM_FLASH struct lim_plane_ref *ref)
{
    lim_plane_unpack_far(plane, *shaft->far->movers->far, ref);
    lim_plane_bring(plane, shaft->far->movers, LIM_NONE, shaft->far->mover);
}

bool lim_shaft_meets_far_extent(const struct lim_shaft *shaft, const struct lim_extent *extent, int8_t exponent)
{
    const int_fast8_t up = (int_fast8_t)(exponent + 1 - lim_mover_exponent(shaft->far->movers, shaft->far->mover));

    for (uint_fast8_t i = 0; i < 3; i++) {
        const int64_t one = INT64_C(1) << (up > 0 ? up : 0);
        const int64_t low = up > 0 ? extent->low[i] * one : extent->low[i] >> -up;
        const int64_t high = up > 0 ? extent->high[i] * one : (extent->high[i] >> -up) + 1;
        if (low > shaft->high[i] || high < shaft->low[i]) return false;
    }
    return true;
}

/* A coordinate of the long scene in the shaft's units, rounded down. */
static int32_t in_shaft(const struct lim_shaft *shaft, int64_t at, uint_fast8_t i)
{
    const struct lim_movers *movers = shaft->far->movers;
    const struct lim_long_eye *eye = (*movers->far)->far;
    const int64_t away_q8 = (at - eye->at[i]) * 256 - (int32_t)eye->fraction_q8[i];
    const int64_t units = away_q8 >> (8 + lim_mover_exponent(movers, shaft->far->mover));

    return units > INT32_MAX / 2 ? INT32_MAX / 2 : units < INT32_MIN / 2 ? INT32_MIN / 2 : (int32_t)units;
}

bool lim_shaft_meets_long_box(const struct lim_shaft *shaft, const struct lim_scene *scene, lim_index number)
{
    const LIM_FLASH struct lim_long_box *box = &lim_scene_long(scene)->boxes[number];

    for (uint_fast8_t i = 0; i < 3; i++) {
        const int64_t centre = box->centre[i], half = box->half[i];
        if (in_shaft(shaft, centre - half, i) > shaft->high[i] || in_shaft(shaft, centre + half, i) + 1 < shaft->low[i])
            return false;
    }
    return true;
}

bool lim_shaft_meets_long_polygon(const struct lim_shaft *shaft, const struct lim_scene *scene,
                                  const LIM_FLASH lim_index *record)
{
    const struct lim_long *all = lim_scene_long(scene);

    for (uint_fast8_t i = 0; i < 3; i++) {
        int32_t low = INT32_MAX, high = INT32_MIN;
        for (uint_fast8_t k = 0; k < (record[0] & LIM_POLYGON_COUNT); k++) {
            const int32_t at = in_shaft(shaft, all->vertices[record[LIM_POLYGON_HEAD_WORDS + k]].at[i], i);
            if (at < low) low = at;
            if (at >= high) high = at + 1;
        }
        if (low > shaft->high[i] || high < shaft->low[i]) return false;
    }
    return true;
}

#endif
