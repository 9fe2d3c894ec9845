/* SPDX-License-Identifier: MIT
 *
 * Levels of detail, and how long stretches may be. */
#include "pixels/texture_planes.h"

#include "pixels/texels.h"

#if LIM_HAS_TEXTURE

/* How the place would change along a line, times depth^2 / h: the larger of what both coordinates have, of two lines.
 */
static inline uint32_t change_of(const struct lim_texture_planes *planes, int32_t x, const int32_t y[2])
{
    uint32_t most = 1;

    for (uint_fast8_t k = 0; k < 2; k++) {
        const int32_t depth = plane_at(&planes->depth, x, y[k]);
        for (uint_fast8_t i = 0; i < 2; i++) {
            const struct lim_texture_plane *uv = &planes->uv[i];
            const uint32_t change =
                abs_s32(mul_high_s32(uv->x, depth) - mul_high_s32(plane_at(uv, x, y[k]), planes->depth.x));
            if (change > most) most = change;
        }
    }
    return most;
}

/* Between the ends of n pixels, of which each is g texels farther than the one before and 2 X farther in depth, texels
 * are off by n^2 g X / (2 depth) at most, where depth is what it is at the farther end. g follows from `change` and
 * depth^2, and the level from depth^(3/2): so n^2 is a matter of the level, but for factors that are gathered here. */
static int16_t even_q4_of(const struct lim_texture_planes *planes, int8_t shift, uint32_t change, uint8_t w_bits)
{
    const int32_t slope_q4 = log2_q4(abs_s32(planes->depth.x) | 1);
    const int32_t real_level_q4 = planes->level_q4 - MIDDLE_OF_LEVEL_Q4 + 3 * LIM_TEXTURE_LOG2_Q4 / 2;
    const int32_t even_q4 = 16 * (shift - w_bits - LIM_TEXTURE_OFF_BITS - 13) - (log2_q4(change) + 32 * 16) - slope_q4 +
                            2 * real_level_q4 + MIDDLE_OF_LEVEL_Q4;

    return (int16_t)(even_q4 > INT16_MAX ? INT16_MAX : even_q4 < INT16_MIN ? INT16_MIN : even_q4);
}

uint32_t lim_texture_pace(const struct lim_gradients *gradients, int32_t far_depth)
{
    const struct lim_texture_planes *planes = &gradients->planes;
    const LIM_FLASH struct lim_texture *texture = gradients->texture;
    const uint32_t depth = (uint32_t)(far_depth < planes->depth_min ? planes->depth_min : far_depth);
    uint32_t zeros;
    (void)normalise_depth(depth, &zeros);
    const int32_t level_q4 = lim_texture_level_q4(planes->level_q4, depth, (uint8_t)zeros),
                  last_q4 = (texture->levels - 1) * 16;
    const int32_t shown_q4 = level_q4 < 0 ? 0 : lim_texture_lesser(level_q4, last_q4);
    const int32_t even_bits = (planes->even_q4 - 2 * level_q4 + shown_q4) >> 5;
    const int32_t most =
        lim_texture_lesser(LIM_TEXTURE_MOST_BITS - texture->w_bits, gradients->slope_zeros - (int32_t)zeros - 3);

    if (most <= 0 || even_bits < 0) return 0;
    return (uint32_t)(even_bits < most ? 2 * even_bits + 3 : 2 * most);
}

/* Lines ask for pixels, counted from the screen's corner. */
static inline void from_corner(const struct lim_texturing *texturing, struct lim_texture_plane *plane)
{
    plane->at = plane_at(plane, 1 - texturing->w_px, 1 - texturing->h_px);
}

void lim_texture_settle(const struct lim_texturing *texturing, const struct around *around, int8_t shift,
                        struct lim_gradients *out)
{
    const int32_t x = 2 * around->x + 1 - texturing->w_px, y = 2 * around->y + 1 - texturing->h_px;
    const int32_t ys[2] = {y - 2 * around->h, y + 2 * around->h};
    struct lim_texture_planes *planes = &out->planes;
    const int32_t depth = plane_at(&planes->depth, x, y), range = depth_range(&planes->depth, around);

    out->shift = shift;
    for (; out->shift > 31; out->shift--)
        for (uint_fast8_t i = 0; i < 2; i++)
            planes->uv[i].at >>= 1, planes->uv[i].x >>= 1, planes->uv[i].y >>= 1;
    planes->even_q4 = even_q4_of(planes, shift, change_of(planes, x, ys), out->texture->w_bits);
    out->slope_zeros = clz_u32(abs_s32(planes->depth.x) | 1);
    const uint32_t near_pace = lim_texture_pace(out, depth + range), far_pace = lim_texture_pace(out, depth - range);
    out->pace = near_pace <= far_pace + 2 ? (uint8_t)far_pace : 0; /* lines that differ less are not asked */
    planes->level_depths = 0;
    from_corner(texturing, &planes->depth);
    from_corner(texturing, &planes->uv[0]);
    from_corner(texturing, &planes->uv[1]);
}

/* Of a masked texture's texels of index 0 nothing is painted. One loop serves all widths, as few pixels are such. */
static LIM_IF_CALLED void paint_masked_texels(uint16_t *end, uint_fast16_t n, uint32_t place,
                                              const struct lim_texture_level *level)
{
    const LIM_FLASH uint8_t *const texels = level->texels;
    const LIM_FLASH uint16_t *const palette = level->palette;
    const uint32_t w_bits = level->w_bits, rows_mask = level->rows_mask >> w_bits, columns = 16 - w_bits;
    const uint32_t step = level->step;
    uint16_t *to = end - n;

    do {
        const uint32_t row = (uint32_t)(uint16_t)place >> columns & rows_mask;
        const uint_fast8_t texel = texels[(row << w_bits) + (place >> 16 >> columns)];
        if (texel) *to = palette[texel];
        to++;
        place += step;
    } while (to != end);
}

void lim_texture_set_level(const struct lim_scene *scene, uint8_t number, struct lim_gradients *gradients)
{
    struct lim_texture_level *const level = &gradients->level;

    lim_texels_take_level(scene, gradients->texture, number, level);
    level->number = number;
    gradients->paint = LIM_OPTIMISE_SIZE ? lim_texels_paint_any : lim_texels_painters[level->w_bits];
    if (LIM_HAS_MASKED && lim_texture_is_masked(gradients->texture)) gradients->paint = paint_masked_texels;
}

/* The least depth whose log2 is that, as lim_texture_level_q4() has it. */
static uint32_t texture_depth_of(int32_t log2_q4)
{
    const int32_t zeros = (31 - log2_q4) >> 4;

    if (zeros < 0) return UINT32_MAX;
    return zeros > 31 ? 0 : (uint32_t)(log2_q4 + 16 * zeros) << 27 >> zeros;
}

/* x / 3, rounded up, for |x| < 2^14: 43691 / 2^17 is a third and 2^-18.6, of which 2^13 / 2^17 is more than x has. */
static inline int32_t third_up(int32_t x)
{
    return (x * 43691 + (2 * 43691 + (1 << 13))) >> 17;
}

/* Level n is shown where 16 n <= level_q4 - floor(3/2 log2) < 16 n + 16, but for the first one and the last one. */
void lim_texture_suit_level(const struct lim_scene *scene, struct lim_gradients *gradients, uint32_t depth)
{
    struct lim_texture_planes *planes = &gradients->planes;
    const uint8_t levels = gradients->texture->levels;
    uint32_t zeros;
    (void)normalise_depth(depth | 1, &zeros); /* where a stretch begins depth may be anything */
    const uint8_t number = lim_texture_level_of(lim_texture_level_q4(planes->level_q4, depth, (uint8_t)zeros), levels);
    const int32_t from_q4 = third_up(2 * (planes->level_q4 - 16 * number - 15));
    const int32_t to_q4 = third_up(2 * (planes->level_q4 - 16 * number + 1));
    const uint32_t from = number == levels - 1 ? 0 : texture_depth_of(from_q4);

    planes->level_depth = from;
    planes->level_depths = (number ? texture_depth_of(to_q4) : UINT32_MAX) - from;
    lim_texture_set_level(scene, number, gradients);
}

#endif
