/* SPDX-License-Identifier: MIT
 *
 * How large the renderer's pools must be: measured with the renderer itself. */
#ifndef SIM_POOL_SIZES_H
#define SIM_POOL_SIZES_H

#include "scene/compiled.h"

/* Sets scene->scene.limits and the image's, pools included: the most that any of 256 sampled cameras
 * and 64 portraits but the greediest needs at this size and precision (NULL: fast), and some more, but for a mesh. Also
 * sets scene->report.instructions, the mean of those cameras. */
bool pools_measure(struct compiled *scene, const struct core *core, unsigned w_px, unsigned h_px, struct error *err);

/* The same for a scene that has all that for the order nearest first: raises its limits to what scan lines take as
 * well, and sets the report's `draws` and `instructions` to theirs; unless a frame takes more than so many
 * instructions (0: any number): then it stops, early where they are many more, and changes nothing. */
bool pools_measure_scanline(struct compiled *scene, const struct core *core, double instructions_most,
                            struct error *err);

/* The same for a scene that has its limits already, with all that moves in it. */
struct moving;
bool pools_measure_moving(struct compiled *scene, struct moving *moving, const struct core *core, struct error *err);

/* Of a scene for which they are measured: raises its limits to what scan lines take as well, and draws it so, unless
 * these are predicted to cost more. */
bool pools_scan_moving(struct compiled *scene, struct moving *moving, const struct core *core, double instructions_most,
                       struct error *err);

#endif
