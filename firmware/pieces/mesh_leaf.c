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
    leaf->size = limits->leaf_polygons;
    leaf->list_count = LIM_MESH_LEAF_LISTS(limits->leaf_polygons);
    leaf->lists = lim_mem_cut(&at, leaf->list_count * sizeof *leaf->lists);
}

/* What faces the eye ----------------------------------------------------------------------------------------------- */

/* What CLIP leaves of a record. */
static const struct lim_clip_polygon *
leaf_clip(struct lim_clip_polygon places[2], const struct lim_mesh_leaf_seen *seen, const LIM_FLASH lim_index *record)
{
    lim_clip_load(&places[0], seen->view, seen->scene, record + LIM_POLYGON_HEAD_WORDS,
                  (uint8_t)(record[0] & LIM_POLYGON_COUNT));
    return lim_clip(places, seen->view->rows.near_qv);
}

/* Most of what would have to be clipped lies behind the eye, or beside the screen. */
static bool is_outside(const struct lim_mesh_leaf *leaf, const LIM_FLASH lim_index *record)
{
    uint_fast8_t codes = LIM_VIEW_OUTSIDE;

    for (uint_fast8_t k = 0; k < (record[0] & LIM_POLYGON_COUNT); k++) {
        const lim_index vertex = (lim_index)(record[LIM_POLYGON_HEAD_WORDS + k] - leaf->first);
        codes &= lim_project_codes(leaf->seen.view, leaf->points[vertex], leaf->nearness[vertex]);
    }
    return codes;
}

static LIM_RARE bool clipped_shows(const struct lim_mesh_leaf *leaf, const LIM_FLASH lim_index *record)
{
    struct lim_clip_polygon places[2];
    struct lim_point at[CLIP_MAX_VERTICES];

    if (is_outside(leaf, record)) return false;
    const struct lim_clip_polygon *clipped = leaf_clip(places, &leaf->seen, record);
    for (uint_fast8_t k = 0; k < clipped->n; k++)
        lim_view_project(leaf->seen.view, &clipped->at[k], &at[k]);
    return clipped->n && lim_edge_area(at, clipped->n) < 0;
}

/* Of more corners than three, or perhaps to be clipped. */
static LIM_RARE bool polygon_shows(const struct lim_mesh_leaf *leaf, const LIM_FLASH lim_index *record)
{
    const uint8_t n = (uint8_t)(record[0] & LIM_POLYGON_COUNT);
    struct lim_point at[LIM_MAX_VERTICES];

    LIM_DEBUG_ASSERT(n <= LIM_MAX_VERTICES);
    return lim_mesh_leaf_corners(leaf, record, n, at) ? lim_edge_area(at, n) < 0 : clipped_shows(leaf, record);
}

/* Whether centres lie from one coordinate to before another, on the screen; `inside`: both are on it. */
static inline bool has_centre(int32_t from, int32_t to, int32_t side_px, bool inside)
{
    const int32_t first = lim_edge_pixel(from), end = lim_edge_pixel(to);

    return first != end && (inside || (end > 0 && first < side_px));
}

/* Of a triangle that is not clipped: it faces the eye, and there is the centre of a line, and of a column, between its
 * corners. Far away most triangles have none. */
static inline bool triangle_shows(const struct lim_view *view, lim_packed a, lim_packed b, lim_packed c, bool inside,
                                  bool by_samples)
{
    const bool faces = inside && !LIM_WIDE ? lim_packed_turns(a, b, c) : lim_packed_turns_far(a, b, c);

    if (!faces || by_samples) return faces;
    return has_centre(lim_packed_least_y(a, b, c), lim_packed_most_y(a, b, c), view->height.px, inside) &&
           has_centre(lim_packed_least_x(a, b, c), lim_packed_most_x(a, b, c), view->width.px, inside);
}

/* Nearness of its corners ------------------------------------------------------------------------------------------ */

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
    const uint32_t mean = n == 3 ? mean_of_three(sum) : n == 4 ? sum >> 1 : 2 * sum / n;

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

/* Lists ------------------------------------------------------------------------------------------------------------ */

/* What is drawn first has the lower key. */
static inline uint16_t key_of(const struct lim_mesh_leaf_seen *seen, uint32_t mean)
{
    return (uint16_t)(seen->back_to_front ? mean : KEY_MOST - mean);
}

static inline void add_entry_at(struct lim_mesh_entry *entry, const struct lim_mesh_leaf_seen *seen,
                                const LIM_FLASH lim_index *record, uint32_t mean)
{
    entry->record = (lim_index)(record - seen->scene->polygons);
    entry->key = key_of(seen, mean);
}

/* What is known of a polygon's corners, one after the other. */
struct leaf_outline {
    int32_t left, right, top, bottom;
    int32_t ux, uy; /* from the first corner to the one before */
    int64_t area;   /* twice that so far: negative where it faces the eye */
    uint32_t nearness;
};

static inline void outline_add(struct leaf_outline *outline, int32_t x, int32_t y, const struct lim_point *first,
                               bool inside)
{
    const int32_t vx = x - first->x, vy = y - first->y;

    outline->area += inside && !LIM_WIDE ? (int64_t)(outline->ux * vy) - outline->uy * vx
                                         : (int64_t)outline->ux * vy - (int64_t)outline->uy * vx;
    outline->ux = vx;
    outline->uy = vy;
    if (x < outline->left) outline->left = x;
    if (x > outline->right) outline->right = x;
    if (y < outline->top) outline->top = y;
    if (y > outline->bottom) outline->bottom = y;
}

static bool polygon_mean(const struct lim_mesh_leaf *leaf, const LIM_FLASH lim_index *record, uint32_t *mean);

/* triangle_shows() for more corners; and the mean of their nearness. */
static LIM_INLINE bool outline_mean(const struct lim_mesh_leaf *leaf, const LIM_FLASH lim_index *record, bool inside,
                                    uint32_t *mean)
{
    const uint_fast8_t n = (uint_fast8_t)(record[0] & LIM_POLYGON_COUNT);
    const struct lim_point first = leaf->points[record[LIM_POLYGON_HEAD_WORDS] - leaf->first];
    const struct lim_view *const view = leaf->seen.view;
    struct leaf_outline outline = {first.x, first.x, first.y, first.y, 0, 0, 0, 0};

    for (uint_fast8_t k = 0; k < n; k++) {
        const lim_index vertex = (lim_index)(record[LIM_POLYGON_HEAD_WORDS + k] - leaf->first);
        const uint16_t nearness = leaf->nearness[vertex];
        if (!inside && !nearness) return polygon_mean(leaf, record, mean);
        outline_add(&outline, leaf->points[vertex].x, leaf->points[vertex].y, &first, inside);
        outline.nearness += nearness;
    }
    if (outline.area >= 0) return false;
    *mean = nearness_of_sum(outline.nearness, 0, n).mean;
    return has_centre(outline.top, outline.bottom, view->height.px, inside) &&
           has_centre(outline.left, outline.right, view->width.px, inside);
}

/* Whether a polygon shows, and then the mean nearness of its corners. */
static LIM_RARE bool polygon_mean(const struct lim_mesh_leaf *leaf, const LIM_FLASH lim_index *record, uint32_t *mean)
{
    if (!polygon_shows(leaf, record)) return false;
    *mean = record_nearness(leaf, &leaf->seen, record).mean;
    return true;
}

/* Words of a record, which has no plane, no alpha and no flags of edges. */
static inline size_t leaf_record_words(lim_index head)
{
    return lim_record_words(head & (LIM_POLYGON_COUNT | LIM_POLYGON_MESH | LIM_POLYGON_TEXTURE));
}

/* All that show, in the order of the run. false: there is no room. */
static LIM_INLINE bool list_plain(struct lim_mesh_leaf *leaf, uint8_t extent, bool by_samples)
{
    const struct lim_mesh_leaf_seen seen = leaf->seen;
    const struct lim_point *const points = leaf->points;
    const uint16_t *const nearness = leaf->nearness;
    const lim_index vertex = leaf->first;
    const LIM_FLASH lim_index *record = leaf->run;
    struct lim_mesh_entry *entry = leaf->entries, *const end = entry + leaf->size;

    for (;;) {
        const lim_index head = record[0];
        const lim_index i = (lim_index)(record[2] - vertex), j = (lim_index)(record[3] - vertex),
                        k = (lim_index)(record[4] - vertex);
        const bool is_plain = (head & LIM_POLYGON_COUNT) == 3 &&
                              (extent != LIM_VIEW_CLIPPED || (nearness[i] && nearness[j] && nearness[k]));
        uint32_t mean = 0;
        bool shows;
        if (!is_plain) {
            shows = by_samples ? polygon_mean(leaf, record, &mean)
                               : outline_mean(leaf, record, extent == LIM_VIEW_INSIDE, &mean);
        } else {
            shows = triangle_shows(seen.view, lim_packed_load(&points[i]), lim_packed_load(&points[j]),
                                   lim_packed_load(&points[k]), extent == LIM_VIEW_INSIDE, by_samples);
            if (shows) mean = mean_of_three((uint32_t)nearness[i] + nearness[j] + nearness[k]);
        }
        if (shows) {
            if (entry == end) return false;
            add_entry_at(entry++, &seen, record, mean);
        }
        if (head & LIM_POLYGON_LAST) break;
        record += leaf_record_words(head);
    }
    leaf->used = (uint16_t)(entry - leaf->entries);
    return true;
}

static LIM_ALONE bool list_inside(struct lim_mesh_leaf *leaf)
{
    return list_plain(leaf, LIM_VIEW_INSIDE, false);
}

/* A place in the order of drawing. Of two that are as near as each other the first one of the run is on top. */
static int64_t place_of(const struct lim_mesh_leaf_seen *seen, const LIM_FLASH lim_index *record, uint16_t key)
{
    const uint32_t at = (uint32_t)(record - seen->scene->polygons);

    return key * (INT64_C(1) << 32) + (seen->back_to_front ? UINT32_MAX - at : at);
}

enum { PLACE_BITS = 48 };

static bool leaf_shows(const struct lim_mesh_leaf *leaf, const LIM_FLASH lim_index *record)
{
    const lim_index i = (lim_index)(record[2] - leaf->first), j = (lim_index)(record[3] - leaf->first),
                    k = (lim_index)(record[4] - leaf->first);
    const uint16_t *nearness = leaf->nearness;
    const struct lim_point *points = leaf->points;

    if ((record[0] & LIM_POLYGON_COUNT) != 3 || !nearness[i] || !nearness[j] || !nearness[k])
        return polygon_shows(leaf, record);
    return triangle_shows(leaf->seen.view, lim_packed_load(&points[i]), lim_packed_load(&points[j]),
                          lim_packed_load(&points[k]), leaf->extent == LIM_VIEW_INSIDE,
                          lim_is_antialiased(leaf->seen.view));
}

/* Those whose places are from leaf->from to before leaf->end, as many as there are. false: there is no room. */
static LIM_RARE bool list_between(struct lim_mesh_leaf *leaf)
{
    leaf->used = 0;
    for (const LIM_FLASH lim_index *record = leaf->run;; record += leaf_record_words(record[0])) {
        if (leaf_shows(leaf, record)) {
            const uint16_t mean = record_nearness(leaf, &leaf->seen, record).mean;
            const int64_t place = place_of(&leaf->seen, record, key_of(&leaf->seen, mean));
            if (place >= leaf->from && place < leaf->end) {
                if (leaf->used == leaf->size) return false;
                add_entry_at(&leaf->entries[leaf->used++], &leaf->seen, record, mean);
            }
        }
        if (record[0] & LIM_POLYGON_LAST) return true;
    }
}

/* From leaf->from on as many as there is room for: parts of the order are halved until one fits. */
static LIM_RARE void list_some(struct lim_mesh_leaf *leaf)
{
    while (!list_between(leaf)) {
        leaf->end = leaf->from + (leaf->end - leaf->from) / 2;
        leaf->is_partial = true;
    }
}

/* Nearness as fine as it gets, before keys are made of it. */
static LIM_RARE void refine_nearness(struct lim_mesh_leaf *leaf, const struct lim_view_part *part)
{
    uint16_t seen = 0;

    for (const LIM_FLASH lim_index *record = leaf->run;; record += leaf_record_words(record[0])) {
        if (leaf_shows(leaf, record)) seen |= record_nearness(leaf, &leaf->seen, record).bits;
        if (record[0] & LIM_POLYGON_LAST) break;
    }
    lim_view_refine(leaf->seen.view, leaf->seen.scene, part, seen, leaf->nearness, &leaf->near_shift);
}

/* All of them, if there is room. */
static void list_first(struct lim_mesh_leaf *leaf)
{
    const bool by_samples = lim_is_antialiased(leaf->seen.view);

    leaf->is_partial = false;
    leaf->from = 0;
    leaf->end = INT64_C(1) << PLACE_BITS;
    if (!LIM_OPTIMISE_SIZE && leaf->extent == LIM_VIEW_INSIDE && !by_samples
            ? list_inside(leaf)
            : list_plain(leaf, leaf->extent, by_samples))
        return;
    list_some(leaf);
}

/* Sorting ---------------------------------------------------------------------------------------------------------- */

/* Makes keys begin at 0. Returns how many bits they are too long by for the number of a list. */
static uint8_t lower_keys(struct lim_mesh_leaf *leaf)
{
    const struct lim_mesh_entry *const end = leaf->entries + leaf->used;
    uint16_t least = KEY_MOST, most = 0;
    uint8_t shift = 0;

    for (const struct lim_mesh_entry *entry = leaf->entries; entry < end; entry++) {
        if (entry->key < least) least = entry->key;
        if (entry->key > most) most = entry->key;
    }
    for (struct lim_mesh_entry *entry = leaf->entries; entry < end; entry++)
        entry->key = (uint16_t)(entry->key - least);
    const uint32_t range = leaf->used ? (uint32_t)(most - least) : 0;
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

static void fill_lists(struct lim_mesh_leaf *leaf)
{
    const uint8_t shift = lower_keys(leaf);

    for (uint_fast16_t i = 0; i < leaf->list_count; i++)
        leaf->lists[i] = LIM_NONE;
    for (uint16_t i = 0; i < leaf->used; i++) {
        const uint16_t at = (uint16_t)(leaf->seen.back_to_front ? i : leaf->used - 1 - i);
        leaf_insert(leaf, at, &leaf->lists[leaf->entries[at].key >> shift]);
    }
    leaf->list = 0;
}

void lim_mesh_leaf_sort(struct lim_mesh_leaf *leaf, const struct lim_mesh_leaf_seen *seen,
                        const LIM_FLASH lim_index *run)
{
    const LIM_FLASH lim_index *words = lim_mesh_leaf_words(run);
    const struct lim_view_part part = {words[LIM_MESH_LEAF_FIRST], words[LIM_MESH_LEAF_COUNT],
                                       words[LIM_MESH_LEAF_BOX]};

    leaf->seen = *seen;
    leaf->run = run;
    leaf->first = part.first;
    leaf->extent =
        (uint8_t)lim_view_all(seen->view, seen->scene, &part, leaf->points, leaf->nearness, &leaf->near_shift);
    if (leaf->extent == LIM_VIEW_CLIPPED) refine_nearness(leaf, &part);
    list_first(leaf);
    fill_lists(leaf);
}

static uint16_t next_entry(struct lim_mesh_leaf *leaf)
{
    for (; leaf->list < leaf->list_count; leaf->list++) {
        const uint16_t entry = leaf->lists[leaf->list];
        if (entry == LIM_NONE) continue;
        leaf->lists[leaf->list] = leaf->entries[entry].next;
        return entry;
    }
    return LIM_NONE;
}

/* The next part of the order, twice as much of it. false: there is none. */
static LIM_RARE bool go_to_next_part(struct lim_mesh_leaf *leaf)
{
    const int64_t length = leaf->end - leaf->from, last = INT64_C(1) << PLACE_BITS;

    if (!leaf->is_partial || leaf->end == last) return false;
    leaf->from = leaf->end;
    leaf->end = last - leaf->from < 2 * length ? last : leaf->from + 2 * length;
    list_some(leaf);
    fill_lists(leaf);
    return true;
}

const LIM_FLASH lim_index *lim_mesh_leaf_next(struct lim_mesh_leaf *leaf)
{
    for (;;) {
        const uint16_t entry = next_entry(leaf);
        if (entry != LIM_NONE) return &leaf->seen.scene->polygons[leaf->entries[entry].record];
        if (!go_to_next_part(leaf)) return NULL;
    }
}

bool lim_mesh_leaf_project(struct lim_screen_polygon *out, const struct lim_mesh_leaf *leaf,
                           const LIM_FLASH lim_index *record, const struct lim_rect *open, struct lim_stats *stats)
{
    const struct lim_mesh_leaf_seen *seen = &leaf->seen;

    if (!lim_mesh_leaf_corners(leaf, record, (uint8_t)(record[0] & LIM_POLYGON_COUNT), out->at))
        return lim_project(out, seen->view, seen->scene, record, open, stats);
    return lim_project_at(out, seen->view, seen->scene, record, open, stats);
}

#endif
