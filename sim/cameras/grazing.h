/* SPDX-License-Identifier: MIT
 *
 * Cameras that look along a face: over floors, at the edges of thin things, down corridors. */
#ifndef SIM_GRAZING_H
#define SIM_GRAZING_H

#include "cameras/sample.h"

/* An eye a little above the plane of a face of the model, in front, from half of the face's width down to a
 * fiftieth, small heights as often as large ones by the logarithm, but no lower than twice the near plane. Faces
 * are drawn by their area. The eye looks from over one point of the face towards another one, or from beside the face;
 * level, or down to that point, or in between. What moves is not looked at. False: no free space is found there, or
 * scene->original is not known. */
bool sampler_grazing(struct sampler *sampler, struct viewpoint *out);

#endif
