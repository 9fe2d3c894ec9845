/* SPDX-License-Identifier: MIT
 *
 * A list of planes takes less room than corners, so they are cut anew each time. */
#include "pieces/corners.h"

#include "pieces/entry.h"
#include "view/plane_unpacked.h"

#if LIM_HAS_NEWELL

static void load_corners(struct lim_corners *corners, const struct lim_sorter *sorter, uint16_t entry)
{
    const LIM_FLASH lim_index *record = lim_entry_record(sorter, entry);

    corners->n = (uint8_t)(record[0] & LIM_POLYGON_COUNT);
    for (uint_fast8_t k = 0; k < corners->n; k++) {
        lim_corner_load(corners->at_q12[k], sorter->pass->scene, record[LIM_POLYGON_HEAD_WORDS + k]);
        for (uint_fast8_t i = 0; i < 3; i++)
            corners->at_q12[k][i] *= LIM_CORNER_LOADED_Q12;
    }
}

/* The scene's limit decides, not the build's, so that all builds split alike. */
static uint_fast16_t most_corners(const struct lim_scene *scene)
{
    const uint_fast16_t most = (uint_fast16_t)scene->limits.vertices + LIM_CUT_VERTICES;

    return most < LIM_PIECE_VERTICES ? most : LIM_PIECE_VERTICES;
}

static void add_corner(struct lim_corners *to, const int32_t at_q12[3])
{
    int32_t *corner = to->at_q12[to->n++];

    corner[0] = at_q12[0];
    corner[1] = at_q12[1];
    corner[2] = at_q12[2];
}

/* The part on one side of a plane. false: it would have too many corners, or has too few. */
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
        if (value_before > 0 && value < 0) lim_plane_cross(to->at_q12[to->n++], before, value_before, here, value);
        if (value_before < 0 && value > 0) lim_plane_cross(to->at_q12[to->n++], here, value, before, value_before);
        if (front ? value >= 0 : value <= 0) add_corner(to, here);
        before = here;
        value_before = value;
    }
    return to->n >= 3;
}

/* The last cut comes first. */
const struct lim_corners *lim_corners_of(const struct lim_sorter *sorter, uint16_t entry, struct lim_corners places[2])
{
    const struct lim_newell *newell = sorter->newell;
    const uint_fast16_t most = most_corners(sorter->pass->scene);
    struct lim_corners *here = &places[0], *there = &places[1];

    load_corners(here, sorter, entry);
    for (uint16_t cut = newell->polygons[entry].cuts; cut != LIM_NONE; cut = newell->cuts[cut].next) {
        struct lim_plane_unpacked plane;
        lim_plane_load(&plane, sorter, newell->cuts[cut].by & LIM_SORTED_MAX);
        if (!clip_to(there, here, &plane, newell->cuts[cut].by & LIM_CUT_FRONT, most)) return NULL;
        struct lim_corners *const clipped = there;
        there = here;
        here = clipped;
    }
    return here;
}

const struct lim_corners *lim_corners_cut(const struct lim_sorter *sorter, uint16_t entry,
                                          const struct lim_plane_unpacked *plane, bool front,
                                          struct lim_corners places[2])
{
    const struct lim_corners *whole = lim_corners_of(sorter, entry, places);
    struct lim_corners *const part = whole == &places[0] ? &places[1] : &places[0];

    return whole && clip_to(part, whole, plane, front, most_corners(sorter->pass->scene)) ? part : NULL;
}

#endif
