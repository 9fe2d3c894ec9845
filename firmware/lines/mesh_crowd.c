/* SPDX-License-Identifier: MIT
 *
 * Whoever is pushed out of the pool is the farthest there, and nearer than all of the crowd: so it goes to the crowd's
 * end. What begins farther away than that is put in its place among them. As soon as all of the crowd fit in, they move
 * in. */
#include "lines/mesh_crowd.h"

#include "lines/mesh_active.h"
#include "lines/mesh_line.h"
#include "view/packed.h"
#include "view/pass.h"

#if LIM_HAS_MESHES

static inline bool is_crowded(const struct lim_mesh *mesh)
{
    return mesh->crowd.first != LIM_NO_INDEX;
}

static void crowd_append(struct lim_mesh *mesh, lim_index triangle, lim_mesh_rank rank)
{
    struct lim_mesh_crowd *crowd = &mesh->crowd;

    *(is_crowded(mesh) ? &mesh->links[crowd->last] : &crowd->first) = triangle;
    mesh->links[triangle] = LIM_NO_INDEX;
    crowd->last = triangle;
    crowd->rank = rank;
}

/* One that is farther away than the last of them. */
static void crowd_insert(struct lim_mesh *mesh, lim_index triangle, lim_mesh_rank rank)
{
    lim_index *link = &mesh->crowd.first;

    while (lim_mesh_find_rank(mesh, *link) < rank)
        link = &mesh->links[*link];
    mesh->links[triangle] = *link;
    *link = triangle;
}

/* The list of the pool's farthest: of those that begin on the line, or of the others. */
static inline struct lim_mesh_active **farthest(struct lim_mesh *mesh)
{
    return mesh->first->rank < mesh->begins->rank ? &mesh->first : &mesh->begins;
}

/* The pool's farthest, with all its parts, becomes the crowd's nearest. false: the pool is empty. */
static bool push_out(struct lim_mesh *mesh)
{
    struct lim_mesh_active **link = farthest(mesh);
    const lim_mesh_rank rank = (*link)->rank;

    if (*link == &mesh->end) return false;
    crowd_append(mesh, lim_mesh_number(*link), rank);
    while ((*link)->rank == rank)
        lim_mesh_give_back(mesh, link, *link);
    return true;
}

/* A triangle that begins on the line: into the pool or the crowd. */
static void crowd_enter(struct lim_mesh *mesh, lim_index triangle, uint16_t y)
{
    struct lim_mesh_trial trial = {is_crowded(mesh) ? mesh->crowd.rank : 0, 0};
    struct lim_mesh_active *last = &mesh->end;

    while (!lim_mesh_try(mesh, triangle, y, &trial, &last)) {
        if (trial.rank < trial.from) {
            crowd_insert(mesh, triangle, trial.rank);
            return;
        }
        if (*farthest(mesh) == &mesh->end) {
            lim_mesh_clear(mesh);
        } else if (trial.rank < (*farthest(mesh))->rank) {
            crowd_append(mesh, triangle, trial.rank);
            return;
        } else {
            (void)push_out(mesh);
        }
    }
}

/* What was never used is free: gradients take nothing of it any more. */
static bool crowd_has_room(struct lim_mesh *mesh)
{
    uint_fast8_t count = 0;

    while (mesh->unused < mesh->pool_size)
        lim_mesh_let_go(mesh, lim_mesh_new_unused(mesh));
    for (const struct lim_mesh_active *free = mesh->free; free && count < MESH_LEAST_ACTIVE; free = free->next)
        count++;
    return count == MESH_LEAST_ACTIVE;
}

/* For the crowd. Where gradients took most of the pool, they give it back with their owners. */
static void crowd_make_room(struct lim_mesh *mesh)
{
    const bool is_taken = LIM_HAS_TEXTURE && mesh->pool_size < mesh->looks->whole_size / 2;

    while (is_taken || !crowd_has_room(mesh)) {
        if (push_out(mesh)) continue;
        lim_mesh_clear(mesh);
        (void)crowd_has_room(mesh);
        return;
    }
}

static int32_t bottom_of_triangle(const struct lim_mesh *mesh, lim_index triangle)
{
    const LIM_FLASH lim_index *corners = lim_mesh_triangle(mesh, triangle);
    struct lim_mesh_clipped clipped;

    if (lim_mesh_is_cut(mesh, corners))
        return lim_mesh_clip(mesh, triangle, &clipped) ? clipped.shape.bottom : INT16_MIN;
    return lim_edge_pixel(lim_packed_most_y(lim_packed_load(&mesh->points[corners[0]]),
                                            lim_packed_load(&mesh->points[corners[1]]),
                                            lim_packed_load(&mesh->points[corners[2]])));
}

static void paint_part(struct lim_mesh *mesh, const struct lim_mesh_line *line)
{
    lim_mesh_paint(mesh, line);
    while (mesh->first != &mesh->end)
        lim_mesh_give_back(mesh, &mesh->first, mesh->first);
    mesh->parts++;
}

/* Begins all of the crowd that have the line, and paints them for which there is no room. The last of them, for which
 * there is, move in: mesh->begins. */
static void paint_crowd(struct lim_mesh *mesh, const struct lim_mesh_line *line)
{
    struct lim_mesh_crowd *const crowd = &mesh->crowd;
    struct lim_mesh_trial trial = {0, 0};
    struct lim_mesh_active *last = &mesh->end;
    lim_index *link = &crowd->first, *part = link, before = LIM_NO_INDEX;
    lim_mesh_rank rank = 0;

    while (*link != LIM_NO_INDEX) {
        const lim_index triangle = *link;
        if (bottom_of_triangle(mesh, triangle) <= (int32_t)line->y) {
            *link = mesh->links[triangle];
            continue;
        }
        while (!lim_mesh_try(mesh, triangle, line->y, &trial, &last)) {
            paint_part(mesh, line);
            last = &mesh->end;
            part = link;
            crowd->last = before;
            crowd->rank = rank;
        }
        before = triangle;
        rank = trial.rank;
        link = &mesh->links[triangle];
    }
    *part = LIM_NO_INDEX;
}

void lim_mesh_paint_crowded(struct lim_mesh *mesh, const struct lim_mesh_line *line, lim_index begins)
{
    for (lim_index triangle = begins; triangle != LIM_NO_INDEX;) {
        const lim_index next = mesh->links[triangle];
        crowd_enter(mesh, triangle, line->y);
        triangle = next;
    }
    if (is_crowded(mesh)) {
        crowd_make_room(mesh);
        struct lim_mesh_active *const first = mesh->first, *const own = mesh->begins, **link = &mesh->begins;
        mesh->first = mesh->begins = &mesh->end;
        paint_crowd(mesh, line);
        while (*link != &mesh->end)
            link = &(*link)->next;
        *link = own;
        mesh->first = first;
    }
    lim_mesh_paint(mesh, line);
    if (LIM_HAS_STATS) lim_stats_of(mesh->pass)->bands = mesh->parts;
}

#endif
