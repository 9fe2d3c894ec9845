/* SPDX-License-Identifier: MIT
 *
 * |n| < 2^31 and |d| < 2^48: with a corner in Q12 each of three products stays below 2^58 + 2^27, and d below 2^60. */
#include "view/plane_unpacked.h"

void lim_corner_load(int32_t at[3], const struct lim_scene *scene, lim_index vertex)
{
    const struct lim_vertex corner = scene->vertices[vertex];

    at[0] = corner.x;
    at[1] = corner.y;
    at[2] = corner.z;
#if LIM_HAS_FRACTIONS
    struct lim_fraction rest = {0, 0, 0};
    if (scene->fractions) rest = scene->fractions[vertex];
    at[0] = at[0] * 256 + rest.x_q8;
    at[1] = at[1] * 256 + rest.y_q8;
    at[2] = at[2] * 256 + rest.z_q8;
#endif
}

static void load_slanted(struct lim_plane_unpacked *plane, const struct lim_scene *scene,
                         const LIM_FLASH struct lim_plane *packed)
{
    plane->narrow = !LIM_HAS_LARGE || lim_plane_exact(packed) == LIM_NO_INDEX;
    plane->axis = LIM_NO_AXIS;
    if (!plane->narrow) {
        const LIM_FLASH struct lim_plane_exact *exact = &scene->exact[lim_plane_exact(packed)];
        for (uint_fast8_t i = 0; i < 3; i++)
            plane->n[i] = exact->n[i];
        plane->d = (int64_t)exact->d_hi * (INT64_C(1) << 32) + exact->d_lo;
        return;
    }
    plane->n[0] = lim_plane_x(packed);
    plane->n[1] = lim_plane_y(packed);
    plane->n[2] = lim_plane_z(packed);
    plane->d = lim_plane_d(packed);
}

void lim_plane_unpack(struct lim_plane_unpacked *plane, const struct lim_scene *scene,
                      const LIM_FLASH struct lim_plane_ref *ref)
{
    if (LIM_HAS_LONG) *plane->along = LIM_NO_AXIS;
    if (LIM_HAS_SLANTED && ref->plane < LIM_PLANE_X) {
        load_slanted(plane, scene, lim_plane_at(scene->planes, ref->plane));
    } else {
        plane->axis = ref->plane & 3;
        for (uint_fast8_t i = 0; i < 3; i++)
            plane->n[i] = i == plane->axis;
        plane->d = ref->offset;
        plane->narrow = true;
    }
    plane->slack = (int64_t)abs_s32(plane->n[0]) + abs_s32(plane->n[1]) + abs_s32(plane->n[2]);
}

uint32_t lim_plane_zero_q31(int64_t from, int64_t to)
{
    const uint64_t part = from < 0 ? 0 - (uint64_t)from : (uint64_t)from;
    const uint64_t sum = part + (to < 0 ? 0 - (uint64_t)to : (uint64_t)to);
    const uint32_t above = (uint32_t)(sum >> 32);
    const uint8_t shift = above ? (uint8_t)(32 - clz_u32(above)) : 0;

    return ratio_q31((uint32_t)(part >> shift), (uint32_t)(sum >> shift));
}

/* Always from the front, so that the pieces on either side get the same corner. */
void lim_plane_cross(int32_t out[3], const int32_t front[3], int64_t front_value, const int32_t back[3],
                     int64_t back_value)
{
    const uint32_t t_q31 = lim_plane_zero_q31(front_value, back_value);

    for (uint_fast8_t i = 0; i < 3; i++)
        out[i] = lerp_q31(front[i], back[i], t_q31);
}
