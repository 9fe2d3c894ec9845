/* SPDX-License-Identifier: MIT
 *
 * From one record to the next by its own length. */
#include "scene/records.h"

size_t records_with(const struct lim_scene *scene, lim_index flags)
{
    size_t count = 0;
    for (size_t at = 0; at < scene->polygon_words; at += record_at(scene, at).words)
        count += (record_at(scene, at).flags & flags) != 0;
    return count;
}

bool records_blended(const struct lim_scene *scene)
{
    for (size_t at = 0; at < scene->polygon_words; at += record_at(scene, at).words)
        if ((record_at(scene, at).flags & (LIM_POLYGON_ALPHA | LIM_POLYGON_TEXTURE)) == LIM_POLYGON_ALPHA) return true;
    return false;
}
