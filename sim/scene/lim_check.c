/* SPDX-License-Identifier: MIT
 *
 * One pass over each array. Every check names the element and what is wrong with it. */
#include "scene/lim_check.h"

#include "base/grow.h"
#include "colour.h"
#include "limner.h"
#include "scene/bounds.h"
#include "scene/plane.h"

#include <stdlib.h>
#include <string.h>

enum { VERTICES_MAX = 250, COORDINATE_MAX = 32767, HALF_MAX = 32768 };
enum { FILTER_D_FACTOR = 1 << 17 };
#define EXACT_D_END (INT64_C(1) << 48)

/* What is known of the nodes and words met so far. */
struct checker {
    const struct lim_scene *scene;
    struct error *err;
    uint32_t *depths; /* of each node; 0: no parent seen yet */
    bool *used_words; /* words that belong to a record already */
    size_t records, words, transparent, mesh_leaves;
};

static bool check_vertices(const struct lim_scene *scene, struct error *err)
{
    if (lim_scene_long(scene)) return lim_check_long_vertices(scene, err);
    for (size_t i = 0; i < scene->vertex_count; i++) {
        const struct lim_vertex *vertex = &scene->vertices[i];
        if (vertex->x < -COORDINATE_MAX || vertex->y < -COORDINATE_MAX || vertex->z < -COORDINATE_MAX)
            return error_set(err, "vertex %zu: a coordinate is -32768", i);
    }
    return true;
}

static bool check_boxes(const struct lim_scene *scene, struct error *err)
{
    if (lim_scene_long(scene) && !lim_check_long_boxes(scene, err)) return false;
    for (size_t i = 0; i < scene->box_count && !lim_scene_long(scene); i++)
        for (int k = 0; k < 3; k++)
            if (scene->boxes[i].half[k] > HALF_MAX)
                return error_set(err, "box %zu: half is %u, more than %d", i, (unsigned)scene->boxes[i].half[k],
                                 HALF_MAX);
    if (!scene->node_count) return true;
    return scene->box_count <= scene->node_count ||
           error_set(err, "%lu boxes for %lu nodes", (unsigned long)scene->box_count, (unsigned long)scene->node_count);
}

/* Planes ------------------------------------------------------------------------------------- */

/* d beyond 2^17 times the longest component would not fit into its filter. */
static bool exact_within_bounds(const int64_t n[3], int64_t d)
{
    int64_t longest = 0;
    for (int k = 0; k < 3; k++) {
        int64_t size = n[k] < 0 ? -n[k] : n[k];
        longest = size > longest ? size : longest;
    }
    if (longest == 0 || longest > INT32_MAX) return false;
    const int64_t end = longest * FILTER_D_FACTOR < EXACT_D_END ? longest * FILTER_D_FACTOR : EXACT_D_END;
    return -end < d && d < end;
}

static int64_t exact_d(const struct lim_plane_exact *exact)
{
    return (int64_t)exact->d_hi * (INT64_C(1) << 32) + exact->d_lo;
}

static bool check_exact(const struct lim_scene *scene, size_t index, struct error *err)
{
    const struct lim_plane_exact *exact = &scene->exact[index];
    const int64_t n[3] = {exact->n[0], exact->n[1], exact->n[2]};
    return exact_within_bounds(n, exact_d(exact)) || error_set(err, "exact plane %zu: out of bounds", index);
}

static bool check_filter(const struct lim_scene *scene, size_t index, struct error *err)
{
    const struct lim_plane *plane = &scene->planes[index];
    const lim_index at = lim_plane_exact(plane);
    if (at >= scene->exact_count)
        return error_set(err, "plane %zu: exact plane %u of %u", index, (unsigned)at, (unsigned)scene->exact_count);
    const struct lim_plane_exact *exact = &scene->exact[at];
    const int64_t n[3] = {exact->n[0], exact->n[1], exact->n[2]};
    const struct lim_plane filter = plane_filter(n, exact_d(exact), at);
    return memcmp(&filter, plane, sizeof filter) == 0 ||
           error_set(err, "plane %zu: does not match its exact plane", index);
}

static bool check_plane(const struct lim_scene *scene, size_t index, struct error *err)
{
    const struct lim_plane *plane = &scene->planes[index];
    const int64_t d = (int64_t)LIM_PLANE_SLACK - plane->slack_less_d;
    if (d < -LIM_PLANE_D_MAX || d > LIM_PLANE_D_MAX)
        return error_set(err, "plane %zu: d is %lld, beyond %ld", index, (long long)d, (long)LIM_PLANE_D_MAX);
    int sum = abs(lim_plane_x(plane)) + abs(lim_plane_y(plane)) + abs(lim_plane_z(plane));
    if (sum == 0 || sum > PLANE_SUM_MAX)
        return error_set(err, "plane %zu: the components of its normal add up to %d", index, sum);
    if ((uint16_t)plane->n_z_exact != (uint16_t)lim_plane_exact(plane))
        return error_set(err, "plane %zu: two indices of its exact plane", index);
    return lim_plane_exact(plane) == LIM_NO_INDEX || check_filter(scene, index, err);
}

static bool check_planes(const struct lim_scene *scene, struct error *err)
{
    if (lim_scene_long(scene)) return lim_check_long_planes(scene, err);
    for (size_t i = 0; i < scene->exact_count; i++)
        if (!check_exact(scene, i, err)) return false;
    for (size_t i = 0; i < scene->plane_count; i++)
        if (!check_plane(scene, i, err)) return false;
    return true;
}

/* `what` and its number name who refers to the plane. */
static bool check_plane_ref(const struct checker *work, const struct lim_plane_ref *ref, const char *what, size_t index)
{
    if (ref->plane > LIM_PLANE_Z) return error_set(work->err, "%s %zu: has no plane", what, index);
    if (lim_scene_long(work->scene)) return lim_check_long_ref(work->scene, ref, what, index, work->err);
    if (ref->plane >= LIM_PLANE_X)
        return (ref->offset >= INT16_MIN && ref->offset <= INT16_MAX) ||
               error_set(work->err, "%s %zu: an axis plane at %ld, outside of the grid", what, index,
                         (long)ref->offset);
    if (ref->offset) return error_set(work->err, "%s %zu: an offset beside a plane of its own", what, index);
    if (ref->plane % LIM_PLANE_WORDS || ref->plane / LIM_PLANE_WORDS >= work->scene->plane_count)
        return error_set(work->err, "%s %zu: plane at word %u, where none of %u begins", what, index,
                         (unsigned)ref->plane, (unsigned)work->scene->plane_count);
    return true;
}

/* Runs --------------------------------------------------------------------------------------- */

static bool check_alpha(struct checker *work, size_t at)
{
    const struct lim_scene *scene = work->scene;
    work->transparent++;
    const lim_index alpha = scene->polygons[at + lim_record_alpha_at(scene->polygons[at])];
    if (alpha < 1 || alpha >= LIM_OPAQUE)
        return error_set(work->err, "polygon at word %zu: its alpha is %u", at, (unsigned)alpha);
    return scene->limits.layers > 0 ||
           error_set(work->err, "polygon at word %zu: transparent, and the limit of layers is 0", at);
}

enum {
    TAKEN_FLAGS = LIM_POLYGON_PLANE | LIM_POLYGON_BACK | LIM_POLYGON_ALPHA | LIM_POLYGON_EDGES | LIM_POLYGON_TEXTURE |
                  LIM_POLYGON_MESH
};

/* Where a run is: in a node, in a leaf with an order, or in a mesh leaf. */
enum place { IN_NODE, IN_LEAF, IN_MESH_LEAF };

/* In a mesh leaf nothing is flagged but textures, and the first record. */
static bool check_mesh_flags(const struct checker *work, size_t at, lim_index flags, enum place place, bool is_first)
{
    const lim_index barred = LIM_POLYGON_PLANE | LIM_POLYGON_BACK | LIM_POLYGON_ALPHA | LIM_POLYGON_EDGES;
    if (place == IN_MESH_LEAF && flags & barred)
        return error_set(work->err, "polygon at word %zu: in a mesh leaf, with a plane, alpha or flags of edges", at);
    return !(flags & LIM_POLYGON_MESH) || (place == IN_MESH_LEAF && is_first) ||
           error_set(work->err, "polygon at word %zu: the words of a mesh leaf, of which it is not the first", at);
}

/* Records of leaves with an order have planes of their own, and no others. */
static bool check_flags(const struct checker *work, size_t at, enum place place, bool is_first)
{
    const lim_index flags = work->scene->polygons[at] & ~(lim_index)(LIM_POLYGON_COUNT | LIM_POLYGON_LAST);
    if (flags & ~(lim_index)TAKEN_FLAGS) return error_set(work->err, "polygon at word %zu: unknown flags", at);
    if (!check_mesh_flags(work, at, flags, place, is_first)) return false;
    if (place == IN_LEAF ? !(flags & LIM_POLYGON_PLANE) : flags & (LIM_POLYGON_PLANE | LIM_POLYGON_BACK))
        return error_set(work->err, "polygon at word %zu: %s", at,
                         place == IN_LEAF ? "in a leaf, without a plane" : "a plane of its own beside its node's");
    return !(flags & LIM_POLYGON_ALPHA) || !(flags & LIM_POLYGON_TEXTURE) || work->scene->texture_count ||
           error_set(work->err, "polygon at word %zu: transparent and textured at once", at);
}

/* Colours have 16 bits in words that may have 32; and of its flags, an edge has one. */
static bool check_bits(const struct checker *work, size_t at)
{
    const lim_index *record = &work->scene->polygons[at];
    const size_t count = record[0] & LIM_POLYGON_COUNT;
    if (record[1] > UINT16_MAX)
        return error_set(work->err, "polygon at word %zu: its colour is 0x%lx", at, (unsigned long)record[1]);
    for (size_t k = 0; record[0] & LIM_POLYGON_EDGES && k < count; k += 16) {
        const size_t bits = count - k < 16 ? count - k : 16;
        if (record[lim_record_edges_at(record[0]) + k / 16] >> bits)
            return error_set(work->err, "polygon at word %zu: flags of more edges than it has", at);
    }
    return true;
}

static bool check_texture_words(const struct checker *work, size_t at)
{
    const struct lim_scene *scene = work->scene;
    const lim_index *record = &scene->polygons[at];
    if (!(record[0] & LIM_POLYGON_TEXTURE)) return true;
    const lim_index *words = record + lim_record_words(record[0]) - LIM_POLYGON_TEXTURE_WORDS;
    if (words[0] >= scene->texture_count || words[1] >= scene->mapping_count)
        return error_set(work->err, "polygon at word %zu: texture %u of %u, mapping %u of %u", at, (unsigned)words[0],
                         (unsigned)scene->texture_count, (unsigned)words[1], (unsigned)scene->mapping_count);
    const uint16_t named = scene->mappings[words[1]].texture;
    if (lim_mappings_name_textures(scene) && named != words[0])
        return error_set(work->err, "polygon at word %zu: texture %u, where its mapping names %u", at,
                         (unsigned)words[0], (unsigned)named);
    const int times = scene->mappings[words[1]].uv[0][0];
    if (lim_texture_is_sky(&scene->textures[words[0]]) && (times < 1 || times > 16))
        return error_set(work->err, "polygon at word %zu: a sky that goes %d times round", at, times);
    const bool is_masked = lim_texture_is_masked(&scene->textures[words[0]]);
    return is_masked == ((record[0] & LIM_POLYGON_ALPHA) != 0) ||
           error_set(work->err, "polygon at word %zu: %s", at,
                     is_masked ? "a masked texture, and no alpha" : "transparent and textured at once");
}

static bool check_record(struct checker *work, size_t at, enum place place, bool is_first)
{
    const struct lim_scene *scene = work->scene;
    const lim_index head = scene->polygons[at], count = head & LIM_POLYGON_COUNT;
    const size_t words = lim_record_words(head);
    if (!check_flags(work, at, place, is_first)) return false;
    if (count < 3 || count > scene->limits.vertices)
        return error_set(work->err, "polygon at word %zu: %u vertices", at, (unsigned)count);
    if (at + words > scene->polygon_words) return error_set(work->err, "polygon at word %zu: runs over the end", at);
    for (size_t i = 0; i < words; i++) {
        if (work->used_words[at + i]) return error_set(work->err, "polygon at word %zu: overlaps another", at);
        work->used_words[at + i] = true;
        if (i >= LIM_POLYGON_HEAD_WORDS && i < LIM_POLYGON_HEAD_WORDS + (size_t)count &&
            scene->polygons[at + i] >= scene->vertex_count)
            return error_set(work->err, "polygon at word %zu: vertex %u of %u", at, (unsigned)scene->polygons[at + i],
                             (unsigned)scene->vertex_count);
    }
    if (!check_bits(work, at) || (head & LIM_POLYGON_ALPHA && !check_alpha(work, at))) return false;
    work->records++;
    work->words += words;
    if (!check_texture_words(work, at)) return false;
    return place != IN_LEAF || check_plane_ref(work, lim_record_plane(&scene->polygons[at]), "polygon at word", at);
}

/* By the run's first record, if there is one. */
static enum place place_of(const struct lim_scene *scene, size_t node, lim_index run)
{
    if (scene->nodes[node].split.plane != LIM_NO_INDEX) return IN_NODE;
    return run < scene->polygon_words && scene->polygons[run] & LIM_POLYGON_MESH ? IN_MESH_LEAF : IN_LEAF;
}

static bool check_run(struct checker *work, size_t node, lim_index run)
{
    const enum place place = place_of(work->scene, node, run);
    if (run == LIM_NO_INDEX) return true;
    for (size_t at = run;; at += lim_record_words(work->scene->polygons[at])) {
        if (at >= work->scene->polygon_words)
            return error_set(work->err, "node %zu: a run begins or goes on behind the last polygon", node);
        if (!check_record(work, at, place, at == run)) return false;
        if (work->scene->polygons[at] & LIM_POLYGON_LAST) return true;
    }
}

/* Nodes -------------------------------------------------------------------------------------- */

/* Every node but the root has one parent, which comes before it: so the nodes are a tree. */
static bool check_child(struct checker *work, size_t index, lim_index child)
{
    if (child == LIM_NO_INDEX) return true;
    if (child <= index || child >= work->scene->node_count)
        return error_set(work->err, "node %zu: child %u of %u", index, (unsigned)child,
                         (unsigned)work->scene->node_count);
    if (work->depths[child]) return error_set(work->err, "node %u: has two parents", (unsigned)child);
    work->depths[child] = work->depths[index] + 1;
    return true;
}

/* A node's plane, or that a leaf is one. */
static bool check_split(const struct checker *work, size_t index)
{
    const struct lim_node *node = &work->scene->nodes[index];
    if (node->split.plane != LIM_NO_INDEX) return check_plane_ref(work, &node->split, "node", index);
    if (node->split.offset || node->front != LIM_NO_INDEX || node->back != LIM_NO_INDEX ||
        node->back_run != LIM_NO_INDEX || node->front_run == LIM_NO_INDEX)
        return error_set(work->err, "node %zu: has no plane, and is not a leaf either", index);
    return true;
}

/* One leaf, whose order means nothing. */
static bool is_set(const struct lim_scene *scene)
{
    return scene->limits.depth == 0 && scene->node_count == 1 && scene->nodes[0].split.plane == LIM_NO_INDEX;
}

/* After its run is known to be sound. */
static bool check_mesh_leaf(struct checker *work, size_t index)
{
    const struct lim_scene *scene = work->scene;
    if (place_of(scene, index, scene->nodes[index].front_run) != IN_MESH_LEAF) return true;
    if (is_set(scene)) return error_set(work->err, "node %zu: a mesh leaf, and no levels of a tree", index);
    work->mesh_leaves++;
    return lim_check_mesh_leaf(scene, index, work->err);
}

static bool check_node(struct checker *work, size_t index)
{
    const struct lim_scene *scene = work->scene;
    const struct lim_node *node = &scene->nodes[index];
    if (work->depths[index] == 0) return error_set(work->err, "node %zu: has no parent", index);
    if (work->depths[index] > scene->limits.depth && !is_set(scene))
        return error_set(work->err, "node %zu: lies deeper than the limit of %u", index, (unsigned)scene->limits.depth);
    if (node->box != LIM_NO_INDEX && node->box >= scene->box_count)
        return error_set(work->err, "node %zu: box %u of %u", index, (unsigned)node->box, (unsigned)scene->box_count);
    return check_split(work, index) && check_run(work, index, node->front_run) &&
           check_run(work, index, node->back_run) && check_mesh_leaf(work, index) &&
           check_child(work, index, node->front) && check_child(work, index, node->back);
}

/* A limit of layers asks a renderer for memory, and says which way it is to paint. */
static bool check_totals(const struct checker *work)
{
    const struct lim_scene *scene = work->scene;
    if (work->records != scene->polygon_count || work->words != scene->polygon_words)
        return error_set(work->err, "%zu polygons in %zu words are drawn, %u in %u are there", work->records,
                         work->words, (unsigned)scene->polygon_count, (unsigned)scene->polygon_words);
    if (is_set(scene) && work->records > LIM_SORTED_MAX)
        return error_set(work->err, "a set of %zu polygons, %u are the most", work->records, LIM_SORTED_MAX);
    if (!work->mesh_leaves && (scene->limits.leaf_vertices || scene->limits.leaf_polygons))
        return error_set(work->err, "limits of %u vertices and %u polygons of mesh leaves, and there is none",
                         (unsigned)scene->limits.leaf_vertices, (unsigned)scene->limits.leaf_polygons);
    return !scene->limits.layers || work->transparent ||
           error_set(work->err, "limit of %u layers, and no polygon is transparent", (unsigned)scene->limits.layers);
}

static bool check_nodes(struct checker *work)
{
    const struct lim_scene *scene = work->scene;
    if (scene->limits.vertices > VERTICES_MAX)
        return error_set(work->err, "limit of %u vertices a polygon, %d are the most", (unsigned)scene->limits.vertices,
                         VERTICES_MAX);
    work->depths[0] = 1;
    for (size_t i = 0; i < scene->node_count; i++)
        if (!check_node(work, i)) return false;
    return check_totals(work);
}

/* Bounds: checked last, when all indices are known to be in range ------------------------------- */

/* The renderer scales its arithmetic by the root's box, and skips what a box does not show. */
static bool check_bounds(const struct checker *work)
{
    const struct lim_scene *scene = work->scene;
    struct bounds *all = grow_zeroed(scene->node_count, sizeof *all);
    bool ok = true;
    bounds_of_subtrees(scene, all);
    for (size_t i = 0; ok && i < scene->node_count; i++) {
        const lim_index box = scene->nodes[i].box;
        ok = box == LIM_NO_INDEX || !all[i].polygons ||
             (lim_scene_long(scene) ? bounds_fit_long(&all[i], &lim_scene_long(scene)->boxes[box])
                                    : bounds_fit(&all[i], &scene->boxes[box])) ||
             error_set(work->err, "node %zu: its box does not hold its polygons", i);
    }
    free(all);
    return ok;
}

/* Visible sets ----------------------------------------------------------------------------------------- */

static bool check_place(const struct lim_scene *scene, size_t index, struct error *err)
{
    const struct lim_place *place = &scene->places[index];
    if (place->cell >= 2 * (size_t)scene->node_count)
        return error_set(err, "place %zu: cell %u of %u nodes", index, (unsigned)place->cell,
                         (unsigned)scene->node_count);
    const struct lim_node *node = &scene->nodes[place->cell / 2];
    if ((place->cell % 2 ? node->back : node->front) != LIM_NO_INDEX)
        return error_set(err, "place %zu: cell %u is divided further", index, (unsigned)place->cell);
    if (index && place->cell <= scene->places[index - 1].cell)
        return error_set(err, "place %zu: does not come after the one before it", index);
    if (place->pvs == LIM_NONE || place->pvs < scene->pvs_bytes) return true;
    return error_set(err, "place %zu: visible set at byte %u of %u", index, (unsigned)place->pvs,
                     (unsigned)scene->pvs_bytes);
}

/* A visible set has a bit for each box, and no more. */
static bool check_pvs(const struct lim_scene *scene, size_t index, struct error *err)
{
    const size_t size_b = ((size_t)scene->box_count + 7) / 8;
    size_t at = scene->places[index].pvs, to = 0;
    if (at == LIM_NONE) return true;
    while (to < size_b && at < scene->pvs_bytes) {
        const size_t zeros = scene->pvs[at] ? 1 : at + 1 < scene->pvs_bytes ? scene->pvs[at + 1] : 0;
        if (zeros == 0) break;
        at += scene->pvs[at] ? 1 : 2;
        to += zeros;
    }
    return to == size_b || error_set(err, "place %zu: its visible set does not end with the boxes", index);
}

/* The renderer numbers cells with 16 bits, goes down to them by planes, and needs boxes to skip. */
static bool check_places(const struct lim_scene *scene, struct error *err)
{
    for (size_t i = 0; scene->place_count && i < scene->node_count; i++)
        if (scene->nodes[i].split.plane == LIM_NO_INDEX)
            return error_set(err, "node %zu: a leaf in a scene of places", i);
    if (scene->place_count && (scene->node_count > INT16_MAX || scene->box_count == 0))
        return error_set(err, "places in a scene of %u nodes and %u boxes", (unsigned)scene->node_count,
                         (unsigned)scene->box_count);
    for (size_t i = 0; i < scene->place_count; i++)
        if (!check_place(scene, i, err) || !check_pvs(scene, i, err)) return false;
    return true;
}

bool lim_check(const struct lim_scene *scene, struct error *err)
{
    struct checker work = {.scene = scene, .err = err};
    if (!lim_check_long(scene, err) || !check_vertices(scene, err) || !check_planes(scene, err) ||
        !check_boxes(scene, err) || !lim_check_textures(scene, err))
        return false;
    if (!scene->node_count) return lim_check_mesh(scene, err);
    if (*scene->deep_from || *scene->near_deep_from)
        return error_set(err, "depth from triangle %lu on, in a scene of polygons",
                         (unsigned long)(*scene->deep_from | *scene->near_deep_from));
    if (*scene->uvs) return error_set(err, "places of vertices in textures, in a scene of polygons");
    work.depths = grow_zeroed(scene->node_count, sizeof *work.depths);
    work.used_words = grow_zeroed(scene->polygon_words, sizeof *work.used_words);
    bool ok = check_nodes(&work) && check_bounds(&work) && check_places(scene, err);
    free(work.depths);
    free(work.used_words);
    return ok;
}
