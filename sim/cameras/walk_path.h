/* SPDX-License-Identifier: MIT
 *
 * A walk through a scene as a camera path: what somebody at the buttons would see who wants to see all of it. Each
 * frame's eye is where lim_walker_move() came to. */
#ifndef SIM_WALK_PATH_H
#define SIM_WALK_PATH_H

#include "cameras/camera_path.h"
#include "cameras/walk_map.h"

struct walk_wish {
    struct walk_body body;
    bool has_from;
    double from_m[3], heading_deg; /* the eye; 0 looks along -z, 90 along -x, as lim_camera's yaw */
    size_t frames;
    double stride_m; /* a frame */
};

struct walk_found {
    size_t places, seen; /* that can be reached; that some frame was at or saw from within SEEN_M */
    double way_m;
};

/* The same for the same scene and wish. Without `from`: of some places in free space that from which most can be
 * reached. *out is the caller's to free on success. */
bool walk_path(const struct compiled *scene, const char *name, const struct walk_wish *wish, struct camera_path *out,
               struct walk_found *found, struct error *err);

#endif
