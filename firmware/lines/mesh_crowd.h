/* SPDX-License-Identifier: MIT
 *
 * Lines that more of a mesh's triangles cross than the pool has room for. The nearest of them stay in the pool. The
 * others, the crowd, are a list of numbers; all of them are farther away than what is in the pool. On each line they
 * begin anew, as many at a time as there is room for. They are painted before the pool's: the picture is the same. */
#ifndef LIM_MESH_CROWD_H
#define LIM_MESH_CROWD_H

#include "lines/mesh_clip.h"

struct lim_mesh_line;

/* All parts of one clipped triangle find room. */
enum { MESH_LEAST_ACTIVE = MESH_FAN + 1 };

/* Paints a line. `begins`: the first of mesh->links of the line that did not begin yet, or LIM_NO_INDEX. */
void lim_mesh_paint_crowded(struct lim_mesh *mesh, const struct lim_mesh_line *line, lim_index begins);

#endif
