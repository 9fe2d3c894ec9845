/* SPDX-License-Identifier: MIT
 *
 * What is left of a way when something stops it: less its part along the normal m, w - m (w . m) / (m . m). If that
 * leads into what stopped it before, it goes by that one's normal; if each leads into another, of two it goes along
 * their crease, m x m', and of more it ends. Normals have 16 bits and ways are rounded, so what is left is turned
 * outwards by a little: 2^-13 of the way, and 2.
 *
 * |w| < 2^24 along each axis and |m| < 2^15: products are below 2^41, m . m below 2^32, their product below 2^57. */
#include "touch/slide.h"

#include "math/fixed.h"
#include "touch/descent.h"

enum { OUT_BITS = 13, OUT_Q8 = 2 };

struct slide {
    int32_t way_q8[3]; /* what is left */
    int16_t normals[LIM_SLIDES][3];
    uint_fast8_t count;
};

static int64_t along_normal(const int16_t m[3], const int32_t way_q8[3])
{
    return (int64_t)m[0] * way_q8[0] + (int64_t)m[1] * way_q8[1] + (int64_t)m[2] * way_q8[2];
}

/* The part of a way along a direction that is not 0. */
static void part_along(const int16_t m[3], const int32_t way_q8[3], int32_t part_q8[3])
{
    const int32_t n[3] = {m[0], m[1], m[2]};
    const int64_t square = along_normal(m, n), dot = along_normal(m, way_q8);

    for (uint_fast8_t i = 0; i < 3; i++)
        part_q8[i] = square ? (int32_t)(m[i] * dot / square) : 0;
}

static void leave_out(const int16_t m[3], const int32_t way_q8[3], int32_t left_q8[3])
{
    const uint32_t size_q8 = abs_s32(way_q8[0]) + abs_s32(way_q8[1]) + abs_s32(way_q8[2]);
    const int32_t out_q8 = (int32_t)(size_q8 >> OUT_BITS) + OUT_Q8;
    int32_t part_q8[3], longest = 1;

    part_along(m, way_q8, part_q8);
    for (uint_fast8_t i = 0; i < 3; i++)
        if ((int32_t)abs_s32(m[i]) > longest) longest = (int32_t)abs_s32(m[i]);
    for (uint_fast8_t i = 0; i < 3; i++)
        left_q8[i] = way_q8[i] - part_q8[i] + out_q8 * m[i] / longest;
}

/* Whether a way leads into nothing that stopped it but, perhaps, one. */
static bool is_out_of_all(const struct slide *slide, const int32_t way_q8[3], uint_fast8_t but)
{
    for (uint_fast8_t i = 0; i < slide->count; i++)
        if (i != but && along_normal(slide->normals[i], way_q8) < 0) return false;
    return true;
}

static void go_along_crease(struct slide *slide)
{
    const int16_t *a = slide->normals[0], *b = slide->normals[1];
    int32_t cross[3], part_q8[3];
    int64_t cross_wide[4] = {0, 0, 0, 0};
    int16_t crease[3];

    for (uint_fast8_t i = 0; i < 3; i++) {
        const uint_fast8_t j = lim_axis_after(i), k = lim_axis_after(j);
        cross_wide[i] = (int64_t)a[j] * b[k] - (int64_t)a[k] * b[j];
    }
    shorten_s64(cross_wide, INT64_C(1) << 30);
    for (uint_fast8_t i = 0; i < 3; i++)
        cross[i] = (int32_t)cross_wide[i];
    lim_hit_normal(cross, false, crease);
    part_along(crease, slide->way_q8, part_q8);
    for (uint_fast8_t i = 0; i < 3; i++)
        slide->way_q8[i] = part_q8[i];
}

/* The last normal is new. false: there is no way left. */
static bool turn_way(struct slide *slide)
{
    for (uint_fast8_t i = slide->count; i-- > 0;) {
        int32_t left_q8[3];
        leave_out(slide->normals[i], slide->way_q8, left_q8);
        if (!is_out_of_all(slide, left_q8, i)) continue;
        for (uint_fast8_t k = 0; k < 3; k++)
            slide->way_q8[k] = left_q8[k];
        return true;
    }
    if (slide->count != 2) return false;
    go_along_crease(slide);
    return slide->way_q8[0] || slide->way_q8[1] || slide->way_q8[2];
}

static void note_normal(struct slide *slide, const int16_t normal[3], bool on_level)
{
    int16_t *const to = slide->normals[slide->count++];

    for (uint_fast8_t i = 0; i < 3; i++)
        to[i] = on_level && i == 1 ? 0 : normal[i];
}

int lim_slide_by(const struct lim_solid *solid, const int32_t half_q8[3], int32_t at_q8[3], const int32_t way_q8[3],
                 uint8_t flags, bool on_level)
{
    struct slide slide = {.way_q8 = {way_q8[0], way_q8[1], way_q8[2]}};

    while (slide.count < LIM_SLIDES) {
        struct lim_hit hit;
        int32_t to_q8[3];
        for (uint_fast8_t i = 0; i < 3; i++)
            to_q8[i] = at_q8[i] + slide.way_q8[i];
        const int stopped = lim_sweep(solid, half_q8, at_q8, to_q8, flags, &hit);
        if (stopped < 0) return stopped;
        for (uint_fast8_t i = 0; i < 3; i++) {
            at_q8[i] = hit.at_q8[i];
            slide.way_q8[i] = to_q8[i] - at_q8[i];
        }
        if (!stopped) break;
        note_normal(&slide, hit.normal, on_level);
        if (!turn_way(&slide)) break;
    }
    return (int)slide.count;
}

int lim_slide(const struct lim_solid *solid, const int32_t half_q8[3], int32_t at_q8[3], const int32_t way_q8[3],
              uint8_t flags)
{
    LIM_ASSERT(solid && half_q8 && at_q8 && way_q8);
    int32_t to_q8[3] = {at_q8[0], at_q8[1], at_q8[2]};

    for (uint_fast8_t i = 0; i < 3; i++)
        if (abs_s32(at_q8[i]) >= LIM_BODY_MAX_Q8 || abs_s32(way_q8[i]) >= LIM_BODY_MAX_Q8) return LIM_ERR_CAMERA;
    const int stops = lim_slide_by(solid, half_q8, to_q8, way_q8, flags, false);

    for (uint_fast8_t i = 0; stops >= 0 && i < 3; i++)
        at_q8[i] = to_q8[i];
    return stops;
}
