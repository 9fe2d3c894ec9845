/* SPDX-License-Identifier: MIT
 *
 * Texels by depth: a place is looked up where its pixel is the nearest. */
#include "lines/mesh_texture.h"

#include "pixels/texture.h"

#if LIM_HAS_TEXTURE && LIM_HAS_MESH_DEPTH

/* Texels that advance evenly, pixels x0 <= x < x1. */
static void mesh_fill_texels(uint16_t *pixels, uint16_t *depths, const struct lim_mesh_active *active,
                             struct lim_texture_walk walk, const struct lim_texture_level *level, int32_t x0,
                             int32_t x1)
{
    const uint32_t step_q16 = active->depth->x_q16, rows_mask = level->rows_mask, w_bits = level->w_bits;
    const uint32_t columns = 31 - w_bits;
    const LIM_FLASH uint8_t *const texels = level->texels;
    const LIM_FLASH uint16_t *const palette = level->palette;
    uint32_t at_q16 = active->depth->at_q16 + (uint32_t)x0 * step_q16;
    const uint16_t *const end = pixels + x1;

    depths += x0;
    for (pixels += x0; pixels < end; pixels++, depths++, at_q16 += step_q16, walk.place += walk.step) {
        const uint32_t nearness = at_q16 >> 16;
        if (nearness <= *depths) continue;
        *depths = (uint16_t)nearness;
        *pixels = palette[texels[(walk.place << 15 >> columns << w_bits & rows_mask) + (walk.place >> 1 >> columns)]];
    }
}

/* Of one in perspective, stretch by stretch. */
static void fill_stretches_deep(struct lim_mesh *mesh, const struct lim_mesh_line *line, uint16_t *depths,
                                const struct lim_mesh_active *active, const struct lim_textured_span *span, int32_t x0,
                                int32_t x1)
{
    struct lim_texture_line stretches;

    lim_texture_line_begin(&stretches, span, (int16_t)x0);
    for (int32_t x = x0;;) {
        const int32_t end = lim_texture_lesser(stretches.end, x1);
        const struct lim_texture_walk walk = {lim_texture_place(&stretches, x), stretches.walk.step};
        mesh_fill_texels(line->pixels, depths, active, walk, &span->gradients->level, x, end);
        if (end == x1) break;
        x = end;
        lim_texture_line_next(&stretches);
    }
    if (LIM_HAS_STATS) lim_stats_of(mesh->pass)->divisions += stretches.divisions;
}

void lim_mesh_texture_paint_deep(struct lim_mesh *mesh, const struct lim_mesh_line *line,
                                 struct lim_mesh_active *active, const struct lim_mesh_depth_span *deep)
{
    const struct lim_mesh_look *const look = active->look;
    struct lim_gradients made;

    if (look->level.w_bits < LIM_MESH_LEVELS) {
        const struct lim_texture_walk walk = {
            lim_texture_even_place(&look->even, look->level.step, deep->x0, line->y + 1), look->level.step};
        mesh_fill_texels(line->pixels, deep->depths, active, walk, &look->level, deep->x0, deep->x1);
        return;
    }
    const struct lim_textured_span span = {mesh->pass->texturing, lim_mesh_texture_gradients(mesh, active, &made),
                                           (int16_t)line->y, (int16_t)deep->left, (int16_t)deep->right};
    fill_stretches_deep(mesh, line, deep->depths, active, &span, deep->x0, deep->x1);
}

#endif
