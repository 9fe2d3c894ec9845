/* SPDX-License-Identifier: MIT
 *
 * A mesh's triangles that cross the current line: their edges, their order, on their way down. */
#ifndef LIM_MESH_ACTIVE_H
#define LIM_MESH_ACTIVE_H

#include "lines/mesh_clip.h"
#include "lines/mesh_edges.h"
#include "lines/mesh_texture.h"
#include "meshes.h"
#include "pixels/target_parts.h"
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

/* Whether no triangle reaches beyond the line. */
static inline bool lim_mesh_is_inside(const struct lim_mesh *mesh)
{
    return !LIM_OPTIMISE_SIZE && LIM_SUB_BITS > 0 && mesh->extent == LIM_VIEW_INSIDE &&
           !lim_target_is_round(&mesh->pass->target);
}

/* One that was never used, of which there are some. */
static inline struct lim_mesh_active *lim_mesh_new_unused(struct lim_mesh *mesh)
{
    struct lim_mesh_active *const active = &mesh->pool[mesh->unused++];

    if (LIM_HAS_TEXTURE) lim_mesh_texture_unset(active);
    return active;
}

/* NULL: there is no room. */
static inline struct lim_mesh_active *lim_mesh_new(struct lim_mesh *mesh)
{
    struct lim_mesh_active *active = mesh->free;

    if (active)
        mesh->free = active->next;
    else if (mesh->unused < mesh->pool_size)
        active = lim_mesh_new_unused(mesh);
    return active;
}

/* Puts an entry on the list of those that are free. */
static inline void lim_mesh_let_go(struct lim_mesh *mesh, struct lim_mesh_active *active)
{
    active->next = mesh->free;
    mesh->free = active;
}

/* Unlinks the one that `link` leads to. */
static inline void lim_mesh_give_back(struct lim_mesh *mesh, struct lim_mesh_active **link,
                                      struct lim_mesh_active *active)
{
    if (LIM_HAS_TEXTURE) lim_mesh_texture_leave(mesh, active);
    *link = active->next;
    lim_mesh_let_go(mesh, active);
}

/* All of them. */
void lim_mesh_clear(struct lim_mesh *mesh);

/* The triangles that begin on line y: into mesh->begins, in their order. Returns the first for which the pool has no
 * room; it and those behind it did not begin. LIM_NO_INDEX: all did. */
lim_index lim_mesh_begin_all(struct lim_mesh *mesh, uint16_t y);

/* A triangle that is tried. */
struct lim_mesh_trial {
    lim_mesh_rank from; /* it begins only if its rank is no less; */
    lim_mesh_rank rank; /* which is found */
};

/* A triangle that has line y, likewise. false: its rank is less, or there is no room. *last: &mesh->end, or the entry
 * that began before, if that is still in the list. It is set to the new one, unless that is clipped. */
bool lim_mesh_try(struct lim_mesh *mesh, lim_index triangle, uint16_t y, struct lim_mesh_trial *trial,
                  struct lim_mesh_active **last);

/* The rank that a triangle has when it begins; of what has no pixels any. */
lim_mesh_rank lim_mesh_find_rank(const struct lim_mesh *mesh, lim_index triangle);

/* Finds the edges for line y anew: LIM_MESH_ANEW. */
void lim_mesh_turn(const struct lim_mesh *mesh, struct lim_mesh_active *active, uint16_t y);

#endif
