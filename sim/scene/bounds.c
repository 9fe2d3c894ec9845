/* SPDX-License-Identifier: MIT
 *
 * Bounding boxes of subtrees, from the rounded vertices that are drawn. A box costs 12 bytes and,
 * on the way, about what two small polygons do: subtrees of fewer polygons go without. */
#include "scene/bounds.h"

#include "base/grow.h"
#include "scene/encoding.h"
#include "scene/records.h"
#include "scene/vertex_units.h"

#include <limits.h>
#include <stdlib.h>

static void bounds_extend(struct bounds *bounds, const int low[3], const int high[3])
{
    for (int k = 0; k < 3; k++) {
        if (low[k] < bounds->low[k]) bounds->low[k] = low[k];
        if (high[k] > bounds->high[k]) bounds->high[k] = high[k];
    }
}

/* A vertex with a fraction lies between two units. */
static void bounds_add_vertex(const struct lim_scene *scene, lim_index index, struct bounds *bounds)
{
    double units[3];
    vertex_units(scene, index, units);
    int low[3] = {(int)units[0], (int)units[1], (int)units[2]}, high[3] = {low[0], low[1], low[2]};
    if (scene->fractions) {
        const struct lim_fraction *fraction = &scene->fractions[index];
        const int rest_q8[3] = {fraction->x_q8, fraction->y_q8, fraction->z_q8};
        for (int k = 0; k < 3; k++) {
            low[k] -= rest_q8[k] < 0;
            high[k] += rest_q8[k] > 0;
        }
    }
    bounds_extend(bounds, low, high);
}

static void bounds_add_run(const struct lim_scene *scene, lim_index run, struct bounds *bounds)
{
    if (run == LIM_NO_INDEX) return;
    for (size_t at = run;;) {
        const struct record record = record_at(scene, at);
        for (size_t k = 0; k < record.count; k++)
            bounds_add_vertex(scene, record.corners[k], bounds);
        bounds->polygons++;
        if (record.flags & LIM_POLYGON_LAST) return;
        at += record.words;
    }
}

static struct bounds no_bounds(void)
{
    return (struct bounds){.low = {INT_MAX, INT_MAX, INT_MAX}, .high = {INT_MIN, INT_MIN, INT_MIN}};
}

static struct bounds bounds_of(const struct lim_scene *scene, const struct bounds *all, size_t index)
{
    const struct lim_node *node = &scene->nodes[index];
    const lim_index children[2] = {node->front, node->back};
    struct bounds bounds = no_bounds();
    bounds_add_run(scene, node->front_run, &bounds);
    bounds_add_run(scene, node->back_run, &bounds);
    for (int k = 0; k < 2; k++) {
        if (children[k] == LIM_NO_INDEX) continue;
        bounds_extend(&bounds, all[children[k]].low, all[children[k]].high);
        bounds.polygons += all[children[k]].polygons;
    }
    return bounds;
}

/* Children come after their parents. */
void bounds_of_subtrees(const struct lim_scene *scene, struct bounds *all)
{
    for (size_t i = scene->node_count; i-- > 0;)
        all[i] = bounds_of(scene, all, i);
}

struct bounds bounds_of_mesh(const struct lim_scene *scene)
{
    struct bounds bounds = no_bounds();
    for (size_t i = 0; i < scene->vertex_count; i++)
        bounds_add_vertex(scene, (lim_index)i, &bounds);
    bounds.polygons = scene->polygon_count;
    return bounds;
}

/* Rounded down, so the upper half is the larger one: at most 32768. */
static int centre_of(const struct bounds *bounds, int axis)
{
    const int sum = bounds->low[axis] + bounds->high[axis];
    return (sum - (sum < 0 && sum % 2 != 0)) / 2;
}

/* Empty bounds are found in scenes that are damaged alone. */
struct lim_box bounds_box(const struct bounds *bounds)
{
    struct lim_box box;
    for (int k = 0; k < 3; k++) {
        const int centre = centre_of(bounds, k);
        box.centre[k] = (int16_t)centre;
        box.half[k] = (uint16_t)(bounds->high[k] - centre);
    }
    return box;
}

struct lim_long_box bounds_long_box(const struct bounds *bounds)
{
    struct lim_long_box box;
    for (int k = 0; k < 3; k++) {
        box.centre[k] = centre_of(bounds, k);
        box.half[k] = (uint32_t)(bounds->high[k] - box.centre[k]);
    }
    return box;
}

bool bounds_fit_long(const struct bounds *bounds, const struct lim_long_box *box)
{
    for (int k = 0; k < 3; k++)
        if (bounds->low[k] < box->centre[k] - (int64_t)box->half[k] ||
            bounds->high[k] > box->centre[k] + (int64_t)box->half[k])
            return false;
    return true;
}

bool bounds_fit(const struct bounds *bounds, const struct lim_box *box)
{
    for (int k = 0; k < 3; k++)
        if (bounds->low[k] < box->centre[k] - box->half[k] || bounds->high[k] > box->centre[k] + box->half[k])
            return false;
    return true;
}

static void encode_mesh_box(struct encoding *encoding, const struct lim_scene *scene)
{
    const struct bounds bounds = bounds_of_mesh(scene);
    encoding->boxes = grow_zeroed(1, sizeof *encoding->boxes);
    encoding->boxes[encoding->box_count++] = bounds_box(&bounds);
}

/* What a mesh leaf's first record says of it; NULL: the node is none. */
static lim_index *mesh_leaf_words(const struct encoding *encoding, size_t node)
{
    const lim_index run = encoding->nodes[node].front_run;
    if (run == LIM_NO_INDEX || !lim_is_mesh_leaf(&encoding->words[run])) return NULL;
    return encoding->words + (lim_mesh_leaf_words(&encoding->words[run]) - encoding->words);
}

void encode_boxes(struct encoding *encoding)
{
    const struct lim_long of_32_bits = {.vertices = encoding->long_vertices};
    const struct lim_scene scene = {.vertices = encoding->vertices,
                                    .of_32_bits = {encoding->is_long ? &of_32_bits : NULL},
                                    .fractions = encoding->fractions,
                                    .nodes = encoding->nodes,
                                    .polygons = encoding->words,
                                    .vertex_count = (lim_index)encoding->vertex_count,
                                    .node_count = (lim_index)encoding->node_count,
                                    .polygon_count = (lim_index)encoding->record_count};
    if (lim_scene_is_mesh(&scene)) {
        encode_mesh_box(encoding, &scene);
        return;
    }
    struct bounds *all = grow_zeroed(encoding->node_count, sizeof *all);
    if (encoding->is_long)
        encoding->long_boxes = grow_zeroed(encoding->node_count, sizeof *encoding->long_boxes);
    else
        encoding->boxes = grow_zeroed(encoding->node_count, sizeof *encoding->boxes);
    bounds_of_subtrees(&scene, all);
    for (size_t i = 0; i < encoding->node_count; i++) {
        lim_index *words = mesh_leaf_words(encoding, i);
        if (all[i].polygons < SUBTREE_BOX_POLYGONS && !words) continue;
        encoding->nodes[i].box = (lim_index)encoding->box_count;
        if (words) words[LIM_MESH_LEAF_BOX] = encoding->nodes[i].box;
        if (encoding->is_long)
            encoding->long_boxes[encoding->box_count++] = bounds_long_box(&all[i]);
        else
            encoding->boxes[encoding->box_count++] = bounds_box(&all[i]);
    }
    free(all);
}
