/* SPDX-License-Identifier: MIT */
#include "portals/set_boxes.h"

#include "base/grow.h"

#include <stdlib.h>

/* A node comes before its children. */
void boxes_find(struct boxes *boxes, const struct lim_scene *scene)
{
    boxes->of_node = grow_zeroed(scene->node_count, sizeof *boxes->of_node);
    boxes->above = grow_zeroed(scene->box_count, sizeof *boxes->above);
    boxes->bits_b = ((size_t)scene->box_count + 7) / 8;
    if (scene->node_count) boxes->of_node[0] = LIM_NO_INDEX;
    for (size_t i = 0; i < scene->node_count; i++) {
        const struct lim_node *node = &scene->nodes[i];
        if (node->box != LIM_NO_INDEX) {
            boxes->above[node->box] = boxes->of_node[i];
            boxes->of_node[i] = node->box;
        }
        if (node->front != LIM_NO_INDEX) boxes->of_node[node->front] = boxes->of_node[i];
        if (node->back != LIM_NO_INDEX) boxes->of_node[node->back] = boxes->of_node[i];
    }
}

void boxes_free(struct boxes *boxes)
{
    free(boxes->of_node);
    free(boxes->above);
}

void boxes_show(const struct boxes *boxes, lim_index box, uint8_t *bits)
{
    for (; box != LIM_NO_INDEX; box = boxes->above[box])
        bits[box / 8] |= (uint8_t)(1u << box % 8);
}
