/* SPDX-License-Identifier: MIT
 *
 * Scenes of many scales, in metres: what is small in them is some millionths of the whole. For the tests of long
 * scenes. */
#ifndef TESTS_SCALES_MODELS_H
#define TESTS_SCALES_MODELS_H

#include "model/model.h"
#include "rigs/random.h"

/* A box upon a place, turned about the upright axis; seen from outside, or, `inside`, from within. */
struct scales_box {
    double foot_m[3], size_m[3];
    double turn; /* radians */
    bool inside;
};
void scales_add_box(struct model *model, const struct scales_box *box);

/* Each adds to a model that is empty, the same one each time; and puts eye and target where what is small is near, or
 * where all of it is seen. Eyes are outside of all solids. */
struct scales {
    const char *name, *about; /* as extreme_about() has them */
    double near_m;            /* less than what is smallest */
    void (*build)(struct model *model);
    void (*look)(struct random *random, double eye_m[3], double target_m[3]);
};

enum { SCALES_COUNT = 6 };
extern const struct scales scales_all[SCALES_COUNT];

#endif
