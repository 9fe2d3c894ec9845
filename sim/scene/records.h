/* SPDX-License-Identifier: MIT
 *
 * The polygon records of a scene: SCENE.md. They follow each other without gaps. */
#ifndef SIM_RECORDS_H
#define SIM_RECORDS_H

#include "scene.h"

/* How many have any of these flags. */
size_t records_with(const struct lim_scene *scene, lim_index flags);

#endif
