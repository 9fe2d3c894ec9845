/* SPDX-License-Identifier: MIT
 *
 * With u and v from one corner to the others, in sub-pixels, and p, q what nearness gains on the way there, the plane's
 * gradient is ((p vy - q uy) / A, (q ux - p vx) / A), A = ux vy - uy vx. All in 32 bits, the same on all processors:
 * differences along an axis are halved until they have 15 bits, so a product has 30 and A as well; what is divided is
 * cut to 15 bits, as A's reciprocal has 15. Both cuts are some 2^-14 of what nearness gains across the triangle. */
#include "lines/mesh_depth.h"

#include "lines/mesh_edges.h"
#include "lines/mesh_plane.h"
#include "lines/mesh_texture.h"
#include "math/fixed.h"
#include "pixels/fill.h"
#include "view/pass.h"

#if LIM_HAS_MESH_DEPTH

/* Gradients in 16.16 a pixel, of a numerator and the area's reciprocal r 2^(shift - 46). */
static LIM_INLINE uint32_t gradient_q16(int32_t numerator, uint32_t recip_q15, uint8_t shift, uint8_t halved_bits)
{
    uint32_t size = abs_s32(numerator);
    int32_t up = 16 + LIM_SUB_BITS + shift - 46 - halved_bits;

    if (!size) return 0;
    const uint8_t zeros = clz_u32(size);
    if (zeros < 17) {
        size >>= 17 - zeros;
        up += 17 - zeros;
    }
    size *= recip_q15;
    size = up >= 0 ? up > 31 ? 0 : size << up : up < -31 ? 0 : size >> -up;
    return numerator < 0 ? 0 - size : size;
}

/* The axes apart: a triangle may be as narrow as a line is high. */
static LIM_INLINE void set_differences(struct plane_of_three *plane, const struct lim_point *a,
                                       const struct lim_point *b, const struct lim_point *c)
{
    plane->ux = (int32_t)b->x - a->x;
    plane->uy = (int32_t)b->y - a->y;
    plane->vx = (int32_t)c->x - a->x;
    plane->vy = (int32_t)c->y - a->y;
    plane->halved_x = mesh_halve(&plane->ux, &plane->vx);
    plane->halved_y = mesh_halve(&plane->uy, &plane->vy);
}

/* Edges change places: what paints without depth finds no pixels, and what turns on the next line is asked there. */
static void take_depth(struct lim_mesh_active *active, uint16_t y)
{
    lim_mesh_edges_swap(&active->edges);
    active->depth->goes_on = active->goes_on;
    active->goes_on = LIM_MESH_DEEP;
    active->depth->turn = active->turn;
    active->turn = (uint16_t)(y + 1);
}

/* What a line of depths has more than nearness: a plane that is not quite right stays above 0, which is nothing, and
 * below 2^16, far away and near by. */
enum { ABOVE_NOTHING = 1 << 14 };

/* Nearness at the first pixel of a line, or of the screen, from a corner where it is known. */
static LIM_INLINE void mesh_set_plane(struct lim_mesh_active *active, const struct lim_point *a, uint16_t nearness,
                                      uint32_t x_q16, uint32_t y_q16, uint16_t y)
{
    const int32_t right_px = LIM_ORIGIN_PX + (a->x >> LIM_SUB_BITS), down_px = LIM_ORIGIN_PX + (a->y >> LIM_SUB_BITS);
    const int32_t part_x = a->x & (LIM_SUB - 1), part_y = a->y & (LIM_SUB - 1);
    uint32_t at_q16 = (uint32_t)(nearness + ABOVE_NOTHING) << 16;

    at_q16 -= x_q16 * (uint32_t)right_px + (uint32_t)(((int32_t)x_q16 >> LIM_SUB_BITS) * part_x);
    at_q16 += y_q16 * (uint32_t)((LIM_HAS_TEXTURE ? 0 : (int32_t)y) - down_px) -
              (uint32_t)(((int32_t)y_q16 >> LIM_SUB_BITS) * part_y);
    active->depth->at_q16 = at_q16;
    active->depth->x_q16 = x_q16;
    active->depth->y_q16 = y_q16;
    if (LIM_HAS_TEXTURE)
        lim_mesh_texture_deepen(active);
    else
        take_depth(active, y);
}

struct near_point {
    struct lim_point at;
    uint16_t nearness;
};

static LIM_INLINE_32 void set_depth(struct lim_mesh_active *active, const struct near_point *a,
                                    const struct near_point *b, const struct near_point *c, uint16_t y)
{
    const int32_t p = (int32_t)b->nearness - a->nearness, q = (int32_t)c->nearness - a->nearness;
    struct plane_of_three plane;
    uint32_t x_q16 = 0, y_q16 = 0;
    uint8_t shift;

    set_differences(&plane, &a->at, &b->at, &c->at);
    const int32_t area = plane.uy * plane.vx - plane.ux * plane.vy;
    if (area > 0) { /* else a sliver, once it is halved: nowhere wider than a pixel */
        const uint32_t recip_q15 = recip_q15_of((uint32_t)area, &shift);
        x_q16 = gradient_q16(q * plane.uy - p * plane.vy, recip_q15, shift, plane.halved_x);
        y_q16 = gradient_q16(p * plane.vx - q * plane.ux, recip_q15, shift, plane.halved_y);
    }
    mesh_set_plane(active, &a->at, a->nearness, x_q16, y_q16, y);
}

static LIM_INLINE struct near_point near_point_of(const struct lim_mesh *mesh, lim_index vertex)
{
    return (struct near_point){mesh->points[vertex], mesh->nearness[vertex]};
}

void lim_mesh_depth_begin(const struct lim_mesh *mesh, struct lim_mesh_active *active, uint16_t y)
{
    const LIM_FLASH lim_index *corners = lim_mesh_triangle(mesh, lim_mesh_number(active));
    const struct near_point a = near_point_of(mesh, corners[0]), b = near_point_of(mesh, corners[1]),
                            c = near_point_of(mesh, corners[2]);

    set_depth(active, &a, &b, &c, y);
    if (LIM_HAS_TEXTURE) lim_mesh_texture_unset(active);
}

/* Twice the size on the screen of a triangle of a fan. */
static int64_t size_of(const struct lim_mesh_clipped *clipped, uint_fast8_t k)
{
    const struct lim_point *const a = &clipped->at[0], *const b = &clipped->at[k], *const c = &clipped->at[k + 1];

    return (int64_t)((int32_t)b->y - a->y) * ((int32_t)c->x - a->x) -
           (int64_t)((int32_t)b->x - a->x) * ((int32_t)c->y - a->y);
}

/* By the largest triangle of a fan. */
LIM_RARE void lim_mesh_depth_clipped(struct lim_mesh_active *active, const struct lim_mesh_clipped *clipped, uint16_t y)
{
    uint_fast8_t largest = 1;

    for (uint_fast8_t k = 2; k + 1u < clipped->n; k++)
        if (size_of(clipped, k) > size_of(clipped, largest)) largest = k;
    const struct near_point a = {clipped->at[0], clipped->nearness[0]},
                            b = {clipped->at[largest], clipped->nearness[largest]},
                            c = {clipped->at[largest + 1], clipped->nearness[largest + 1]};
    set_depth(active, &a, &b, &c, y);
}

LIM_RARE void lim_mesh_depths_clear(struct lim_mesh *mesh, uint16_t y)
{
    mesh->depths->y = y;
    lim_fill_pairs((lim_pixel_pair *)mesh->depths->line_q16, mesh->pass->target.w_px, 0);
}

void lim_mesh_depth_go_on(struct lim_mesh_active *active, uint16_t y)
{
    take_depth(active, y);
}

/* Both edges have changed places. */
void lim_mesh_depth_replace(struct lim_mesh_active *active)
{
    lim_mesh_edges_replace(&active->edges, active->depth->goes_on ^ 1, &active->lower);
    active->depth->turn = active->bottom;
}

static LIM_INLINE void paint_deep(struct lim_mesh *mesh, const struct lim_mesh_line *line,
                                  struct lim_mesh_active *active, int32_t x0, int32_t x1)
{
    lim_mesh_depth_fill(line->pixels, lim_mesh_depths_q16(mesh, line->y), active, active->depth->at_q16, x0, x1);
}

void lim_mesh_depth_paint(struct lim_mesh *mesh, const struct lim_mesh_line *line, struct lim_mesh_active *active,
                          int32_t left, int32_t right)
{
    paint_deep(mesh, line, active, left, right);
}

void lim_mesh_depth_paint_part(struct lim_mesh *mesh, const struct lim_mesh_line *line, struct lim_mesh_active *active,
                               int32_t left, int32_t right)
{
    const int32_t x0 = left > line->x0 ? left : line->x0, x1 = right < line->x1 ? right : line->x1;

    if (x0 < x1) paint_deep(mesh, line, active, x0, x1);
}

#endif
