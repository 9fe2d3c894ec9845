/* SPDX-License-Identifier: MIT
 *
 * Polygons that face the eye get a key by their nearness, and lists by the upper bits of keys: each is sorted by
 * insertion, as it is short. */
#include "pieces/mesh_leaf.h"

#include "screen/edge.h"
#include "screen/project.h"
#include "view/packed.h"
#include "view/pass.h"

#if LIM_HAS_MESH_LEAVES

enum { KEY_MOST = 0xFFFF, LISTS_BITS = 6 };
_Static_assert(1 << LISTS_BITS == LIM_MESH_LEAF_LISTS, "a list for each value of so many bits");

/* Widest alignment first. */
void lim_mesh_leaf_lend(struct lim_mesh_leaf *leaf, void *mem, const struct lim_limits *limits)
{
    uint8_t *at = mem;

    leaf->points = lim_mem_cut(&at, limits->leaf_vertices * sizeof *leaf->points); /* some targets write whole words */
    leaf->entries = lim_mem_cut(&at, limits->leaf_polygons * sizeof *leaf->entries);
    leaf->nearness = lim_mem_cut(&at, limits->leaf_vertices * sizeof *leaf->nearness);
}

/* What faces the eye ------------------------------------------------------------------------------------------------
 */

/* What has to be clipped, as what is left of it does. */
static LIM_RARE bool clipped_faces(const struct lim_mesh_leaf_seen *seen, const LIM_FLASH lim_index *record)
{
    const struct lim_rect screen = {0, 0, (uint16_t)seen->view->width.px, (uint16_t)seen->view->height.px};
    struct lim_screen_polygon polygon;

    return lim_project(&polygon, seen->view, seen->scene, record, &screen, NULL) &&
           lim_edge_area(polygon.at, polygon.n) < 0;
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

/* Of what faces the eye, what may have pixels. */
static inline bool leaf_shows(const struct lim_mesh_leaf *leaf, const struct lim_mesh_leaf_seen *seen,
                              const LIM_FLASH lim_index *record)
{
    const LIM_FLASH lim_index *corners = record + LIM_POLYGON_HEAD_WORDS;

    if (leaf->extent == LIM_VIEW_CLIPPED || (record[0] & LIM_POLYGON_COUNT) != 3)
        return polygon_faces(leaf, seen, record);
    const lim_packed a = lim_packed_load(&leaf->points[corners[0] - leaf->first]);
    const lim_packed b = lim_packed_load(&leaf->points[corners[1] - leaf->first]);
    const lim_packed c = lim_packed_load(&leaf->points[corners[2] - leaf->first]);
    const bool faces =
        leaf->extent == LIM_VIEW_INSIDE && !LIM_WIDE ? lim_packed_turns(a, b, c) : lim_packed_turns_far(a, b, c);
    return faces && (lim_is_antialiased(seen->view) || has_centres(a, b, c));
}

/* Nearness of its corners -------------------------------------------------------------------------------------------
 */

/* A corner that has none is before the near plane, or beside the screen. */
static LIM_RARE uint16_t clipped_nearness(const struct lim_mesh_leaf *leaf, const struct lim_mesh_leaf_seen *seen,
                                          lim_index vertex)
{
    struct lim_view_point point;

    lim_view_transform(seen->view, seen->scene, &seen->scene->vertices[vertex], &point);
    if (point.z_qv < seen->view->rows.near_qv) point.z_qv = seen->view->rows.near_qv;
    return lim_view_nearness(&point, leaf->near_shift);
}

static inline uint16_t nearness_of(const struct lim_mesh_leaf *leaf, const struct lim_mesh_leaf_seen *seen,
                                   lim_index vertex)
{
    const uint16_t nearness = leaf->nearness[vertex - leaf->first];

    return leaf->extent == LIM_VIEW_CLIPPED && !nearness ? clipped_nearness(leaf, seen, vertex) : nearness;
}

/* Twice the mean. */
static inline uint16_t leaf_mean(const struct lim_mesh_leaf *leaf, const struct lim_mesh_leaf_seen *seen,
                                 const LIM_FLASH lim_index *record)
{
    const uint_fast8_t n = (uint_fast8_t)(record[0] & LIM_POLYGON_COUNT);
    uint32_t sum = 0;

    for (uint_fast8_t k = 0; k < n; k++)
        sum += nearness_of(leaf, seen, record[LIM_POLYGON_HEAD_WORDS + k]);
    const uint32_t mean =
        n == 3 ? (sum * 43690u) >> 16 : 2 * sum / n; /* 43690: 2^17 / 3; the sum is 3 * 2^15 at most */
    return (uint16_t)(mean < KEY_MOST ? mean : KEY_MOST);
}

static uint16_t nearness_bits(const struct lim_mesh_leaf *leaf, const struct lim_mesh_leaf_seen *seen,
                              const LIM_FLASH lim_index *record)
{
    uint16_t bits = 0;

    for (uint_fast8_t k = 0; k < (record[0] & LIM_POLYGON_COUNT); k++)
        bits |= nearness_of(leaf, seen, record[LIM_POLYGON_HEAD_WORDS + k]);
    return bits;
}

/* Lists -------------------------------------------------------------------------------------------------------------
 */

/* Entries in the order of the run. Returns their nearness, OR'ed, where the eye may be close. */
static uint16_t list_seen(struct lim_mesh_leaf *leaf, const struct lim_mesh_leaf_seen *seen,
                          const LIM_FLASH lim_index *record)
{
    uint16_t nearest = 0;

    leaf->used = 0;
    for (;;) {
        const lim_index head = record[0];
        if (leaf_shows(leaf, seen, record)) {
            leaf->entries[leaf->used++].record = (lim_index)(record - seen->scene->polygons);
            if (leaf->extent == LIM_VIEW_CLIPPED) nearest |= nearness_bits(leaf, seen, record);
        }
        if (head & LIM_POLYGON_LAST) return nearest;
        record += lim_record_words(head);
    }
}

/* Returns how many bits keys are too long by for the number of a list, once the least of them is taken away from all.
 */
static uint8_t set_keys(struct lim_mesh_leaf *leaf, const struct lim_mesh_leaf_seen *seen, uint16_t *least)
{
    uint16_t most = 0;

    *least = KEY_MOST;
    for (uint_fast16_t i = 0; i < leaf->used; i++) {
        struct lim_mesh_entry *entry = &leaf->entries[i];
        const uint16_t mean = leaf_mean(leaf, seen, &seen->scene->polygons[entry->record]);
        entry->key = (uint16_t)(seen->back_to_front ? mean : KEY_MOST - mean);
        if (entry->key < *least) *least = entry->key;
        if (entry->key > most) most = entry->key;
    }
    const uint32_t range = leaf->used ? (uint32_t)(most - *least) : 0;
    return (uint8_t)(range >> LISTS_BITS ? 32 - LISTS_BITS - clz_u32(range) : 0);
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
static void fill_lists(struct lim_mesh_leaf *leaf, bool back_to_front, uint8_t shift, uint16_t least)
{
    for (uint_fast8_t i = 0; i < LIM_MESH_LEAF_LISTS; i++)
        leaf->lists[i] = LIM_NONE;
    for (uint16_t i = 0; i < leaf->used; i++) {
        const uint16_t at = (uint16_t)(back_to_front ? i : leaf->used - 1 - i);
        leaf_insert(leaf, at, &leaf->lists[(leaf->entries[at].key - least) >> shift]);
    }
}

void lim_mesh_leaf_sort(struct lim_mesh_leaf *leaf, const struct lim_mesh_leaf_seen *seen,
                        const LIM_FLASH lim_index *run)
{
    const LIM_FLASH lim_index *words = lim_mesh_leaf_words(run);
    const struct lim_view_part part = {words[LIM_MESH_LEAF_FIRST], words[LIM_MESH_LEAF_COUNT],
                                       words[LIM_MESH_LEAF_BOX]};
    uint16_t least;

    leaf->first = part.first;
    leaf->extent =
        (uint8_t)lim_view_all(seen->view, seen->scene, &part, leaf->points, leaf->nearness, &leaf->near_shift);
    const uint16_t nearest = list_seen(leaf, seen, run);
    if (leaf->extent == LIM_VIEW_CLIPPED)
        lim_view_refine(seen->view, seen->scene, &part, nearest, leaf->nearness, &leaf->near_shift);
    const uint8_t shift = set_keys(leaf, seen, &least);
    fill_lists(leaf, seen->back_to_front, shift, least);
    leaf->list = 0;
}

uint16_t lim_mesh_leaf_next(struct lim_mesh_leaf *leaf)
{
    for (; leaf->list < LIM_MESH_LEAF_LISTS; leaf->list++) {
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
