/* SPDX-License-Identifier: MIT
 *
 * A list of planes takes less room than corners, so they are cut anew each time. */
#include "pieces/corners.h"

#include "movers/deform.h"
#include "pieces/entry.h"

#if LIM_HAS_PIECES

void lim_entry_corner(const struct lim_sorter *sorter, uint16_t entry, lim_index vertex, int32_t at_q12[3])
{
    const struct lim_scene *scene = sorter->pass->scene;
    const uint16_t owner = lim_entry_owner(sorter, entry);

    if (LIM_HAS_MOVERS && owner != LIM_NONE) {
        const int32_t *placed_q12 = lim_mover_corner(sorter->movers, owner, vertex);
        for (uint_fast8_t i = 0; i < 3; i++)
            at_q12[i] = placed_q12[i];
        return;
    }
    const struct lim_vertex at = scene->vertices[vertex];
    at_q12[0] = at.x * (int32_t)LIM_CORNER_ONE_Q12;
    at_q12[1] = at.y * (int32_t)LIM_CORNER_ONE_Q12;
    at_q12[2] = at.z * (int32_t)LIM_CORNER_ONE_Q12;
#if LIM_HAS_FRACTIONS
    if (!scene->fractions) return;
    const struct lim_fraction fraction = scene->fractions[vertex];
    at_q12[0] += fraction.x_q8 * 16;
    at_q12[1] += fraction.y_q8 * 16;
    at_q12[2] += fraction.z_q8 * 16;
#endif
}

static void load_corners(struct lim_corners *corners, const struct lim_sorter *sorter, uint16_t entry)
{
    const LIM_FLASH lim_index *record = lim_entry_record(sorter, entry);

    corners->n = (uint8_t)(record[0] & LIM_POLYGON_COUNT);
    if (LIM_HAS_FAR_MOVERS && lim_movers_are_far(sorter->movers))
        *corners->exponent = lim_mover_exponent(sorter->movers, lim_entry_owner(sorter, entry));
    for (uint_fast8_t k = 0; k < corners->n; k++)
        lim_entry_corner(sorter, entry, record[LIM_POLYGON_HEAD_WORDS + k], corners->at_q12[k]);
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

/* Parts are in the frame of their whole. */
static LIM_IF_CALLED void keep_frame(struct lim_corners *front, struct lim_corners *back,
                                     const struct lim_corners *from)
{
    if (front) *front->exponent = *from->exponent;
    if (back) *back->exponent = *from->exponent;
}

/* The parts on both sides of a plane, or one: the other is NULL. false: one would have too many corners, or too few. */
static bool cut_to(struct lim_corners *front, struct lim_corners *back, const struct lim_corners *from,
                   const struct lim_plane_unpacked *plane, uint_fast16_t most)
{
    const int32_t *before = from->at_q12[from->n - 1];
    int64_t value_before = lim_corner_value(plane, before);
    struct lim_corners *parts[2] = {front, back};

    for (uint_fast8_t side = 0; side < 2; side++)
        if (parts[side]) parts[side]->n = 0;
    if (LIM_HAS_FAR_MOVERS) keep_frame(front, back, from);
    for (uint_fast8_t k = 0; k < from->n; k++) {
        const int32_t *here = from->at_q12[k];
        const int64_t value = lim_corner_value(plane, here);
        const bool leaves = value_before > 0 && value < 0, crosses = leaves || (value_before < 0 && value > 0);
        int32_t cross_q12[3] = {0, 0, 0}; /* set where it is asked for, which compilers do not always see */
        if (crosses)
            lim_plane_cross(cross_q12, leaves ? before : here, leaves ? value_before : value, leaves ? here : before,
                            leaves ? value : value_before);
        for (uint_fast8_t side = 0; side < 2; side++) {
            struct lim_corners *const part = parts[side];
            if (!part) continue;
            if (part->n + 2u > most) return false;
            if (crosses) add_corner(part, cross_q12);
            if (side ? value <= 0 : value >= 0) add_corner(part, here);
        }
        before = here;
        value_before = value;
    }
    return (!front || front->n >= 3) && (!back || back->n >= 3);
}

static bool clip_to(struct lim_corners *to, const struct lim_corners *from, const struct lim_plane_unpacked *plane,
                    bool front, uint_fast16_t most)
{
    return cut_to(front ? to : NULL, front ? NULL : to, from, plane, most);
}

const struct lim_corners *lim_corners_part(const struct lim_sorter *sorter, uint16_t entry,
                                           const struct lim_corners *whole, const struct lim_plane_unpacked *plane,
                                           bool front, struct lim_corners places[2])
{
    struct lim_corners *const part = whole == &places[0] ? &places[1] : &places[0];

    return clip_to(part, whole, plane, front, most_corners(lim_entry_scene(sorter, entry))) ? part : NULL;
}

const struct lim_corners *lim_corners_cut(const struct lim_sorter *sorter, uint16_t entry,
                                          const struct lim_plane_unpacked *plane, bool front,
                                          struct lim_corners places[2])
{
    const struct lim_corners *whole = lim_corners_of(sorter, entry, places);

    return whole ? lim_corners_part(sorter, entry, whole, plane, front, places) : NULL;
}

static bool are_of_movers(const struct lim_sorter *sorter)
{
    return LIM_HAS_MOVERS && !LIM_IS_NEWELL(&sorter->pass->target);
}

/* Whether corners are kept: of movers' pieces, and not by the smallest code. */
static bool keeps_corners(const struct lim_sorter *sorter)
{
    return !LIM_OPTIMISE_SIZE && are_of_movers(sorter);
}

static struct lim_kept_corners *kept_of(const struct lim_sorter *sorter, uint16_t cut)
{
    return &sorter->movers->kept[cut % LIM_KEPT_CORNERS];
}

static bool is_kept(const struct lim_sorter *sorter, uint16_t cut)
{
    return keeps_corners(sorter) && kept_of(sorter, cut)->cut == cut;
}

/* The cut that is `steps` before another one of a piece. */
static uint16_t cut_before(const struct lim_newell *newell, uint16_t cut, uint_fast16_t steps)
{
    for (; steps; steps--)
        cut = newell->cuts[cut].next;
    return cut;
}

/* From the whole record, or the last one of those that it was a part of whose corners are kept. Movers' are cut in the
 * order in which they were, so that they have no more corners than they had then; others the other way round. */
static const struct lim_corners *cut_corners(const struct lim_sorter *sorter, uint16_t entry,
                                             struct lim_corners places[2])
{
    const struct lim_newell *newell = sorter->newell;
    const uint_fast16_t most = most_corners(lim_entry_scene(sorter, entry));
    const struct lim_corners *here = &places[0];
    uint16_t from = newell->polygons[entry].cuts;
    uint_fast16_t count = 0;

    for (; from != LIM_NONE && !is_kept(sorter, from); from = newell->cuts[from].next)
        count++;
    if (from != LIM_NONE)
        here = &kept_of(sorter, from)->corners;
    else
        load_corners(&places[0], sorter, entry);
    for (uint_fast16_t k = 0; k < count; k++) {
        const uint16_t cut =
            cut_before(newell, newell->polygons[entry].cuts, are_of_movers(sorter) ? count - 1 - k : k);
        struct lim_corners *const there = here == &places[0] ? &places[1] : &places[0];
        struct lim_plane_unpacked plane;
        lim_plane_load_for(&plane, sorter, newell->cuts[cut].by & LIM_SORTED_MAX, entry);
        if (!clip_to(there, here, &plane, newell->cuts[cut].by & LIM_CUT_FRONT, most)) return NULL;
        here = there;
    }
    return here;
}

static const struct lim_corners *copy_corners(struct lim_corners *to, const struct lim_corners *from)
{
    to->n = from->n;
    if (LIM_HAS_FAR_MOVERS) *to->exponent = *from->exponent;
    for (uint_fast8_t k = 0; k < from->n; k++)
        for (uint_fast8_t i = 0; i < 3; i++)
            to->at_q12[k][i] = from->at_q12[k][i];
    return to;
}

/* The few pieces that a plane or a comparison is about are asked for several times. */
const struct lim_corners *lim_corners_of(const struct lim_sorter *sorter, uint16_t entry, struct lim_corners places[2])
{
    const uint16_t cut = sorter->newell->polygons[entry].cuts;

    if (cut == LIM_NONE || !keeps_corners(sorter)) return cut_corners(sorter, entry, places);
    if (is_kept(sorter, cut)) return &kept_of(sorter, cut)->corners;
    const struct lim_corners *corners = cut_corners(sorter, entry, places);
    if (!corners) return NULL;
    kept_of(sorter, cut)->cut = cut;
    return copy_corners(&kept_of(sorter, cut)->corners, corners);
}

bool lim_corners_split(const struct lim_sorter *sorter, uint16_t entry, const struct lim_plane_unpacked *plane,
                       uint16_t cut)
{
    struct lim_kept_corners *front = kept_of(sorter, cut), *back = kept_of(sorter, (uint16_t)(cut + 1));
    struct lim_corners places[2];
    const struct lim_corners *whole = lim_corners_of(sorter, entry, places);

    if (!whole) return false;
    if (whole == &front->corners || whole == &back->corners) whole = copy_corners(&places[0], whole);
    if (!cut_to(&front->corners, &back->corners, whole, plane, most_corners(lim_entry_scene(sorter, entry))))
        return false;
    front->cut = cut;
    back->cut = (uint16_t)(cut + 1);
    return true;
}

/* In steps of two units. */
static int16_t halved(int32_t at_q12, int32_t more)
{
    const int32_t half = (at_q12 >> 13) + more;

    return (int16_t)(half > INT16_MAX ? INT16_MAX : half < INT16_MIN ? INT16_MIN : half);
}

void lim_entry_set_extent(struct lim_sorter *sorter, uint16_t entry, struct lim_reach reach)
{
    struct lim_newell_polygon *polygon = &sorter->newell->polygons[entry];

    for (uint_fast8_t i = 0; i < 3; i++) {
        polygon->extent.low[i] = halved(reach.low_q12[i], 0);
        polygon->extent.high[i] = halved(reach.high_q12[i], 1);
    }
    polygon->has_extent = true;
}

#endif
