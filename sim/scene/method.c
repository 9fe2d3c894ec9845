/* SPDX-License-Identifier: MIT
 *
 * The methods. */
#include "scene/method.h"

#include "base/choice.h"

#include <stdio.h>
#include <string.h>

const struct method methods[] = {
    {"nearest", LIM_NEAREST_FIRST, TREE_AUTO, false, true},
    {"painter", LIM_PAINTER, TREE_AUTO, false, true},
    {"convex", LIM_CONVEX, TREE_AUTO, false, true},
    {"scanline", LIM_SCANLINE, TREE_AUTO, false, true},
    {"bsp", LIM_NEAREST_FIRST, TREE_BSP, false, true},
    {"clusters", LIM_NEAREST_FIRST, TREE_CLUSTERS, false, true},
    {"axis", LIM_NEAREST_FIRST, TREE_AXIS, false, true},
    {"octree", LIM_NEAREST_FIRST, TREE_OCTREE, false, true},
    {"portals", LIM_NEAREST_FIRST, TREE_BSP, true, true},
    {"depth", LIM_DEPTH, TREE_NONE, false, false},
    {"newell", LIM_NEWELL, TREE_NONE, false, true},
    {"mesh", LIM_MESH, TREE_MESH, false, false},
    {"mesh-depth", LIM_MESH_DEPTH, TREE_MESH, false, false},
};
const size_t method_count = sizeof methods / sizeof *methods;

static const char *name_at(const void *list, size_t index)
{
    const struct method *of = list;
    return index < method_count ? of[index].name : NULL;
}

const struct method *method_parse(const char *text, struct error *err)
{
    size_t index;
    return choice_find(&(struct choice){"--method", "method", name_at, methods}, text, &index, err) ? &methods[index]
                                                                                                    : NULL;
}

const struct method *method_that(enum lim_method draws)
{
    size_t i = 0;

    while (methods[i].draws != draws)
        i++;
    return &methods[i];
}

enum lim_method method_of_scene(const struct lim_scene *scene)
{
    if (lim_scene_is_mesh(scene)) return *scene->near_deep_from < scene->polygon_count ? LIM_MESH_DEPTH : LIM_MESH;
    return !scene->limits.depth && scene->limits.pieces ? LIM_NEWELL : LIM_NEAREST_FIRST;
}

const char *method_name(enum lim_method draws)
{
    return method_that(draws)->name;
}

bool method_is_exact(enum lim_method draws)
{
    return method_that(draws)->exact;
}

const char *method_title(enum lim_method draws)
{
    static const char *const titles[] = {
        [LIM_NEAREST_FIRST] = "nearest first", [LIM_PAINTER] = "back to front",
        [LIM_CONVEX] = "as one convex solid",  [LIM_SCANLINE] = "by scan lines",
        [LIM_DEPTH] = "by farthest points",    [LIM_NEWELL] = "by Newell's depth sort",
        [LIM_MESH] = "as a mesh, by distance", [LIM_MESH_DEPTH] = "as a mesh, by depth"};
    return titles[draws];
}

const char *method_symbol(enum lim_method draws)
{
    static const char *const symbols[] = {[LIM_NEAREST_FIRST] = "LIM_NEAREST_FIRST",
                                          [LIM_PAINTER] = "LIM_PAINTER",
                                          [LIM_CONVEX] = "LIM_CONVEX",
                                          [LIM_SCANLINE] = "LIM_SCANLINE",
                                          [LIM_DEPTH] = "LIM_DEPTH",
                                          [LIM_NEWELL] = "LIM_NEWELL",
                                          [LIM_MESH] = "LIM_MESH",
                                          [LIM_MESH_DEPTH] = "LIM_MESH_DEPTH"};
    return symbols[draws];
}

bool method_sorts(enum lim_method draws)
{
    return draws == LIM_DEPTH || draws == LIM_NEWELL;
}

bool method_draws_meshes(enum lim_method draws)
{
    return draws == LIM_MESH || draws == LIM_MESH_DEPTH;
}

bool method_needs_no_tree(enum lim_method draws)
{
    return method_sorts(draws) || method_draws_meshes(draws);
}

bool method_suits(enum lim_method draws, const char *name, const struct lim_scene *scene, struct error *err)
{
    const bool is_mesh = lim_scene_is_mesh(scene);
    if (is_mesh == method_draws_meshes(draws))
        return method_needs_no_tree(draws) || scene->limits.depth ||
               error_set(err, "%s: a set has no order; draw it with --method newell or depth", name);
    if (is_mesh) return error_set(err, "%s: a mesh has no tree; draw it with --method mesh or mesh-depth", name);
    return error_set(err, "%s: has a tree; --method %s draws meshes, give the model", name, method_name(draws));
}

bool method_scans(enum lim_method draws, const char *what, struct error *err)
{
    return (draws != LIM_SCANLINE && !method_draws_meshes(draws)) || !what ||
           error_set(err, "--method %s: %s drawn nearest first; take --method nearest", method_name(draws), what);
}

bool method_draws_wireframe(enum lim_method draws, struct error *err)
{
    if (!method_scans(draws, "--wireframe is", err)) return false;
    return draws != LIM_NEWELL ||
           error_set(err, "--wireframe --method newell: pieces of split polygons have no outline; take another method");
}

bool method_antialiases(enum lim_method draws, bool wireframe, struct error *err)
{
    if (wireframe) return error_set(err, "--antialias --wireframe: outlines are not antialiased; take one of the two");
    if (method_draws_meshes(draws) && !method_scans(draws, "--antialias is", err)) return false;
    if (draws == LIM_CONVEX)
        return error_set(err, "--antialias --method convex: faces are painted over one another; take --method nearest");
    return draws != LIM_PAINTER || error_set(err, "--antialias --method painter: back to front, what lies behind "
                                                  "shines through edges; take --method nearest");
}

bool method_can_move(enum lim_method draws)
{
    return draws == LIM_NEAREST_FIRST || draws == LIM_SCANLINE;
}

bool method_moves(enum lim_method draws, struct error *err)
{
    return method_can_move(draws) ||
           error_set(err, "--method %s: it moves no objects; nearest and scanline do, with any tree",
                     method_name(draws));
}
