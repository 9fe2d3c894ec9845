/* SPDX-License-Identifier: MIT
 *
 * Texels advance evenly over most triangles of a dense mesh, as depth hardly changes on them. Between corners where 1 /
 * z is w, they are off from where they should be by the covariance of place and w, over the mean of w: a quarter of the
 * product of both ranges at most, over the least w. Where that is more than LIM_TEXTURE_OFF_BITS allow, or numbers get
 * too large, texels advance in perspective. */
#include "lines/mesh_texture.h"

#include "colour.h"
#include "lines/mesh_clip.h"
#include "lines/mesh_even.h"
#include "lines/mesh_way.h"
#include "math/fixed.h"
#include "pixels/texture.h"
#include "pixels/texture_triangle.h"
#include "view/perspective.h"

#if LIM_HAS_TEXTURE && LIM_HAS_MESHES

LIM_STATIC_ASSERT(sizeof(union lim_mesh_gradients) <= MESH_GRADIENT_ENTRIES * sizeof(struct lim_mesh_active),
                  "gradients take the room of so many entries");

/* A frame --------------------------------------------------------------------------------------------------------- */

/* Of a row, or a twelfth more: the longest part, and sqrt(2) - 1 of the others. */
static uint32_t length_of(const struct lim_row *row)
{
    uint32_t longest = 0, sum = 0;

    for (uint_fast8_t i = 0; i < 3; i++) {
        const uint32_t part = abs_s32((int32_t)row->n_qv[i]);
        sum += part;
        if (part > longest) longest = part;
    }
    return longest + ((sum - longest) * 107 >> 8) + 1;
}

/* A triangle may be so many pixels of a lens long: mesh_texture.h. */
static uint32_t mesh_reach_of(const struct lim_rows *rows, uint_fast8_t axis, int32_t side_px)
{
    const uint32_t reach = length_of(&rows->row[axis]) * (uint32_t)side_px / (2 * MESH_EVEN_LENS_PX);

    return LIM_HAS_TELE ? reach << rows->zoom_bits[axis] : reach;
}

/* Units in view space, those across as far as the lens makes steps' rounding matter. */
static uint32_t unit_of(const struct lim_view *view)
{
    const uint32_t z = length_of(&view->rows.row[2]) >> view->rows.tele_bits;
    const uint32_t x = mesh_reach_of(&view->rows, 0, view->width.px),
                   y = mesh_reach_of(&view->rows, 1, view->height.px);
    const uint32_t across = x > y ? x : y;

    return (z > across ? z : across) + 1;
}

/* x 2^bits of 24 bits, or what fits. */
static uint32_t scaled(uint32_t x, int_fast16_t bits)
{
    if (bits > 7) return UINT32_MAX;
    return bits >= 0 ? x << bits : bits > -32 ? x >> -bits : 0;
}

void lim_mesh_texture_frame(struct lim_mesh *mesh)
{
    const uint16_t count = lim_texture_count(mesh->pass->scene);
    uint8_t shift;

    mesh->looks->even = 0;
    if (!count) return;
    const uint32_t unit_q24 = recip_q24(unit_of(&mesh->pass->view), &shift);
    const int_fast16_t bits = (int_fast16_t)perspective_nearness_bits(mesh->near_shift) + 2 + 2 - LIM_TEXTURE_OFF_BITS;

    mesh->looks->taken.sizes = 0;
    mesh->looks->mask = lim_triangle_texture_mask(count);
    mesh->looks->even = count > LIM_TRIANGLE_TEXTURES ? 0 : scaled(unit_q24 / 2 * 3 / 2, bits + shift - 54);
}

/* A triangle ------------------------------------------------------------------------------------------------------ */

static inline const LIM_FLASH struct lim_texture *texture_of(const struct lim_mesh *mesh,
                                                             const LIM_FLASH lim_index *corners)
{
    return &mesh->pass->scene->textures[corners[3] & mesh->looks->mask];
}

/* NULL: there are no textures. */
static inline const LIM_FLASH struct lim_texture *texture_if_any(const struct lim_mesh *mesh,
                                                                 const LIM_FLASH lim_index *corners)
{
    return lim_mesh_has_textures(mesh) ? texture_of(mesh, corners) : NULL;
}

/* Whether a triangle that is not clipped is as far away as the compiler wants it. */
static LIM_INLINE bool is_far(const struct lim_mesh *mesh, const struct lim_mesh_active *active,
                              const LIM_FLASH lim_index *corners)
{
    const uint32_t nearness = (uint32_t)(active->rank >> 8 * sizeof(lim_index));
    const uint32_t from = (uint32_t)corners[3] >> LIM_TRIANGLE_TEXTURE_BITS;

    return nearness * (7 - (from & 3)) <= mesh->looks->even >> (31 - (from >> 2));
}

/* A triangle's ways from its corner a, on the screen and in its texture. */
struct shape {
    lim_packed a;
    mesh_way u, v, a_place, b_place, c_place; /* a_place: from where places are counted */
    uint8_t halved[2];                        /* across, down: of the ways on the screen */
    int32_t wide; /* twice its size on the screen, of halved ways; not above 0: nowhere wider than a pixel */
};

static LIM_INLINE_32 void set_shape(const struct lim_mesh *mesh, const LIM_FLASH lim_index *corners,
                                    struct shape *shape)
{
    const LIM_FLASH struct lim_uv *const uvs = *mesh->pass->scene->uvs;

    shape->a = lim_packed_load(&mesh->points[corners[0]]);
    shape->u = mesh_way_of_points(shape->a, lim_packed_load(&mesh->points[corners[1]]));
    shape->v = mesh_way_of_points(shape->a, lim_packed_load(&mesh->points[corners[2]]));
    shape->a_place = mesh_way_to_place(&uvs[corners[0]]);
    shape->b_place = mesh_way_between(shape->a_place, mesh_way_to_place(&uvs[corners[1]]));
    shape->c_place = mesh_way_between(shape->a_place, mesh_way_to_place(&uvs[corners[2]]));
    mesh_way_halve(&shape->u, &shape->v, shape->halved);
    shape->wide = mesh_way_cross(shape->v, shape->u);
}

/* What is not clipped faces the eye, so it has some, but for halving. */
static inline uint32_t mesh_area_of(const struct shape *shape)
{
    return LIM_HAS_LIMBS && shape->wide <= 0 ? 1 : (uint32_t)shape->wide | 1;
}

/* The level whose texels are as large as pixels, by the areas of both: of each level four times as many go on a pixel
 * as of the one before, and half as much is nearer to the one before. */
static LIM_INLINE uint_fast8_t level_of(const struct lim_mesh_picture *taken,
                                        const LIM_FLASH struct lim_texture *texture, const struct shape *shape)
{
    uint32_t own = nearly_abs(mesh_way_cross(shape->b_place, shape->c_place)), area = mesh_area_of(shape);
    uint_fast8_t level = 0;

    if (LIM_HAS_LIMBS) {
        const int_fast16_t down = taken->own_down - taken->area_down + shape->halved[0] + shape->halved[1];
        own >>= down > 31 ? 31 : down > 0 ? down : 0;
        area >>= down < 0 ? -down : 0;
    } else {
        own >>= taken->own_down;
        area >>= taken->area_down;
    }
    if (LIM_UNLIKELY(own >= area)) {
        const uint_fast8_t last = (uint_fast8_t)(texture->levels - 1);
        for (; own >= area && level < last; own >>= 2)
            level++;
    }
    return level;
}

static LIM_INLINE uint32_t most_half_of(const struct lim_mesh *mesh, const LIM_FLASH lim_index *corners)
{
    return mesh_way_most_half(lim_packed_load(&mesh->points[corners[0]]), lim_packed_load(&mesh->points[corners[1]]),
                              lim_packed_load(&mesh->points[corners[2]]));
}

/* By what both coordinates and nearness gain along the sides. *moved: of is_even(). */
static LIM_INLINE bool is_even_as_seen(const struct lim_mesh *mesh, const LIM_FLASH lim_index *corners,
                                       const LIM_FLASH struct lim_texture *texture, const struct shape *shape,
                                       uint_fast8_t level, uint32_t *moved)
{
    const struct nears nears = nears_of(mesh, corners);
    const uint32_t most_half = most_half_of(mesh, corners);
    const int_fast16_t finer_bits = (int_fast16_t)level - texture->w_bits - LIM_TEXTURE_OFF_BITS;

    if ((!LIM_HAS_LIMBS && most_half >> 13) || !is_within_reach(most_half, finer_bits + 16)) return false;
    return is_even(&nears, shape->b_place, shape->c_place, finer_bits + texture->place_bits,
                   (uint_fast8_t)(16 - texture->place_bits), moved);
}

/* a b / 2^32, rounded to nearest, halves up. */
#if LIM_DUAL_MULTIPLY && defined(__arm__)

static inline int32_t mul_high_rounded_s32(int32_t a, int32_t b)
{
    int32_t high;

    __asm__("smmulr %0, %1, %2" : "=r"(high) : "r"(a), "r"(b));
    return high;
}

#else

static inline int32_t mul_high_rounded_s32(int32_t a, int32_t b)
{
    const int64_t product = (int64_t)a * b;

    return (int32_t)(product >> 32) + (int32_t)((uint32_t)product >> 31);
}

#endif

/* What places are in 2^-16 of the width, rounded to nearest, of numerators over the area. A reciprocal of 15 bits is
 * made shorter by `down`. */
static LIM_INLINE int32_t place_step(int32_t numerator, int32_t recip_q31, int_fast16_t down)
{
    if (LIM_HAS_LIMBS) return (mul_high_s32(numerator, recip_q31) + ((int32_t)1 << (down - 1))) >> down;
    const int32_t shorter_q31 = recip_q31 >> down;
    if (!LIM_LONG_MULTIPLY)
        return (mul_s32_top(numerator, (int32_t)((uint32_t)shorter_q31 << down)) + ((int32_t)1 << (down - 1))) >> down;
    return mul_high_rounded_s32(numerator, shorter_q31);
}

static LIM_INLINE void set_steps(const struct lim_mesh_picture *taken, const struct shape *shape,
                                 struct mesh_numerators *steps)
{
    uint8_t zeros;
    const int32_t recip_q31 = lim_texture_reciprocal(mesh_area_of(shape), &zeros);
    const int_fast16_t down = (int_fast16_t)(taken->step_down - zeros);

    if (down <= 0) { /* nowhere wider than a pixel: one texel */
        *steps = (struct mesh_numerators){0, 0, 0, 0};
        return;
    }
    mesh_way_numerators(shape->u, shape->v, shape->b_place, shape->c_place, steps);
    steps->ux = place_step(steps->ux, recip_q31, down + shape->halved[0]);
    steps->uy = place_step(steps->uy, recip_q31, down + shape->halved[1]);
    steps->vx = place_step(steps->vx, recip_q31, down + shape->halved[0]);
    steps->vy = place_step(steps->vy, recip_q31, down + shape->halved[1]);
}

/* The place of pixel (0, 0), of which the upper bits may be wrong. */
static inline uint32_t place_at_zero(uint32_t corner_q16, int32_t step_x, int32_t step_y, int32_t x, int32_t y)
{
    if (LIM_HAS_LIMBS) return corner_q16 - (uint32_t)(((int64_t)step_x * x + (int64_t)step_y * y) >> LIM_SUB_BITS);
    return corner_q16 -
           (uint32_t)((int32_t)((uint32_t)step_x * (uint32_t)x + (uint32_t)step_y * (uint32_t)y) >> LIM_SUB_BITS);
}

/* Below the place's width v does not wrap: it would carry over to u. */
static LIM_INLINE void mesh_set_even(const struct lim_mesh_picture *taken, const struct shape *shape, uint32_t moved,
                                     struct lim_mesh_look *look)
{
    const uint_fast8_t up = taken->up;
    const int32_t x = lim_packed_x(shape->a) + LIM_ORIGIN_PX * LIM_SUB,
                  y = lim_packed_y(shape->a) + (LIM_ORIGIN_PX + 1) * LIM_SUB;
    struct mesh_numerators steps;

    set_steps(taken, shape, &steps);
    look->level.step = lim_texture_packed((uint32_t)steps.ux, (uint32_t)steps.vx);
    look->even.y = lim_texture_packed((uint32_t)steps.uy, (uint32_t)steps.vy);
    look->even.place =
        moved + lim_texture_packed(
                    place_at_zero((uint32_t)mesh_way_x(shape->a_place) << up, steps.ux, steps.uy, x, y),
                    place_at_zero((uint16_t)((uint32_t)mesh_way_y(shape->a_place) << up), steps.vx, steps.vy, x, y));
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
        if (LIM_HAS_TELE) lim_view_even(&pass->view.rows, &corners[k].at);
        corners[k].place[0] = place->u;
        corners[k].place[1] = place->v;
    }
    lim_texture_set_triangle(pass->texturing, texture_of(mesh, triangle), corners, at, n, gradients);
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

    active->look->show = lim_mesh_show_perspective;
    active->look->level.w_bits = LIM_MESH_PERSPECTIVE;
    active->look->gradients = own;
    if (own) make_gradients(mesh, active, &own->gradients);
}

/* One texel is a colour; or there are no textures, and it has one. */
static LIM_RARE void set_plain(const struct lim_mesh *mesh, struct lim_mesh_active *active,
                               const LIM_FLASH struct lim_texture *texture)
{
    const struct lim_scene *const scene = mesh->pass->scene;

    active->look->show = lim_mesh_show_colour;
    active->look->level.w_bits = LIM_MESH_COLOUR;
    active->colour =
        texture ? scene->palettes[texture->palette + scene->texels[(uint32_t)texture->texels * LIM_TEXEL_BLOCK]]
                : lim_memory_colour((uint16_t)lim_mesh_triangle(mesh, lim_mesh_number(active))[3]);
}

/* All of its sizes, as a number to compare; at least one is not 0. */
typedef uint32_t __attribute__((may_alias)) texture_word;
static inline uint32_t sizes_of(const LIM_FLASH struct lim_texture *texture)
{
    return LIM_FLASH_AS(texture_word, texture)[1];
}

/* Another picture than the last one. */
static LIM_ALONE void take_picture(struct lim_mesh *mesh, const LIM_FLASH struct lim_texture *texture)
{
    struct lim_mesh_picture *const taken = &mesh->looks->taken;
    const int_fast16_t down = 2 * (int_fast16_t)(texture->place_bits - texture->w_bits - LIM_SUB_BITS) + 1;

    taken->sizes = sizes_of(texture);
    taken->texels = texture->texels;
    taken->own_down = (uint8_t)(down > 0 ? down : 0);
    taken->area_down = (uint8_t)(down < 0 ? -down : 0);
    taken->up = (uint8_t)(16 - texture->place_bits);
    taken->step_down = (int8_t)(14 + texture->place_bits - LIM_SUB_BITS);
    lim_texels_take_level(mesh->pass->scene, texture, 0, &taken->level);
}

static LIM_INLINE const struct lim_mesh_picture *picture_of(struct lim_mesh *mesh,
                                                            const LIM_FLASH struct lim_texture *texture)
{
    const struct lim_mesh_picture *const taken = &mesh->looks->taken;

    if (LIM_UNLIKELY(taken->sizes != sizes_of(texture) || taken->texels != texture->texels))
        take_picture(mesh, texture);
    return taken;
}

/* A level that is not the first one: from that on. */
static LIM_INLINE void make_smaller(struct lim_texture_level *level, uint_fast8_t number)
{
    uint32_t size = level->rows_mask + (UINT32_C(1) << level->w_bits);
    const LIM_FLASH uint8_t *texels = level->texels;

    level->w_bits = (uint8_t)(level->w_bits - number);
    do {
        texels += size;
        size >>= 2;
    } while (--number);
    level->texels = texels;
    level->rows_mask = size - (UINT32_C(1) << level->w_bits);
}

/* A level, and how texels advance. */
static LIM_INLINE_32 void take_even(const struct lim_mesh *mesh, const LIM_FLASH struct lim_texture *texture,
                                    const struct shape *shape, uint_fast8_t level, uint32_t moved,
                                    struct lim_mesh_look *look)
{
    const struct lim_mesh_picture *const taken = &mesh->looks->taken;

    look->level.rows_mask = taken->level.rows_mask;
    look->level.texels = taken->level.texels;
    look->level.w_bits = taken->level.w_bits;
    look->level.palette = mesh->pass->scene->palettes + texture->palette;
    if (LIM_UNLIKELY(level > 0)) make_smaller(&look->level, level);
    look->show = LIM_OPTIMISE_SIZE ? lim_texels_paint_any : lim_texels_painters[look->level.w_bits];
    mesh_set_even(taken, shape, moved, look);
}

/* false: it has no level. */
static LIM_ALONE bool mesh_set_near(struct lim_mesh *mesh, struct lim_mesh_active *active)
{
    const LIM_FLASH lim_index *const corners = lim_mesh_triangle(mesh, lim_mesh_number(active));
    const LIM_FLASH struct lim_texture *const texture = texture_if_any(mesh, corners);
    uint32_t moved = 0;
    struct shape shape;

    if (!texture || !texture->w_bits) {
        set_plain(mesh, active, texture);
        return false;
    }
    set_shape(mesh, corners, &shape);
    const uint_fast8_t level = level_of(picture_of(mesh, texture), texture, &shape);
    if (!is_even_as_seen(mesh, corners, texture, &shape, level, &moved)) {
        set_perspective(mesh, active);
        return false;
    }
    take_even(mesh, texture, &shape, level, moved, active->look);
    return true;
}

static LIM_INLINE bool mesh_set_look(struct lim_mesh *mesh, struct lim_mesh_active *active)
{
    const LIM_FLASH lim_index *const corners = lim_mesh_triangle(mesh, lim_mesh_number(active));
    struct shape shape;

    if (LIM_UNLIKELY(!is_far(mesh, active, corners))) return mesh_set_near(mesh, active);
    const LIM_FLASH struct lim_texture *const texture = texture_of(mesh, corners);
    const struct lim_mesh_picture *const taken = picture_of(mesh, texture);
    set_shape(mesh, corners, &shape);
    take_even(mesh, texture, &shape, level_of(taken, texture, &shape), 0, active->look);
    return true;
}

LIM_ALONE void lim_mesh_texture_set(struct lim_mesh *mesh, struct lim_mesh_active *active)
{
    (void)mesh_set_look(mesh, active);
}

void lim_mesh_show_first(uint16_t *end, uint_fast16_t n, uint32_t place, const struct lim_texture_level *level)
{
    struct lim_mesh_active *const active = lim_mesh_of_level(level);
    struct lim_mesh *const mesh = active->look->mesh;

    (void)place;
    if (LIM_UNLIKELY(!mesh_set_look(mesh, active))) {
        lim_mesh_show_other(end, n, level);
        return;
    }
    const struct lim_mesh_run run = lim_mesh_run(mesh, end, n);
    const uint32_t first = lim_texture_even_place(&active->look->even, level->step, run.x0, run.line->y + 1);
    if (LIM_OPTIMISE_SIZE)
        lim_texels_paint_any(end, n, first, level);
    else
        lim_texels_painters[level->w_bits](end, n, first, level);
}

LIM_RARE void lim_mesh_texture_set_clipped(struct lim_mesh *mesh, struct lim_mesh_active *active)
{
    const LIM_FLASH struct lim_texture *const texture =
        texture_if_any(mesh, lim_mesh_triangle(mesh, lim_mesh_number(active)));

    if (texture && texture->w_bits)
        set_perspective(mesh, active);
    else
        set_plain(mesh, active, texture);
}

struct lim_gradients *lim_mesh_texture_gradients(struct lim_mesh *mesh, struct lim_mesh_active *active,
                                                 struct lim_gradients *made)
{
    if (active->look->gradients) return &active->look->gradients->gradients;
    make_gradients(mesh, active, made);
    return made;
}

#endif
