/* SPDX-License-Identifier: MIT
 *
 * Polygons that are not flat or not convex, cut into triangles of their own corners. */
#ifndef SIM_TRIANGULATE_H
#define SIM_TRIANGULATE_H

#include "model/loop.h"

/* Writes count - 2 triangles of three corners each, with the loop's orientation. Where corners lie
 * on one line, or the loop crosses itself, some may have no area: the caller drops them. */
void triangulate(const struct loop *loop, const struct loop_view *view, uint32_t (*triangles)[3]);

#endif
