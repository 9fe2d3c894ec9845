/* SPDX-License-Identifier: MIT
 *
 * Texels advance evenly over most triangles of a dense mesh, as depth hardly changes on them. Between corners where 1 /
 * z is w, they are off from where they should be by the covariance of place and w, over the mean of w: a quarter of the
 * product of both ranges at most, over the least w. Where that is more than LIM_TEXTURE_OFF_BITS allow, or numbers get
 * too large, texels advance in perspective. */
#include "lines/mesh_texture.h"

#include "lines/mesh_plane.h"
#include "math/fixed.h"
#include "pixels/texture_planes.h"
#include "pixels/texture_triangle.h"
#include "view/packed.h"

#if LIM_HAS_TEXTURE && LIM_HAS_MESHES

LIM_STATIC_ASSERT(sizeof(union lim_mesh_gradients) <= MESH_GRADIENT_ENTRIES * sizeof(struct lim_mesh_active),
                  "gradients take the room of so many entries");

/* How far three numbers, of which one is 0, are apart. */
static inline uint32_t range_of(int32_t a, int32_t b)
{
    int32_t least = a < b ? a : b, most = a < b ? b : a;

    if (least > 0) least = 0;
    if (most < 0) most = 0;
    return (uint32_t)(most - least);
}

/* A triangle: what the corners b and c have more than a has, of a place and of nearness. */
struct places {
    int32_t bu, bv, cu, cv;
    uint32_t range, least_near, near_range;
};

static LIM_INLINE void set_places(const struct lim_mesh *mesh, const LIM_FLASH lim_index *corners,
                                  const LIM_FLASH struct lim_uv *a, struct places *places)
{
    const LIM_FLASH struct lim_uv *const uvs = *mesh->pass->scene->uvs;
    const LIM_FLASH struct lim_uv *const b = &uvs[corners[1]], *const c = &uvs[corners[2]];
    const uint32_t i = mesh->nearness[corners[0]], j = mesh->nearness[corners[1]], k = mesh->nearness[corners[2]];
    uint32_t least = i < j ? i : j, most = i < j ? j : i;

    if (k < least) least = k;
    if (k > most) most = k;
    places->least_near = least;
    places->near_range = most - least + 1; /* both are rounded */
    places->bu = b->u - a->u, places->bv = b->v - a->v;
    places->cu = c->u - a->u, places->cv = c->v - a->v;
    const uint32_t u_range = range_of(places->bu, places->cu), v_range = range_of(places->bv, places->cv);
    places->range = u_range > v_range ? u_range : v_range;
}

/* log2 of the mantissa and its shift, but for a constant. */
static inline int32_t short_log2_q4(uint32_t mantissa_q31, uint8_t zeros)
{
    return (int32_t)(mantissa_q31 >> 27) - zeros * 16;
}

/* Texels to a pixel, by the areas of both. */
static LIM_INLINE uint8_t level_of_places(const LIM_FLASH struct lim_texture *texture, const struct places *places,
                                          uint32_t area, uint8_t zeros, int_fast16_t halved)
{
    uint8_t own_zeros;
    const uint32_t own = normalise_u32(abs_s32(places->bu * places->cv - places->cu * places->bv) | 1, &own_zeros);
    const int32_t twice_q4 = short_log2_q4(own, own_zeros) - short_log2_q4(area << zeros, zeros) +
                             32 * (texture->w_bits - texture->place_bits + LIM_SUB_BITS) - 16 * (int32_t)halved;
    const int32_t level = (twice_q4 + 2 * MIDDLE_OF_LEVEL_Q4) >> 5;

    return (uint8_t)(level < 0 ? 0 : level < texture->levels ? level : texture->levels - 1);
}

/* Whether even texels are right enough, and steps, which are rounded, lead no farther away. */
static LIM_INLINE bool is_even(const LIM_FLASH struct lim_texture *texture, const struct places *places, uint8_t level,
                               uint32_t reach_px)
{
    const int_fast16_t bits = (int_fast16_t)(2 - LIM_TEXTURE_OFF_BITS + texture->place_bits + level - texture->w_bits);
    const int_fast16_t reach_bits = (int_fast16_t)(level + 15 - LIM_TEXTURE_OFF_BITS - texture->w_bits);

    if (bits < 0 || reach_bits < 0 || places->range >> 15) return false;
    return places->near_range * places->range <= places->least_near << (bits < 15 ? bits : 15) &&
           reach_px >> reach_bits == 0;
}

/* What a pixel adds to a place, in 2^-16 of the width. */
static inline int32_t place_step(int32_t numerator, int32_t recip_q31, int_fast16_t down)
{
    return (int32_t)(lim_texture_shifted(lim_texture_times(numerator, recip_q31), down - 1) + 1) >> 1;
}

/* The place of a corner's pixel's centre. */
static inline uint32_t place_at(int32_t corner_q16, int32_t step_x, int32_t step_y, lim_packed at)
{
    const uint32_t part_x = (uint32_t)(lim_packed_x(at) & (LIM_SUB - 1)),
                   part_y = (uint32_t)(lim_packed_y(at) & (LIM_SUB - 1));

    return (uint32_t)corner_q16 -
           (uint32_t)((int32_t)((uint32_t)step_x * part_x + (uint32_t)step_y * part_y) >> LIM_SUB_BITS);
}

/* From the corner a, whose pixel is that of its sub-pixels. */
static LIM_INLINE void set_steps(const struct lim_texture *texture, const struct lim_uv *corner, lim_packed a,
                                 const struct plane_of_three *plane, const struct places *places, int32_t recip_q31,
                                 uint8_t zeros, struct lim_texture_even *even)
{
    const int_fast16_t down = (int_fast16_t)(14 + texture->place_bits - LIM_SUB_BITS - zeros);
    const int_fast16_t down_x = down + plane->halved_x, down_y = down + plane->halved_y;
    const uint8_t up = (uint8_t)(16 - texture->place_bits);
    const int32_t ux = place_step(places->cu * plane->uy - places->bu * plane->vy, recip_q31, down_x);
    const int32_t uy = place_step(places->bu * plane->vx - places->cu * plane->ux, recip_q31, down_y);
    const int32_t vx = place_step(places->cv * plane->uy - places->bv * plane->vy, recip_q31, down_x);
    const int32_t vy = place_step(places->bv * plane->vx - places->cv * plane->ux, recip_q31, down_y);
    const int32_t x_px = LIM_ORIGIN_PX + (lim_packed_x(a) >> LIM_SUB_BITS),
                  y_px = LIM_ORIGIN_PX + (lim_packed_y(a) >> LIM_SUB_BITS);

    even->x = lim_texture_packed((uint32_t)ux, (uint32_t)vx);
    even->y = lim_texture_packed((uint32_t)uy, (uint32_t)vy);
    even->place = lim_texture_packed(place_at(corner->u * (INT32_C(1) << up), ux, uy, a),
                                     (uint16_t)place_at(corner->v * (INT32_C(1) << up), vx, vy, a)) -
                  even->x * (uint32_t)x_px - even->y * (uint32_t)y_px;
}

/* false: it is not even. */
static LIM_INLINE bool set_even_look(const struct lim_mesh *mesh, struct lim_mesh_look *look,
                                     const LIM_FLASH lim_index *corners, const LIM_FLASH struct lim_texture *texture)
{
    const lim_packed a = lim_packed_load(&mesh->points[corners[0]]), b = lim_packed_load(&mesh->points[corners[1]]),
                     c = lim_packed_load(&mesh->points[corners[2]]);
    const struct lim_uv corner = (*mesh->pass->scene->uvs)[corners[0]];
    struct plane_of_three plane = {lim_packed_x(b) - lim_packed_x(a),
                                   lim_packed_y(b) - lim_packed_y(a),
                                   lim_packed_x(c) - lim_packed_x(a),
                                   lim_packed_y(c) - lim_packed_y(a),
                                   0,
                                   0};
    const uint32_t reach_px = (range_of(plane.ux, plane.vx) + range_of(plane.uy, plane.vy)) >> LIM_SUB_BITS;
    struct places places;
    uint8_t zeros;

    set_places(mesh, corners, &(*mesh->pass->scene->uvs)[corners[0]], &places);
    plane.halved_x = mesh_halve(&plane.ux, &plane.vx);
    plane.halved_y = mesh_halve(&plane.uy, &plane.vy);
    const int32_t wide = plane.uy * plane.vx - plane.ux * plane.vy;
    const uint32_t area = wide > 0 ? (uint32_t)wide : 1; /* a sliver, once it is halved: nowhere wider than a pixel */
    const int32_t recip_q31 = lim_texture_reciprocal(area, &zeros);
    const uint8_t level = level_of_places(texture, &places, area, zeros, plane.halved_x + plane.halved_y);
    if (!is_even(texture, &places, level, reach_px)) return false;
    lim_texture_set_level(mesh->pass->scene, texture, level, &look->level);
    if (wide <= 0) plane.ux = plane.uy = plane.vx = plane.vy = 0;
    set_steps(texture, &corner, a, &plane, &places, recip_q31, zeros, &look->even);
    return true;
}

/* NULL: no room. */
static struct lim_gradients *new_gradients(struct lim_mesh *mesh, struct lim_mesh_look *look)
{
    union lim_mesh_gradients *own = mesh->looks->free;

    if (own) {
        mesh->looks->free = own->next;
    } else {
        if (mesh->pool_size - mesh->unused < MESH_GRADIENT_ENTRIES) return NULL;
        mesh->pool_size = (uint16_t)(mesh->pool_size - MESH_GRADIENT_ENTRIES);
        own = (union lim_mesh_gradients *)(void *)&mesh->pool[mesh->pool_size];
    }
    look->gradients = own;
    return &own->gradients;
}

/* `at`: what is seen of it. */
static LIM_RARE bool set_perspective(struct lim_mesh *mesh, struct lim_mesh_look *look,
                                     const LIM_FLASH lim_index *triangle, const struct lim_point *at, uint8_t n)
{
    const struct lim_pass *const pass = mesh->pass;
    const LIM_FLASH struct lim_texture *const texture = &pass->scene->textures[triangle[3]];
    struct lim_gradients *const gradients = new_gradients(mesh, look);
    struct lim_texture_corner corners[3];

    if (!gradients) return false;
    for (uint_fast8_t k = 0; k < 3; k++) {
        const LIM_FLASH struct lim_uv *const place = &(*pass->scene->uvs)[triangle[k]];
        lim_view_transform(&pass->view, pass->scene, &pass->scene->vertices[triangle[k]], &corners[k].at);
        corners[k].place[0] = place->u;
        corners[k].place[1] = place->v;
    }
    lim_texture_set_triangle(pass->texturing, texture, corners, at, n, gradients);
    look->level.texels = pass->scene->texels;
    look->level.palette = NULL;
    return true;
}

/* One texel is a colour. */
static LIM_INLINE bool set_plain(const struct lim_mesh *mesh, struct lim_mesh_active *active,
                                 const LIM_FLASH struct lim_texture *texture)
{
    const struct lim_scene *const scene = mesh->pass->scene;

    if (texture->w_bits) return false;
    active->look->level.texels = NULL;
    active->colour = scene->palettes[texture->palette + scene->texels[(uint32_t)texture->texels * LIM_TEXEL_BLOCK]];
    return true;
}

LIM_ALONE bool lim_mesh_texture_set(struct lim_mesh *mesh, struct lim_mesh_active *active,
                                    const LIM_FLASH lim_index *corners)
{
    const LIM_FLASH struct lim_texture *const texture = &mesh->pass->scene->textures[corners[3]];

    if (set_plain(mesh, active, texture) || set_even_look(mesh, active->look, corners, texture)) return true;
    const struct lim_point at[3] = {mesh->points[corners[0]], mesh->points[corners[1]], mesh->points[corners[2]]};
    return set_perspective(mesh, active->look, corners, at, 3);
}

bool lim_mesh_texture_clipped(struct lim_mesh *mesh, struct lim_mesh_active *active,
                              const struct lim_mesh_clipped *clipped, lim_index triangle)
{
    const LIM_FLASH lim_index *const corners = lim_mesh_triangle(mesh, triangle);

    return set_plain(mesh, active, &mesh->pass->scene->textures[corners[3]]) ||
           set_perspective(mesh, active->look, corners, clipped->at, clipped->n);
}

void lim_mesh_texture_paint(struct lim_mesh *mesh, const struct lim_mesh_line *line, struct lim_mesh_active *active,
                            int32_t left, int32_t right, int32_t x0, int32_t x1)
{
    const struct lim_textured_span span = {mesh->pass->texturing, &active->look->gradients->gradients, (int16_t)line->y,
                                           (int16_t)left, (int16_t)right};

    lim_texture_fill(&span, line->pixels, (uint16_t)x0, (uint16_t)x1, lim_stats_of(mesh->pass));
}

#endif
