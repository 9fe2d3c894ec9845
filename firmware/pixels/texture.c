/* SPDX-License-Identifier: MIT
 *
 * Setting up: per frame the camera's axes, per polygon three planes over the screen, or where they are as good as flat
 * what a pixel adds. Axes have 30 fraction bits in two limbs and normals 15, so no sum of products leaves 32 bits. In
 * profiles with limbs the planes are then scaled, each by a power of two, until they fill 30 bits: what rounding a
 * gradient adds up to over half a screen of 240 pixels is 2^-23 of the largest depth on the screen. */
#include "pixels/texture.h"

#include "long.h"
#include "pixels/texture_seen.h"

#if LIM_HAS_TEXTURE

/* Once a frame ------------------------------------------------------------------------------------- */

static LIM_IN_EACH_CALLER void set_axis(struct lim_texture_axis *axis, const int32_t way_q30[3])
{
    for (uint_fast8_t i = 0; i < LIM_TEXTURE_AXES; i++) {
        const int32_t way = way_q30[i % 3];
        axis->high_q14[i] = (int16_t)((way + 0x8000) >> 16);
        axis->low_q30[i] = (int16_t)(way - axis->high_q14[i] * INT32_C(65536));
    }
}

/* tan / side = mantissa / 2^31 / 2^bits. Both mantissas are cut, by 2^-21 at most: the texture is that much too narrow,
 * a 4000th of a pixel. */
static LIM_IN_EACH_CALLER int32_t texture_mantissa_of(uint32_t tan_q28, int16_t side_px, int8_t *bits)
{
    uint8_t zeros, more;
    const uint32_t quotient = normalise_u32(tan_q28, &zeros) / (uint16_t)side_px;
    const uint32_t mantissa_q32 = normalise_u32(quotient, &more);

    *bits = (int8_t)(zeros + more - 4);
    return (int32_t)(mantissa_q32 >> 1);
}

/* What a half-pixel adds to the way ahead. In profiles without limbs all three axes are of one length, such that no sum
 * over twice the screen leaves 31 bits. */
static void texture_set_axes(struct lim_texturing *texturing, const struct lim_camera *camera,
                             const int32_t camera_q30[9])
{
    const uint32_t tans_q28[2] = {camera->tan_x_q28, camera->tan_y_q28};
    const int16_t sides_px[2] = {texturing->w_px, texturing->h_px};
    /* 1 + 3 tan_x + tan_y: twice as much is 2^bits or less. */
    const uint32_t most_q25 = (UINT32_C(1) << 25) + (tans_q28[0] >> 2) + (tans_q28[0] >> 3) + (tans_q28[1] >> 3) + 1;
    const int8_t shorter = LIM_HAS_LIMBS ? 0 : (int8_t)(6 - clz_u32(most_q25));
    int32_t axes_q30[9];

    for (uint_fast8_t i = 0; i < 2; i++) {
        int8_t bits;
        const int32_t mantissa_q31 = texture_mantissa_of(tans_q28[i], sides_px[i], &bits);
        texturing->axis_bits[i] = LIM_HAS_LIMBS ? bits : (int8_t)(-shorter);
        for (uint_fast8_t k = (uint_fast8_t)(3 * i), end = (uint_fast8_t)(k + 3); k < end; k++)
            axes_q30[k] =
                lim_texture_scaled(mul_high_s32(camera_q30[k], mantissa_q31) * 2, LIM_HAS_LIMBS ? 0 : bits + shorter);
    }
    texturing->axis_bits[2] = (int8_t)(-shorter);
    for (uint_fast8_t k = 6; k < 9; k++)
        axes_q30[k] = camera_q30[k] >> shorter;
    for (uint_fast8_t i = 0; i < 3; i++)
        set_axis(&texturing->axes[i], &axes_q30[3 * i]);
}

void lim_texture_begin(struct lim_texturing *texturing, const struct lim_scene *scene, const struct lim_view *view,
                       const struct lim_camera *camera, const int32_t axes_q30[9])
{
    texturing->scene = scene;
    texturing->w_px = (int16_t)view->width.px;
    texturing->h_px = (int16_t)view->height.px;
    texturing->far_bits = (uint8_t)(32 - clz_u32(view->rows.far_units));
    if (LIM_HAS_LONG && lim_scene_long(scene)) {
        texturing->far_bits = LIM_LONG_FAR_BITS;
        texturing->far = view->rows.eye;
    } else {
        for (uint_fast8_t i = 0; i < LIM_TEXTURE_AXES; i++) {
            const int32_t at_q8 = camera->eye_q8[i % 3];
            texturing->eye_high[i] = (int16_t)((at_q8 + 0x8000) >> 16);
            texturing->eye_low_q8[i] = (int16_t)(at_q8 - texturing->eye_high[i] * INT32_C(65536));
        }
    }
    texture_set_axes(texturing, camera, axes_q30);
    /* log2 of a pixel's side at depth 1, the mean of both: 2 tan / side. */
    const int16_t sum_q4 = (int16_t)(log2_q4(camera->tan_x_q28) + log2_q4(camera->tan_y_q28) -
                                     log2_q4((uint32_t)texturing->w_px) - log2_q4((uint32_t)texturing->h_px));
    texturing->level_q4 = (int16_t)((sum_q4 >> 1) - 27 * 16);
}

/* Once a polygon ----------------------------------------------------------------------------------- */

static inline int32_t dot_2(const LIM_FLASH int16_t *a, const int16_t *b)
{
    return DOT_OF_PAIRS(a, b);
}

static inline int32_t across_q15(const LIM_FLASH int16_t a[2], const struct lim_texture_axis *axis, uint_fast8_t j)
{
    return dot_2(a, &axis->high_q14[j]) * 2 + (dot_2(a, &axis->low_q30[j]) >> 15);
}

/* An eye in the plane itself sees nothing of it; with rounding perhaps a line of pixels, whose texels are as good as
 * any. */
static inline struct height height_of(const struct lim_texturing *texturing, const int16_t n[3], int32_t d)
{
    /* h = upper * 2^16 + lower, lower not negative. */
    const int32_t rest_q8 = (d & 255) * 256 - dot_3(n, texturing->eye_low_q8);
    int32_t upper = (d >> 8) - dot_3(n, texturing->eye_high) + (rest_q8 >> 16), lower = rest_q8 & 0xFFFF;
    const bool behind = upper < 0;
    if (behind) {
        upper = -upper - (lower > 0);
        lower = -lower & 0xFFFF;
    }
    return height_of_words((uint32_t)upper >> 16, (uint32_t)upper << 16 | (uint32_t)lower, behind);
}

static inline void times(struct lim_texture_plane *plane, int32_t by_q31)
{
    plane->at = mul_high_s32(plane->at * 2, by_q31);
    plane->x = mul_high_s32(plane->x * 2, by_q31);
    plane->y = mul_high_s32(plane->y * 2, by_q31);
}

/* Depth at 2^far_bits units: h / 2^far_bits, in the format of `depth`. Rounding leaves some pixels outside of their
 * polygon, and there the depth may be anything; no smaller one is ever divided by. */
static inline int32_t depth_min_of(struct height height, int8_t depth_bits, uint8_t far_bits)
{
    const int_fast16_t bits = (int_fast16_t)(far_bits - height.bits - 7 - depth_bits);
    const int32_t least = bits <= 1 ? INT32_C(1) << 29 : lim_texture_scaled(height.mantissa, bits);

    return least < 1 ? 1 : least;
}

/* The place at the eye, of a coordinate that is across the axes j and k. */
static inline uint32_t eye_place_q16(const struct lim_texturing *texturing, const LIM_FLASH int16_t a[2],
                                     uint_fast8_t j, uint8_t bits, uint16_t at_zero_q16)
{
    const int32_t high = dot_2(a, &texturing->eye_high[j]), low = dot_2(a, &texturing->eye_low_q8[j]);
    const int_fast16_t down = (int_fast16_t)(bits - 8); /* of high * 2^16 + low, which has 8 + bits fraction bits */

    return at_zero_q16 + (down >= 16  ? lim_texture_shifted(high + (low >> 16), down - 16)
                          : down >= 0 ? ((uint32_t)high << (16 - down)) + (uint32_t)(low >> down)
                                      : ((uint32_t)high << 8 << (8 - down)) + ((uint32_t)low << -down));
}

static inline void see(const struct lim_texturing *texturing, const LIM_FLASH struct lim_mapping *mapping,
                       struct seen *seen)
{
    const struct lim_texture_axis *axes = texturing->axes;
    const uint8_t bits = mapping->scale & LIM_MAPPING_BITS;
    const uint_fast8_t axis = mapping->scale >> LIM_MAPPING_AXIS_SHIFT, j = lim_axis_after(axis);
    int16_t n[3] = {0, 0, 0};
    int32_t d;

    if (mapping->scale & LIM_MAPPING_UPRIGHT) {
        n[axis] = LIM_MAPPING_UPRIGHT_N;
        d = (lim_offset)mapping->plane * INT32_C(LIM_MAPPING_UPRIGHT_N);
    } else {
        const LIM_FLASH struct lim_plane *plane = lim_plane_at(texturing->scene->planes, mapping->plane);
        n[0] = lim_plane_x(plane), n[1] = lim_plane_y(plane), n[2] = lim_plane_z(plane);
        d = lim_plane_d(plane);
    }

    seen->height = height_of(texturing, n, d);
    seen->depth = (struct lim_texture_plane){normal_q15(n, &axes[2]), normal_q15(n, &axes[0]), normal_q15(n, &axes[1])};
    if (seen->height.behind) negate(&seen->depth);
    seen->depth_bits = fill_bits(texturing, &seen->depth, 1);
    for (uint_fast8_t i = 0; i < 2; i++) {
        const LIM_FLASH int16_t *a = mapping->uv[i];
        seen->uv[i] = (struct lim_texture_plane){across_q15(a, &axes[2], j), across_q15(a, &axes[0], j),
                                                 across_q15(a, &axes[1], j)};
        seen->eye_uv_q16[i] = eye_place_q16(texturing, a, j, bits, mapping->at_zero_q16[i]);
    }
    const int8_t uv_bits = fill_bits(texturing, seen->uv, 2);
    seen->shift = (int8_t)(bits + uv_bits - seen->depth_bits - seen->height.bits - 9);
    seen->level_q4 =
        (int16_t)(mapping->level_q3 * 2 + 7 * 16 + texturing->level_q4 + log2_q4((uint32_t)seen->height.mantissa) +
                  16 * seen->height.bits + (29 * 16 + 3 * 16 * seen->depth_bits) / 2 + MIDDLE_OF_LEVEL_Q4 -
                  3 * LIM_TEXTURE_LOG2_Q4 / 2);
}

/* Even ------------------------------------------------------------------------------------------------------------ */

/* How much of a coordinate a pixel is, of a plane's gradient for half of one: what is left of it when the depth's part,
 * `ratio` times the depth's gradient, is gone, times h / depth. */
static inline int32_t step_of(int32_t gradient, int32_t ratio, int32_t depth_gradient, int32_t h_recip,
                              int_fast16_t down)
{
    const int32_t rest = gradient - mul_high_s32(ratio, depth_gradient) * 4;

    return (int32_t)(lim_texture_shifted(lim_texture_times(rest, h_recip), down - 1) + 1) >> 1;
}

/* Whether the polygon may be drawn so, and how.
 *
 * Where depth is (1 + e) times that of the middle, texels are off by e / (1 + e) of their way from there along the
 * gradients of the middle: u = (u0 + g . q) / (1 + e) if u0 + g . q are what the gradients alone would have. */
static bool set_even(const struct lim_texturing *texturing, const struct seen *seen, const struct around *around,
                     struct lim_gradients *out)
{
    const int32_t x = 2 * around->x + 1 - texturing->w_px, y = 2 * around->y + 1 - texturing->h_px;
    const int32_t depth = plane_at(&seen->depth, x, y);
    const uint32_t range = (uint32_t)depth_range(&seen->depth, around);
    uint8_t zeros;

    if (depth < 64 || range >= (uint32_t)depth >> 2) return false;
    const int32_t recip_q31 = lim_texture_reciprocal((uint32_t)depth, &zeros);
    const int_fast16_t down = (int_fast16_t)(seen->shift - zeros);
    const int32_t h_recip = lim_texture_h_recip(seen->height.mantissa, recip_q31);
    const int32_t depth_x = (int32_t)((uint32_t)seen->depth.x << zeros),
                  depth_y = (int32_t)((uint32_t)seen->depth.y << zeros);
    uint32_t place[2], farthest_q16 = 0;
    int32_t step_x[2], step_y[2];

    for (uint_fast8_t i = 0; i < 2; i++) {
        const struct lim_texture_plane *uv = &seen->uv[i];
        const int32_t ratio = lim_texture_times(plane_at(uv, x, y), recip_q31);
        step_x[i] = step_of(uv->x, ratio, depth_x, h_recip, down - 1);
        step_y[i] = step_of(uv->y, ratio, depth_y, h_recip, down - 1);
        if (abs_s32(step_x[i]) >> 15 || abs_s32(step_y[i]) >> 15) return false;
        const uint32_t way_q16 = abs_s32(step_x[i]) * (uint32_t)around->w + abs_s32(step_y[i]) * (uint32_t)around->h;
        if (way_q16 > farthest_q16) farthest_q16 = way_q16;
        place[i] = seen->eye_uv_q16[i] + lim_texture_shifted(mul_high_s32(ratio * 2, seen->height.mantissa), down);
    }
    const uint8_t w_bits = out->texture->w_bits;
    const uint8_t level =
        lim_texture_level_of(lim_texture_level_q4(seen->level_q4, (uint32_t)depth, zeros), out->texture->levels);
    const uint32_t way_q8 = (farthest_q16 >> 6 << w_bits) >> (level + 2);
    const uint32_t e_q14 = (range << zeros >> 16) * ((uint32_t)recip_q31 >> 16) >> 16;
    if (way_q8 >> 16 || way_q8 * e_q14 > UINT32_C(1) << (23 - LIM_TEXTURE_OFF_BITS)) return false;
    const int_fast8_t reach_bits = (int_fast8_t)(level + 15 - LIM_TEXTURE_OFF_BITS - w_bits);
    if (reach_bits < 0 || (uint32_t)(around->w + around->h) >> reach_bits) return false;
    out->level.step = lim_texture_packed((uint32_t)step_x[0], (uint32_t)step_x[1]);
    out->even.y = lim_texture_packed((uint32_t)step_y[0], (uint32_t)step_y[1]);
    out->even.place = (place[0] << 16 | (uint16_t)place[1]) - out->level.step * (uint32_t)around->x -
                      out->even.y * (uint32_t)around->y;
    lim_texture_set_level(texturing->scene, level, out);
    if (LIM_HAS_SKY) out->pace = 0; /* it is no sky */
    return true;
}

/* In perspective -------------------------------------------------------------------------------------------------- */

static void set_planes(const struct lim_texturing *texturing, const struct seen *seen, const struct around *around,
                       struct lim_gradients *out)
{
    struct lim_texture_planes *planes = &out->planes;

    for (uint_fast8_t i = 0; i < 2; i++) {
        planes->uv[i] = seen->uv[i];
        times(&planes->uv[i], seen->height.mantissa);
    }
    planes->eye_place = pair_of_lows(seen->eye_uv_q16[1], seen->eye_uv_q16[0]);
    planes->depth = seen->depth;
    planes->depth_min = depth_min_of(seen->height, seen->depth_bits, texturing->far_bits);
    planes->level_q4 = seen->level_q4;
    lim_texture_settle(texturing, around, seen->shift, out);
}

/* Whose number it is, and which of its own. */
static inline const struct lim_texturing *owner_of(const struct lim_texturing *texturing, uint16_t *number)
{
    if (!LIM_HAS_MOVERS || *number < lim_texture_numbers(texturing->scene)) return texturing;
    do
        texturing = *texturing->moved;
    while (*number < *texturing->first_texture);
    *number = (uint16_t)(*number - *texturing->first_texture);
    return texturing;
}

/* lim_screen_polygon.texture, of a scene, and the words that are there. */
static inline uint16_t number_of_mapping(const struct lim_scene *scene, uint16_t number,
                                         const LIM_FLASH lim_index *words)
{
    return (uint16_t)(lim_mappings_name_textures(scene) ? number : words[1]);
}

static inline uint16_t number_of_texture(const struct lim_scene *scene, uint16_t number,
                                         const LIM_FLASH lim_index *words)
{
    return (uint16_t)(lim_mappings_name_textures(scene) ? LIM_MAPPING_TEXTURE(&scene->mappings[number]) : words[0]);
}

void lim_texture_set(const struct lim_texturing *texturing, uint16_t number, const struct lim_point *at, uint8_t n,
                     struct lim_gradients *out)
{
    texturing = owner_of(texturing, &number);
    const LIM_FLASH lim_index *words = &texturing->scene->polygons[number]; /* there are as many, in any scene */
    const struct around around = around_points(texturing, at, n);
    struct seen seen;

    const struct lim_scene *const scene = texturing->scene;
    const LIM_FLASH struct lim_mapping *const mapping = &scene->mappings[number_of_mapping(scene, number, words)];
    out->texture = &scene->textures[number_of_texture(scene, number, words)];
    if (LIM_HAS_SKY && lim_texture_is_sky(out->texture)) {
        lim_sky_set(texturing, mapping, out);
        return;
    }
    if (LIM_HAS_LONG && lim_scene_long(scene))
        lim_texture_see_long(texturing, number_of_mapping(scene, number, words), &seen);
    else
        see(texturing, mapping, &seen);
    out->is_even = set_even(texturing, &seen, &around, out);
    if (!out->is_even) set_planes(texturing, &seen, &around, out);
}

#endif
