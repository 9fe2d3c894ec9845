/* SPDX-License-Identifier: MIT
 *
 * A scan-line algorithm. The faces of a convex solid lie side by side on a line, but for a pixel here
 * and there that rounding gives to two of them: then the one of lower rank owns it, which is the one that
 * nearest first would have met first. So both orders paint the same pixels, on slivers as well.
 *
 * Where more faces cross a line than there is room for, that line is painted back to front over its
 * background, face by face, which needs no room at all. */
#include "order.h"

#if LIM_HAS_CONVEX

enum { RANKS_A_FACE = 256 }; /* triangles of a folded face, in their order */

size_t lim_convex_mem_b(const struct lim_scene *scene, const struct lim_target *target, bool least)
{
    return LIM_CONVEX_MEM_B(target->h_px, scene->polygon_count, least ? 1 : scene->limits.active);
}

void lim_convex_init(struct lim *lim, void *mem, size_t mem_b)
{
    struct lim_convex *convex = &lim->convex;
    const size_t spare_b = mem_b - lim_convex_mem_b(lim->scene, &lim->target, true);
    const size_t more = spare_b / sizeof(struct lim_crossing);
    const uint16_t wanted = lim->scene->limits.active;

    convex->pool_size = (uint16_t)(more + 1 < wanted ? more + 1 : wanted ? wanted : 1);
    convex->pool = mem;
    struct lim_view_cached *cache = (struct lim_view_cached *)(void *)(convex->pool + convex->pool_size);
    convex->faces = (struct lim_face *)(void *)(cache + LIM_VIEW_CACHE_ENTRIES);
    convex->tops = (uint16_t *)(void *)(convex->faces + lim->scene->polygon_count);
    lim_view_init(&lim->view, lim->target.w_px, lim->target.h_px, cache);
}

static bool project(struct lim *lim, struct lim_screen_polygon *polygon, uint16_t record, struct lim_stats *stats)
{
    const struct lim_rect screen = {0, 0, lim->target.w_px, lim->target.h_px};

    return lim_project(polygon, &lim->view, lim->scene, &lim->scene->polygons[record], &screen, stats);
}

/* Pass one: which faces there are, and where they start ------------------------------------------- */

static void note_face(struct lim_convex *convex, uint16_t record, int16_t top)
{
    uint16_t *start = &convex->tops[top > 0 ? top : 0];

    convex->faces[convex->face_count] = (struct lim_face){record, *start};
    *start = convex->face_count++;
}

static void note_run(struct lim *lim, uint16_t record)
{
    struct lim_screen_polygon *polygon = &lim->convex.pool[0].polygon;

    for (;;) {
        const uint16_t head = lim->scene->polygons[record];
        if (project(lim, polygon, record, lim_stats_of(lim))) note_face(&lim->convex, record, polygon->shape.top);
        if (head & LIM_POLYGON_LAST) return;
        record = (uint16_t)(record + LIM_POLYGON_HEAD_WORDS + (head & LIM_POLYGON_COUNT));
    }
}

static void note_faces(struct lim *lim)
{
    for (uint16_t i = 0; i < lim->scene->node_count; i++) {
        const LIM_FLASH struct lim_node *node = &lim->scene->nodes[i];
        const int32_t side = lim_eye_side(lim_eye_of(lim), node);
        const uint16_t run = side > 0 ? node->front_run : node->back_run;
        if (LIM_HAS_STATS) lim_stats_of(lim)->nodes++;
        if (side && run != LIM_NONE) note_run(lim, run);
    }
}

/* Pass two: the faces that cross a line ----------------------------------------------------------- */

static struct lim_crossing *take(struct lim_convex *convex)
{
    const uint16_t self = convex->free;
    struct lim_crossing *crossing = &convex->pool[self];

    convex->free = crossing->next;
    convex->used++;
    crossing->next = convex->first;
    convex->first = self;
    return crossing;
}

static void give_back(struct lim_convex *convex, uint16_t self)
{
    convex->pool[self].next = convex->free;
    convex->free = self;
    convex->used--;
}

/* A triangle of a folded face may start further down: it covers nothing until then. */
static void begin(struct lim_crossing *crossing, uint32_t rank, int16_t y)
{
    struct lim_edge_shape *shape = &crossing->polygon.shape;

    if (shape->top < y) shape->top = y;
    crossing->pair.left.x = INT16_MAX;
    crossing->pair.right.x = INT16_MIN;
    crossing->rank = rank;
    crossing->seen = false;
}

static void begin_fan(struct lim_convex *convex, const struct lim_screen_polygon *folded, uint32_t rank, int16_t y)
{
    for (uint8_t k = 1; k + 1 < folded->n; k++) {
        struct lim_crossing *crossing = take(convex);
        lim_project_fan(folded, k, &crossing->polygon);
        begin(crossing, rank + k, y);
    }
}

/* false: there is no room. A folded face is projected into an entry that its triangles do not keep. */
static bool enter(struct lim *lim, uint16_t face, int16_t y)
{
    struct lim_convex *convex = &lim->convex;
    const uint32_t rank = (uint32_t)face * RANKS_A_FACE;

    if (convex->free == LIM_NONE) return false;
    const uint16_t self = convex->free;
    struct lim_screen_polygon *polygon = &convex->pool[self].polygon;
    (void)project(lim, polygon, convex->faces[face].record, NULL);
    if (!polygon->shape.folded) {
        begin(take(convex), rank, y);
        return true;
    }
    if (convex->used + polygon->n - 1 > convex->pool_size) return false;
    convex->free = convex->pool[self].next;
    begin_fan(convex, polygon, rank, y);
    convex->pool[self].next = convex->free;
    convex->free = self;
    return true;
}

/* All faces that start on line y, and those that had no room before. false: some still have none. */
static bool enter_line(struct lim *lim, uint16_t y)
{
    struct lim_convex *convex = &lim->convex;
    const uint16_t lists[2] = {convex->late, convex->tops[y]};

    convex->late = LIM_NONE;
    for (uint8_t i = 0; i < 2; i++) {
        uint16_t next;
        for (uint16_t face = lists[i]; face != LIM_NONE; face = next) {
            next = convex->faces[face].next;
            if (enter(lim, face, (int16_t)y)) continue;
            convex->faces[face].next = convex->late;
            convex->late = face;
        }
    }
    return convex->late == LIM_NONE;
}

/* To line y. false: it has ended. */
static bool advance(struct lim_crossing *crossing, int16_t y)
{
    const struct lim_screen_polygon *polygon = &crossing->polygon;
    struct lim_edge_pair *pair = &crossing->pair;

    if (y >= polygon->shape.bottom) return false;
    if (y == polygon->shape.top) lim_edge_begin(pair, polygon->at, polygon->n, polygon->shape.first, y);
    if (y <= polygon->shape.top) return true;
    if (pair->left_end > y) lim_edge_step(&pair->left);
    if (pair->right_end > y) lim_edge_step(&pair->right);
    (void)lim_edge_turn(pair, polygon->at, polygon->n, y);
    return true;
}

/* Puts a crossing into its place from left to right. Few change places from one line to the next, so
 * most go behind `last`, the one before. */
static void insert(struct lim_convex *convex, uint16_t self, uint16_t last)
{
    const int16_t left = convex->pool[self].pair.left.x;
    uint16_t *link = &convex->first;

    if (last != LIM_NONE && convex->pool[last].pair.left.x <= left) link = &convex->pool[last].next;
    while (*link != LIM_NONE && convex->pool[*link].pair.left.x < left)
        link = &convex->pool[*link].next;
    convex->pool[self].next = *link;
    *link = self;
}

static void advance_all(struct lim_convex *convex, int16_t y)
{
    uint16_t self = convex->first, last = LIM_NONE;

    convex->first = LIM_NONE;
    while (self != LIM_NONE) {
        const uint16_t next = convex->pool[self].next;
        if (advance(&convex->pool[self], y)) {
            insert(convex, self, last);
            last = self;
        } else {
            give_back(convex, self);
        }
        self = next;
    }
}

/* Painting a line --------------------------------------------------------------------------------- */

/* The crossing that owns pixel x, or NULL; *end is the first pixel that may have another owner. All that
 * ends at or before x is skipped, and *from, where the search begins, moves on. */
static struct lim_crossing *owner_of(const struct lim_convex *convex, uint16_t *from, int16_t x, int16_t *end)
{
    struct lim_crossing *owner = NULL;

    while (*from != LIM_NONE && convex->pool[*from].pair.right.x <= x)
        *from = convex->pool[*from].next;
    for (uint16_t self = *from; self != LIM_NONE; self = convex->pool[self].next) {
        struct lim_crossing *crossing = &convex->pool[self];
        const int16_t left = crossing->pair.left.x, right = crossing->pair.right.x;
        if (left >= *end) break;
        if (right <= x || (owner && crossing->rank > owner->rank)) continue;
        if (left > x) {
            *end = left;
            break;
        }
        owner = crossing;
        *end = right;
    }
    return owner;
}

static void note_pixels(struct lim *lim, struct lim_crossing *owner, uint16_t n_px)
{
    struct lim_stats *stats = lim_stats_of(lim);

    if (!owner) {
        stats->pixels_background += n_px;
        return;
    }
    stats->pixels_painted += n_px;
    stats->polygons_seen += !owner->seen;
    owner->seen = true;
}

static void paint_line(struct lim *lim, uint16_t *line, uint16_t background)
{
    const int16_t w_px = (int16_t)lim->target.w_px;
    uint16_t from = lim->convex.first;

    for (int16_t x = 0, end; x < w_px; x = end) {
        end = w_px;
        struct lim_crossing *owner = owner_of(&lim->convex, &from, x, &end);
        if (end > w_px) end = w_px;
        lim_fill(line, (uint16_t)x, (uint16_t)(end - x), owner ? owner->polygon.colour : background);
        if (LIM_HAS_STATS) note_pixels(lim, owner, (uint16_t)(end - x));
    }
}

static void fill_piece(struct lim *lim, uint16_t *line, const struct lim_screen_polygon *polygon, int16_t y)
{
    const int16_t w_px = (int16_t)lim->target.w_px;
    struct lim_edge_pair pair;

    if (y < polygon->shape.top || y >= polygon->shape.bottom) return;
    lim_edge_begin(&pair, polygon->at, polygon->n, polygon->shape.first, y);
    const int16_t x0 = pair.left.x > 0 ? pair.left.x : 0, x1 = pair.right.x < w_px ? pair.right.x : w_px;
    if (x0 >= x1) return;
    lim_fill(line, (uint16_t)x0, (uint16_t)(x1 - x0), polygon->colour);
    if (LIM_HAS_STATS) lim_stats_of(lim)->pixels_painted += (uint32_t)(x1 - x0);
}

static void paint_line_without_room(struct lim *lim, uint16_t *line, uint16_t background, int16_t y)
{
    struct lim_screen_polygon polygon, triangle;

    lim_fill(line, 0, lim->target.w_px, background);
    for (uint16_t face = lim->convex.face_count; face-- > 0;) {
        (void)project(lim, &polygon, lim->convex.faces[face].record, NULL);
        if (!polygon.shape.folded) fill_piece(lim, line, &polygon, y);
        for (uint8_t k = (uint8_t)(polygon.n - 2); polygon.shape.folded && k > 0; k--) {
            lim_project_fan(&polygon, k, &triangle);
            fill_piece(lim, line, &triangle, y);
        }
    }
    if (LIM_HAS_STATS) lim_stats_of(lim)->bands++;
}

static int draw_line(struct lim *lim, uint16_t y, uint16_t background)
{
    struct lim_convex *convex = &lim->convex;
    const bool has_room = enter_line(lim, y);

    advance_all(convex, (int16_t)y);
    uint16_t *line = lim->target.lend(lim->target.ctx, y);
    if (!line) return LIM_ERR_TARGET;
    if (LIM_HAS_STATS) {
        struct lim_stats *stats = lim_stats_of(lim);
        stats->lines += convex->used;
        if (convex->used > stats->active_max) stats->active_max = convex->used;
    }
    if (has_room)
        paint_line(lim, line, background);
    else
        paint_line_without_room(lim, line, background, (int16_t)y);
    return lim->target.done(lim->target.ctx, y, 0, lim->target.w_px);
}

static void start(struct lim_convex *convex, uint16_t h_px)
{
    for (uint16_t i = 0; i < convex->pool_size; i++)
        convex->pool[i].next = (uint16_t)(i + 1);
    convex->pool[convex->pool_size - 1].next = LIM_NONE;
    convex->free = 0;
    convex->first = convex->late = LIM_NONE;
    convex->used = convex->face_count = 0;
    for (uint16_t y = 0; y < h_px; y++)
        convex->tops[y] = LIM_NONE;
}

int lim_convex_frame(struct lim *lim)
{
    const uint16_t background = lim_memory_colour(lim->scene->background);

    start(&lim->convex, lim->target.h_px);
    note_faces(lim);
    for (uint16_t y = 0; y < lim->target.h_px; y++) {
        const int err = draw_line(lim, y, background);
        if (err) return err;
    }
    return 0;
}

#endif
