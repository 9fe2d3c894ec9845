/* SPDX-License-Identifier: MIT
 *
 * The sizes of scene.h's structs in a firmware without LIM_HAS_WIDE, which the host's own are not. */
#include "scene/width.h"

#include "long.h"

#include <assert.h>

enum {
    INDEX_B = 2,
    NODE_FIELDS = 7,
    NARROW_COUNT_MAX = 0xFFFF,
    NARROW_PLANE_B = 12,
    NARROW_PLANES_MAX = 0xFFFC / 3,
    NARROW_LONG_PLANES_MAX = 0xFFFC,
    NARROW_MAPPING_B = 16
};

static_assert(sizeof(struct lim_node) == NODE_FIELDS * sizeof(lim_index), "node");
static_assert(sizeof(struct lim_mapping) == NARROW_MAPPING_B + sizeof(lim_index), "mapping");
static_assert(sizeof(struct lim_plane) == NARROW_PLANE_B + sizeof(lim_index), "plane");

bool width_is_wide(const struct lim_scene *scene)
{
    return scene->vertex_count > NARROW_COUNT_MAX || scene->node_count > NARROW_COUNT_MAX ||
           scene->plane_count > (lim_scene_long(scene) ? NARROW_LONG_PLANES_MAX : NARROW_PLANES_MAX) ||
           scene->polygon_words > NARROW_COUNT_MAX;
}

size_t width_node_b(bool wide)
{
    return wide ? sizeof(struct lim_node) : (size_t)NODE_FIELDS * INDEX_B;
}

size_t width_vertex_b(const struct lim_scene *scene)
{
    return lim_scene_long(scene) ? sizeof(struct lim_long_vertex) : sizeof(struct lim_vertex);
}

size_t width_box_b(const struct lim_scene *scene)
{
    return lim_scene_long(scene) ? sizeof(struct lim_long_box) : sizeof(struct lim_box);
}

size_t width_plane_b(const struct lim_scene *scene, bool wide)
{
    if (lim_scene_long(scene)) return sizeof(struct lim_long_plane);
    return wide ? sizeof(struct lim_plane) : (size_t)NARROW_PLANE_B;
}

size_t width_mapping_b(const struct lim_scene *scene, bool wide)
{
    return (wide ? sizeof(struct lim_mapping) : (size_t)NARROW_MAPPING_B) +
           (lim_scene_long(scene) ? sizeof(struct lim_long_mapping) : 0);
}

size_t width_word_b(bool wide)
{
    return wide ? sizeof(lim_index) : (size_t)INDEX_B;
}
