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
#include "orders/order.h"

#include "pieces/piece.h"

#if LIM_HAS_PIECES

#if LIM_HAS_MOVERS
#define NO_OWNER LIM_NONE
#else
#define NO_OWNER
#endif

/* How often an entry may be compared before its part is divided: of the whole list, times its entries, which no scene
 * needs whose polygons mostly have an order; and of a part. */
enum { WHOLE_COMPARES = 4, PART_COMPARES = 2 };

/* On which sides of each other's planes two polygons lie; asked once, when it is needed. */
struct couple {
    uint16_t p, q;
    uint8_t p_sides, q_sides;
    bool known;
};

void lim_newell_set(struct lim *lim, const struct lim_newell_options *options)
{
    lim->sorter.newell.options = *options;
}

static uint16_t within(int16_t at, uint16_t end)
{
    return at < 0 ? 0 : at > (int16_t)end ? end : (uint16_t)at;
}

bool lim_newell_add(struct lim *lim, uint16_t entry, const LIM_FLASH lim_index *record, int32_t near_qv, lim_index node,
                    bool eye_in_front)
{
    const uint16_t w_px = lim->target.w_px, h_px = lim->target.h_px;
    const struct lim_rect screen = {0, 0, w_px, h_px};
    struct lim_screen_polygon polygon;

    if (!lim_project(&polygon, &lim->view, lim->scene, record, &screen, NULL)) return false;
    const struct lim_edge_shape *shape = &polygon.shape;
    const struct lim_rect rect = {within(shape->left, w_px), within(shape->top, h_px), within(shape->right, w_px),
                                  within(shape->bottom, h_px)};
    lim->sorter.newell.polygons[entry] =
        (struct lim_newell_polygon){near_qv, rect, node, LIM_NONE, eye_in_front, false, false, NO_OWNER};
    return true;
}

static struct lim_newell_polygon *polygon_of(struct lim *lim, uint16_t entry)
{
    return &lim->sorter.newell.polygons[entry];
}

static void count(struct lim *lim, enum lim_newell_test test)
{
    if (LIM_HAS_STATS) lim_stats_of(lim)->newell.decided[test]++;
}

/* A comparison. false: none is left. */
static bool spend(struct lim *lim)
{
    struct lim_newell *newell = &lim->sorter.newell;

    if (LIM_HAS_STATS) lim_stats_of(lim)->newell.comparisons++;
    if (newell->left) newell->left--;
    return newell->left;
}

static void note_forced(struct lim *lim, enum lim_forced reason)
{
    if (!LIM_HAS_STATS) return;
    lim_stats_of(lim)->newell.forced++;
    lim_stats_of(lim)->newell.forced_by[reason]++;
}

/* Front is where the eye is. */
static uint8_t seen_from_eye(uint8_t sides, bool eye_in_front)
{
    if (eye_in_front || sides == 0 || sides == LIM_SIDE_BOTH) return sides;
    return (uint8_t)(LIM_SIDE_BOTH - sides);
}

static void look_at_planes(struct lim *lim, struct couple *couple)
{
    if (couple->known) return;
    couple->known = true;
    couple->p_sides =
        seen_from_eye(lim_piece_sides(lim, couple->p, couple->q), polygon_of(lim, couple->q)->eye_in_front);
    couple->q_sides =
        seen_from_eye(lim_piece_sides(lim, couple->q, couple->p), polygon_of(lim, couple->p)->eye_in_front);
}

static bool passes(struct lim *lim, struct couple *couple, enum lim_newell_test test)
{
    const struct lim_rect *p = &polygon_of(lim, couple->p)->rect, *q = &polygon_of(lim, couple->q)->rect;

    if (test == LIM_TEST_X) return p->x1 <= q->x0 || q->x1 <= p->x0;
    if (test == LIM_TEST_Y) return p->y1 <= q->y0 || q->y1 <= p->y0;
    if (test == LIM_TEST_APART) return !lim_piece_overlaps(lim, couple->p, couple->q, LIM_SIDE_BOTH);
    look_at_planes(lim, couple);
    const bool both = couple->p_sides == LIM_SIDE_BOTH && couple->q_sides == LIM_SIDE_BOTH;
    if (test == LIM_TEST_P_PART) return both && !lim_piece_overlaps(lim, couple->p, couple->q, LIM_SIDE_FRONT);
    if (test == LIM_TEST_P_REST) return both && !lim_piece_overlaps(lim, couple->p, couple->q, LIM_SIDE_BACK);
    if (test == LIM_TEST_P_BEHIND) return !(couple->p_sides & LIM_SIDE_FRONT);
    if (test == LIM_TEST_Q_IN_FRONT) return !(couple->q_sides & LIM_SIDE_BACK);
    if (test == LIM_TEST_Q_BEHIND) return !(couple->q_sides & LIM_SIDE_FRONT);
    return !(couple->p_sides & LIM_SIDE_BACK);
}

/* Whether P may be painted before Q. */
static bool may_precede(struct lim *lim, struct couple *couple)
{
    static const LIM_FLASH uint8_t orders[2][6] = {
        {LIM_TEST_X, LIM_TEST_Y, LIM_TEST_P_BEHIND, LIM_TEST_Q_IN_FRONT, LIM_TEST_APART, LIM_TEST_P_PART},
        {LIM_TEST_P_BEHIND, LIM_TEST_Q_IN_FRONT, LIM_TEST_X, LIM_TEST_Y, LIM_TEST_APART, LIM_TEST_P_PART}};
    const LIM_FLASH uint8_t *order = orders[lim->sorter.newell.options.planes_first];

    (void)spend(lim);
    for (uint_fast8_t i = 0; i < 6; i++) {
        const enum lim_newell_test test = (enum lim_newell_test)order[i];
        if (!passes(lim, couple, test)) continue;
        count(lim, test);
        return true;
    }
    return false;
}

/* The first Q that the head P must not be painted before, in couple->q. false: none. */
static bool find_obstacle(struct lim *lim, struct couple *couple)
{
    const struct lim_sorted *list = lim->sorter.list;
    const int32_t near_qv = polygon_of(lim, couple->p)->near_qv;

    for (uint16_t q = list[couple->p].next; q != LIM_NONE; q = list[q].next) {
        if (list[q].far_qv <= near_qv) {
            if (polygon_of(lim, q)->swapped) continue;
            return false;
        }
        couple->q = q;
        couple->known = false;
        if (!may_precede(lim, couple)) return true;
    }
    return false;
}

static void unlink_entry(struct lim *lim, uint16_t entry)
{
    uint16_t *link = &lim->sorter.first;

    while (*link != entry)
        link = &lim->sorter.list[*link].next;
    *link = lim->sorter.list[entry].next;
}

/* Into its sorted place, behind what is swapped. */
static void insert(struct lim *lim, uint16_t entry)
{
    struct lim_sorted *list = lim->sorter.list;
    uint16_t *link = &lim->sorter.first;

    while (*link != LIM_NONE && (polygon_of(lim, *link)->swapped || lim_sorted_precedes(&list[*link], &list[entry])))
        link = &list[*link].next;
    list[entry].next = *link;
    *link = entry;
}

static void swap(struct lim *lim, uint16_t q)
{
    unlink_entry(lim, q);
    lim->sorter.list[q].next = lim->sorter.first;
    lim->sorter.first = q;
    polygon_of(lim, q)->swapped = true;
    if (LIM_HAS_STATS) lim_stats_of(lim)->newell.swaps++;
}

/* Splits an entry of the list and sorts both pieces in. false: no room, and nothing has changed. */
static bool split(struct lim *lim, uint16_t entry, uint16_t by)
{
    const uint16_t other = lim_piece_split(lim, entry, by);

    if (other == LIM_NONE) return false;
    if (LIM_HAS_STATS) lim_stats_of(lim)->newell.splits++;
    polygon_of(lim, entry)->swapped = polygon_of(lim, other)->swapped = false;
    unlink_entry(lim, entry);
    insert(lim, entry);
    insert(lim, other);
    return true;
}

/* Nothing waits for anything any more: a piece may be what was waited for. */
static void forget_swaps(struct lim *lim)
{
    uint16_t head;

    while ((head = lim->sorter.first) != LIM_NONE && polygon_of(lim, head)->swapped) {
        lim->sorter.first = lim->sorter.list[head].next;
        polygon_of(lim, head)->swapped = false;
        insert(lim, head);
    }
}

/* Those that lie on both sides of the other's plane. The plane stays that of the whole. */
static bool split_couple(struct lim *lim, struct couple *couple)
{
    look_at_planes(lim, couple);
    const bool p_splits = couple->p_sides == LIM_SIDE_BOTH;
    const bool q_splits = couple->q_sides == LIM_SIDE_BOTH && !(p_splits && lim->sorter.newell.options.split_one);
    bool done = false;

    if (p_splits) done = split(lim, couple->p, couple->q);
    if (q_splits) done |= split(lim, couple->q, couple->p);
    if (done) forget_swaps(lim);
    return done;
}

/* P waits for Q at the end of a circle, and neither reaches through the other's plane: some two of the circle do, for
 * polygons none of which does have an order from everywhere. */
static bool split_circle(struct lim *lim, uint16_t last)
{
    const struct lim_sorted *list = lim->sorter.list;

    for (uint16_t a = lim->sorter.first;; a = list[a].next) {
        for (uint16_t b = lim->sorter.first; b != a; b = list[b].next) {
            struct couple couple = {.p = a, .q = b};
            if (!spend(lim)) return false;
            if (split_couple(lim, &couple)) return true;
        }
        if (a == last) return false;
    }
}

/* P must not go before Q: Q goes first, or something is split. false: neither; there is no room, or a piece would have
 * too many corners, or what waits in a circle does so by no more than rounding explains. */
static bool resolve(struct lim *lim, struct couple *couple)
{
    const bool in_circle = polygon_of(lim, couple->q)->swapped;

    if (!in_circle) {
        static const LIM_FLASH uint8_t swapped[3] = {LIM_TEST_Q_BEHIND, LIM_TEST_P_IN_FRONT, LIM_TEST_P_REST};
        for (uint_fast8_t i = 0; i < 3; i++) {
            if (!passes(lim, couple, (enum lim_newell_test)swapped[i])) continue;
            count(lim, (enum lim_newell_test)swapped[i]);
            swap(lim, couple->q);
            return true;
        }
    }
    return split_couple(lim, couple) || (in_circle && split_circle(lim, couple->q));
}

/* The first entry of a list is painted next. */
static uint16_t emit(struct lim *lim, uint16_t *first, uint16_t nearest)
{
    const uint16_t entry = *first;

    *first = lim->sorter.list[entry].next;
    lim->sorter.list[entry].next = nearest;
    return entry;
}

/* Without room for pieces dividing is no help. */
static bool may_compare(const struct lim *lim, uint32_t pause)
{
    const uint32_t left = lim->sorter.newell.left;

    return left && (left > pause || !lim_piece_has_room(lim));
}

/* Orders a part until comparing has to pause, or decides nothing: a plane that divides it does. Returns the nearest of
 * what is ordered; the others stay in the list. */
static uint16_t order_part(struct lim *lim, uint16_t nearest, uint32_t pause)
{
    struct lim_sorter *sorter = &lim->sorter;

    while (sorter->first != LIM_NONE && may_compare(lim, pause)) {
        struct couple couple = {.p = sorter->first};
        if (find_obstacle(lim, &couple)) {
            if (resolve(lim, &couple)) continue;
            if (!sorter->newell.left || lim_piece_has_room(lim)) break;
            note_forced(lim, LIM_FORCED_ROOM);
        }
        nearest = emit(lim, &sorter->first, nearest);
    }
    return nearest;
}

/* Dividing ------------------------------------------------------------------------------------ */

/* Where an entry lies, as the eye sees the plane. */
enum { BEHIND, ON, BEFORE, PLACES };

/* The largest on the screen: it would be cut by most of the others. */
static uint16_t choose_divider(struct lim *lim)
{
    uint16_t chosen = lim->sorter.first;
    uint32_t most_px = 0;

    for (uint16_t at = chosen; at != LIM_NONE; at = lim->sorter.list[at].next) {
        const struct lim_rect *rect = &polygon_of(lim, at)->rect;
        const uint32_t px = (uint32_t)(rect->x1 - rect->x0) * (uint32_t)(rect->y1 - rect->y0);
        if (px <= most_px) continue;
        most_px = px;
        chosen = at;
    }
    return chosen;
}

static void newell_push(struct lim *lim, uint16_t *head, uint16_t entry)
{
    lim->sorter.list[entry].next = *head;
    *head = entry;
}

/* What cannot be split goes where its farthest point is. */
static uint_fast8_t place_uncut(struct lim *lim, uint16_t entry, uint16_t divider)
{
    const struct lim_sorted *list = lim->sorter.list;

    note_forced(lim, lim_piece_has_room(lim) ? LIM_FORCED_CORNERS : LIM_FORCED_ROOM);
    return list[entry].far_qv > list[divider].far_qv ? BEHIND : BEFORE;
}

static void place(struct lim *lim, uint16_t entry, uint16_t divider, uint16_t heads[PLACES])
{
    const bool eye_in_front = polygon_of(lim, divider)->eye_in_front;
    const uint8_t sides = seen_from_eye(lim_piece_sides(lim, entry, divider), eye_in_front);
    uint_fast8_t where = sides == 0 || entry == divider ? ON : sides == LIM_SIDE_FRONT ? BEFORE : BEHIND;

    (void)spend(lim);
    if (where != ON && sides == LIM_SIDE_BOTH) {
        const uint16_t other = lim_piece_split(lim, entry, divider);
        if (other != LIM_NONE) {
            if (LIM_HAS_STATS) lim_stats_of(lim)->newell.splits++;
            newell_push(lim, &heads[eye_in_front ? BEHIND : BEFORE], other);
            where = eye_in_front ? BEFORE : BEHIND;
        } else {
            where = place_uncut(lim, entry, divider);
        }
    }
    newell_push(lim, &heads[where], entry);
}

/* Puts a list before the rest, as one part or, each entry, as a part of its own. */
static uint16_t put_before(struct lim *lim, uint16_t first, uint16_t rest, bool each)
{
    struct lim_sorted *list = lim->sorter.list;
    uint16_t at;

    if (first == LIM_NONE) return rest;
    first = lim_sorted_sort(list, first);
    for (at = first; list[at].next != LIM_NONE; at = list[at].next)
        polygon_of(lim, at)->last = each;
    polygon_of(lim, at)->last = true;
    list[at].next = rest;
    return first;
}

/* Divides the list into parts, farthest first. What lies in the plane is in the order of records, as everywhere. */
static uint16_t newell_divide(struct lim *lim, uint16_t rest, bool is_stuck)
{
    const uint16_t divider = choose_divider(lim);
    uint16_t heads[PLACES], next;

    for (uint_fast8_t k = 0; k < PLACES; k++)
        heads[k] = LIM_NONE;
    if (LIM_HAS_STATS) lim_stats_of(lim)->newell.divisions++;
    if (LIM_HAS_STATS) lim_stats_of(lim)->newell.stuck += is_stuck;
    for (uint16_t at = lim->sorter.first; at != LIM_NONE; at = next) {
        next = lim->sorter.list[at].next;
        polygon_of(lim, at)->swapped = false;
        place(lim, at, divider, heads);
    }
    lim->sorter.first = LIM_NONE;
    for (uint16_t at = heads[ON]; at != LIM_NONE; at = lim->sorter.list[at].next)
        lim->sorter.list[at].far_qv = 0;
    rest = put_before(lim, heads[BEFORE], rest, false);
    rest = put_before(lim, heads[ON], rest, true);
    return put_before(lim, heads[BEHIND], rest, false);
}

/* Makes the first part of the rest the list. Returns how many entries it has. */
static uint16_t take_part(struct lim *lim, uint16_t *rest)
{
    struct lim_sorted *list = lim->sorter.list;
    uint16_t at = *rest, count = 1;

    for (; !polygon_of(lim, at)->last && list[at].next != LIM_NONE; at = list[at].next)
        count++;
    polygon_of(lim, at)->last = false;
    lim->sorter.first = *rest;
    *rest = list[at].next;
    list[at].next = LIM_NONE;
    return count;
}

/* No more comparisons: as they lie. */
static uint16_t emit_all(struct lim *lim, uint16_t first, uint16_t nearest)
{
    while (first != LIM_NONE) {
        note_forced(lim, LIM_FORCED_EFFORT);
        nearest = emit(lim, &first, nearest);
    }
    return nearest;
}

/* LIM_NEWELL_EFFORT times the square, or all that 32 bits count. */
static uint32_t most_for(uint16_t polygons)
{
    const uint32_t square = (uint32_t)polygons * polygons;

    return square > UINT32_MAX / LIM_NEWELL_EFFORT ? UINT32_MAX : LIM_NEWELL_EFFORT * square;
}

void lim_newell_order(struct lim *lim)
{
    struct lim_sorter *sorter = &lim->sorter;
    struct lim_newell *newell = &sorter->newell;
    uint16_t nearest = LIM_NONE, rest = sorter->first, count = 0;

    for (uint16_t at = rest; at != LIM_NONE; at = sorter->list[at].next)
        count++;
    newell->left = newell->options.most ? newell->options.most : most_for(count);
    for (uint32_t each = (uint32_t)WHOLE_COMPARES * count; rest != LIM_NONE && newell->left; each = PART_COMPARES) {
        count = take_part(lim, &rest);
        const uint32_t pause = newell->left > each * count ? newell->left - each * count : 0;
        nearest = order_part(lim, nearest, pause);
        if (sorter->first != LIM_NONE && newell->left) rest = newell_divide(lim, rest, newell->left > pause);
        nearest = emit_all(lim, sorter->first, nearest);
    }
    sorter->first = emit_all(lim, rest, nearest);
}

#endif
