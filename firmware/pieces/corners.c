/* SPDX-License-Identifier: MIT
 *
 * A list of planes takes less room than corners, so they are cut anew each time. |n| < 2^31 and |d| < 2^48: with a
 * corner in Q12 each of three products stays below 2^58 + 2^27, and d below 2^60. */
#include "pieces/corners.h"

#include "pieces/deform.h"
#include "pieces/entry.h"

#if LIM_HAS_PIECES

const LIM_FLASH struct lim_plane_ref *lim_plane_of(const struct lim *lim, uint16_t entry)
{
    const struct lim_scene *scene = lim_entry_scene(lim, entry);

    if (!LIM_HAS_MOVERS || lim->sorter.list[entry].record != LIM_NO_INDEX) {
        const LIM_FLASH lim_index *record = lim_entry_record(lim, entry);
        if (LIM_HAS_LEAVES && record[0] & LIM_POLYGON_PLANE) return lim_record_plane(record);
    }
    return &scene->nodes[lim->sorter.newell.polygons[entry].node].split;
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

static inline void unpack(struct lim_plane_unpacked *plane, const struct lim_scene *scene,
                          const LIM_FLASH struct lim_plane_ref *ref)
{
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

void lim_plane_load(struct lim_plane_unpacked *plane, const struct lim *lim, uint16_t entry)
{
#if LIM_HAS_MOVERS
    const uint16_t owner = lim_entry_owner(lim, entry);

    if (LIM_HAS_DEFORM && owner != LIM_NONE && lim_deforms(&lim->movers.instances[owner]))
        (void)lim_deform_plane(plane, lim_entry_scene(lim, entry), lim_entry_record(lim, entry));
    else
        unpack(plane, lim_entry_scene(lim, entry), lim_plane_of(lim, entry));
    if (owner != LIM_NONE) lim_mover_turn(lim, owner, plane);
#else
    unpack(plane, lim_entry_scene(lim, entry), lim_plane_of(lim, entry));
#endif
}

#if LIM_HAS_MOVERS
void lim_plane_unpack(struct lim_plane_unpacked *plane, const struct lim_scene *scene,
                      const LIM_FLASH struct lim_plane_ref *ref)
{
    unpack(plane, scene, ref);
}
#endif

static inline void place_corner(const struct lim *lim, uint16_t entry, lim_index vertex, int32_t at_q12[3])
{
#if LIM_HAS_MOVERS
    const uint16_t owner = lim_entry_owner(lim, entry);

    if (owner != LIM_NONE) {
        lim_mover_place(lim, owner, vertex, at_q12);
        return;
    }
#else
    (void)entry;
#endif
    const struct lim_vertex at = lim->scene->vertices[vertex];
    at_q12[0] = at.x * (int32_t)LIM_CORNER_ONE_Q12;
    at_q12[1] = at.y * (int32_t)LIM_CORNER_ONE_Q12;
    at_q12[2] = at.z * (int32_t)LIM_CORNER_ONE_Q12;
#if LIM_HAS_FRACTIONS
    if (!lim->scene->fractions) return;
    const struct lim_fraction fraction = lim->scene->fractions[vertex];
    at_q12[0] += fraction.x_q8 * 16;
    at_q12[1] += fraction.y_q8 * 16;
    at_q12[2] += fraction.z_q8 * 16;
#endif
}

#if LIM_HAS_MOVERS
void lim_entry_corner(const struct lim *lim, uint16_t entry, lim_index vertex, int32_t at_q12[3])
{
    place_corner(lim, entry, vertex, at_q12);
}
#endif

static void load_corners(struct lim_corners *corners, const struct lim *lim, uint16_t entry)
{
    const LIM_FLASH lim_index *record = lim_entry_record(lim, entry);

    corners->n = (uint8_t)(record[0] & LIM_POLYGON_COUNT);
    for (uint_fast8_t k = 0; k < corners->n; k++)
        place_corner(lim, entry, record[LIM_POLYGON_HEAD_WORDS + k], corners->at_q12[k]);
}

/* How far along from a value to one of the other sign 0 is. */
static uint32_t zero_q31(int64_t from, int64_t to)
{
    uint64_t part = from < 0 ? 0 - (uint64_t)from : (uint64_t)from;
    uint64_t sum = part + (to < 0 ? 0 - (uint64_t)to : (uint64_t)to);

    while (sum >> 32) {
        part >>= 1;
        sum >>= 1;
    }
    return ratio_q31((uint32_t)part, (uint32_t)sum);
}

/* Always from the front, so that the pieces on either side get the same corner. */
void lim_plane_cross(int32_t out[3], const int32_t front[3], int64_t front_value, const int32_t back[3],
                     int64_t back_value)
{
    const uint32_t t_q31 = zero_q31(front_value, back_value);

    for (uint_fast8_t i = 0; i < 3; i++)
        out[i] = lerp_q31(front[i], back[i], t_q31);
}

/* The scene's limit decides, not the build's, so that all builds split alike. */
static uint_fast16_t most_corners(const struct lim_scene *scene)
{
    const uint_fast16_t most = (uint_fast16_t)scene->limits.vertices + LIM_CUT_VERTICES;

    return most < LIM_PIECE_VERTICES ? most : LIM_PIECE_VERTICES;
}

/* false: it would have too many corners, or has too few. */
static bool clip_to(struct lim_corners *to, const struct lim_corners *from, const struct lim_plane_unpacked *plane,
                    bool front, uint_fast16_t most)
{
    const int32_t *before = from->at_q12[from->n - 1];
    int64_t value_before = lim_corner_value(plane, before);

    to->n = 0;
    for (uint_fast8_t k = 0; k < from->n; k++) {
        const int32_t *here = from->at_q12[k];
        const int64_t value = lim_corner_value(plane, here);
        if (to->n + 2u > most) return false;
        if (value_before < 0 && value > 0) lim_plane_cross(to->at_q12[to->n++], here, value, before, value_before);
        if (value_before > 0 && value < 0) lim_plane_cross(to->at_q12[to->n++], before, value_before, here, value);
        if (front ? value >= 0 : value <= 0) {
            for (uint_fast8_t i = 0; i < 3; i++)
                to->at_q12[to->n][i] = here[i];
            to->n++;
        }
        before = here;
        value_before = value;
    }
    return to->n >= 3;
}

const struct lim_corners *lim_corners_cut(const struct lim *lim, uint16_t entry, const struct lim_plane_unpacked *plane,
                                          bool front, struct lim_corners places[2])
{
    const struct lim_corners *whole = lim_corners_of(lim, entry, places);
    struct lim_corners *const part = whole == &places[0] ? &places[1] : &places[0];

    return whole && clip_to(part, whole, plane, front, most_corners(lim_entry_scene(lim, entry))) ? part : NULL;
}

/* The corners of a piece, in one of two places. NULL: too many, or none. */
const struct lim_corners *lim_corners_of(const struct lim *lim, uint16_t entry, struct lim_corners places[2])
{
    const struct lim_newell *newell = &lim->sorter.newell;
    const uint_fast16_t most = most_corners(lim_entry_scene(lim, entry));
    struct lim_corners *here = &places[0], *there = &places[1];

    load_corners(here, lim, entry);
    for (uint16_t cut = newell->polygons[entry].cuts; cut != LIM_NONE; cut = newell->cuts[cut].next) {
        struct lim_plane_unpacked plane;
        lim_plane_load(&plane, lim, newell->cuts[cut].by & LIM_SORTED_MAX);
        if (!clip_to(there, here, &plane, newell->cuts[cut].by & LIM_CUT_FRONT, most)) return NULL;
        struct lim_corners *const clipped = there;
        there = here;
        here = clipped;
    }
    return here;
}

#endif
