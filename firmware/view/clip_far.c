/* SPDX-License-Identifier: MIT
 *
 * Clipping corners at the horizon with the eye close to their polygon. Of a corner 2^29 units away view space has 30
 * bits, the last of which is worth 2 to 7 units: if the eye is 8 units above a ground, that ground may come to lie
 * above the eye, or nearer to it than the near plane. So where a corner's last bits are not small beside the near
 * plane, it is seen once more with all bits of the way and of the rows, and its edges are cut in 64 bits.
 *
 * A way has 31 bits of units and 8 of a fraction, a row 16, or 31 of which 16 are whole; so a coordinate is below 2^55
 * in units of 2^LIM_VIEW_FAR_LAST. It is kept in two words. Whether a corner is coarse does not depend on its polygon,
 * so an edge is cut in the same way in both polygons that it belongs to. */
#include "math/fixed.h"
#include "view/clip.h"
#include "view/transform.h"

#if LIM_HAS_LONG

enum {
    /* A corner that is not may be off by 3 of its last bits, with limbs by one: by 2^-12 of the near plane's distance.
     */
    COARSE_BITS = LIM_HAS_LIMBS ? 12 : 14,
    WAY_LOW_BITS = 15,
    SHARE_BITS = 30,
    CUT_LOW_BITS = 28
};

static inline int64_t far_coordinate(const struct lim_view_point *point, uint_fast8_t i)
{
    return (int64_t)((uint64_t)(uint32_t)point->qv[i] << 32 | point->low[i]);
}

static inline void far_put(struct lim_view_point *point, uint_fast8_t i, int64_t x)
{
    point->qv[i] = (int32_t)(x >> 32);
    point->low[i] = (uint32_t)x;
}

/* Of any point. */
static LIM_RARE int64_t far_coordinate_of(const struct lim_view_point *point, uint_fast8_t i)
{
    const int_fast8_t up = (int_fast8_t)(*point->exponent - LIM_VIEW_FAR_LAST);

    if (lim_clip_is_far(point)) return far_coordinate(point, i);
    return up < 0 ? point->qv[i] >> (up > -31 ? -up : 31) : (int64_t)point->qv[i] * (INT64_C(1) << up);
}

/* Corners ----------------------------------------------------------------------------------------- */

/* From the eye to a vertex. */
static void far_way(int64_t way_q8[3], const struct lim_long_eye *eye, lim_index vertex)
{
    const struct lim_long *all = eye->all;
    const LIM_FLASH struct lim_long_vertex *point = &all->vertices[vertex];

    for (uint_fast8_t i = 0; i < 3; i++)
        way_q8[i] = (int64_t)(point->at[i] - eye->at[i]) * 256 - eye->fraction_q8[i];
    if (!all->fractions) return;
    const LIM_FLASH struct lim_fraction *fraction = &all->fractions[vertex];
    way_q8[0] += fraction->x_q8;
    way_q8[1] += fraction->y_q8;
    way_q8[2] += fraction->z_q8;
}

/* n . way: the upper part is below 2^30 sqrt(3) 2^24, the lower one below 2^30 * 3 * 2^15. */
static LIM_RARE int64_t far_row(const struct lim_row *row, const int64_t way_q8[3])
{
    int64_t high = 0, low = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
        const int32_t entry_qv15 = transform_entry_qv15(row, i);
        high += (int64_t)entry_qv15 * (int32_t)(way_q8[i] >> WAY_LOW_BITS);
        low += (int64_t)entry_qv15 * ((int32_t)way_q8[i] & ((1 << WAY_LOW_BITS) - 1));
    }
    return high + (low >> WAY_LOW_BITS);
}

/* What a long lens's row has turned by, of z. */
static inline int64_t far_turned(int64_t z, int32_t turn_q32)
{
    return (z >> 32) * turn_q32 + ((int64_t)(uint32_t)z * turn_q32 >> 32);
}

static LIM_RARE void far_set(struct lim_view_point *out, const struct lim_rows *rows, lim_index vertex)
{
    int64_t way_q8[3];

    far_way(way_q8, rows->eye, vertex);
    const int64_t z = far_row(&rows->row[2], way_q8);
    for (uint_fast8_t i = 0; i < 2; i++) {
        const int64_t x = far_row(&rows->row[i], way_q8);
        far_put(out, i, LIM_TURNS_ROWS ? x + far_turned(z, rows->turn_q32[i]) : x);
    }
    far_put(out, 2, LIM_HAS_LIMBS ? z : z >> rows->tele_bits);
    *out->exponent = LIM_VIEW_FAR;
}

/* The least exponent of what is coarse. */
static inline int_fast8_t coarse_exponent(int32_t near_qv)
{
    const int_fast8_t least = (int_fast8_t)(32 - COARSE_BITS - clz_u32((uint32_t)near_qv));

    return least < LIM_VIEW_WHOLE_UNITS ? least : LIM_VIEW_WHOLE_UNITS;
}

bool lim_clip_refine(struct lim_clip_polygon *polygon, int32_t near_qv)
{
    const int_fast8_t least = coarse_exponent(near_qv);
    bool is_any = false;

    for (uint_fast8_t k = 0; k < polygon->n; k++) {
        struct lim_view_point *const point = &polygon->at[k];
        if (*point->exponent < least) continue;
        far_set(point, &(*polygon->view)->rows, (*polygon->corners)[k]);
        *point->corner = (uint8_t)(k + 1);
        is_any = true;
    }
    return is_any;
}

/* Cuts -------------------------------------------------------------------------------------------- */

/* Twice the distance, |it| < 2^58. */
static LIM_RARE int64_t far_distance(const struct lim_view_point *point, const struct lim_clip_plane *plane)
{
    const int64_t z = far_coordinate_of(point, 2) * 2 >> (LIM_HAS_TELE ? *plane->zoom_bits : 0);
    const int64_t x = plane->kept ? far_coordinate_of(point, plane->of) : 0;

    return z + (plane->turned ? -x : x) - (int64_t)plane->near_qv2 * (4 << -LIM_VIEW_FAR_LAST);
}

LIM_RARE int32_t lim_clip_far_distance(const struct lim_view_point *point, const struct lim_clip_plane *plane)
{
    return (int32_t)(far_distance(point, plane) >> 32);
}

/* The next bits of part / whole; what is left of the part is theirs that follow. */
static LIM_RARE uint32_t far_share_q30(uint64_t *part, uint64_t whole)
{
    uint32_t share_q30 = 0;

    for (uint_fast8_t i = 0; i < SHARE_BITS; i++) {
        *part <<= 1;
        share_q30 <<= 1;
        if (*part < whole) continue;
        *part -= whole;
        share_q30++;
    }
    return share_q30;
}

/* way (high_q30 / 2^30 + low_q60 / 2^60), |way| < 2^57; what two low parts make is less than one. */
static LIM_RARE int64_t far_part(int64_t way, uint32_t high_q30, uint32_t low_q60)
{
    const int64_t way_high = way >> CUT_LOW_BITS, way_low = way & ((INT64_C(1) << CUT_LOW_BITS) - 1);
    const int64_t low = way_low * high_q30 + (way_high * low_q60 >> (SHARE_BITS - CUT_LOW_BITS));

    return (way_high * high_q30 + (low >> CUT_LOW_BITS)) >> (SHARE_BITS - CUT_LOW_BITS);
}

/* A point of another exponent may have lost last bits, and its side with them: then it is in the plane. */
LIM_RARE void lim_clip_cut_far(struct lim_view_point *out, const struct lim_view_point *inner,
                               const struct lim_view_point *outer, const struct lim_clip_plane *plane)
{
    const int64_t inner_d = far_distance(inner, plane), outer_d = far_distance(outer, plane);
    uint64_t part = inner_d > 0 ? (uint64_t)inner_d : 0;
    const uint64_t whole = part + (outer_d < 0 ? 0 - (uint64_t)outer_d : 1);
    const uint32_t high_q30 = far_share_q30(&part, whole), low_q60 = far_share_q30(&part, whole);

    for (uint_fast8_t i = 0; i < 3; i++) {
        const int64_t from = far_coordinate_of(inner, i);
        far_put(out, i, from + far_part(far_coordinate_of(outer, i) - from, high_q30, low_q60));
    }
    *out->exponent = LIM_VIEW_FAR;
    *out->corner = 0;
}

/* A cut's 29 bits leave room for the near plane, which has as many. */
LIM_RARE void lim_clip_end_far(struct lim_view_point *point, const struct lim_clip_polygon *begun)
{
    uint64_t size = 0;
    uint_fast8_t down = 0;

    if (*point->corner) {
        lim_view_transform_long(*begun->view, (*begun->corners)[*point->corner - 1], point);
        return;
    }
    for (uint_fast8_t i = 0; i < 3; i++) {
        const int64_t x = far_coordinate(point, i);
        size |= (uint64_t)(x ^ x >> 63);
    }
    for (; size >> 29; size >>= 1)
        down++;
    for (uint_fast8_t i = 0; i < 3; i++)
        point->qv[i] = (int32_t)(far_coordinate(point, i) >> down);
    *point->exponent = (int8_t)(LIM_VIEW_FAR_LAST + (int_fast8_t)down);
}

#endif
