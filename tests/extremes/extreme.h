/* SPDX-License-Identifier: MIT
 *
 * What the tests of extremes share: a model compiled for each precision profile in turn, drawn, and
 * judged by the double-precision reference; and the row that says what was promised and measured. */
#ifndef TESTS_EXTREME_H
#define TESTS_EXTREME_H

#include "extreme_picture.h"
#include "render/ids.h"
#include "rigs/holes.h"
#include "rigs/profiles.h"
#include "rigs/random.h"

struct extreme_picture {
    unsigned w_px, h_px;
    double fov_deg; /* vertical */
    double near_m;  /* raised to what the renderer's near plane can be: camera.h */
};

/* A model on its way through one profile. */
struct extreme {
    const struct core *profile;
    struct mesh mesh;
    struct compiled scene;
    struct extreme_picture picture;
    struct lens lens;
    struct reference reference;
    struct ids ids;
    struct holes sum; /* over all frames drawn */
    struct extreme_best best;
};

/* Anything that fails ends the test. */
void extreme_open(struct extreme *extreme, const struct model *model, const struct core *profile,
                  const struct extreme_picture *picture);

/* The same with coordinates of 32 bits. */
void extreme_open_long(struct extreme *extreme, const struct model *model, const struct core *profile,
                       const struct extreme_picture *picture);
void extreme_close(struct extreme *extreme);

/* Draws a frame and adds it to the sum; the faces are in extreme->ids.faces. */
void extreme_frame(struct extreme *extreme, const double eye_m[3], const double target_m[3]);

/* The same for a camera of the renderer's own, without the reference. Returns the background's pixels. */
size_t extreme_camera(struct extreme *extreme, const struct lim_camera *camera);

/* The camera that extreme_frame() would draw with. */
struct lim_camera extreme_aim(const struct extreme *extreme, const double eye_m[3], const double target_m[3]);

/* The last frame as the extreme's picture, for those that are not drawn by extreme_frame(); only of profile fast. */
void extreme_show(struct extreme *extreme, const char *name);

/* A scene and how to look at it. */
struct extreme_plan {
    const char *name, *about; /* as extreme_about() */
    struct extreme_picture picture;
    void (*build)(struct model *model); /* starts from an empty one; every metre a unit: boxes.h */
    void (*look)(struct extreme *extreme, struct random *random); /* draws one frame */
    int frames;
    bool order; /* as in extreme_judge() */
};

/* Draws and judges it in every profile. */
void extreme_run(const struct extreme_plan *plan);

/* The same with coordinates of 32 bits; a metre may be any number of units. */
void extreme_run_long(const struct extreme_plan *plan);

/* What is extreme, as the beginning of a sentence that ends with what is promised: "The eye lies in a face's plane". */
void extreme_about(const char *name, const char *about);

/* The table's row, for tests/extremes/extremes.sh to collect: "# extreme NAME PROFILE promised ... measured ...". */
void extreme_row(const char *name, const char *profile, const char *promised, const char *measured, ...)
    __attribute__((format(printf, 4, 5)));

/* The usual row: holes and misplaced pixels of the frames so far. Holes are always promised to be none. With
 * `order`, so are misplaced pixels, which say that the order is exact; but not of profile draft, whose
 * corners are up to 0.7 pixels off, nor where faces are so thin that the reference's lattice of 1/64
 * pixels misses them. And so is the profile's share of wrong pixels, on screens that are not mostly edge. */
void extreme_judge(const struct extreme *extreme, const char *name, bool order);

#endif
