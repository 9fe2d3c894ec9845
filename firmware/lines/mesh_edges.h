/* SPDX-License-Identifier: MIT
 *
 * Both boundaries of a triangle on a line, on their way down. In: edges that are set for a line (edge.h). */
#ifndef LIM_MESH_EDGES_H
#define LIM_MESH_EDGES_H

#include "meshes.h"
#include "screen/edge.h"

/* Pixels left <= x < right of a line. */
struct lim_mesh_ends {
    int32_t left, right;
};

/* Of what has no pixels, on any line. */
static inline void lim_mesh_edges_rest(struct lim_mesh_edges *edges)
{
    *edges = (struct lim_mesh_edges){0};
}

#if LIM_8_BIT

static inline void lim_mesh_edge_take(struct lim_mesh_edge *edge, const struct lim_edge *begun)
{
    edge->whole = *begun;
}

static inline void lim_mesh_edges_take(struct lim_mesh_edges *edges, uint_fast8_t side, const struct lim_edge *begun)
{
    edges->whole[side] = *begun;
}

static inline void lim_mesh_edges_replace(struct lim_mesh_edges *edges, uint_fast8_t side,
                                          const struct lim_mesh_edge *edge)
{
    edges->whole[side] = edge->whole;
}

static inline void lim_mesh_edges_swap(struct lim_mesh_edges *edges)
{
    const struct lim_edge left = edges->whole[0];

    edges->whole[0] = edges->whole[1];
    edges->whole[1] = left;
}

static inline struct lim_mesh_ends lim_mesh_edges_next(struct lim_mesh_edges *edges)
{
    const struct lim_mesh_ends ends = {lim_edge_x(&edges->whole[0]), lim_edge_x(&edges->whole[1])};

    lim_edge_step(&edges->whole[0]);
    lim_edge_step(&edges->whole[1]);
    return ends;
}

#else

/* From an edge that is set for a line. */
static inline void lim_mesh_edge_take(struct lim_mesh_edge *edge, const struct lim_edge *begun)
{
    edge->at = begun->at;
    edge->step = begun->step;
}

static inline void lim_mesh_edges_take(struct lim_mesh_edges *edges, uint_fast8_t side, const struct lim_edge *begun)
{
    edges->at[side] = begun->at;
    edges->step[side] = begun->step;
}

/* By what follows it, where that begins. */
static inline void lim_mesh_edges_replace(struct lim_mesh_edges *edges, uint_fast8_t side,
                                          const struct lim_mesh_edge *edge)
{
    edges->at[side] = edge->at;
    edges->step[side] = edge->step;
}

static inline void lim_mesh_edges_swap(struct lim_mesh_edges *edges)
{
    const struct lim_mesh_edge left = {edges->at[0], edges->step[0]};

    edges->at[0] = edges->at[1];
    edges->step[0] = edges->step[1];
    lim_mesh_edges_replace(edges, 1, &left);
}

/* The first pixels at or right of both boundaries; and on to the next line. */
static LIM_INLINE struct lim_mesh_ends lim_mesh_edges_next(struct lim_mesh_edges *edges)
{
    const lim_edge_at left = edges->at[0], right = edges->at[1];

    edges->at[0] = (lim_edge_at)((lim_edge_wrap)left + (lim_edge_wrap)edges->step[0]);
    edges->at[1] = (lim_edge_at)((lim_edge_wrap)right + (lim_edge_wrap)edges->step[1]);
    return (struct lim_mesh_ends){(int32_t)(left >> LIM_EDGE_BITS), (int32_t)(right >> LIM_EDGE_BITS)};
}

#endif

#endif
