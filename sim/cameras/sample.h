/* SPDX-License-Identifier: MIT
 *
 * Cameras sampled in a scene's free space: what the compiler measures memory and accuracy on, so
 * that neither is tuned to one path. The same scene gives the same cameras, on every machine. */
#ifndef SIM_SAMPLE_H
#define SIM_SAMPLE_H

#include "cameras/camera_path.h"
#include "scene/compiled.h"

struct sampler {
    const struct compiled *scene;
    uint64_t state;             /* of the random numbers */
    double low_m[3], high_m[3]; /* bounds of the scene */
    double near_m;              /* of the lens; the default by default */
    bool fronts_only;           /* eyes that see backs rather than fronts are left out */
    double time_s;              /* at which scene->moving is where sampler_near() looks at it */
};

/* The scene must outlive the sampler and have polygons. If a quarter of the eyes in its free space or more see backs
 * rather than fronts, these are left out: nobody is meant to be outside of a level that is made to be seen from within.
 * A closed scene, or an object, has hardly any such places, and keeps them. Of a model that is an interior all eyes are
 * where fronts are seen nearly all round, and in its bounds. */
void sampler_init(struct sampler *sampler, const struct compiled *scene);

/* Whether an eye may be there: in free space, and not where it is left out. */
bool sampler_may_be_at(const struct sampler *sampler, const double eye_m[3]);

/* How far an eye may be from the middle of the bounds, along an axis; longest_m: their longest side. */
double sampler_reach_m(const struct sampler *sampler, double longest_m);

/* An eye in front of whatever polygons face it (in a closed building: inside of it; around an
 * object: outside, up to one and a half times its size away), looking at some vertex. */
struct viewpoint sampler_next(struct sampler *sampler);

/* An eye around the scene, one to two times as far from the middle of its bounds as their corners are, looking there:
 * from twice as far a lens of 60 degrees has all in view, as large as it can be. False: there is no free space at that
 * place, as around a closed building. */
bool sampler_portrait(struct sampler *sampler, struct viewpoint *out);

/* An eye in front of a face of the model, from once to four times as far away as the face's surface patch is large, but
 * never so near that the near plane is in between; it looks at the face. Patches of all sizes have the same chance, by
 * the logarithm: of what is small as many are seen as of what is large, however few they are. What the scene has lost
 * is looked at, too. Half of the eyes look at something that moves in the scene, if anything does, where it is at the
 * sampler's time. False: no free space is found there, or scene->original is not known. */
bool sampler_near(struct sampler *sampler, struct viewpoint *out);

/* Other random numbers than those that sampler_init() begins with, which the compiler tunes on. */
void sampler_seed(struct sampler *sampler, uint32_t seed);

/* The next random number, from 0 up to 1. */
double sampler_unit(struct sampler *sampler);

/* An eye in free space as above, looking anywhere in the bounds: no vertex is preferred. False: no free space found. */
bool sampler_anywhere(struct sampler *sampler, struct viewpoint *out);

#endif
