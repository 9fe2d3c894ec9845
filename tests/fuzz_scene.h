/* SPDX-License-Identifier: MIT
 *
 * Scenes from bytes: whatever the bytes, the scene keeps every promise of scene.h. Its polygons are anything
 * else: neither flat nor convex nor on their planes. */
#ifndef TESTS_FUZZ_SCENE_H
#define TESTS_FUZZ_SCENE_H

#include "fuzz.h"
#include "scene.h"

enum {
    FUZZ_VERTICES_MAX = 16,
    FUZZ_NODES_MAX = 10,
    FUZZ_RUN_MAX = 3,
    FUZZ_CORNERS_MAX = 9,
    FUZZ_PLANE_WORDS = sizeof(struct lim_plane_ref) / 2,
    FUZZ_WORDS_MAX = FUZZ_NODES_MAX * 2 * FUZZ_RUN_MAX * (LIM_POLYGON_HEAD_WORDS + FUZZ_CORNERS_MAX + FUZZ_PLANE_WORDS)
};

struct fuzz_scene {
    struct lim_scene scene; /* points into the arrays */
    struct lim_vertex vertices[FUZZ_VERTICES_MAX];
    struct lim_fraction fractions[FUZZ_VERTICES_MAX];
    struct lim_node nodes[FUZZ_NODES_MAX];
    struct lim_plane planes[FUZZ_NODES_MAX];
    struct lim_plane_exact exact[FUZZ_NODES_MAX];
    struct lim_box boxes[FUZZ_NODES_MAX];
    lim_index polygons[FUZZ_WORDS_MAX];
};

void fuzz_scene_make(struct fuzz_scene *made, struct fuzz_bytes *bytes);

#endif
