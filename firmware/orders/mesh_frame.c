/* SPDX-License-Identifier: MIT
 *
 * Vertices, then triangles into their lines, then lines from the top down. */
#include "orders/mesh_frame.h"

#include "lines/mesh_active.h"
#include "lines/mesh_crowd.h"
#include "lines/mesh_line.h"
#include "lines/overlaid.h"
#include "math/fixed.h"
#include "pixels/fill.h"
#include "pixels/target_parts.h"
#include "screen/edge.h"
#include "screen/project.h"
#include "view/packed.h"
#include "view/pass.h"
#include "view/view.h"

#if LIM_HAS_MESHES

/* All of it. */
static struct lim_view_part whole_part(const struct lim_scene *scene)
{
    return (struct lim_view_part){.count = scene->vertex_count};
}

static uint16_t active_of(const struct lim_scene *scene, bool least)
{
    return least || scene->limits.active < MESH_LEAST_ACTIVE ? MESH_LEAST_ACTIVE : scene->limits.active;
}

static size_t mem_b_of(const struct lim_scene *scene, const struct lim_target *target, uint16_t active)
{
    const size_t depth_b = LIM_IS_MESH_DEPTH(target) ? LIM_MESH_DEPTH_MEM_B(target->w_px) : 0;

    return depth_b + LIM_MESH_MEM_B(target->h_px, scene->vertex_count, scene->polygon_count, active);
}

size_t lim_mesh_mem_b(const struct lim_scene *scene, const struct lim_target *target, bool least)
{
    return mem_b_of(scene, target, active_of(scene, least));
}

static LIM_IF_CALLED void cut_depths(struct lim_mesh *mesh, uint8_t **at)
{
    const struct lim_pass *pass = mesh->pass;
    const bool is_deep = LIM_IS_MESH_DEPTH(&pass->target);

    mesh->depths->line_q16 = is_deep ? lim_mem_cut(at, LIM_MESH_DEPTH_MEM_B(pass->target.w_px)) : NULL;
    mesh->depths->from = LIM_NO_INDEX;
}

/* Widest alignment first; what is left of the pool's size is not used. */
void lim_mesh_init(struct lim_mesh *mesh, void *mem, size_t mem_b)
{
    struct lim_pass *pass = mesh->pass;
    const struct lim_scene *scene = pass->scene;
    const size_t most = (mem_b - mem_b_of(scene, &pass->target, 0)) / sizeof(struct lim_mesh_active);
    const uint16_t wanted = active_of(scene, false);
    uint8_t *at = mem;

    mesh->pool_size = most < wanted ? (uint16_t)most : wanted;
    if (LIM_HAS_TEXTURE) mesh->looks->whole_size = mesh->pool_size;
    mesh->pool = lim_mem_cut(&at, mesh->pool_size * sizeof *mesh->pool);
    mesh->points = lim_mem_cut(&at, scene->vertex_count * sizeof *mesh->points);
    if (LIM_HAS_MESH_DEPTH) cut_depths(mesh, &at);
    mesh->links = lim_mem_cut(&at, scene->polygon_count * sizeof *mesh->links);
    mesh->tops = lim_mem_cut(&at, pass->target.h_px * sizeof *mesh->tops);
    mesh->nearness = lim_mem_cut(&at, scene->vertex_count * sizeof *mesh->nearness);
    mesh->end = (struct lim_mesh_active){.rank = LIM_MESH_NEAREST}; /* and no texels */
    lim_view_init(&pass->view, pass->target.w_px, pass->target.h_px, NULL);
}

/* Triangles into their lines -------------------------------------------------------------------------------------- */

/* Lines that a triangle may have, on the screen or not. */
static inline struct lim_span_extent lines_of(lim_packed a, lim_packed b, lim_packed c)
{
    const struct lim_span_extent lines = {(int16_t)lim_edge_pixel(lim_packed_least_y(a, b, c)),
                                          (int16_t)lim_edge_pixel(lim_packed_most_y(a, b, c))};
    return lines;
}

/* Whether the corners run counter-clockwise as the eye sees them. Within a screen of 16-bit coordinates they are near
 * each other. */
static LIM_INLINE bool faces_eye(lim_packed a, lim_packed b, lim_packed c, bool inside)
{
    return inside && !LIM_WIDE ? lim_packed_turns(a, b, c) : lim_packed_turns_far(a, b, c);
}

static inline void link_at(struct lim_mesh *mesh, size_t triangle, int32_t top)
{
    mesh->links[triangle] = mesh->tops[top];
    mesh->tops[top] = (lim_index)triangle;
    if (LIM_HAS_STATS) lim_stats_of(mesh->pass)->polygons++;
}

/* What has pixels between two lines; those above the screen begin on its first. `nearness` is that of its corners,
 * OR'ed. */
static inline void link_lines(struct lim_mesh *mesh, size_t triangle, struct lim_span_extent lines,
                              uint_fast16_t nearness)
{
    if (lines.top >= lines.bottom || lines.bottom <= 0 || lines.top >= (int16_t)mesh->pass->target.h_px) return;
    mesh->nearest |= (uint16_t)nearness;
    link_at(mesh, triangle, lines.top > 0 ? lines.top : 0);
}

/* The same of what lies on the screen: its uppermost and its lowest corner. */
static LIM_INLINE void link_inside_lines(struct lim_mesh *mesh, size_t triangle, int32_t top, int32_t bottom)
{
    const int32_t first = lim_edge_row((lim_edge_sub)top), end = lim_edge_row((lim_edge_sub)bottom);

    LIM_DEBUG_ASSERT(first + LIM_ORIGIN_PX >= 0 && end + LIM_ORIGIN_PX <= mesh->pass->target.h_px);
    if (first != end) link_at(mesh, triangle, first + LIM_ORIGIN_PX);
}

static uint_fast8_t mesh_codes(const struct lim_mesh *mesh, lim_index vertex)
{
    return lim_project_codes(&mesh->pass->view, mesh->points[vertex], mesh->nearness[vertex]);
}

/* Most of what needs to be clipped is behind the eye, or beside the screen. */
static LIM_RARE void link_clipped(struct lim_mesh *mesh, lim_index triangle)
{
    const LIM_FLASH lim_index *corners = lim_mesh_triangle(mesh, triangle);
    struct lim_mesh_clipped clipped;
    uint_fast16_t nearness = 0;

    if (mesh_codes(mesh, corners[0]) & mesh_codes(mesh, corners[1]) & mesh_codes(mesh, corners[2])) return;
    if (!lim_mesh_clip(mesh, triangle, &clipped)) return;
    for (uint_fast8_t k = 0; k < clipped.n; k++)
        nearness |= clipped.nearness[k];
    if (LIM_HAS_STATS) {
        lim_stats_of(mesh->pass)->clipped++;
        lim_stats_of(mesh->pass)->non_monotone += clipped.shape.non_monotone;
    }
    link_lines(mesh, triangle, (struct lim_span_extent){clipped.shape.top, clipped.shape.bottom}, nearness);
}

/* To the left or right of the screen. */
static inline bool mesh_is_beside(const struct lim_mesh *mesh, lim_packed a, lim_packed b, lim_packed c)
{
    const int32_t left = lim_edge_pixel(lim_packed_least_x(a, b, c));
    const int32_t right = lim_edge_pixel(lim_packed_most_x(a, b, c));

    return right <= 0 || left >= mesh->pass->target.w_px;
}

static inline size_t number_of(const LIM_FLASH lim_index *corners, const LIM_FLASH lim_index *all)
{
    return (size_t)(corners - all) / LIM_TRIANGLE_WORDS;
}

/* `all`: the corners of triangle 0. Its number is asked for by those that are linked alone. */
static LIM_INLINE void link_triangle(struct lim_mesh *mesh, const LIM_FLASH lim_index *corners,
                                     const LIM_FLASH lim_index *all, uint8_t extent)
{
    const lim_index i = corners[0], j = corners[1], k = corners[2];

    if (extent == LIM_VIEW_CLIPPED && (!mesh->nearness[i] || !mesh->nearness[j] || !mesh->nearness[k])) {
        link_clipped(mesh, (lim_index)number_of(corners, all));
        return;
    }
    const lim_packed a = lim_packed_load(&mesh->points[i]), b = lim_packed_load(&mesh->points[j]),
                     c = lim_packed_load(&mesh->points[k]);
    if (!faces_eye(a, b, c, extent == LIM_VIEW_INSIDE)) return;
    if (extent == LIM_VIEW_INSIDE)
        link_inside_lines(mesh, number_of(corners, all), lim_packed_least_y(a, b, c), lim_packed_most_y(a, b, c));
    else if (!mesh_is_beside(mesh, a, b, c))
        link_lines(mesh, number_of(corners, all), lines_of(a, b, c),
                   mesh->nearness[i] | mesh->nearness[j] | mesh->nearness[k]);
}

static LIM_INLINE void link_all(struct lim_mesh *mesh, uint8_t extent)
{
    const LIM_FLASH lim_index *const all = mesh->pass->scene->polygons;
    const LIM_FLASH lim_index *const end = all + (size_t)mesh->pass->scene->polygon_count * LIM_TRIANGLE_WORDS;

    for (const LIM_FLASH lim_index *corners = all; corners < end; corners += LIM_TRIANGLE_WORDS)
        link_triangle(mesh, corners, all, extent);
}

static LIM_ALONE void link_inside(struct lim_mesh *mesh)
{
    link_all(mesh, LIM_VIEW_INSIDE);
}

static void clear_tops(lim_index *top, const lim_index *end)
{
    LIM_UNROLLED(8)
    while (top < end)
        *top++ = LIM_NO_INDEX;
}

static void link_triangles(struct lim_mesh *mesh)
{
    clear_tops(mesh->tops, mesh->tops + mesh->pass->target.h_px);
    mesh->nearest = 0;
    if (LIM_HAS_STATS) lim_stats_of(mesh->pass)->records += mesh->pass->scene->polygon_count;
    if (mesh->extent == LIM_VIEW_INSIDE && !LIM_OPTIMISE_SIZE)
        link_inside(mesh);
    else
        link_all(mesh, mesh->extent);
}

/* A frame --------------------------------------------------------------------------------------------------------- */

static inline void mesh_clean(struct lim_pass *pass, const struct lim_mesh_line *line, uint16_t background)
{
    if (LIM_HAS_ROUND && lim_target_is_round(&pass->target)) {
        if (line->x0 >= line->x1) return;
        lim_fill(line->pixels, line->x0, (uint16_t)(line->x1 - line->x0), background);
    } else {
        lim_fill_line(line->pixels, line->x1, background);
    }
    if (LIM_HAS_STATS) lim_stats_of(pass)->pixels_background += (uint32_t)(line->x1 - line->x0);
}

static inline bool has_none(const struct lim_mesh *mesh)
{
    return mesh->first == &mesh->end && mesh->begins == &mesh->end;
}

static int mesh_draw_line(struct lim_mesh *mesh, uint16_t y, uint16_t background)
{
    struct lim_pass *pass = mesh->pass;
    const struct lim_target *target = &pass->target;
    uint16_t *const pixels = target->lend(target->ctx, y);
    uint16_t x0 = 0, x1 = target->w_px;

    if (!pixels) return LIM_ERR_TARGET;
    if (LIM_HAS_ROUND && lim_target_is_round(target)) lim_target_visible(target, y, &x0, &x1);
    const struct lim_mesh_line line = {pixels, x0, x1, y};
    mesh_clean(pass, &line, background);
    const bool is_crowded = mesh->crowd.first != LIM_NO_INDEX;
    lim_index left = mesh->tops[y];
    if (!is_crowded && left != LIM_NO_INDEX) left = lim_mesh_begin_all(mesh, y);
    if (is_crowded || left != LIM_NO_INDEX)
        lim_mesh_paint_crowded(mesh, &line, left);
    else if (!has_none(mesh))
        lim_mesh_paint(mesh, &line);
    lim_overlay_line(pass, pixels, y, x0, x1);
    return target->done(target->ctx, y, x0, (uint16_t)(x1 - x0));
}

/* Which triangles have depth is a matter of how near the eye is. */
static inline void set_deep(struct lim_mesh *mesh)
{
    const struct lim_pass *pass = mesh->pass;

    if (!LIM_HAS_MESH_DEPTH || !LIM_IS_MESH_DEPTH(&pass->target)) return;
    mesh->depths->from = mesh->extent == LIM_VIEW_CLIPPED ? *pass->scene->near_deep_from : *pass->scene->deep_from;
    mesh->depths->y = LIM_NONE;
}

int lim_mesh_frame(struct lim_mesh *mesh)
{
    struct lim_pass *pass = mesh->pass;

    const struct lim_view_part part = whole_part(pass->scene);
    mesh->extent =
        (uint8_t)lim_view_all(&pass->view, pass->scene, &part, mesh->points, mesh->nearness, &mesh->near_shift);
    set_deep(mesh);
    link_triangles(mesh);
    if (mesh->extent == LIM_VIEW_CLIPPED)
        lim_view_refine(&pass->view, pass->scene, &part, mesh->nearest, mesh->nearness, &mesh->near_shift);
    if (LIM_HAS_TEXTURE) lim_mesh_texture_frame(mesh);
    lim_mesh_clear(mesh);
    mesh->crowd.first = LIM_NO_INDEX;
    mesh->parts = 0;
    const uint16_t background = lim_background_of(pass);
    for (uint_fast16_t y = 0; y < pass->target.h_px; y++) {
        const int err = mesh_draw_line(mesh, (uint16_t)y, background);
        if (err) return err;
    }
    return LIM_OK;
}

#endif
