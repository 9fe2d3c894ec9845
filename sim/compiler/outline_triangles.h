/* SPDX-License-Identifier: MIT
 *
 * Triangles of an outline. All of its corners are corners of some triangle, those in the middle of a straight side too,
 * and each of its edges is an edge of one: so meshes of such triangles are watertight where outlines are. */
#ifndef SIM_OUTLINE_TRIANGLES_H
#define SIM_OUTLINE_TRIANGLES_H

#include "compiler/outline.h"

/* Writes outline->count - 2 triangles, as indices of corners, turning as the outline does; of all ways to cut a small
 * outline that whose thinnest triangle is thickest. A turned or flat one is there only where no other cut does: the
 * outline is not convex, or a line, or has a corner twice. */
void outline_triangulate(const struct outline *outline, uint32_t (*triangles)[3]);

#endif
