/* SPDX-License-Identifier: MIT
 *
 * Welding: in the file's order, each point that is still free stays, and takes every free point
 * near it along. So the points that stay are at least weld_m apart. */
#include "model/weld.h"

#include "base/deadline.h"
#include "base/grow.h"
#include "base/point_tree.h"
#include "base/progress.h"

#include <stdlib.h>
#include <string.h>

struct welding {
    uint32_t *index;  /* of each point of the model: in the mesh, or UINT32_MAX while it is free */
    uint32_t staying; /* the mesh index of the point that takes others along */
};

static void take_along(void *context, uint32_t point)
{
    struct welding *welding = context;
    if (welding->index[point] == UINT32_MAX) welding->index[point] = welding->staying;
}

/* The points that faces use, in the file's order. Returns how many. */
static size_t used_points(const struct model *model, uint32_t *used)
{
    bool *is_used = grow_zeroed(model->point_count, sizeof *is_used);
    size_t count = 0;
    for (size_t i = 0; i < model->corner_count; i++)
        is_used[model->corners[i]] = true;
    for (size_t i = 0; i < model->point_count; i++)
        if (is_used[i]) used[count++] = (uint32_t)i;
    free(is_used);
    return count;
}

uint32_t *weld_points(const struct model *model, double weld_m, struct mesh *mesh)
{
    struct welding welding = {.index = grow_zeroed(model->point_count, sizeof(uint32_t))};
    memset(welding.index, 0xFF, model->point_count * sizeof *welding.index);
    uint32_t *used = grow_zeroed(model->point_count, sizeof *used);
    size_t used_count = used_points(model, used);
    struct point_tree tree;
    point_tree_build(&tree, model->points, used, used_count);
    mesh->points = grow_zeroed(used_count, sizeof *mesh->points);
    for (size_t i = 0; i < used_count && !deadline_passed(); i++) {
        const double *point = model->points[used[i]];
        progress_bar(i, used_count, "welding points");
        if (welding.index[used[i]] != UINT32_MAX) continue;
        memcpy(mesh->points[mesh->point_count], point, sizeof *mesh->points);
        welding.staying = (uint32_t)mesh->point_count++;
        point_tree_near(&tree, point, point, weld_m, take_along, &welding);
    }
    progress_end();
    point_tree_free(&tree);
    free(used);
    return welding.index;
}
