/* SPDX-License-Identifier: MIT
 *
 * The vertices once more, in view space, through CLIP to the screen. */
#include "lines/mesh_clip.h"

#include "screen/edge.h"
#include "view/clip.h"
#include "view/view.h"

#if LIM_HAS_MESHES

bool lim_mesh_clip(const struct lim_mesh *mesh, lim_index triangle, struct lim_mesh_clipped *out)
{
    const struct lim_pass *pass = mesh->pass;
    const LIM_FLASH lim_index *corners = lim_mesh_triangle(mesh, triangle);
    struct lim_clip_polygon polygons[2];

    lim_clip_load(&polygons[0], &pass->view, pass->scene, corners, 3);
    const struct lim_clip_polygon *clipped = lim_clip(polygons, pass->view.rows.near_qv);
    out->n = clipped->n;
    for (uint_fast8_t k = 0; k < clipped->n; k++) {
        lim_view_project(&pass->view, &clipped->at[k], &out->at[k]);
        out->nearness[k] = lim_view_nearness(&clipped->at[k], mesh->near_shift);
    }
    if (!out->n || lim_edge_area(out->at, out->n) >= 0) return false;
    lim_edge_bounds(&out->shape, out->at, out->n);
    return true;
}

bool lim_mesh_fan(const struct lim_mesh_clipped *clipped, uint8_t part, struct lim_point at[3])
{
    uint_fast16_t corner = clipped->shape.apex;

    for (uint_fast8_t i = 0; i < 3; i++) {
        at[i] = clipped->at[corner];
        corner += i ? 1u : part;
        if (corner >= clipped->n) corner -= clipped->n;
    }
    return lim_edge_area(at, 3) < 0;
}

#endif
