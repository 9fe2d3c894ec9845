/* SPDX-License-Identifier: MIT
 *
 * Most polygons need no clipping and come out of the vertex cache. The few that meet the near
 * plane or the guard band are transformed again, in view space. */
#include "project.h"

#include "fill.h"

/* For wireframe: which edges are not drawn, as flags beside the polygon, and in its corners while it is clipped. */
static void set_hidden(struct lim_screen_polygon *out, uint_fast8_t k, bool hidden)
{
#if LIM_HAS_WIREFRAME
    const uint16_t bit = (uint16_t)(1u << (k & 15));

    out->hidden[k >> 4] = (uint16_t)(hidden ? out->hidden[k >> 4] | bit : out->hidden[k >> 4] & ~bit);
#else
    (void)out, (void)k, (void)hidden;
#endif
}

static bool is_hidden(const struct lim_screen_polygon *polygon, uint_fast8_t k)
{
    return lim_hidden_of(polygon)[k >> 4] >> (k & 15) & 1;
}

static void read_hidden(struct lim_screen_polygon *out, const LIM_FLASH lim_index *record)
{
    const lim_index head = record[0];
    const uint16_t at = lim_record_edges_at(head);

    for (uint_fast8_t k = 0; k < out->n; k++)
        set_hidden(out, k, head & LIM_POLYGON_EDGES && record[at + (k >> 4)] >> (k & 15) & 1);
}

static void hidden_to_corners(const struct lim_screen_polygon *polygon, struct lim_clip_polygon *corners)
{
#if LIM_HAS_WIREFRAME
    for (uint_fast8_t k = 0; k < corners->n; k++)
        corners->at[k].hidden = is_hidden(polygon, k);
#else
    (void)polygon, (void)corners;
#endif
}

static void hidden_from_corners(struct lim_screen_polygon *polygon, const struct lim_clip_polygon *corners)
{
#if LIM_HAS_WIREFRAME
    for (uint_fast8_t k = 0; k < corners->n; k++)
        set_hidden(polygon, k, corners->at[k].hidden);
#else
    (void)polygon, (void)corners;
#endif
}

/* Returns how many vertices are left. */
static uint8_t clip_and_project(struct lim_point *out, const struct lim_view *view, const struct lim_scene *scene,
                                const LIM_FLASH lim_index *corners, uint8_t n, struct lim_screen_polygon *outlined)
{
    struct lim_clip_polygon polygons[2];

    polygons[0].n = n;
    for (uint_fast8_t k = 0; k < n; k++)
        lim_view_transform(view, scene, &scene->vertices[corners[k]], &polygons[0].at[k]);
    if (LIM_HAS_WIREFRAME) hidden_to_corners(outlined, &polygons[0]);
    const struct lim_clip_polygon *clipped = lim_clip(polygons, view->rows.near_qv);
    if (LIM_HAS_WIREFRAME) hidden_from_corners(outlined, clipped);
    for (uint_fast8_t k = 0; k < clipped->n; k++)
        lim_view_project(view, &clipped->at[k], &out[k]);
    return clipped->n;
}

/* A scene whose textures are taken away keeps its records. */
static void note_texture(struct lim_screen_polygon *out, const struct lim_scene *scene,
                         const LIM_FLASH lim_index *record)
{
#if LIM_HAS_TEXTURE
    const bool has_one = record[0] & LIM_POLYGON_TEXTURE && scene->texture_count;
    const uint16_t end = (uint16_t)((uint16_t)(record - scene->polygons) + lim_record_words(record[0]));

    out->texture = has_one ? (uint16_t)(end - LIM_POLYGON_TEXTURE_WORDS) : LIM_NONE;
#else
    (void)out, (void)scene, (void)record;
#endif
}

static inline void set_antialiased(struct lim_screen_polygon *out, bool antialiased)
{
#if LIM_HAS_ANTIALIAS
    out->antialiased = antialiased;
#else
    (void)out, (void)antialiased;
#endif
}

static inline bool is_antialiased(const struct lim_screen_polygon *polygon)
{
#if LIM_HAS_ANTIALIAS
    return polygon->antialiased;
#else
    (void)polygon;
    return false;
#endif
}

/* Whether columns have to be looked at: where polygons are compared, and where some columns of the screen are no longer
 * open. What is beyond the screen's own sides CULL and the codes leave out. */
static inline bool needs_sides(const struct lim_view *view, const struct lim_rect *open)
{
    if (LIM_HAS_PIECES) return true;
    return LIM_HAS_HIDDEN && (open->x0 || (int32_t)open->x1 != view->width.px);
}

/* To the left or right of the view a convex solid may keep faces that the tree's orders drop: they cover no pixel. */
static inline bool meets_sides(struct lim_screen_polygon *out, const struct lim_rect *open)
{
    struct lim_edge_shape *shape = &out->shape;

    if (!is_antialiased(out)) lim_edge_measure_sides(shape, out->at, out->n);
    return shape->left < shape->right && shape->left < (int16_t)open->x1 && shape->right > (int16_t)open->x0;
}

static inline bool meets_lines(const struct lim_edge_shape *shape, const struct lim_rect *open)
{
    return shape->top < shape->bottom && shape->top < (int16_t)open->y1 && shape->bottom > (int16_t)open->y0;
}

static inline void set_alpha(struct lim_screen_polygon *out, uint8_t alpha)
{
#if LIM_HAS_TRANSPARENT
    out->alpha = alpha;
#else
    (void)out, (void)alpha;
#endif
}

static inline uint8_t alpha_of(const LIM_FLASH lim_index *record)
{
    const lim_index head = record[0];

    return (uint8_t)(head & LIM_POLYGON_ALPHA ? record[lim_record_alpha_at(head)] : LIM_OPAQUE);
}

bool lim_project(struct lim_screen_polygon *out, struct lim_view *view, const struct lim_scene *scene,
                 const LIM_FLASH lim_index *record, const struct lim_rect *open, struct lim_stats *stats)
{
    const LIM_FLASH lim_index *corners = record + LIM_POLYGON_HEAD_WORDS;

    out->n = (uint8_t)(record[0] & LIM_POLYGON_COUNT);
    LIM_ASSERT(out->n <= LIM_MAX_VERTICES);
    const uint32_t codes = lim_view_polygon(view, scene, corners, out->n, out->at);
    if (LIM_HAS_STATS && stats) stats->polygons++;
    if (codes >> 8 & LIM_VIEW_OUTSIDE) return false;
    if (LIM_HAS_WIREFRAME) read_hidden(out, record);
    if (codes & LIM_VIEW_GUARD) {
        if (LIM_HAS_STATS && stats) stats->clipped++;
        out->n = clip_and_project(out->at, view, scene, corners, out->n, out);
        if (!out->n) return false;
    }
    set_antialiased(out, lim_is_antialiased(view));
    lim_shape_measure(&out->shape, out->at, out->n, lim_is_antialiased(view));
    if (LIM_HAS_STATS && stats) stats->folded += out->shape.folded;
    if (!meets_lines(&out->shape, open) || (needs_sides(view, open) && !meets_sides(out, open))) return false;
    out->colour = lim_memory_colour((uint16_t)record[1]);
    if (LIM_HAS_TRANSPARENT) set_alpha(out, alpha_of(record));
    note_texture(out, scene, record);
    return true;
}

/* Of a triangle's edges those are the polygon's that lead on from a corner to the next: the first one in the first
 * triangle, the last one in the last, and the middle one in all. */
static void hidden_of_fan(const struct lim_screen_polygon *folded, uint8_t k, struct lim_screen_polygon *triangle)
{
    const uint8_t n = folded->n;
    const uint_fast8_t apex = folded->shape.apex;
    const uint_fast16_t second = (uint_fast16_t)(apex + k), third = second + 1;

    set_hidden(triangle, 0, k > 1 || is_hidden(folded, apex));
    set_hidden(triangle, 1, is_hidden(folded, (uint_fast8_t)(second < n ? second : second - n)));
    set_hidden(triangle, 2, k + 2 < n || is_hidden(folded, (uint_fast8_t)(third < n ? third : third - n)));
}

void lim_project_fan(const struct lim_screen_polygon *folded, uint8_t k, struct lim_screen_polygon *triangle)
{
    uint_fast16_t corner = folded->shape.apex;

    triangle->n = 3;
    if (LIM_HAS_WIREFRAME) hidden_of_fan(folded, k, triangle);
    triangle->colour = folded->colour;
    if (LIM_HAS_TRANSPARENT) set_alpha(triangle, lim_alpha_of(folded));
#if LIM_HAS_TEXTURE
    triangle->texture = folded->texture;
#endif
    for (uint_fast8_t i = 0; i < 3; i++) {
        triangle->at[i] = folded->at[corner];
        corner += i ? 1u : k;
        if (corner >= folded->n) corner -= folded->n;
    }
    set_antialiased(triangle, is_antialiased(folded));
    lim_shape_measure(&triangle->shape, triangle->at, 3, is_antialiased(folded));
}
