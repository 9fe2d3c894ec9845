/* SPDX-License-Identifier: MIT
 *
 * What the renderer relies on in a long scene: the bounds of long.h. */
#include "long.h"
#include "scene/lim_check.h"

#include <stdlib.h>

enum { NORMAL_MAX = 1 << 30, HALF_MAX = 1 << 30 };

static bool is_within(const int32_t at[3], int32_t most)
{
    for (int i = 0; i < 3; i++)
        if (at[i] < -most || at[i] > most) return false;
    return true;
}

/* What such a scene cannot have. */
bool lim_check_long(const struct lim_scene *scene, struct error *err)
{
    if (!lim_scene_long(scene)) return true;
    if (!scene->node_count) return error_set(err, "coordinates of 32 bits without a tree");
    if (scene->exact_count) return error_set(err, "exact planes beside coordinates of 32 bits");
    return !scene->limits.leaf_polygons || error_set(err, "mesh leaves beside coordinates of 32 bits");
}

bool lim_check_long_vertices(const struct lim_scene *scene, struct error *err)
{
    for (size_t i = 0; i < scene->vertex_count; i++)
        if (!is_within(lim_scene_long(scene)->vertices[i].at, LIM_LONG_END))
            return error_set(err, "vertex %zu: a coordinate is beyond 2^29", i);
    return true;
}

bool lim_check_long_boxes(const struct lim_scene *scene, struct error *err)
{
    for (size_t i = 0; i < scene->box_count; i++) {
        const struct lim_long_box *box = &lim_scene_long(scene)->boxes[i];
        bool fits = is_within(box->centre, LIM_LONG_END);
        for (int k = 0; k < 3; k++)
            fits &= box->half[k] <= HALF_MAX;
        if (!fits) return error_set(err, "box %zu: beyond the grid", i);
    }
    return true;
}

bool lim_check_long_planes(const struct lim_scene *scene, struct error *err)
{
    for (size_t i = 0; i < scene->plane_count; i++) {
        const struct lim_long_plane *plane = &lim_scene_long(scene)->planes[i];
        if (!is_within(plane->n, NORMAL_MAX) || !(plane->n[0] | plane->n[1] | plane->n[2]))
            return error_set(err, "plane %zu: its normal is out of bounds", i);
        if (plane->vertex >= scene->vertex_count)
            return error_set(err, "plane %zu: at vertex %lu of %lu", i, (unsigned long)plane->vertex,
                             (unsigned long)scene->vertex_count);
    }
    return true;
}

/* A sky has no place on a plane, but its mapping keeps these bounds, too. */
bool lim_check_long_mapping(const struct lim_scene *scene, size_t index, struct error *err)
{
    const struct lim_mapping *mapping = &scene->mappings[index];
    const struct lim_long_mapping *places = &lim_scene_long(scene)->mappings[index];
    const bool upright = mapping->scale & LIM_MAPPING_UPRIGHT;
    const lim_index count = upright ? scene->vertex_count : scene->plane_count;
    for (int i = 0; i < 2; i++)
        if (llabs(places->uv[i][0]) + llabs(places->uv[i][1]) > LIM_LONG_UV_MAX)
            return error_set(err, "mapping %zu: a vector is too long", index);
    if (places->bits < LIM_LONG_UV_BITS_MIN || places->bits > LIM_LONG_UV_BITS_MAX)
        return error_set(err, "mapping %zu: places of %u bits", index, places->bits);
    if (abs(places->level_q4) > LIM_LONG_LEVEL_MAX_Q4)
        return error_set(err, "mapping %zu: no picture has %d / 16 levels", index, places->level_q4);
    if (places->zero) return error_set(err, "mapping %zu: %u where zero is", index, places->zero);
    return mapping->plane < count || error_set(err, "mapping %zu: its plane is number %lu of %lu", index,
                                               (unsigned long)mapping->plane, (unsigned long)count);
}

bool lim_check_long_ref(const struct lim_scene *scene, const struct lim_plane_ref *ref, const char *what, size_t index,
                        struct error *err)
{
    const lim_index at = ref->plane >= LIM_PLANE_X ? (lim_index)ref->offset : ref->plane;
    const lim_index count = ref->plane >= LIM_PLANE_X ? scene->vertex_count : scene->plane_count;
    if (ref->plane < LIM_PLANE_X && ref->offset)
        return error_set(err, "%s %zu: an offset beside a plane of its own", what, index);
    return at < count || error_set(err, "%s %zu: its plane is number %lu of %lu", what, index, (unsigned long)at,
                                   (unsigned long)count);
}
