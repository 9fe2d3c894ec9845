/* SPDX-License-Identifier: MIT
 *
 * A line of depths: nearness, 1 / z, is linear on the screen, so a triangle's is a plane over it. In: points in
 * sub-pixels, nearness at each, 1..32769. Out: nearness in 16.16, right to some units of 2^-14 of what it spans; a
 * pixel is its who is nearest there, or who comes first among equals. */
#ifndef LIM_MESH_DEPTH_H
#define LIM_MESH_DEPTH_H

#include "lines/mesh_clip.h"
#include "orders.h"

#if LIM_HAS_MESH_DEPTH

/* On line y, of a triangle. */
void lim_mesh_depth_set(struct lim_mesh_active *active, const struct lim_point at[3], const uint16_t nearness[3],
                        uint16_t y);

/* The same of what clipping has left. */
void lim_mesh_depth_clipped(struct lim_mesh_active *active, const struct lim_mesh_clipped *clipped, uint16_t y);

/* Paints pixels x0 <= x < x1 of a line where nothing is nearer. */
static LIM_INLINE void lim_mesh_depth_fill(uint16_t *line, uint16_t *depths, const struct lim_mesh_active *active,
                                           int32_t x0, int32_t x1)
{
    const uint32_t step_q16 = active->depth->x_q16;
    uint32_t at_q16 = active->depth->at_q16 + (uint32_t)x0 * step_q16;
    const uint16_t colour = active->colour;

    for (int32_t x = x0; x < x1; x++, at_q16 += step_q16) {
        const uint32_t nearness = at_q16 >> 16;
        if (nearness <= depths[x]) continue;
        depths[x] = (uint16_t)nearness;
        line[x] = colour;
    }
}

#else

static inline void lim_mesh_depth_set(struct lim_mesh_active *active, const struct lim_point at[3],
                                      const uint16_t nearness[3], uint16_t y)
{
    (void)active, (void)at, (void)nearness, (void)y;
}

static inline void lim_mesh_depth_clipped(struct lim_mesh_active *active, const struct lim_mesh_clipped *clipped,
                                          uint16_t y)
{
    (void)active, (void)clipped, (void)y;
}

static inline void lim_mesh_depth_fill(uint16_t *line, uint16_t *depths, const struct lim_mesh_active *active,
                                       int32_t x0, int32_t x1)
{
    (void)line, (void)depths, (void)active, (void)x0, (void)x1;
}

#endif

#endif
