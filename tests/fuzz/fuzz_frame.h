/* SPDX-License-Identifier: MIT
 *
 * Frames for the fuzz targets, in any precision profile, method and size of memory, with what every
 * frame promises checked. */
#ifndef TESTS_FUZZ_FRAME_H
#define TESTS_FUZZ_FRAME_H

#include "fuzz.h"
#include "limner.h"

enum { FUZZ_SIDE_MAX_PX = 32 };

struct fuzz_frame {
    const struct lim_scene *scene;
    struct lim_camera camera;
    uint16_t w_px, h_px; /* 1..FUZZ_SIDE_MAX_PX */
    bool is_ordered;     /* the scene keeps more than lim_check()'s promises: its boxes hold their subtrees */
};

/* Any bits. */
struct lim_camera fuzz_camera_from(struct fuzz_bytes *bytes);

/* camera.h's ranges. */
bool fuzz_camera_is_legal(const struct lim_camera *camera);

/* Draws in one of the precision profiles and one of six ways (nearest first, the same in the least memory or by gaps,
 * by scan lines in enough memory or the least, back to front), or as a mesh by one of four (by distance or depth, each
 * in the least memory, too); `choice` says which. A legal camera must be drawn, any other one refused; every pixel
 * painted, and done exactly once. An ordered scene, which is no mesh, is drawn in another way too, and must look the
 * same. The broken promise, or NULL. */
const char *fuzz_draw(const struct fuzz_frame *frame, uint8_t choice);

#endif
