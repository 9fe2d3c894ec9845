/* SPDX-License-Identifier: MIT
 *
 * The cameras of a glTF 2.0 file as a camera path: a frame each, in the order of its nodes, parents first. */
#ifndef SIM_GLTF_CAMERAS_H
#define SIM_GLTF_CAMERAS_H

#include "cameras/camera_path.h"

/* By its suffix. */
bool gltf_cameras_are_named(const char *path);

/* z_is_up: the file's z is taken for up, as its model's is with --up z. fov_deg: what is shown, from top to bottom; a
 * notice tells of cameras with another angle, and of those that lean to a side, which are drawn upright. Refuses, by
 * name, orthographic cameras, and a file that has none. */
bool gltf_cameras_read(const char *path, bool z_is_up, double fov_deg, struct camera_path *out, struct error *err);

#endif
