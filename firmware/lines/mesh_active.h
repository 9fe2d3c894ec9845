/* SPDX-License-Identifier: MIT
 *
 * A mesh's triangles that cross the current line: their edges, their order, on their way down. */
#ifndef LIM_MESH_ACTIVE_H
#define LIM_MESH_ACTIVE_H

#include "lines/mesh_clip.h"
#include "lines/mesh_texture.h"
#include "orders.h"
#include "screen/edge.h"
#include "view/pass.h"
#include "view/view.h"

/* Among those that cross a line: far to near, and by their numbers where they are equally far. */
static inline lim_mesh_rank lim_mesh_rank_of(uint32_t nearness, lim_index triangle)
{
    return (lim_mesh_rank)nearness << 8 * sizeof(lim_index) | triangle;
}

/* Whether a triangle has depth at each pixel. */
static inline bool lim_mesh_is_deep(const struct lim_mesh *mesh, lim_index triangle)
{
    return LIM_HAS_MESH_DEPTH && triangle >= mesh->depths->from;
}

/* NULL: there is no room. */
static inline struct lim_mesh_active *lim_mesh_new(struct lim_mesh *mesh)
{
    struct lim_mesh_active *active = mesh->free;

    if (active)
        mesh->free = active->next;
    else if (mesh->unused < mesh->pool_size)
        active = &mesh->pool[mesh->unused++];
    return active;
}

/* Unlinks the one that `link` leads to. */
static inline void lim_mesh_give_back(struct lim_mesh *mesh, struct lim_mesh_active **link)
{
    struct lim_mesh_active *active = *link;

    if (LIM_HAS_TEXTURE) lim_mesh_texture_leave(mesh, active);
    *link = active->next;
    active->next = mesh->free;
    mesh->free = active;
}

#if LIM_8_BIT

static inline void lim_mesh_edge_take(struct lim_mesh_edge *edge, const struct lim_edge *begun)
{
    edge->whole = *begun;
}

static inline int32_t lim_mesh_edge_next(struct lim_mesh_edge *edge)
{
    const int16_t x = lim_edge_x(&edge->whole);

    lim_edge_step(&edge->whole);
    return x;
}

#else

/* From an edge that is set for a line. */
static inline void lim_mesh_edge_take(struct lim_mesh_edge *edge, const struct lim_edge *begun)
{
    edge->at = begun->at;
    edge->step = begun->step;
}

/* The first pixel at or right of a boundary; and on to the next line. */
static LIM_INLINE int32_t lim_mesh_edge_next(struct lim_mesh_edge *edge)
{
    const lim_edge_at at = edge->at;

    edge->at = (lim_edge_at)((lim_edge_wrap)at + (lim_edge_wrap)edge->step);
    return (int32_t)(at >> LIM_EDGE_BITS);
}

#endif

/* All of them. */
void lim_mesh_clear(struct lim_mesh *mesh);

/* The triangles that begin on line y: into mesh->begins, in their order. false: the pool has no room. */
bool lim_mesh_begin_all(struct lim_mesh *mesh, uint16_t y);

/* Ranks from <= rank < below; and that of the triangle for which there was no room last. */
struct lim_mesh_range {
    lim_mesh_rank from, below;
    lim_mesh_rank tried; /* that of the triangle that was begun last, if there was room or not */
};

/* A triangle that has line y, likewise; if its rank is not within a range it is left out. */
bool lim_mesh_begin_within(struct lim_mesh *mesh, lim_index triangle, uint16_t y, struct lim_mesh_range *range);

/* Finds the edges for line y anew: LIM_MESH_ANEW. */
void lim_mesh_turn(const struct lim_mesh *mesh, struct lim_mesh_active *active, uint16_t y);

#endif
