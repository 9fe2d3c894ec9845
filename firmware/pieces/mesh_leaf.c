/* SPDX-License-Identifier: MIT
 *
 * Polygons that face the eye get a key by their nearness, and lists by the upper bits of keys: each is sorted by
 * insertion, as it is short. */
#include "pieces/mesh_leaf.h"

#include "screen/edge.h"
#include "screen/project.h"
#include "view/clip.h"
#include "view/packed.h"
#include "view/pass.h"

#if LIM_HAS_MESH_LEAVES

enum { KEY_MOST = 0xFFFF };

/* Points first: some processors write them as words. */
void lim_mesh_leaf_lend(struct lim_mesh_leaf *leaf, void *mem, const struct lim_limits *limits)
{
    uint8_t *at = mem;

    leaf->points = lim_mem_cut(&at, limits->leaf_vertices * sizeof *leaf->points);
    leaf->entries = lim_mem_cut(&at, limits->leaf_polygons * sizeof *leaf->entries);
    leaf->nearness = lim_mem_cut(&at, limits->leaf_vertices * sizeof *leaf->nearness);
    leaf->list_count = LIM_MESH_LEAF_LISTS(limits->leaf_polygons);
    leaf->lists = lim_mem_cut(&at, leaf->list_count * sizeof *leaf->lists);
}

/* What faces the eye ------------------------------------------------------------------------------------------------
 */

/* What CLIP leaves of a record. */
static const struct lim_clip_polygon *
leaf_clip(struct lim_clip_polygon places[2], const struct lim_mesh_leaf_seen *seen, const LIM_FLASH lim_index *record)
{
    places[0].n = (uint8_t)(record[0] & LIM_POLYGON_COUNT);
    for (uint_fast8_t k = 0; k < places[0].n; k++) {
        lim_view_transform(seen->view, seen->scene, &seen->scene->vertices[record[LIM_POLYGON_HEAD_WORDS + k]],
                           &places[0].at[k]);
        if (LIM_HAS_WIREFRAME) lim_view_hide_edge(&places[0].at[k], false);
    }
    return lim_clip(places, seen->view->rows.near_qv);
}

static LIM_RARE bool clipped_faces(const struct lim_mesh_leaf_seen *seen, const LIM_FLASH lim_index *record)
{
    struct lim_clip_polygon places[2];
    struct lim_point at[CLIP_MAX_VERTICES];
    const struct lim_clip_polygon *clipped = leaf_clip(places, seen, record);

    for (uint_fast8_t k = 0; k < clipped->n; k++)
        lim_view_project(seen->view, &clipped->at[k], &at[k]);
    return clipped->n && lim_edge_area(at, clipped->n) < 0;
}

/* Of more corners than three, or perhaps to be clipped. */
static LIM_RARE bool polygon_faces(const struct lim_mesh_leaf *leaf, const struct lim_mesh_leaf_seen *seen,
                                   const LIM_FLASH lim_index *record)
{
    const uint8_t n = (uint8_t)(record[0] & LIM_POLYGON_COUNT);
    struct lim_point at[LIM_MAX_VERTICES];

    LIM_DEBUG_ASSERT(n <= LIM_MAX_VERTICES);
    return lim_mesh_leaf_corners(leaf, record, n, at) ? lim_edge_area(at, n) < 0 : clipped_faces(seen, record);
}

static inline int32_t leaf_least(int32_t a, int32_t b, int32_t c)
{
    const int32_t ab = a < b ? a : b;

    return ab < c ? ab : c;
}

static inline int32_t leaf_most(int32_t a, int32_t b, int32_t c)
{
    const int32_t ab = a > b ? a : b;

    return ab > c ? ab : c;
}

/* Whether there is the centre of a line, and of a column, between the corners: far away most triangles have none. */
static inline bool has_centres(lim_packed a, lim_packed b, lim_packed c)
{
    const int32_t top = lim_packed_least_y(a, b, c), bottom = lim_packed_most_y(a, b, c);
    const int32_t ax = lim_packed_x(a), bx = lim_packed_x(b), cx = lim_packed_x(c);

    return lim_edge_row((lim_edge_sub)top) != lim_edge_row((lim_edge_sub)bottom) &&
           lim_edge_row((lim_edge_sub)leaf_least(ax, bx, cx)) != lim_edge_row((lim_edge_sub)leaf_most(ax, bx, cx));
}

/* Of a triangle that is not clipped: it faces the eye, and may have pixels. */
static inline bool triangle_shows(lim_packed a, lim_packed b, lim_packed c, bool inside, bool by_samples)
{
    const bool faces = inside && !LIM_WIDE ? lim_packed_turns(a, b, c) : lim_packed_turns_far(a, b, c);

    return faces && (by_samples || has_centres(a, b, c));
}

/* Nearness of its corners -------------------------------------------------------------------------------------------
 */

/* 2^17 / 3; the sum is 3 * 2^15 at most. */
static inline uint32_t mean_of_three(uint32_t sum)
{
    return (sum * 43690u) >> 16;
}

/* Twice the mean, in 16 bits, and all OR'ed: of corners that near ones have more of. */
struct leaf_nearness {
    uint16_t mean, bits;
};

static struct leaf_nearness nearness_of_sum(uint32_t sum, uint16_t bits, uint_fast8_t n)
{
    const uint32_t mean = n == 3 ? mean_of_three(sum) : 2 * sum / n;

    return (struct leaf_nearness){(uint16_t)(mean < KEY_MOST ? mean : KEY_MOST), bits};
}

static LIM_RARE struct leaf_nearness clipped_nearness(const struct lim_mesh_leaf *leaf,
                                                      const struct lim_mesh_leaf_seen *seen,
                                                      const LIM_FLASH lim_index *record)
{
    struct lim_clip_polygon places[2];
    const struct lim_clip_polygon *clipped = leaf_clip(places, seen, record);
    uint32_t sum = 0;
    uint16_t bits = 0;

    for (uint_fast8_t k = 0; k < clipped->n; k++) {
        const uint16_t nearness = lim_view_nearness(&clipped->at[k], leaf->near_shift);
        sum += nearness;
        bits |= nearness;
    }
    return nearness_of_sum(sum, bits, clipped->n);
}

/* Of a record that faces the eye. */
static LIM_RARE struct leaf_nearness record_nearness(const struct lim_mesh_leaf *leaf,
                                                     const struct lim_mesh_leaf_seen *seen,
                                                     const LIM_FLASH lim_index *record)
{
    const uint_fast8_t n = (uint_fast8_t)(record[0] & LIM_POLYGON_COUNT);
    uint32_t sum = 0;
    uint16_t bits = 0;

    for (uint_fast8_t k = 0; k < n; k++) {
        const uint16_t nearness = leaf->nearness[record[LIM_POLYGON_HEAD_WORDS + k] - leaf->first];
        if (!nearness) return clipped_nearness(leaf, seen, record);
        sum += nearness;
        bits |= nearness;
    }
    return nearness_of_sum(sum, bits, n);
}

/* Lists -------------------------------------------------------------------------------------------------------------
 */

/* Entries in the order of the run, with twice the mean nearness for a key. */
static LIM_INLINE void list_plain(struct lim_mesh_leaf *leaf, const struct lim_mesh_leaf_seen *seen,
                                  const LIM_FLASH lim_index *record, bool inside, bool by_samples)
{
    const LIM_FLASH lim_index *const polygons = seen->scene->polygons;
    const struct lim_point *const points = leaf->points;
    const uint16_t *const nearness = leaf->nearness;
    const lim_index first = leaf->first;
    struct lim_mesh_entry *entry = leaf->entries;

    for (;;) {
        const lim_index head = record[0];
        if (LIM_UNLIKELY((head & LIM_POLYGON_COUNT) != 3)) {
            if (polygon_faces(leaf, seen, record)) {
                entry->record = (lim_index)(record - polygons);
                entry++->key = record_nearness(leaf, seen, record).mean;
            }
        } else {
            const lim_index i = (lim_index)(record[2] - first), j = (lim_index)(record[3] - first),
                            k = (lim_index)(record[4] - first);
            if (triangle_shows(lim_packed_load(&points[i]), lim_packed_load(&points[j]), lim_packed_load(&points[k]),
                               inside, by_samples)) {
                const uint32_t mean = mean_of_three((uint32_t)nearness[i] + nearness[j] + nearness[k]);
                entry->record = (lim_index)(record - polygons);
                entry++->key = (uint16_t)mean;
            }
        }
        if (head & LIM_POLYGON_LAST) break;
        record += lim_record_words(head);
    }
    leaf->used = (uint16_t)(entry - leaf->entries);
}

static LIM_ALONE void list_inside(struct lim_mesh_leaf *leaf, const struct lim_mesh_leaf_seen *seen,
                                  const LIM_FLASH lim_index *run)
{
    list_plain(leaf, seen, run, true, false);
}

/* The same where some may have to be clipped: keys wait until nearness is as fine as it gets. */
static LIM_RARE void list_clipped(struct lim_mesh_leaf *leaf, const struct lim_mesh_leaf_seen *seen,
                                  const LIM_FLASH lim_index *record, const struct lim_view_part *part)
{
    uint16_t nearest = 0;

    leaf->used = 0;
    for (;; record += lim_record_words(record[0])) {
        if (polygon_faces(leaf, seen, record)) {
            leaf->entries[leaf->used++].record = (lim_index)(record - seen->scene->polygons);
            nearest |= record_nearness(leaf, seen, record).bits;
        }
        if (record[0] & LIM_POLYGON_LAST) break;
    }
    lim_view_refine(seen->view, seen->scene, part, nearest, leaf->nearness, &leaf->near_shift);
    for (uint16_t i = 0; i < leaf->used; i++)
        leaf->entries[i].key = record_nearness(leaf, seen, &seen->scene->polygons[leaf->entries[i].record]).mean;
}

static void leaf_list(struct lim_mesh_leaf *leaf, const struct lim_mesh_leaf_seen *seen, const LIM_FLASH lim_index *run,
                      const struct lim_view_part *part)
{
    const bool by_samples = lim_is_antialiased(seen->view);

    if (leaf->extent == LIM_VIEW_CLIPPED)
        list_clipped(leaf, seen, run, part);
    else if (!LIM_OPTIMISE_SIZE && leaf->extent == LIM_VIEW_INSIDE && !by_samples)
        list_inside(leaf, seen, run);
    else
        list_plain(leaf, seen, run, leaf->extent == LIM_VIEW_INSIDE, by_samples);
}

/* Keys in the order of drawing, from 0 on. Returns how many bits they are too long by for the number of a list. */
static uint8_t turn_keys(struct lim_mesh_leaf *leaf, bool back_to_front)
{
    const struct lim_mesh_entry *const end = leaf->entries + leaf->used;
    uint16_t least = KEY_MOST, most = 0;

    for (struct lim_mesh_entry *entry = leaf->entries; entry < end; entry++) {
        if (entry->key < least) least = entry->key;
        if (entry->key > most) most = entry->key;
    }
    for (struct lim_mesh_entry *entry = leaf->entries; entry < end; entry++)
        entry->key = (uint16_t)(back_to_front ? entry->key - least : most - entry->key);
    const uint32_t range = leaf->used ? (uint32_t)(most - least) : 0;
    uint8_t shift = 0;
    while (range >> shift >= leaf->list_count)
        shift++;
    return shift;
}

/* Before those of the same key. */
static inline void leaf_insert(struct lim_mesh_leaf *leaf, uint16_t at, uint16_t *link)
{
    const uint16_t key = leaf->entries[at].key;

    while (*link != LIM_NONE && leaf->entries[*link].key < key)
        link = &leaf->entries[*link].next;
    leaf->entries[at].next = *link;
    *link = at;
}

/* Of two that are as near as each other the first one of the run is on top. */
static void fill_lists(struct lim_mesh_leaf *leaf, bool back_to_front, uint8_t shift)
{
    for (uint_fast16_t i = 0; i < leaf->list_count; i++)
        leaf->lists[i] = LIM_NONE;
    for (uint16_t i = 0; i < leaf->used; i++) {
        const uint16_t at = (uint16_t)(back_to_front ? i : leaf->used - 1 - i);
        leaf_insert(leaf, at, &leaf->lists[leaf->entries[at].key >> shift]);
    }
}

void lim_mesh_leaf_sort(struct lim_mesh_leaf *leaf, const struct lim_mesh_leaf_seen *seen,
                        const LIM_FLASH lim_index *run)
{
    const LIM_FLASH lim_index *words = lim_mesh_leaf_words(run);
    const struct lim_view_part part = {words[LIM_MESH_LEAF_FIRST], words[LIM_MESH_LEAF_COUNT],
                                       words[LIM_MESH_LEAF_BOX]};

    leaf->first = part.first;
    leaf->extent =
        (uint8_t)lim_view_all(seen->view, seen->scene, &part, leaf->points, leaf->nearness, &leaf->near_shift);
    leaf_list(leaf, seen, run, &part);
    fill_lists(leaf, seen->back_to_front, turn_keys(leaf, seen->back_to_front));
    leaf->list = 0;
}

uint16_t lim_mesh_leaf_next(struct lim_mesh_leaf *leaf)
{
    for (; leaf->list < leaf->list_count; leaf->list++) {
        const uint16_t entry = leaf->lists[leaf->list];
        if (entry == LIM_NONE) continue;
        leaf->lists[leaf->list] = leaf->entries[entry].next;
        return entry;
    }
    return LIM_NONE;
}

bool lim_mesh_leaf_project(struct lim_screen_polygon *out, const struct lim_mesh_leaf *leaf,
                           const struct lim_mesh_leaf_seen *seen, uint16_t entry, const struct lim_rect *open,
                           struct lim_stats *stats)
{
    const LIM_FLASH lim_index *record = lim_mesh_leaf_record(leaf, seen->scene, entry);

    if (!lim_mesh_leaf_corners(leaf, record, (uint8_t)(record[0] & LIM_POLYGON_COUNT), out->at))
        return lim_project(out, seen->view, seen->scene, record, open, stats);
    return lim_project_at(out, seen->view, seen->scene, record, open, stats);
}

#endif
