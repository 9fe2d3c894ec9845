/* SPDX-License-Identifier: MIT
 *
 * A line of depths: nearness, 1 / z, is linear on the screen, so a triangle's is a plane over it. In: points in
 * sub-pixels, nearness at each, 1..32769. Out: nearness in 16.16, right to some units of 2^-14 of what it spans; less
 * right where a triangle is thinner than a pixel. A pixel goes to the nearest of those that have depth, or to the first
 * among equals; what has none paints over it, as its distance says, and is painted over. */
#ifndef LIM_MESH_DEPTH_H
#define LIM_MESH_DEPTH_H

#include "lines/mesh_clip.h"
#include "meshes.h"
#include "pixels/fill.h"
#include "view/pass.h"

#if LIM_HAS_MESH_DEPTH

/* An entry that is not clipped and whose edges are set for line y gets depth. */
void lim_mesh_depth_begin(const struct lim_mesh *mesh, struct lim_mesh_active *active, uint16_t y);

/* The same of what clipping has left. */
void lim_mesh_depth_clipped(struct lim_mesh_active *active, const struct lim_mesh_clipped *clipped, uint16_t y);

/* Paints a triangle that has depth between two edges, where it is nearest so far. left < right, both on the line. The
 * second takes any edges, and paints the part that is on the line. */
void lim_mesh_depth_paint(struct lim_mesh *mesh, const struct lim_mesh_line *line, struct lim_mesh_active *active,
                          int32_t left, int32_t right);
void lim_mesh_depth_paint_part(struct lim_mesh *mesh, const struct lim_mesh_line *line, struct lim_mesh_active *active,
                               int32_t left, int32_t right);

/* Makes it that of line y, on which there is nothing yet. */
void lim_mesh_depths_clear(struct lim_mesh *mesh, uint16_t y);

/* The line of depths, which is cleared where it is wanted first. */
static inline uint32_t *lim_mesh_depths_q16(struct lim_mesh *mesh, uint16_t y)
{
    if (LIM_UNLIKELY(mesh->depths->y != y)) lim_mesh_depths_clear(mesh, y);
    return mesh->depths->line_q16;
}

/* Pixels x0 <= x < x1, one at least, of one colour, of a line whose first has a nearness. Indices run from -n up to 0,
 * so that one number leads to both lines. */
static LIM_INLINE void lim_mesh_depth_fill(uint16_t *pixels, uint32_t *depths_q16, const struct lim_mesh_active *active,
                                           uint32_t at_q16, int32_t x0, int32_t x1)
{
    const uint32_t step_q16 = active->depth->x_q16;
    const uint16_t colour = active->colour;
    int32_t at = x0 - x1;

    at_q16 += (uint32_t)x0 * step_q16;
    pixels += x1;
    depths_q16 += x1;
    do {
        if (at_q16 > depths_q16[at]) {
            depths_q16[at] = at_q16;
            pixels[at] = colour;
        }
        at_q16 += step_q16;
    } while (++at < 0);
}

/* Unless LIM_HAS_TEXTURE, as are the next three: then what has depth is shown like everything (mesh_texture_depth.c).
 * On to line y, the next one; its edges are stepped already. false: that has none of it. */
static inline bool lim_mesh_depth_next(struct lim_mesh_active *active, uint16_t y)
{
    active->depth->at_q16 += active->depth->y_q16;
    active->turn = (uint16_t)(y + 1);
    return active->bottom != y;
}

/* Whether an edge ends there. */
static inline bool lim_mesh_depth_turns(const struct lim_mesh_active *active, uint16_t y)
{
    return active->depth->turn == y;
}

/* The lower edge takes its place; or it has edges anew, as those without depth have them. */
void lim_mesh_depth_replace(struct lim_mesh_active *active);
void lim_mesh_depth_go_on(struct lim_mesh_active *active, uint16_t y);

#else

static inline void lim_mesh_depth_begin(const struct lim_mesh *mesh, struct lim_mesh_active *active, uint16_t y)
{
    (void)mesh, (void)active, (void)y;
}

static inline void lim_mesh_depth_clipped(struct lim_mesh_active *active, const struct lim_mesh_clipped *clipped,
                                          uint16_t y)
{
    (void)active, (void)clipped, (void)y;
}

static inline void lim_mesh_depth_paint(struct lim_mesh *mesh, const struct lim_mesh_line *line,
                                        struct lim_mesh_active *active, int32_t left, int32_t right)
{
    (void)mesh, (void)line, (void)active, (void)left, (void)right;
}

static inline void lim_mesh_depth_paint_part(struct lim_mesh *mesh, const struct lim_mesh_line *line,
                                             struct lim_mesh_active *active, int32_t left, int32_t right)
{
    (void)mesh, (void)line, (void)active, (void)left, (void)right;
}

static inline bool lim_mesh_depth_next(struct lim_mesh_active *active, uint16_t y)
{
    (void)active, (void)y;
    return false;
}

static inline bool lim_mesh_depth_turns(const struct lim_mesh_active *active, uint16_t y)
{
    (void)active, (void)y;
    return false;
}

static inline void lim_mesh_depth_replace(struct lim_mesh_active *active)
{
    (void)active;
}

static inline void lim_mesh_depth_go_on(struct lim_mesh_active *active, uint16_t y)
{
    (void)active, (void)y;
}

#endif

#endif
