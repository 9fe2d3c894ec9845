/* SPDX-License-Identifier: MIT
 *
 * The polygon records of a scene: SCENE.md. They follow each other without gaps. A mesh's are triangles, of another
 * form: whoever goes from one to the next, or wants to know what is in one, asks here. */
#ifndef SIM_RECORDS_H
#define SIM_RECORDS_H

#include "scene.h"

#include <stddef.h>

struct record {
    const lim_index *corners; /* indices of vertices */
    size_t count;             /* of them */
    size_t words;             /* of all of it: the next one begins there */
    size_t colour_at;         /* the word, from its first, that is its colour */
    lim_index flags;          /* LIM_POLYGON_...; a triangle has none */
};

/* The one that begins at that word; both must be sound. */
static inline struct record record_at(const struct lim_scene *scene, size_t word)
{
    const lim_index *at = &scene->polygons[word];
    if (lim_scene_is_mesh(scene))
        return (struct record){.corners = at, .count = 3, .words = LIM_TRIANGLE_WORDS, .colour_at = 3};
    return (struct record){.corners = at + LIM_POLYGON_HEAD_WORDS,
                           .count = at[0] & LIM_POLYGON_COUNT,
                           .words = lim_record_words(at[0]),
                           .colour_at = 1,
                           .flags = at[0] & ~(lim_index)LIM_POLYGON_COUNT};
}

/* How many have any of these flags. */
size_t records_with(const struct lim_scene *scene, lim_index flags);

/* Whether any is transparent all over: not by holes of its texture alone. */
bool records_blended(const struct lim_scene *scene);

#endif
