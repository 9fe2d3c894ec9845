/* SPDX-License-Identifier: MIT
 *
 * The list is a row of parts, each of which may be painted before the next: at first it is one part. Within a part
 * the list begins with the swapped entries, the last one first: each waits for the one before it. Behind them all
 * is sorted. So "swapped already" is a circle, and the search for overlaps in z ends at the first sorted
 * entry that has none.
 *
 * Comparing pays as long as it seldom splits. So a part may take so many comparisons; then the largest polygon's plane
 * divides it into what lies behind, on and before it, and nothing of one part is compared with another again.
 *
 * It ends. A split is made only by a plane on both sides of which the polygon has corners, and its pieces are never
 * split by that plane again: there are as many splits at most as the planes allow, and never more than there is
 * room. Between two splits an entry leaves the list, or one more of those in it is swapped; where neither can be
 * done the list is divided, and a division takes its divider out; without room the entry leaves all the same. And
 * comparisons are counted: when there are none left, the list is painted as it is. */
#include "pieces/newell.h"

#include "pieces/piece.h"
#include "pieces/sorter.h"
#include "view/pass.h"

#if LIM_HAS_NEWELL

/* How often an entry may be compared before its part is divided: of the whole list, times its entries, which no scene
 * needs whose polygons mostly have an order; and of a part. */
enum { WHOLE_COMPARES = 4, PART_COMPARES = 2 };

/* On which sides of each other's planes two polygons lie; asked once, when it is needed. */
struct couple {
    uint16_t p, q;
    uint8_t p_sides, q_sides;
    bool known;
};

bool lim_newell_add(struct lim_sorter *sorter, uint16_t entry, int32_t near_qv, lim_index node, bool eye_in_front)
{
    sorter->newell->polygons[entry] =
        (struct lim_newell_polygon){.near_qv = near_qv, .node = node, .cuts = LIM_NONE, .eye_in_front = eye_in_front};
    return lim_piece_rect(sorter, entry);
}

static struct lim_newell_polygon *polygon_of(const struct lim_sorter *sorter, uint16_t entry)
{
    return &sorter->newell->polygons[entry];
}

static void count(struct lim_sorter *sorter, enum lim_newell_test test)
{
    if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->newell.decided[test]++;
}

/* A comparison. false: none is left. */
static bool spend(struct lim_sorter *sorter)
{
    struct lim_newell *newell = sorter->newell;

    if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->newell.comparisons++;
    if (newell->left) newell->left--;
    return newell->left;
}

static void note_forced(struct lim_sorter *sorter, enum lim_forced reason)
{
    if (!LIM_HAS_STATS) return;
    lim_stats_of(sorter->pass)->newell.forced++;
    lim_stats_of(sorter->pass)->newell.forced_by[reason]++;
}

/* Front is where the eye is. */
static uint8_t seen_from_eye(uint8_t sides, bool eye_in_front)
{
    if (eye_in_front || sides == 0 || sides == LIM_SIDE_BOTH) return sides;
    return (uint8_t)(LIM_SIDE_BOTH - sides);
}

static void look_at_planes(struct lim_sorter *sorter, struct couple *couple)
{
    if (couple->known) return;
    couple->known = true;
    couple->p_sides =
        seen_from_eye(lim_piece_sides(sorter, couple->p, couple->q), polygon_of(sorter, couple->q)->eye_in_front);
    couple->q_sides =
        seen_from_eye(lim_piece_sides(sorter, couple->q, couple->p), polygon_of(sorter, couple->p)->eye_in_front);
}

static bool are_apart_x(const struct lim_rect *p, const struct lim_rect *q)
{
    return p->x1 <= q->x0 || q->x1 <= p->x0;
}

static bool are_apart_y(const struct lim_rect *p, const struct lim_rect *q)
{
    return p->y1 <= q->y0 || q->y1 <= p->y0;
}

static bool passes(struct lim_sorter *sorter, struct couple *couple, enum lim_newell_test test)
{
    const struct lim_rect *p = &polygon_of(sorter, couple->p)->rect, *q = &polygon_of(sorter, couple->q)->rect;

    if (test == LIM_TEST_X) return are_apart_x(p, q);
    if (test == LIM_TEST_Y) return are_apart_y(p, q);
    if (test == LIM_TEST_APART) return !lim_piece_overlaps(sorter, couple->p, couple->q, LIM_SIDE_BOTH);
    look_at_planes(sorter, couple);
    const bool both = couple->p_sides == LIM_SIDE_BOTH && couple->q_sides == LIM_SIDE_BOTH;
    if (test == LIM_TEST_P_PART) return both && !lim_piece_overlaps(sorter, couple->p, couple->q, LIM_SIDE_FRONT);
    if (test == LIM_TEST_P_REST) return both && !lim_piece_overlaps(sorter, couple->p, couple->q, LIM_SIDE_BACK);
    if (test == LIM_TEST_P_BEHIND) return !(couple->p_sides & LIM_SIDE_FRONT);
    if (test == LIM_TEST_Q_IN_FRONT) return !(couple->q_sides & LIM_SIDE_BACK);
    if (test == LIM_TEST_Q_BEHIND) return !(couple->q_sides & LIM_SIDE_FRONT);
    return !(couple->p_sides & LIM_SIDE_BACK);
}

/* Whether tests 1 and 2 come first, and are asked by a function of their own: not by the smallest code. */
static bool asks_at_once(const struct lim_sorter *sorter)
{
    return !LIM_OPTIMISE_SIZE && !sorter->newell->options.planes_first;
}

/* Whether P may be painted before Q. */
static bool may_precede(struct lim_sorter *sorter, struct couple *couple)
{
    static const LIM_FLASH uint8_t orders[2][6] = {
        {LIM_TEST_X, LIM_TEST_Y, LIM_TEST_P_BEHIND, LIM_TEST_Q_IN_FRONT, LIM_TEST_APART, LIM_TEST_P_PART},
        {LIM_TEST_P_BEHIND, LIM_TEST_Q_IN_FRONT, LIM_TEST_X, LIM_TEST_Y, LIM_TEST_APART, LIM_TEST_P_PART}};
    const LIM_FLASH uint8_t *order = orders[sorter->newell->options.planes_first];

    for (uint_fast8_t i = asks_at_once(sorter) ? 2 : 0; i < 6; i++) { /* else is_apart() has said no */
        const enum lim_newell_test test = (enum lim_newell_test)order[i];
        if (!passes(sorter, couple, test)) continue;
        count(sorter, test);
        return true;
    }
    return false;
}

/* Tests 1 and 2, which decide nearly all, at once. */
static inline bool is_apart(struct lim_sorter *sorter, uint16_t p, uint16_t q)
{
    const struct lim_rect *p_rect = &polygon_of(sorter, p)->rect, *q_rect = &polygon_of(sorter, q)->rect;
    const bool apart_x = are_apart_x(p_rect, q_rect);

    if (!apart_x && !are_apart_y(p_rect, q_rect)) return false;
    count(sorter, apart_x ? LIM_TEST_X : LIM_TEST_Y);
    return true;
}

/* The first Q that the head P must not be painted before, in couple->q. false: none. */
static bool find_obstacle(struct lim_sorter *sorter, struct couple *couple)
{
    const struct lim_sorted *list = sorter->list;
    const int32_t near_qv = polygon_of(sorter, couple->p)->near_qv;
    const bool rects_first = asks_at_once(sorter);

    for (uint16_t q = list[couple->p].next; q != LIM_NONE; q = list[q].next) {
        if (list[q].far_qv <= near_qv) {
            if (polygon_of(sorter, q)->swapped) continue;
            return false;
        }
        (void)spend(sorter);
        if (rects_first && is_apart(sorter, couple->p, q)) continue;
        couple->q = q;
        couple->known = false;
        if (!may_precede(sorter, couple)) return true;
    }
    return false;
}

static void unlink_entry(struct lim_sorter *sorter, uint16_t entry)
{
    uint16_t *link = &sorter->first;

    while (*link != entry)
        link = &sorter->list[*link].next;
    *link = sorter->list[entry].next;
}

/* Into its sorted place, behind what is swapped. */
static void insert(struct lim_sorter *sorter, uint16_t entry)
{
    struct lim_sorted *list = sorter->list;
    uint16_t *link = &sorter->first;

    while (*link != LIM_NONE && (polygon_of(sorter, *link)->swapped || lim_sorted_precedes(&list[*link], &list[entry])))
        link = &list[*link].next;
    list[entry].next = *link;
    *link = entry;
}

static void swap(struct lim_sorter *sorter, uint16_t q)
{
    unlink_entry(sorter, q);
    sorter->list[q].next = sorter->first;
    sorter->first = q;
    polygon_of(sorter, q)->swapped = true;
    if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->newell.swaps++;
}

/* Splits an entry of the list and sorts both pieces in. false: no room, and nothing has changed. */
static bool split(struct lim_sorter *sorter, uint16_t entry, uint16_t by)
{
    const uint16_t other = lim_piece_split(sorter, entry, by);

    if (other == LIM_NONE) return false;
    if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->newell.splits++;
    polygon_of(sorter, entry)->swapped = polygon_of(sorter, other)->swapped = false;
    unlink_entry(sorter, entry);
    insert(sorter, entry);
    insert(sorter, other);
    return true;
}

/* Nothing waits for anything any more: a piece may be what was waited for. */
static void forget_swaps(struct lim_sorter *sorter)
{
    uint16_t head;

    while ((head = sorter->first) != LIM_NONE && polygon_of(sorter, head)->swapped) {
        sorter->first = sorter->list[head].next;
        polygon_of(sorter, head)->swapped = false;
        insert(sorter, head);
    }
}

/* Those that lie on both sides of the other's plane. The plane stays that of the whole. */
static bool split_couple(struct lim_sorter *sorter, struct couple *couple)
{
    look_at_planes(sorter, couple);
    const bool p_splits = couple->p_sides == LIM_SIDE_BOTH;
    const bool q_splits = couple->q_sides == LIM_SIDE_BOTH && !(p_splits && sorter->newell->options.split_one);
    bool done = false;

    if (p_splits) done = split(sorter, couple->p, couple->q);
    if (q_splits) done |= split(sorter, couple->q, couple->p);
    if (done) forget_swaps(sorter);
    return done;
}

/* P waits for Q at the end of a circle, and neither reaches through the other's plane: some two of the circle do, for
 * polygons none of which does have an order from everywhere. */
static bool split_circle(struct lim_sorter *sorter, uint16_t last)
{
    const struct lim_sorted *list = sorter->list;

    for (uint16_t a = sorter->first;; a = list[a].next) {
        for (uint16_t b = sorter->first; b != a; b = list[b].next) {
            struct couple couple = {.p = a, .q = b};
            if (!spend(sorter)) return false;
            if (split_couple(sorter, &couple)) return true;
        }
        if (a == last) return false;
    }
}

/* P must not go before Q: Q goes first, or something is split. false: neither; there is no room, or a piece would have
 * too many corners, or what waits in a circle does so by no more than rounding explains. */
static bool resolve(struct lim_sorter *sorter, struct couple *couple)
{
    const bool in_circle = polygon_of(sorter, couple->q)->swapped;

    if (!in_circle) {
        static const LIM_FLASH uint8_t swapped[3] = {LIM_TEST_Q_BEHIND, LIM_TEST_P_IN_FRONT, LIM_TEST_P_REST};
        for (uint_fast8_t i = 0; i < 3; i++) {
            if (!passes(sorter, couple, (enum lim_newell_test)swapped[i])) continue;
            count(sorter, (enum lim_newell_test)swapped[i]);
            swap(sorter, couple->q);
            return true;
        }
    }
    return split_couple(sorter, couple) || (in_circle && split_circle(sorter, couple->q));
}

/* The first entry of a list is painted next. */
static uint16_t emit(struct lim_sorter *sorter, uint16_t *first, uint16_t nearest)
{
    const uint16_t entry = *first;

    *first = sorter->list[entry].next;
    sorter->list[entry].next = nearest;
    return entry;
}

/* Without room for pieces dividing is no help. */
static bool may_compare(const struct lim_sorter *sorter, uint32_t pause)
{
    const uint32_t left = sorter->newell->left;

    return left && (left > pause || !lim_piece_has_room(sorter));
}

/* Orders a part until comparing has to pause, or decides nothing: a plane that divides it does. Returns the nearest of
 * what is ordered; the others stay in the list. */
static uint16_t order_part(struct lim_sorter *sorter, uint16_t nearest, uint32_t pause)
{
    while (sorter->first != LIM_NONE && may_compare(sorter, pause)) {
        struct couple couple = {.p = sorter->first};
        if (find_obstacle(sorter, &couple)) {
            if (resolve(sorter, &couple)) continue;
            if (!sorter->newell->left || lim_piece_has_room(sorter)) break;
            note_forced(sorter, LIM_FORCED_ROOM);
        }
        nearest = emit(sorter, &sorter->first, nearest);
    }
    return nearest;
}

/* Dividing ------------------------------------------------------------------------------------ */

/* Where an entry lies, as the eye sees the plane. */
enum { BEHIND, ON, BEFORE, PLACES };

/* The largest on the screen: it would be cut by most of the others. */
static uint16_t choose_divider(struct lim_sorter *sorter)
{
    uint16_t chosen = sorter->first;
    uint32_t most_px = 0;

    for (uint16_t at = chosen; at != LIM_NONE; at = sorter->list[at].next) {
        const struct lim_rect *rect = &polygon_of(sorter, at)->rect;
        const uint32_t px = (uint32_t)(rect->x1 - rect->x0) * (uint32_t)(rect->y1 - rect->y0);
        if (px <= most_px) continue;
        most_px = px;
        chosen = at;
    }
    return chosen;
}

static void newell_push(struct lim_sorter *sorter, uint16_t *head, uint16_t entry)
{
    sorter->list[entry].next = *head;
    *head = entry;
}

/* What cannot be split goes where its farthest point is. */
static uint_fast8_t place_uncut(struct lim_sorter *sorter, uint16_t entry, uint16_t divider)
{
    const struct lim_sorted *list = sorter->list;

    note_forced(sorter, lim_piece_has_room(sorter) ? LIM_FORCED_CORNERS : LIM_FORCED_ROOM);
    return list[entry].far_qv > list[divider].far_qv ? BEHIND : BEFORE;
}

static void place(struct lim_sorter *sorter, uint16_t entry, uint16_t divider, uint16_t heads[PLACES])
{
    const bool eye_in_front = polygon_of(sorter, divider)->eye_in_front;
    const uint8_t sides = seen_from_eye(lim_piece_sides(sorter, entry, divider), eye_in_front);
    uint_fast8_t where = sides == 0 || entry == divider ? ON : sides == LIM_SIDE_FRONT ? BEFORE : BEHIND;

    (void)spend(sorter);
    if (where != ON && sides == LIM_SIDE_BOTH) {
        const uint16_t other = lim_piece_split(sorter, entry, divider);
        if (other != LIM_NONE) {
            if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->newell.splits++;
            newell_push(sorter, &heads[eye_in_front ? BEHIND : BEFORE], other);
            where = eye_in_front ? BEFORE : BEHIND;
        } else {
            where = place_uncut(sorter, entry, divider);
        }
    }
    newell_push(sorter, &heads[where], entry);
}

/* Puts a list before the rest, as one part or, each entry, as a part of its own. */
static uint16_t put_before(struct lim_sorter *sorter, uint16_t first, uint16_t rest, bool each)
{
    struct lim_sorted *list = sorter->list;
    uint16_t at;

    if (first == LIM_NONE) return rest;
    first = lim_sorted_sort(list, first);
    for (at = first; list[at].next != LIM_NONE; at = list[at].next)
        polygon_of(sorter, at)->last = each;
    polygon_of(sorter, at)->last = true;
    list[at].next = rest;
    return first;
}

/* Divides the list into parts, farthest first. What lies in the plane is in the order of records, as everywhere. */
static uint16_t newell_divide(struct lim_sorter *sorter, uint16_t rest, bool is_stuck)
{
    const uint16_t divider = choose_divider(sorter);
    uint16_t heads[PLACES], next;

    for (uint_fast8_t k = 0; k < PLACES; k++)
        heads[k] = LIM_NONE;
    if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->newell.divisions++;
    if (LIM_HAS_STATS) lim_stats_of(sorter->pass)->newell.stuck += is_stuck;
    for (uint16_t at = sorter->first; at != LIM_NONE; at = next) {
        next = sorter->list[at].next;
        polygon_of(sorter, at)->swapped = false;
        place(sorter, at, divider, heads);
    }
    sorter->first = LIM_NONE;
    for (uint16_t at = heads[ON]; at != LIM_NONE; at = sorter->list[at].next)
        sorter->list[at].far_qv = 0;
    rest = put_before(sorter, heads[BEFORE], rest, false);
    rest = put_before(sorter, heads[ON], rest, true);
    return put_before(sorter, heads[BEHIND], rest, false);
}

/* Makes the first part of the rest the list. Returns how many entries it has. */
static uint16_t next_part(struct lim_sorter *sorter, uint16_t *rest)
{
    struct lim_sorted *list = sorter->list;
    uint16_t at = *rest, count = 1;

    for (; !polygon_of(sorter, at)->last && list[at].next != LIM_NONE; at = list[at].next)
        count++;
    polygon_of(sorter, at)->last = false;
    sorter->first = *rest;
    *rest = list[at].next;
    list[at].next = LIM_NONE;
    return count;
}

/* No more comparisons: as they lie. */
static uint16_t emit_all(struct lim_sorter *sorter, uint16_t first, uint16_t nearest)
{
    while (first != LIM_NONE) {
        note_forced(sorter, LIM_FORCED_EFFORT);
        nearest = emit(sorter, &first, nearest);
    }
    return nearest;
}

/* LIM_NEWELL_EFFORT times the square, or all that 32 bits count. */
static uint32_t most_for(uint16_t polygons)
{
    const uint32_t square = (uint32_t)polygons * polygons;

    return square > UINT32_MAX / LIM_NEWELL_EFFORT ? UINT32_MAX : LIM_NEWELL_EFFORT * square;
}

void lim_newell_order(struct lim_sorter *sorter)
{
    struct lim_newell *newell = sorter->newell;
    uint16_t nearest = LIM_NONE, rest = sorter->first, count = 0;

    for (uint16_t at = rest; at != LIM_NONE; at = sorter->list[at].next)
        count++;
    newell->left = newell->options.most ? newell->options.most : most_for(count);
    for (uint32_t each = (uint32_t)WHOLE_COMPARES * count; rest != LIM_NONE && newell->left; each = PART_COMPARES) {
        count = next_part(sorter, &rest);
        const uint32_t pause = newell->left > each * count ? newell->left - each * count : 0;
        nearest = order_part(sorter, nearest, pause);
        if (sorter->first != LIM_NONE && newell->left) rest = newell_divide(sorter, rest, newell->left > pause);
        nearest = emit_all(sorter, sorter->first, nearest);
    }
    sorter->first = emit_all(sorter, rest, nearest);
}

#endif
