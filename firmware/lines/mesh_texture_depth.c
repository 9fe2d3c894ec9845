/* SPDX-License-Identifier: MIT
 *
 * Texels by depth: runs of pixels that are the nearest are painted as those of any other triangle. */
#include "lines/mesh_depth.h"
#include "lines/mesh_texture.h"
#include "pixels/texture.h"

#if LIM_HAS_TEXTURE && LIM_HAS_MESH_DEPTH

/* A line of something that has depth. */
struct deep_line {
    uint16_t *pixels;
    uint32_t *depths_q16;
    uint32_t at_q16, step_q16; /* nearness of its first pixel, and what one to the right adds */
};

static LIM_INLINE struct deep_line deep_line(const struct lim_mesh_active *active, const struct lim_mesh_line *line)
{
    const struct lim_mesh_depth *const depth = active->depth;

    return (struct deep_line){line->pixels, lim_mesh_depths_q16(depth->mesh, line->y),
                              depth->at_q16 + depth->y_q16 * line->y, depth->x_q16};
}

/* Texels that advance evenly, pixels x0 <= x < x1, from the first one's place on. Indices run from -n up to 0, so that
 * one number leads to both lines. */
static LIM_INLINE void mesh_fill_texels(const struct deep_line *line, int32_t x0, int32_t x1, uint32_t place,
                                        const struct lim_texture_level *level, lim_texels_painter *paint)
{
    uint32_t at_q16 = line->at_q16 + line->step_q16 * (uint32_t)x0;
    uint16_t *const pixels = line->pixels + x1;
    uint32_t *const depths_q16 = line->depths_q16 + x1;
    int32_t at = x0 - x1;

    do {
        while (at_q16 <= depths_q16[at]) {
            at_q16 += line->step_q16;
            place += level->step;
            if (++at == 0) return;
        }
        const int32_t from = at;
        do {
            depths_q16[at] = at_q16;
            at_q16 += line->step_q16;
        } while (++at < 0 && at_q16 > depths_q16[at]);
        paint(pixels + at, (uint_fast16_t)(at - from), place, level);
        place += level->step * (uint32_t)(at - from);
    } while (at < 0);
}

/* Of one in perspective, stretch by stretch. */
static LIM_RARE void fill_stretches_deep(const struct deep_line *line, const struct lim_textured_span *span, int32_t x0,
                                         int32_t x1, struct lim_stats *stats)
{
    struct lim_texture_line stretches;

    lim_texture_line_begin(&stretches, span, (int16_t)x0);
    for (int32_t x = x0;;) {
        const int32_t end = lim_texture_lesser(stretches.end, x1);
        span->gradients->level.step = stretches.walk.step;
        mesh_fill_texels(line, x, end, lim_texture_place(&stretches, x), &span->gradients->level,
                         span->gradients->paint);
        if (end == x1) break;
        x = end;
        lim_texture_line_next(&stretches);
    }
    if (LIM_HAS_STATS) stats->divisions += stretches.divisions;
}

/* What has no level, or none so far. false: it has got one. */
static LIM_RARE bool show_deep_other(struct lim_mesh_active *active, const struct lim_mesh_run *run)
{
    struct lim_mesh *const mesh = active->depth->mesh;
    const uint8_t *const w_bits = &active->look->level.w_bits;
    struct lim_gradients made;

    if (*w_bits == LIM_MESH_UNSET) lim_mesh_texture_set(mesh, active);
    if (*w_bits == LIM_MESH_UNSET_CLIPPED) lim_mesh_texture_set_clipped(mesh, active);
    active->look->show = lim_mesh_show_deep;
    if (*w_bits < LIM_MESH_LEVELS) return false;
    const struct deep_line line = deep_line(active, run->line);
    if (*w_bits == LIM_MESH_COLOUR) {
        lim_mesh_depth_fill(line.pixels, line.depths_q16, active, line.at_q16, run->x0, run->x1);
        return true;
    }
    const struct lim_textured_span span = lim_mesh_span(mesh, run, lim_mesh_texture_gradients(mesh, active, &made));
    fill_stretches_deep(&line, &span, run->x0, run->x1, lim_stats_of(mesh->pass));
    return true;
}

void lim_mesh_show_deep(uint16_t *end, uint_fast16_t n, uint32_t place, const struct lim_texture_level *level)
{
    struct lim_mesh_active *const active = lim_mesh_of_level(level);
    const struct lim_mesh_look *const look = active->look;
    const struct lim_mesh_run run = lim_mesh_run(active->depth->mesh, end, n);

    if (level->w_bits >= LIM_MESH_LEVELS) {
        if (show_deep_other(active, &run)) return;
        place = lim_texture_even_place(&look->even, level->step, run.x0, run.line->y + 1);
    }
    const struct deep_line line = deep_line(active, run.line);
    mesh_fill_texels(&line, run.x0, run.x1, place, level,
                     LIM_OPTIMISE_SIZE ? lim_texels_paint_any : lim_texels_painters[level->w_bits]);
}

#endif
