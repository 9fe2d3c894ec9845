/* SPDX-License-Identifier: MIT
 *
 * Most polygons need no clipping and come out of the vertex cache. The few that meet the near
 * plane or the guard band are transformed again, in view space. */
#include "screen/project.h"

#include "colour.h"
#include "screen/polygon.h"
#include "screen/samples.h"
#include "view/clip.h"

/* By samples or by the centres of pixels. */
static void shape_bounds(struct lim_edge_shape *shape, const struct lim_point *at, uint8_t n, bool by_samples)
{
    if (LIM_HAS_ANTIALIAS && by_samples)
        lim_samples_bounds(shape, at, n);
    else
        lim_edge_bounds(shape, at, n);
}

static void shape_sides(struct lim_edge_shape *shape, const struct lim_point *at, uint8_t n, bool by_samples)
{
    if (LIM_HAS_ANTIALIAS && by_samples)
        lim_samples_sides(shape, at, n);
    else
        lim_edge_bounds_sides(shape, at, n);
}

/* For wireframe: which edges are not drawn, as flags beside the polygon, and in its corners while it is clipped. */
static void set_hidden(struct lim_screen_polygon *out, uint_fast8_t k, bool hidden)
{
    const uint16_t bit = (uint16_t)(1u << (k & 15));

    out->hidden[k >> 4] = (uint16_t)(hidden ? out->hidden[k >> 4] | bit : out->hidden[k >> 4] & ~bit);
}

static bool project_is_hidden(const struct lim_screen_polygon *polygon, uint_fast8_t k)
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
    for (uint_fast8_t k = 0; k < corners->n; k++)
        lim_view_hide_edge(&corners->at[k], project_is_hidden(polygon, k));
}

static void hidden_from_corners(struct lim_screen_polygon *polygon, const struct lim_clip_polygon *corners)
{
    for (uint_fast8_t k = 0; k < corners->n; k++)
        set_hidden(polygon, k, *corners->at[k].hidden);
}

/* Of a polygon that meets the near plane or the guard band. false: nothing is left. */
static LIM_RARE bool clip_and_project(struct lim_screen_polygon *out, const struct lim_view *view,
                                      const struct lim_scene *scene, const LIM_FLASH lim_index *corners)
{
    struct lim_clip_polygon polygons[2];

    lim_clip_load(&polygons[0], view, scene, corners, out->n);
    if (LIM_HAS_WIREFRAME) hidden_to_corners(out, &polygons[0]);
    const struct lim_clip_polygon *clipped = lim_clip(polygons, view->rows.near_qv);
    if (LIM_HAS_WIREFRAME) hidden_from_corners(out, clipped);
    out->n = clipped->n;
    if (!out->n) return false;
    for (uint_fast8_t k = 0; k < clipped->n; k++)
        lim_view_project(view, &clipped->at[k], &out->at[k]);
    shape_bounds(&out->shape, out->at, out->n, lim_is_antialiased(view));
    return true;
}

/* A scene whose textures are taken away keeps its records. */
static void note_texture(struct lim_screen_polygon *out, const struct lim_scene *scene,
                         const LIM_FLASH lim_index *record)
{
    const bool has_one = record[0] & LIM_POLYGON_TEXTURE && lim_texture_count(scene);
    const uint16_t end = (uint16_t)((uint16_t)(record - scene->polygons) + lim_record_words(record[0]));

    *out->texture = has_one ? (uint16_t)(end - LIM_POLYGON_TEXTURE_WORDS) : LIM_NONE;
    if (has_one && lim_mappings_name_textures(scene)) *out->texture = lim_record_mapping(record);
}

static inline uint8_t alpha_of(const LIM_FLASH lim_index *record)
{
    const lim_index head = record[0];

    return (uint8_t)(head & LIM_POLYGON_ALPHA ? record[lim_record_alpha_at(head)] : LIM_OPAQUE);
}

static inline bool meets_lines(const struct lim_edge_shape *shape, const struct lim_rect *open)
{
    return shape->top < shape->bottom && shape->top < (int16_t)open->y1 && shape->bottom > (int16_t)open->y0;
}

/* What is left to do once a record's corners are on the screen, and its shape is known. */
static inline bool project_set_look(struct lim_screen_polygon *out, const struct lim_view *view,
                                    const struct lim_scene *scene, const LIM_FLASH lim_index *record,
                                    const struct lim_rect *open, struct lim_stats *stats)
{
    if (LIM_HAS_STATS && stats) stats->non_monotone += out->shape.non_monotone;
    if (!meets_lines(&out->shape, open)) return false;
    if (LIM_HAS_NEWELL || lim_project_is_narrow(view, open)) { /* or they are compared */
        shape_sides(&out->shape, out->at, out->n, lim_is_polygon_antialiased(out));
        if (!lim_shape_meets_sides(&out->shape, open)) return false;
    }
    out->colour = lim_memory_colour((uint16_t)record[1]);
    if (LIM_HAS_TRANSPARENT) lim_set_alpha(out, alpha_of(record));
    if (LIM_HAS_TEXTURE) note_texture(out, scene, record);
    return true;
}

bool lim_project(struct lim_screen_polygon *out, struct lim_view *view, const struct lim_scene *scene,
                 const LIM_FLASH lim_index *record, const struct lim_rect *open, struct lim_stats *stats)
{
    const LIM_FLASH lim_index *corners = record + LIM_POLYGON_HEAD_WORDS;

    out->n = (uint8_t)(record[0] & LIM_POLYGON_COUNT);
    LIM_DEBUG_ASSERT(out->n <= LIM_MAX_VERTICES);
    lim_set_antialiased(out, lim_is_antialiased(view));
    const uint_fast16_t codes = lim_project_corners(out->at, out->n, view, scene, corners);
    if (LIM_HAS_STATS && stats) stats->polygons++;
    if (lim_view_all_outside(codes)) return false;
    if (LIM_HAS_WIREFRAME) read_hidden(out, record);
    if (codes & LIM_VIEW_GUARD) {
        if (LIM_HAS_STATS && stats) stats->clipped++;
        if (!clip_and_project(out, view, scene, corners)) return false;
    } else {
        shape_bounds(&out->shape, out->at, out->n, lim_is_antialiased(view));
    }
    return project_set_look(out, view, scene, record, open, stats);
}

#if LIM_HAS_MESH_LEAVES
bool lim_project_at(struct lim_screen_polygon *out, const struct lim_view *view, const struct lim_scene *scene,
                    const LIM_FLASH lim_index *record, const struct lim_rect *open, struct lim_stats *stats)
{
    out->n = (uint8_t)(record[0] & LIM_POLYGON_COUNT);
    lim_set_antialiased(out, lim_is_antialiased(view));
    if (LIM_HAS_STATS && stats) stats->polygons++;
    if (LIM_HAS_WIREFRAME) read_hidden(out, record);
    shape_bounds(&out->shape, out->at, out->n, lim_is_antialiased(view));
    return project_set_look(out, view, scene, record, open, stats);
}
#endif

/* Of a triangle's edges those are the polygon's that lead on from a corner to the next: the first one in the first
 * triangle, the last one in the last, and the middle one in all. */
static void hidden_of_fan(const struct lim_screen_polygon *non_monotone, uint8_t k, struct lim_screen_polygon *triangle)
{
    const uint8_t n = non_monotone->n;
    const uint_fast8_t apex = non_monotone->shape.apex;
    const uint_fast16_t second = (uint_fast16_t)(apex + k), third = second + 1;

    set_hidden(triangle, 0, k > 1 || project_is_hidden(non_monotone, apex));
    set_hidden(triangle, 1, project_is_hidden(non_monotone, (uint_fast8_t)(second < n ? second : second - n)));
    set_hidden(triangle, 2,
               k + 2 < n || project_is_hidden(non_monotone, (uint_fast8_t)(third < n ? third : third - n)));
}

void lim_project_fan(const struct lim_screen_polygon *non_monotone, uint8_t k, struct lim_screen_polygon *triangle)
{
    uint_fast16_t corner = non_monotone->shape.apex;

    triangle->n = 3;
    if (LIM_HAS_WIREFRAME) hidden_of_fan(non_monotone, k, triangle);
    triangle->colour = non_monotone->colour;
    if (LIM_HAS_TRANSPARENT) lim_set_alpha(triangle, lim_alpha_of(non_monotone));
    if (LIM_HAS_TEXTURE) *triangle->texture = lim_screen_texture(non_monotone);
    for (uint_fast8_t i = 0; i < 3; i++) {
        triangle->at[i] = non_monotone->at[corner];
        corner += i ? 1u : k;
        if (corner >= non_monotone->n) corner -= non_monotone->n;
    }
    lim_set_antialiased(triangle, lim_is_polygon_antialiased(non_monotone));
    shape_bounds(&triangle->shape, triangle->at, 3, lim_is_polygon_antialiased(non_monotone));
}
