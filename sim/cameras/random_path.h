/* SPDX-License-Identifier: MIT
 *
 * Cameras that nothing was tuned on: at random in a scene's free space. */
#ifndef SIM_RANDOM_PATH_H
#define SIM_RANDOM_PATH_H

#include "cameras/camera_path.h"

/* The same seed and the same bounds give the same cameras, but for points so near a polygon that rounding decides on
 * which side they are: the order of vertices and polygons does not matter. Fails where no free space is found. `name`
 * is for messages. */
bool random_path(const struct compiled *scene, const char *name, uint32_t seed, size_t count, struct camera_path *out,
                 struct error *err);

/* The same near faces of the model, whatever their size, but no nearer than the lens sees them (sampler_near()). Fails
 * for a scene from a .lim file, too. */
bool near_path(const struct compiled *scene, const struct lens *lens, const char *name, uint32_t seed, size_t count,
               struct camera_path *out, struct error *err);

/* The same looking along faces (sampler_grazing()). */
bool grazing_path(const struct compiled *scene, const struct lens *lens, const char *name, uint32_t seed, size_t count,
                  struct camera_path *out, struct error *err);

#endif
