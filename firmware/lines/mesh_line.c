/* SPDX-License-Identifier: MIT
 *
 * Those that begin on the line are merged into the list while it is painted: each is looked at once. */
#include "lines/mesh_line.h"

#include "lines/mesh_active.h"
#include "lines/mesh_depth.h"
#include "pixels/fill.h"
#include "pixels/texture.h"
#include "screen/edge.h"
#include "view/pass.h"
#include "view/view.h"

#if LIM_HAS_MESHES

/* Pixels x0 <= x < x1, as far as they lie on the line: those of what has depth as often as they are compared. */
static inline void mesh_note(struct lim_stats *stats, const struct lim_mesh_line *line, struct lim_mesh_active *active,
                             int32_t x0, int32_t x1)
{
    const int32_t n_px = (x1 < line->x1 ? x1 : line->x1) - (x0 > line->x0 ? x0 : line->x0);

    if (n_px <= 0) return;
    stats->lines++;
    stats->pixels_painted += (uint32_t)n_px;
    stats->polygons_seen += !*active->seen;
    *active->seen = true;
}

static inline void note_deep(struct lim_stats *stats, const struct lim_mesh_line *line, struct lim_mesh_active *active,
                             int32_t x0, int32_t x1)
{
    const uint32_t before = stats->pixels_painted;

    mesh_note(stats, line, active, x0, x1);
    stats->pixels_deep += stats->pixels_painted - before;
}

static inline void note_painted(struct lim_mesh *mesh, const struct lim_mesh_line *line, struct lim_mesh_active *active,
                                int32_t x0, int32_t x1)
{
    if (LIM_HAS_TEXTURE && lim_mesh_is_deep(mesh, lim_mesh_number(active)))
        note_deep(lim_stats_of(mesh->pass), line, active, x0, x1);
    else
        mesh_note(lim_stats_of(mesh->pass), line, active, x0, x1);
}

/* Replaces the edge that ends. */
static LIM_INLINE void replace_edge(const struct lim_mesh *mesh, struct lim_mesh_active *active, uint16_t y)
{
    if (LIM_UNLIKELY(active->goes_on == LIM_MESH_ANEW)) {
        lim_mesh_turn(mesh, active, y);
        return;
    }
    lim_mesh_edges_replace(&active->edges, active->goes_on, &active->lower);
    active->turn = active->bottom;
}

static LIM_RARE void turn_deep(const struct lim_mesh *mesh, struct lim_mesh_active *active, uint16_t y)
{
    if (active->depth->goes_on != LIM_MESH_ANEW) {
        lim_mesh_depth_replace(active);
        return;
    }
    lim_mesh_turn(mesh, active, y);
    lim_mesh_depth_go_on(active, y);
}

/* Where an edge ends, on the line below; or of what has depth. false: that line has none of it. */
static LIM_INLINE bool go_on(struct lim_mesh *mesh, const struct lim_mesh_line *line, uint16_t below,
                             struct lim_mesh_active *active, int32_t x0, int32_t x1, bool inside)
{
    if (LIM_HAS_MESH_DEPTH && !LIM_HAS_TEXTURE && active->goes_on == LIM_MESH_DEEP) {
        if (LIM_HAS_STATS) note_deep(lim_stats_of(mesh->pass), line, active, x1, x0);
        if (x1 < x0 && inside) lim_mesh_depth_paint(mesh, line, active, x1, x0);
        if (x1 < x0 && !inside) lim_mesh_depth_paint_part(mesh, line, active, x1, x0);
        if (!lim_mesh_depth_next(active, below)) return false;
        if (LIM_UNLIKELY(lim_mesh_depth_turns(active, below))) turn_deep(mesh, active, below);
        return true;
    }
    if (active->bottom == below) return false;
    replace_edge(mesh, active, below);
    return true;
}

/* What it shows knows how: texels that advance evenly are painted without delay. */
static LIM_INLINE void paint_look(struct lim_mesh *mesh, uint16_t *pixels, uint16_t below,
                                  struct lim_mesh_active *active, const struct lim_mesh_ends *ends, int32_t x0,
                                  int32_t x1, bool inside)
{
    const struct lim_mesh_look *const look = active->look;

    if (!inside) lim_mesh_texture_reach(mesh, ends->left, ends->right);
    look->show(pixels + x1, (uint_fast16_t)(x1 - x0), lim_texture_even_place(&look->even, look->level.step, x0, below),
               &look->level);
}

/* Paints a triangle, and puts it on the next line. false: that has none of it. */
static LIM_INLINE bool paint_one(struct lim_mesh *mesh, const struct lim_mesh_line *line, uint16_t *pixels,
                                 uint16_t below, struct lim_mesh_active *active, bool inside)
{
    const struct lim_mesh_ends ends = lim_mesh_edges_next(&active->edges);
    const int32_t left = ends.left, right = ends.right;
    const int32_t x0 = inside || left > line->x0 ? left : line->x0, x1 = inside || right < line->x1 ? right : line->x1;

    if (LIM_HAS_TEXTURE && x0 < x1)
        paint_look(mesh, pixels, below, active, &ends, x0, x1, inside);
    else if (x0 < x1)
        lim_fill_inline(pixels, (int_fast16_t)x0, (int_fast16_t)x1, active->colour);
    if (LIM_HAS_STATS && x0 < x1) note_painted(mesh, line, active, x0, x1);
    if (LIM_UNLIKELY(active->turn == below)) return go_on(mesh, line, below, active, left, right, inside);
    return true;
}

/* Paints those that are farther than a rank. Returns the link that leads to the next one. */
static LIM_INLINE struct lim_mesh_active **paint_farther(struct lim_mesh *mesh, const struct lim_mesh_line *line,
                                                         uint16_t *pixels, uint16_t below, bool inside,
                                                         struct lim_mesh_active **link, lim_mesh_rank rank)
{
    for (struct lim_mesh_active *active = *link; active->rank <= rank; active = *link)
        if (paint_one(mesh, line, pixels, below, active, inside))
            link = &active->next;
        else
            lim_mesh_give_back(mesh, link, active);
    return link;
}

/* Those that begin on the line, each before the first that is nearer, and what is farther than the last of them.
 * Returns where what is left of the list begins, with the last of them. */
static LIM_INLINE struct lim_mesh_active **paint_merged(struct lim_mesh *mesh, const struct lim_mesh_line *line,
                                                        uint16_t *pixels, uint16_t below, bool inside)
{
    struct lim_mesh_active **link = &mesh->first, *begins = mesh->begins;

    for (lim_mesh_rank rank; (rank = begins->rank) != LIM_MESH_NEAREST;) {
        link = paint_farther(mesh, line, pixels, below, inside, link, rank);
        struct lim_mesh_active *const next = begins->next;
        begins->next = *link;
        *link = begins;
        begins = next;
    }
    mesh->begins = &mesh->end;
    return link;
}

static void note_active(struct lim_mesh *mesh)
{
    struct lim_stats *stats = lim_stats_of(mesh->pass);
    uint16_t count = 0;

    for (const struct lim_mesh_active *active = mesh->first; active != &mesh->end; active = active->next)
        count++;
    for (const struct lim_mesh_active *active = mesh->begins; active != &mesh->end; active = active->next)
        count++;
    if (count > stats->active_max) stats->active_max = count;
}

/* With room for gradients. */
static void note_used(struct lim_mesh *mesh)
{
    struct lim_stats *stats = lim_stats_of(mesh->pass);
    const uint16_t count = lim_mesh_texture_used(mesh);

    if (count > stats->active_max) stats->active_max = count;
}

/* The list's end has no pixels, and turns on each line: so nobody has to ask for it elsewhere. */
static LIM_INLINE void paint_all(struct lim_mesh *mesh, const struct lim_mesh_line *line, bool inside)
{
    const uint16_t below = (uint16_t)(line->y + 1);
    uint16_t *const pixels = line->pixels;

    if (LIM_HAS_STATS) note_active(mesh);
    struct lim_mesh_active **link = paint_merged(mesh, line, pixels, below, inside);
    mesh->end.turn = mesh->end.bottom = below;
    for (;;) {
        struct lim_mesh_active *const active = *link;
        if (paint_one(mesh, line, pixels, below, active, inside)) {
            link = &active->next;
        } else {
            if (active == &mesh->end) return;
            lim_mesh_give_back(mesh, link, active);
        }
    }
}

/* Most frames: without a comparison with the line's ends. */
static LIM_ALONE void paint_inside(struct lim_mesh *mesh, const struct lim_mesh_line *line)
{
    paint_all(mesh, line, true);
}

static LIM_ALONE void paint_across(struct lim_mesh *mesh, const struct lim_mesh_line *line)
{
    paint_all(mesh, line, false);
}

void lim_mesh_paint(struct lim_mesh *mesh, const struct lim_mesh_line *line)
{
    if (LIM_HAS_TEXTURE) mesh->looks->line = line;
    if (lim_mesh_is_inside(mesh))
        paint_inside(mesh, line);
    else
        paint_across(mesh, line);
    if (LIM_HAS_STATS && lim_mesh_has_textures(mesh)) note_used(mesh);
}

#endif
