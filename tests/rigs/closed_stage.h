/* SPDX-License-Identifier: MIT
 *
 * A random closed scene, compiled, with a lens to look around in it: for tests of whole frames. */
#ifndef TESTS_CLOSED_STAGE_H
#define TESTS_CLOSED_STAGE_H

#include "closed_scene.h"
#include "compiler/compile.h"
#include "scene/compiled.h"

struct closed_stage {
    struct closed_scene closed;
    struct mesh mesh;
    struct compiled scene;
    struct lens lens;
};

/* Between the two the model may be changed. A failure ends the test; closed_stage_close() what has been compiled. */
void closed_stage_make(struct closed_stage *stage, struct random *random);
void closed_stage_compile(struct closed_stage *stage, const struct compile_options *options, unsigned w_px,
                          unsigned h_px);
void closed_stage_close(struct closed_stage *stage);

/* Somewhere in free space, rolled anyhow. */
struct lim_camera closed_stage_camera(const struct closed_stage *stage, struct random *random);

#endif
