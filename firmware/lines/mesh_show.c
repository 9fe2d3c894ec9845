/* SPDX-License-Identifier: MIT
 *
 * What has no level of a texture, or none so far, paints itself by functions that look like those of a level
 * (texels.h): so a line asks no triangle what it shows. They find all they need by the level, which an entry holds. */
#include "lines/mesh_active.h"
#include "lines/mesh_texture.h"
#include "pixels/fill.h"
#include "pixels/texture.h"

#if LIM_HAS_TEXTURE && LIM_HAS_MESHES

void lim_mesh_show_colour(uint16_t *end, uint_fast16_t n, uint32_t place, const struct lim_texture_level *level)
{
    const struct lim_mesh_active *const active = lim_mesh_of_level(level);
    const struct lim_mesh_run run = lim_mesh_run(active->look->mesh, end, n);

    (void)place;
    lim_fill(run.line->pixels, (uint16_t)run.x0, (uint16_t)n, active->colour);
}

struct lim_textured_span lim_mesh_span(const struct lim_mesh *mesh, const struct lim_mesh_run *run,
                                       struct lim_gradients *gradients)
{
    const bool is_inside = lim_mesh_is_inside(mesh);

    return (struct lim_textured_span){mesh->pass->texturing, gradients, (int16_t)run->line->y,
                                      is_inside ? (int16_t)run->x0 : mesh->looks->left,
                                      is_inside ? (int16_t)run->x1 : mesh->looks->right};
}

void lim_mesh_show_perspective(uint16_t *end, uint_fast16_t n, uint32_t place, const struct lim_texture_level *level)
{
    struct lim_mesh_active *const active = lim_mesh_of_level(level);
    struct lim_mesh *const mesh = active->look->mesh;
    const struct lim_mesh_run run = lim_mesh_run(mesh, end, n);
    struct lim_gradients made;
    const struct lim_textured_span span = lim_mesh_span(mesh, &run, lim_mesh_texture_gradients(mesh, active, &made));

    (void)place;
    lim_texture_fill(&span, run.line->pixels, (uint16_t)run.x0, (uint16_t)run.x1, lim_stats_of(mesh->pass));
}

LIM_RARE void lim_mesh_show_other(uint16_t *end, uint_fast16_t n, const struct lim_texture_level *level)
{
    if (level->w_bits == LIM_MESH_COLOUR)
        lim_mesh_show_colour(end, n, 0, level);
    else
        lim_mesh_show_perspective(end, n, 0, level);
}

LIM_RARE void lim_mesh_show_first_clipped(uint16_t *end, uint_fast16_t n, uint32_t place,
                                          const struct lim_texture_level *level)
{
    struct lim_mesh_active *const active = lim_mesh_of_level(level);

    (void)place;
    if (level->w_bits == LIM_MESH_UNSET_CLIPPED) lim_mesh_texture_set_clipped(active->look->mesh, active);
    lim_mesh_show_other(end, n, level);
}

#endif
