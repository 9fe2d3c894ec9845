/* SPDX-License-Identifier: MIT
 *
 * What the renderer relies on in a mesh leaf: what its first record says of all of it. */
#include "scene/lim_check.h"
#include "scene/records.h"

enum { POLYGONS_MAX = 32767 };

/* The leaf's vertices, from the first one on. */
struct range {
    lim_index first, count;
};

static bool check_range(const struct lim_scene *scene, size_t node, struct range range, struct error *err)
{
    if (range.count < 1 || range.first >= scene->vertex_count || range.count > scene->vertex_count - range.first)
        return error_set(err, "node %zu: a mesh leaf of %lu vertices from %lu on, of %lu", node,
                         (unsigned long)range.count, (unsigned long)range.first, (unsigned long)scene->vertex_count);
    return range.count <= scene->limits.leaf_vertices ||
           error_set(err, "node %zu: a mesh leaf of %lu vertices, the limit is %u", node, (unsigned long)range.count,
                     (unsigned)scene->limits.leaf_vertices);
}

static bool check_corners(const struct record *record, size_t word, struct range range, struct error *err)
{
    for (size_t k = 0; k < record->count; k++)
        if (record->corners[k] < range.first || record->corners[k] - range.first >= range.count)
            return error_set(err, "polygon at word %zu: vertex %lu is none of its mesh leaf", word,
                             (unsigned long)record->corners[k]);
    return true;
}

/* Its records, and how many they are. */
static bool check_records(const struct lim_scene *scene, size_t node, struct range range, lim_index polygons,
                          struct error *err)
{
    size_t count = 0, word = scene->nodes[node].front_run;
    for (;; count++) {
        const struct record record = record_at(scene, word);
        if (!check_corners(&record, word, range, err)) return false;
        if (record.flags & LIM_POLYGON_LAST) break;
        word += record.words;
    }
    return ++count == polygons || error_set(err, "node %zu: a mesh leaf that says it has %lu polygons, and has %zu",
                                            node, (unsigned long)polygons, count);
}

bool lim_check_mesh_leaf(const struct lim_scene *scene, size_t node, struct error *err)
{
    const lim_index *words = lim_mesh_leaf_words(&scene->polygons[scene->nodes[node].front_run]);
    const struct range range = {words[LIM_MESH_LEAF_FIRST], words[LIM_MESH_LEAF_COUNT]};
    const lim_index polygons = words[LIM_MESH_LEAF_POLYGONS], box = words[LIM_MESH_LEAF_BOX];
    if (scene->limits.leaf_polygons < 1 || scene->limits.leaf_polygons > POLYGONS_MAX)
        return error_set(err, "limit of %u polygons of a mesh leaf, 1 to %d may be sorted at once",
                         (unsigned)scene->limits.leaf_polygons, POLYGONS_MAX);
    if (polygons < 1 || polygons > POLYGONS_MAX)
        return error_set(err, "node %zu: a mesh leaf of %lu polygons, %d are the most", node, (unsigned long)polygons,
                         POLYGONS_MAX);
    if (box == LIM_NO_INDEX || box != scene->nodes[node].box)
        return error_set(err, "node %zu: a mesh leaf whose box is not the node's", node);
    return check_range(scene, node, range, err) && check_records(scene, node, range, polygons, err);
}
