/* SPDX-License-Identifier: MIT
 *
 * Ranges. An eye is less than 2^31.6 units of the scene away from an object's origin, and 2^29 of the object's own. An
 * object reaches 2^15.8 of its own units along an axis of the scene, and a ball around it is less than 2^16 wide. A
 * frame's unit is at least one of the object's, and all of the object and its ball is within 2^16 of them: 2^28 in Q12.
 * Normals n are below 2^30 along each axis, so n . p is below 2^60 there, and planes beyond 2^50 have all of it on one
 * side: d is at most that, in n's scale times units. */
#include "movers/mover_long.h"

#include "eye.h"
#include "math/relative.h"
#include "movers/axes.h"
#include "movers/deform.h"
#include "view/cull.h"
#include "view/transform.h"
#include "view/view.h"

#if LIM_HAS_FAR_MOVERS

enum { OWN_MIN = -8, OWN_MAX = 14, FRAME_BITS = 16, PLACE_END_BITS = 30, OWN_EYE_BITS = 29 };
#define PLANE_END (INT64_C(1) << 50)

/* Stands for those of objects whose eye, or view, is told in whole units: they have none of their own. */
static const struct lim_long none_of_32_bits;

void lim_movers_copy(struct lim_movers *movers)
{
    for (uint16_t i = 0; i < movers->count; i++)
        (*movers->copies)[i] = movers->instances[i];
    movers->instances = *movers->copies;
}

/* Pose ------------------------------------------------------------------------------------------------------------- */

/* From the eye to the object's origin, in units of the scene. false: it is out of range. */
static bool way_to_origin(int64_t way_q8[3], const struct lim_long_eye *eye, const struct lim_instance *instance)
{
    for (uint_fast8_t i = 0; i < 3; i++) {
        if (abs_s32(instance->origin[i]) >= UINT32_C(1) << PLACE_END_BITS) return false;
        const int32_t whole = instance->origin[i] + (instance->at_q8[i] >> 8);
        if (abs_s32(whole) >= UINT32_C(1) << PLACE_END_BITS) return false;
        way_q8[i] = ((int64_t)whole - eye->at[i]) * 256 + (instance->at_q8[i] & 0xFF) - (int32_t)eye->fraction_q8[i];
    }
    return true;
}

/* The eye, as the object sees it: products of 30 bits with the upper and the lower bits of a way of 40. */
static bool eye_of_object(int64_t own_q8[3], const int64_t way_q8[3], const struct lim_instance *instance, int8_t own)
{
    for (uint_fast8_t j = 0; j < 3; j++) {
        int64_t upper = 0, lower = 0;
        for (uint_fast8_t i = 0; i < 3; i++) {
            upper -= instance->axes_q30[3 * j + i] * (way_q8[i] >> 20);
            lower -= instance->axes_q30[3 * j + i] * (way_q8[i] & 0xFFFFF);
        }
        own_q8[j] = shift_round_s64(upper + (lower >> 20), (uint8_t)(10 + own));
        if (own_q8[j] >> (OWN_EYE_BITS + 8) != own_q8[j] >> 63) return false;
    }
    return true;
}

static void set_own_eye(struct lim_eye *eye, const struct lim_scene *object, const int64_t own_q8[3], int8_t own)
{
    bool is_near = true;
    int32_t at_q8[3];

    for (uint_fast8_t j = 0; j < 3; j++) {
        at_q8[j] = (int32_t)own_q8[j];
        is_near = is_near && own_q8[j] < LIM_EYE_MAX_Q8 && own_q8[j] > -LIM_EYE_MAX_Q8;
    }
    for (uint_fast8_t j = 0; j < 3 && !is_near; j++)
        at_q8[j] = 0;
    lim_eye_set(eye, object, at_q8);
    if (!is_near) {
        eye->far->all = &none_of_32_bits;
        eye->near_end = 0;
    }
    for (uint_fast8_t j = 0; j < 3; j++) {
        eye->far->at[j] = (int32_t)(own_q8[j] >> 8);
        eye->far->fraction_q8[j] = (uint8_t)own_q8[j];
    }
    eye->far->unit = own;
}

/* 2^-8 units of the scene, in a frame. */
static int64_t to_frame(int64_t at_q8, int8_t exponent)
{
    return exponent > 0 ? shift_round_s64(at_q8, (uint8_t)exponent) : at_q8 * (INT32_C(1) << -exponent);
}

bool lim_mover_approach(struct lim_movers *movers, uint16_t mover)
{
    struct lim_instance *instance = &(*movers->copies)[mover];
    struct lim_mover *self = &movers->movers[mover];
    const int8_t own = (int8_t)(*instance->coarser_bits - instance->finer_bits);
    int64_t way_q8[3], own_q8[3], size_q8 = 0;

    if ((instance->object->limits.leaf_polygons && !lim_deforms(instance)) || instance->finer_bits > -OWN_MIN ||
        *instance->coarser_bits > OWN_MAX || !way_to_origin(way_q8, (*movers->far)->far, instance) ||
        !eye_of_object(own_q8, way_q8, instance, own))
        return false;
    set_own_eye(&self->eye, instance->object, own_q8, own);
    for (uint_fast8_t i = 0; i < 3; i++)
        size_q8 = larger_s64(size_q8, way_q8[i]);
    size_q8 += INT64_C(7) << (14 + 8 + own); /* of corners, and the ball's radius */
    int8_t exponent = own;
    while (size_q8 >> (exponent + 8) >> FRAME_BITS)
        exponent++;
    instance->finer_bits = (uint8_t)(exponent - own);
    for (uint_fast8_t i = 0; i < 3; i++)
        instance->at_q8[i] = (int32_t)to_frame(way_q8[i], exponent);
    return true;
}

/* View ------------------------------------------------------------------------------------------------------------- */

void lim_mover_set_far_view(struct lim_mover *mover)
{
    struct lim_long_eye *eye = mover->view.rows.eye;
    uint32_t farthest = 0;

    *eye = *mover->eye.far;
    eye->all = &none_of_32_bits;
    for (uint_fast8_t i = 0; i < 3; i++)
        if (abs_s32(eye->at[i]) > farthest) farthest = abs_s32(eye->at[i]);
    mover->view.rows.far_units = 2 * farthest + 65536; /* for textures */
}

enum { CULL_BITS = 2, CULL_EYE_BITS = 17 };

/* The planes go through the eye, with two bits less, so that 2^17 units fit: then a place is off by another unit at
 * most along each axis, and the eye's fraction. From farther away all of an object counts as in view. */
void lim_mover_set_far_cull(struct lim_cull *cull, const struct lim_mover *mover, const struct lim_rect *open)
{
    static const int32_t here_q8[3];
    const struct lim_long_eye *eye = mover->view.rows.eye;

    for (uint_fast8_t i = 0; i < 3; i++) {
        if (abs_s32(eye->at[i]) < UINT32_C(1) << CULL_EYE_BITS) continue;
        cull->inside_depth = 0;
        return;
    }
    lim_cull_set(cull, &mover->view, here_q8, open);
    for (uint_fast8_t k = 0; k < 4; k++) {
        struct lim_cull_plane *plane = &cull->sides[k];
        plane->offset = INT32_C(4) << CULL_EYE_BITS << CULL_BITS;
        for (uint_fast8_t i = 0; i < 3; i++) {
            plane->n[i] = (int16_t)(plane->n[i] >> CULL_BITS);
            plane->offset -= plane->n[i] * eye->at[i];
        }
    }
}

void lim_mover_far_box(const struct lim_mover *mover, struct lim_box *box)
{
    for (uint_fast8_t i = 0; i < 3; i++) {
        box->centre[i] = (int16_t)(mover->centre_q12[i] >> 14);
        box->half[i] = (uint16_t)((mover->half_q12[i] >> 14) + 2);
    }
}

/* Planes ----------------------------------------------------------------------------------------------------------- */

static int64_t norm_of(const struct lim_plane_unpacked *plane)
{
    return (int64_t)abs_s32(plane->n[0]) + abs_s32(plane->n[1]) + abs_s32(plane->n[2]);
}

/* n . (p - e) = rest - n . (e - v): below 2^62.2 in the scale of n, of which at least one component has 30 bits. */
void lim_plane_unpack_far(struct lim_plane_unpacked *plane, const struct lim_eye *eye,
                          const LIM_FLASH struct lim_plane_ref *ref)
{
    const struct lim_long_eye *from = eye->far;
    const struct lim_long *all = from->all;

    plane->narrow = false;
    plane->axis = LIM_NO_AXIS;
    if (ref->plane >= LIM_PLANE_X) {
        const uint8_t axis = ref->plane & 3;
        const int64_t away = (int64_t)all->vertices[(lim_index)ref->offset].at[axis] - from->at[axis];
        *plane->along = axis;
        for (uint_fast8_t i = 0; i < 3; i++)
            plane->n[i] = i == axis ? LIM_FAR_AXIS : 0;
        plane->d = (away * 256 - (int32_t)from->fraction_q8[axis]) * (LIM_FAR_AXIS >> 8);
    } else {
        const LIM_FLASH struct lim_long_plane *packed = &all->planes[ref->plane];
        uint8_t fraction_q8;
        const int64_t value = lim_eye_long_value(from, packed, &all->vertices[packed->vertex], &fraction_q8);
        const uint8_t zeros = clz_u32(abs_s32(packed->n[0]) | abs_s32(packed->n[1]) | abs_s32(packed->n[2]) | 1);
        const uint8_t up = (uint8_t)(zeros > 2 ? zeros - 2 : 0);
        *plane->along = LIM_NO_AXIS;
        for (uint_fast8_t i = 0; i < 3; i++)
            plane->n[i] = packed->n[i] * (INT32_C(1) << up);
        plane->d = -(value * (INT64_C(1) << up) + (int64_t)(((uint64_t)fraction_q8 << up) >> 8));
    }
    plane->slack = norm_of(plane);
}

int64_t lim_plane_scaled(int64_t x, int_fast8_t up)
{
    if (up <= 0) x >>= -up < 63 ? -up : 63;
    if (up > 0 && up < 50 && x < PLANE_END >> up && x > -(PLANE_END >> up)) return x * (INT64_C(1) << up);
    if (up > 0 && x) return x < 0 ? -PLANE_END : PLANE_END;
    return x > PLANE_END ? PLANE_END : x < -PLANE_END ? -PLANE_END : x;
}

static int_fast8_t lesser_exponent(int_fast8_t a, int_fast8_t b)
{
    return a < b ? a : b;
}

/* What lies within a plane's slack is on it: in any scene a unit, by which corners are off. Here units differ: it is
 * the larger of both, the scene's or the object's whose the plane is, and the corners' object's; but where that could
 * be seen, because the plane is less than 2^10 times as far away, the smaller one. */
void lim_plane_bring(struct lim_plane_unpacked *plane, const struct lim_movers *movers, uint16_t from, uint16_t to)
{
    const int_fast8_t exponent = lim_mover_exponent(movers, to), own = movers->movers[to].eye.far->unit;
    const int_fast8_t exponent_from = from == LIM_NONE ? 0 : lim_mover_exponent(movers, from);
    const int_fast8_t own_from = from == LIM_NONE ? 0 : movers->movers[from].eye.far->unit;
    const int64_t norm = norm_of(plane);
    const int64_t most = lim_plane_scaled(norm, (int_fast8_t)((own > own_from ? own : own_from) - exponent));
    const int64_t least = lim_plane_scaled(norm, (int_fast8_t)(lesser_exponent(own, own_from) - exponent));

    plane->d = lim_plane_scaled(plane->d, (int_fast8_t)(exponent_from - exponent));
    const int64_t seldom_seen = (plane->d < 0 ? -plane->d : plane->d) >> 10;
    const int64_t between = seldom_seen > least ? seldom_seen : least;
    plane->slack = (most < between ? most : between) + (norm >> 6); /* what frames round */
}

#endif
