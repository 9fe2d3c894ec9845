/* SPDX-License-Identifier: MIT
 *
 * Texels advance evenly over most triangles of a dense mesh, as depth hardly changes on them. Between corners where 1 /
 * z is w, they are off from where they should be by the covariance of place and w, over the mean of w: a quarter of the
 * product of both ranges at most, over the least w. Where that is more than LIM_TEXTURE_OFF_BITS allow, or numbers get
 * too large, texels advance in perspective. */
#include "lines/mesh_texture.h"

#include "lines/mesh_active.h"
#include "lines/mesh_way.h"
#include "math/fixed.h"
#include "pixels/texture_triangle.h"

#if LIM_HAS_TEXTURE && LIM_HAS_MESHES

LIM_STATIC_ASSERT(sizeof(union lim_mesh_gradients) <= MESH_GRADIENT_ENTRIES * sizeof(struct lim_mesh_active),
                  "gradients take the room of so many entries");

/* What the corners b and c are nearer than a. */
struct nears {
    int32_t a, b, c;
};

static LIM_INLINE struct nears nears_of(const struct lim_mesh *mesh, const LIM_FLASH lim_index *corners)
{
    const int32_t a = mesh->nearness[corners[0]];

    return (struct nears){a, mesh->nearness[corners[1]] - a, mesh->nearness[corners[2]] - a};
}

/* The level whose texels are as large as pixels, by the areas of both: the first of which a texel is less than twice a
 * pixel, within a half of a level. `area` is that on the screen, halved so often. */
static LIM_INLINE uint8_t level_of_areas(const LIM_FLASH struct lim_texture *texture, int32_t of_places, uint32_t area,
                                         int_fast16_t halved)
{
    const int_fast16_t down = 2 * (int_fast16_t)(texture->place_bits - texture->w_bits - LIM_SUB_BITS) + 1 + halved;
    const uint_fast8_t last = (uint_fast8_t)(texture->levels - 1);
    uint32_t own = abs_s32(of_places);
    uint_fast8_t level = 0;

    if (down >= 0)
        own >>= LIM_HAS_LIMBS && down > 31 ? 31 : down;
    else
        area >>= -down;
    for (; level < last && own >= area; own >>= 2)
        level++;
    return (uint8_t)level;
}

/* How far apart the errors of a coordinate are, of which those along the sides are products of what place and nearness
 * gain there, over four times the nearness; and twice the middle between them. */
static uint32_t spread_of(int32_t b, int32_t c, const struct nears *nears, int32_t *twice_middle)
{
    const int32_t sides[3] = {b * nears->b, c * nears->c, (c - b) * (nears->c - nears->b)};
    int32_t least = 0, most = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
        if (sides[i] < least) least = sides[i];
        if (sides[i] > most) most = sides[i];
    }
    *twice_middle = least + most;
    return (uint32_t)most - (uint32_t)least;
}

static inline int32_t least_of(const struct nears *nears)
{
    const int32_t b = nears->b < 0 ? nears->b : 0;

    return nears->a + (nears->c < b ? nears->c : b);
}

/* Where an even way is not right enough between the corners it may be if it leaves them, by the middle of all errors:
 * *moved is that, packed. false: not even so. `bits`: of is_even(). */
static LIM_ALONE bool is_even_beside(const struct lim_mesh *mesh, const LIM_FLASH lim_index *corners, int_fast16_t bits,
                                     uint32_t *moved)
{
    const LIM_FLASH struct lim_uv *const uvs = *mesh->pass->scene->uvs, *const a = &uvs[corners[0]];
    const LIM_FLASH struct lim_uv *const b = &uvs[corners[1]], *const c = &uvs[corners[2]];
    const struct nears nears = nears_of(mesh, corners);
    const int32_t least = least_of(&nears);
    const uint32_t most = mesh_way_most(mesh_way_of_places(a, b), mesh_way_of_places(a, c));
    int32_t middle[2];

    if ((most | nearly_abs(nears.b) | nearly_abs(nears.c)) >> 14 || bits < 0) return false;
    const uint32_t u = spread_of(b->u - a->u, c->u - a->u, &nears, &middle[0]),
                   v = spread_of(b->v - a->v, c->v - a->v, &nears, &middle[1]);
    if ((u > v ? u : v) + 2 * most > (uint32_t)least << (bits < 12 ? bits + 3 : 15)) return false;
    const LIM_FLASH struct lim_texture *const texture = &mesh->pass->scene->textures[corners[3]];
    const int32_t width = (int32_t)1 << (16 - texture->place_bits);
    *moved =
        lim_texture_packed((uint32_t)(middle[0] / (8 * least) * width), (uint32_t)(middle[1] / (8 * least) * width));
    return true;
}

/* What nearness and a coordinate gain along each side, multiplied: nearly_abs() of them, OR'ed. */
static inline uint32_t sides_of(const struct nears *nears, int32_t b, int32_t c)
{
    return nearly_abs(nears->b * b) | nearly_abs(nears->c * c) | nearly_abs((nears->c - nears->b) * (c - b));
}

/* Whether even texels are right enough between the corners. Nearness is rounded at both ends of a side. */
static LIM_INLINE bool is_even(const struct nears *nears, mesh_way b, mesh_way c, int_fast16_t bits)
{
    const uint32_t sides =
        sides_of(nears, mesh_way_x(b), mesh_way_x(c)) | sides_of(nears, mesh_way_y(b), mesh_way_y(c));

    return bits >= 0 && sides + 2 * mesh_way_most(b, c) < (uint32_t)least_of(nears) << (bits < 13 ? bits + 2 : 15);
}

/* Steps are rounded: whether that leads less than half of what even texels may be off, over pixels that are not more
 * than four times the longest way. */
static LIM_INLINE bool is_within_reach(uint32_t most_half, int_fast16_t bits)
{
    return bits >= 0 && !((most_half + 1) * 8 >> LIM_SUB_BITS >> (bits < 31 ? bits : 31));
}

static LIM_INLINE uint32_t most_half_of(const struct lim_mesh *mesh, const LIM_FLASH lim_index *corners)
{
    return mesh_way_most_half(lim_packed_load(&mesh->points[corners[0]]), lim_packed_load(&mesh->points[corners[1]]),
                              lim_packed_load(&mesh->points[corners[2]]));
}

/* By what both coordinates and nearness gain along the sides. *moved as of is_even_beside(). */
static LIM_ALONE bool is_even_at_level(const struct lim_mesh *mesh, const LIM_FLASH lim_index *corners, uint8_t level,
                                       uint32_t *moved)
{
    const LIM_FLASH struct lim_texture *const texture = &mesh->pass->scene->textures[corners[3]];
    const LIM_FLASH struct lim_uv *const uvs = *mesh->pass->scene->uvs, *const corner = &uvs[corners[0]];
    const int_fast16_t finer_bits = (int_fast16_t)(level - texture->w_bits - LIM_TEXTURE_OFF_BITS);
    const struct nears nears = nears_of(mesh, corners);

    if (!is_within_reach(most_half_of(mesh, corners), finer_bits + 16)) return false;
    return is_even(&nears, mesh_way_of_places(corner, &uvs[corners[1]]), mesh_way_of_places(corner, &uvs[corners[2]]),
                   finer_bits + texture->place_bits) ||
           is_even_beside(mesh, corners, finer_bits + texture->place_bits, moved);
}

/* Of a numerator, in 2^-16 of the width. */
static inline int32_t place_step(int32_t numerator, int32_t recip_q31, int_fast16_t down)
{
    return (lim_texture_times(numerator, recip_q31) + ((int32_t)1 << (down - 1))) >> down;
}

/* The place of pixel (0, 0), of which the upper bits may be wrong. */
static inline uint32_t place_at_zero(uint32_t corner_q16, int32_t step_x, int32_t step_y, int32_t x, int32_t y)
{
    if (LIM_HAS_LIMBS) return corner_q16 - (uint32_t)(((int64_t)step_x * x + (int64_t)step_y * y) >> LIM_SUB_BITS);
    return corner_q16 -
           (uint32_t)((int32_t)((uint32_t)step_x * (uint32_t)x + (uint32_t)step_y * (uint32_t)y) >> LIM_SUB_BITS);
}

/* From the corner a. Below the place's width v does not wrap: it would carry over to u. */
static LIM_INLINE void set_even(const LIM_FLASH struct lim_uv *corner, uint8_t up, lim_packed a,
                                const struct mesh_numerators *steps, struct lim_mesh_look *look)
{
    const int32_t x = lim_packed_x(a) + LIM_ORIGIN_PX * LIM_SUB, y = lim_packed_y(a) + LIM_ORIGIN_PX * LIM_SUB;

    look->level.step = lim_texture_packed((uint32_t)steps->ux, (uint32_t)steps->vx);
    look->even.y = lim_texture_packed((uint32_t)steps->uy, (uint32_t)steps->vy);
    look->even.place +=
        lim_texture_packed(place_at_zero((uint32_t)corner->u << up, steps->ux, steps->uy, x, y),
                           place_at_zero((uint16_t)((uint32_t)corner->v << up), steps->vx, steps->vy, x, y));
}

/* false: it is not even. */
static LIM_INLINE bool set_even_look(const struct lim_mesh *mesh, struct lim_mesh_look *look,
                                     const LIM_FLASH lim_index *corners, const LIM_FLASH struct lim_texture *texture)
{
    const LIM_FLASH struct lim_uv *const uvs = *mesh->pass->scene->uvs, *const corner = &uvs[corners[0]];
    const lim_packed a = lim_packed_load(&mesh->points[corners[0]]), b = lim_packed_load(&mesh->points[corners[1]]),
                     c = lim_packed_load(&mesh->points[corners[2]]);
    const mesh_way b_place = mesh_way_of_places(corner, &uvs[corners[1]]),
                   c_place = mesh_way_of_places(corner, &uvs[corners[2]]);
    struct mesh_numerators steps = {0, 0, 0, 0};
    uint8_t zeros, halved[2];

    if (!LIM_HAS_LIMBS && mesh_way_most_half(a, b, c) >> 13) return false;
    mesh_way u = mesh_way_of_points(a, b), v = mesh_way_of_points(a, c);
    mesh_way_halve(&u, &v, halved);
    const int32_t wide = mesh_way_cross(v, u);
    const uint32_t area = wide > 0 ? (uint32_t)wide : 1;
    const uint8_t level = level_of_areas(texture, mesh_way_cross(b_place, c_place), area, halved[0] + halved[1]);
    look->even.place = 0;
    if (!is_even_at_level(mesh, corners, level, &look->even.place)) return false;
    const int32_t recip_q31 = lim_texture_reciprocal(area, &zeros);
    const int_fast16_t down = (int_fast16_t)(15 + texture->place_bits - LIM_SUB_BITS - zeros);
    if (down > 1 && wide > 0) { /* else it is nowhere wider than a pixel, and shows one texel */
        mesh_way_numerators(u, v, b_place, c_place, &steps);
        steps.ux = place_step(steps.ux, recip_q31, down - 1 + halved[0]);
        steps.uy = place_step(steps.uy, recip_q31, down - 1 + halved[1]);
        steps.vx = place_step(steps.vx, recip_q31, down - 1 + halved[0]);
        steps.vy = place_step(steps.vy, recip_q31, down - 1 + halved[1]);
    }
    set_even(corner, (uint8_t)(16 - texture->place_bits), a, &steps, look);
    lim_texture_take_level(mesh->pass->scene, texture, level, &look->level);
    return true;
}

/* NULL: no room. */
static union lim_mesh_gradients *new_gradients(struct lim_mesh *mesh)
{
    union lim_mesh_gradients *own = mesh->looks->free;

    if (own) {
        mesh->looks->free = own->next;
    } else {
        if (mesh->pool_size - mesh->unused < MESH_GRADIENT_ENTRIES) return NULL;
        mesh->pool_size = (uint16_t)(mesh->pool_size - MESH_GRADIENT_ENTRIES);
        own = (union lim_mesh_gradients *)(void *)&mesh->pool[mesh->pool_size];
    }
    return own;
}

/* `at`: what is seen of it. */
static void set_gradients(const struct lim_mesh *mesh, const LIM_FLASH lim_index *triangle, const struct lim_point *at,
                          uint8_t n, struct lim_gradients *gradients)
{
    const struct lim_pass *const pass = mesh->pass;
    struct lim_texture_corner corners[3];

    for (uint_fast8_t k = 0; k < 3; k++) {
        const LIM_FLASH struct lim_uv *const place = &(*pass->scene->uvs)[triangle[k]];
        lim_view_transform(&pass->view, pass->scene, &pass->scene->vertices[triangle[k]], &corners[k].at);
        corners[k].place[0] = place->u;
        corners[k].place[1] = place->v;
    }
    lim_texture_set_triangle(pass->texturing, &pass->scene->textures[triangle[3]], corners, at, n, gradients);
}

static LIM_RARE void make_gradients(const struct lim_mesh *mesh, const struct lim_mesh_active *active,
                                    struct lim_gradients *gradients)
{
    const lim_index triangle = lim_mesh_number(active);
    const LIM_FLASH lim_index *const corners = lim_mesh_triangle(mesh, triangle);
    struct lim_mesh_clipped clipped;

    if (lim_mesh_is_cut(mesh, corners)) {
        (void)lim_mesh_clip(mesh, triangle, &clipped);
        set_gradients(mesh, corners, clipped.at, clipped.n, gradients);
        return;
    }
    const struct lim_point at[3] = {mesh->points[corners[0]], mesh->points[corners[1]], mesh->points[corners[2]]};
    set_gradients(mesh, corners, at, 3, gradients);
}

static LIM_RARE void set_perspective(struct lim_mesh *mesh, struct lim_mesh_active *active)
{
    union lim_mesh_gradients *const own = new_gradients(mesh);

    active->look->level.w_bits = LIM_MESH_PERSPECTIVE;
    active->look->gradients = own;
    if (own) make_gradients(mesh, active, &own->gradients);
}

/* One texel is a colour. */
static LIM_RARE void set_plain(const struct lim_mesh *mesh, struct lim_mesh_active *active,
                               const LIM_FLASH struct lim_texture *texture)
{
    const struct lim_scene *const scene = mesh->pass->scene;

    active->look->level.w_bits = LIM_MESH_COLOUR;
    active->colour = scene->palettes[texture->palette + scene->texels[(uint32_t)texture->texels * LIM_TEXEL_BLOCK]];
}

LIM_ALONE void lim_mesh_texture_set(struct lim_mesh *mesh, struct lim_mesh_active *active)
{
    const LIM_FLASH lim_index *const corners = lim_mesh_triangle(mesh, lim_mesh_number(active));
    const LIM_FLASH struct lim_texture *const texture = &mesh->pass->scene->textures[corners[3]];

    if (!texture->w_bits) {
        set_plain(mesh, active, texture);
        return;
    }
    if (!lim_mesh_is_cut(mesh, corners) && set_even_look(mesh, active->look, corners, texture)) return;
    set_perspective(mesh, active);
}

struct lim_gradients *lim_mesh_texture_gradients(struct lim_mesh *mesh, struct lim_mesh_active *active,
                                                 struct lim_gradients *made)
{
    if (active->look->gradients) return &active->look->gradients->gradients;
    make_gradients(mesh, active, made);
    return made;
}

void lim_mesh_texture_paint(struct lim_mesh *mesh, const struct lim_mesh_line *line, struct lim_mesh_active *active,
                            int32_t left, int32_t right, int32_t x0, int32_t x1)
{
    struct lim_gradients made;
    const struct lim_textured_span span = {mesh->pass->texturing, lim_mesh_texture_gradients(mesh, active, &made),
                                           (int16_t)line->y, (int16_t)left, (int16_t)right};

    lim_texture_fill(&span, line->pixels, (uint16_t)x0, (uint16_t)x1, lim_stats_of(mesh->pass));
}

#endif
