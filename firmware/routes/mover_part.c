/* SPDX-License-Identifier: MIT
 *
 * Sides are those of whole polygons: what a plane does not cross it does not trace. */
#include "routes/mover_part.h"

#include "pieces/corners.h"
#include "pieces/entry.h"
#include "pieces/piece.h"

#if LIM_HAS_MOVERS

/* Q14 and the object's units, more than all that is left out: the normal's fraction, and a vertex's; what lies within
 * the plane's slack; the rounding of a corner in its place. */
#define DOUBT_Q14 (3 * INT32_C(32768) + 6 * INT32_C(16384))
#define DOUBT_A_UNIT_Q14 (4 * INT32_C(16384))

enum { TURNED_BITS_MAX = 3 };

static int32_t saturate(int64_t x)
{
    return x > INT32_MAX ? INT32_MAX : x < INT32_MIN ? INT32_MIN : (int32_t)x;
}

/* With n < 2^(32 - spare), n_q14 is a normal of a length below sqrt(3) 2^14, and products with a vertex add up to less
 * than 3 * 2^29; offsets stay below 2^62. */
void lim_plane_turn(struct lim_turned_plane *turned, const struct lim_instance *instance,
                    const struct lim_plane_unpacked *plane)
{
    const int32_t *n = plane->n;
    const uint8_t axis = plane->axis;
    const uint8_t spare = axis != LIM_NO_AXIS ? 31 : clz_u32(abs_s32(n[0]) | abs_s32(n[1]) | abs_s32(n[2]));
    int64_t offset_q8 = plane->d * 256;

    if (LIM_HAS_LONG && instance->finer_bits > TURNED_BITS_MAX) { /* in a long scene, far away: nothing is certain */
        turned->n_q14[0] = turned->n_q14[1] = turned->n_q14[2] = 0;
        turned->front_q14 = INT32_MAX;
        turned->back_q14 = INT32_MIN;
        return;
    }
    for (uint_fast8_t i = 0; i < 3; i++) {
        if (axis != LIM_NO_AXIS) { /* the same, of a normal of 1 */
            turned->n_q14[i] = instance->axes_q30[3 * i + axis] >> 17;
            continue;
        }
        int64_t sum = 0;
        for (uint_fast8_t k = 0; k < 3; k++)
            sum += (int64_t)instance->axes_q30[3 * i + k] * n[k];
        turned->n_q14[i] = (int32_t)(sum >> (48 - spare));
        offset_q8 -= (int64_t)n[i] * instance->at_q8[i];
    }
    if (axis != LIM_NO_AXIS) offset_q8 -= instance->at_q8[axis];
    offset_q8 *= INT32_C(1) << instance->finer_bits;
    const int64_t offset_q14 = spare > 26 ? offset_q8 * (INT64_C(1) << (spare - 26)) : offset_q8 >> (26 - spare);
    int64_t doubt_q14 = DOUBT_Q14 + (DOUBT_A_UNIT_Q14 * (INT64_C(1) << instance->finer_bits));
    if (LIM_HAS_LONG) { /* a slack may be more than a unit */
        const int64_t slack_q8 = plane->slack * (INT64_C(256) << instance->finer_bits);
        doubt_q14 += spare > 26 ? slack_q8 * (INT64_C(1) << (spare - 26)) : slack_q8 >> (26 - spare);
    }
    turned->front_q14 = saturate(offset_q14 + doubt_q14);
    turned->back_q14 = saturate(offset_q14 - doubt_q14);
}

static void turn_plane_of(struct lim_turned_plane *turned, const struct lim_sorter *sorter, uint16_t owner, uint16_t by)
{
    struct lim_plane_unpacked plane;

    lim_plane_load(&plane, sorter, by);
    lim_plane_bring_for(&plane, sorter, by, owner);
    lim_plane_turn(turned, &sorter->movers->instances[owner], &plane);
}

void lim_part_begin(struct lim_part *part, const struct lim_sorter *sorter, uint16_t entry)
{
    uint16_t cut = part->cuts = sorter->newell->polygons[entry].cuts;

    for (uint_fast8_t k = 0; k < LIM_PART_PLANES && cut != LIM_NONE; k++, cut = sorter->newell->cuts[cut].next)
        turn_plane_of(&part->planes[k], sorter, lim_entry_owner(sorter, entry),
                      sorter->newell->cuts[cut].by & LIM_SORTED_MAX);
}

/* 0: it is not certain. */
static uint8_t sides_by_far(const struct lim_sorter *sorter, const struct lim_turned_plane *plane, uint16_t entry)
{
    const LIM_FLASH struct lim_vertex *vertices = lim_entry_scene(sorter, entry)->vertices;
    const LIM_FLASH lim_index *record = lim_entry_record(sorter, entry);
    struct lim_turned_range range = {INT32_MAX, INT32_MIN};

    for (uint_fast8_t k = 0; k < (record[0] & LIM_POLYGON_COUNT); k++) {
        const struct lim_vertex at = vertices[record[LIM_POLYGON_HEAD_WORDS + k]];
        lim_turned_add(&range, plane, &at);
    }
    return lim_turned_sides(&range, plane);
}

/* The sides of a cut's plane that an entry reaches to; what lies in it is where the eye is. */
static uint8_t sides_of_cut(const struct lim_sorter *sorter, uint16_t by, uint16_t entry)
{
    struct lim_plane_unpacked plane;

    lim_plane_load_for(&plane, sorter, by, entry);
    const uint8_t sides = lim_piece_sides_of(sorter, entry, &plane);
    if (sides) return sides;
    return sorter->newell->polygons[by].eye_in_front ? LIM_SIDE_FRONT : LIM_SIDE_BACK;
}

enum lim_part_share lim_part_take(const struct lim_part *part, struct lim_sorter *sorter, uint16_t entry)
{
    struct lim_newell *newell = sorter->newell;
    const uint16_t used = newell->cuts_used;
    uint16_t cuts = LIM_NONE, *link = &cuts;
    uint_fast8_t k = 0;

    newell->polygons[entry].cuts = LIM_NONE;
    for (uint16_t cut = part->cuts; cut != LIM_NONE; cut = newell->cuts[cut].next, k++) {
        const uint16_t by = newell->cuts[cut].by;
        const uint8_t own = by & LIM_CUT_FRONT ? LIM_SIDE_FRONT : LIM_SIDE_BACK;
        uint8_t sides = k < LIM_PART_PLANES ? sides_by_far(sorter, &part->planes[k], entry) : 0;
        if (!sides) sides = sides_of_cut(sorter, by & LIM_SORTED_MAX, entry);
        if (sides == own) continue;
        if (sides != LIM_SIDE_BOTH) {
            newell->cuts_used = used;
            return LIM_PART_NOTHING;
        }
        if (newell->cuts_used == newell->cut_size) { /* more of it is drawn than belongs here */
            if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->movers.forced++;
            continue;
        }
        newell->cuts[newell->cuts_used] = (struct lim_cut){LIM_NONE, by};
        *link = newell->cuts_used;
        link = &newell->cuts[newell->cuts_used++].next;
    }
    newell->polygons[entry].cuts = cuts;
    return cuts == LIM_NONE ? LIM_PART_ALL : LIM_PART_PIECE;
}

#endif
