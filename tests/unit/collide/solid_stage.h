/* SPDX-License-Identifier: MIT
 *
 * A scene to move in, compiled, with the oracle's list of its polygons: what tests of movement begin with. A failure
 * ends the test. */
#ifndef TESTS_SOLID_STAGE_H
#define TESTS_SOLID_STAGE_H

#include "collide.h"
#include "compiler/compile.h"
#include "rigs/closed_scene.h"
#include "rigs/random.h"
#include "unit/collide/solid_oracle.h"

#define SOLID_E1M1 "/usr/share/games/doom/freedoom1.wad:E1M1"

struct solid_stage {
    char name[200];
    struct compiled scene;
    struct solid_list list;
    struct lim_solid solid;
    lim_index *stack;
    struct random random;
};

/* stage->scene has been compiled. */
void solid_stage_begin(struct solid_stage *stage, uint64_t seed);
void solid_stage_end(struct solid_stage *stage);

/* These compile a scene and begin: a file, a random building, a random closed scene, which the caller frees. */
void solid_stage_model(struct solid_stage *stage, const char *path, enum tree_kind tree, enum mesh_leaves leaves);
void solid_stage_building(struct solid_stage *stage, struct random *random, uint64_t number);
void solid_stage_closed(struct solid_stage *stage, struct closed_scene *closed, struct random *random, uint64_t number);

/* At random within the scene's bounds, whose half sizes are taken times part_q8. */
void solid_stage_in_bounds(struct solid_stage *stage, int64_t part_q8, int32_t at_q8[3]);

/* A place in a scene's own coordinates. */
void solid_place_q8(const struct compiled *scene, const double at_m[3], int32_t at_q8[3]);

#endif
