/* SPDX-License-Identifier: MIT
 *
 * Whether a compiled scene keeps what its precision profile promises: every face of the file that can be seen is there,
 * and about where the file has it. */
#ifndef SIM_FAITHFUL_H
#define SIM_FAITHFUL_H

#include "compiler/compile_options.h"
#include "scene/compiled.h"

struct original;

/* The promise: no corner of a face moves by more than this share of the size of the face's surface patch; and the plane
 * by which it is seen or not is stored no farther off than by the square root of the share. sim/DESIGN.md has the
 * reasons. */
#define FAITHFUL_SHARE (1.0 / 32.0)
#define FAITHFUL_PLANE_SHARE 0.17677669529663687

/* What spans less than a pixel of the default picture even from the near plane (options.near_m, or the usual one) is
 * not looked at: 240 pixels, 60 degrees. */
#define FAITHFUL_PIXEL 0.0048

/* FAITHFUL_CUT: drawn as it should be, but by no camera that is as near as the face's patch is large, because the
 * renderer cannot have its near plane so near; if nobody chose one (options.near_m). */
enum faithful_fault { FAITHFUL_KEPT, FAITHFUL_CUT, FAITHFUL_MOVED, FAITHFUL_VANISHED };

/* Whether the grid alone breaks the promise of any face: by rounding, or by how far it has the near plane. A mesh that
 * knows no original is not judged. */
bool faithful_wants_finer(const struct mesh *mesh, const struct compile_options *options);

/* tree_choice_compile(), and then: refuses, with faces and sizes named, a scene that does not keep the promise; or,
 * with options->drop_small, leaves those faces out, and what small faces they are joined to, and says so in
 * report.left_out. A mesh that knows no original is not judged. Of a scene that is refused report.is_refused is set. */
bool faithful_compile(const struct mesh *mesh, const struct compile_options *options, struct compiled *out,
                      struct error *err);

/* Says on standard error what --drop-small left out of a scene, and what faces in one plane cover, if anything. */
void faithful_note(const struct compiled *scene);

#endif
