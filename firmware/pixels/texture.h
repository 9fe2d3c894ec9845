/* SPDX-License-Identifier: MIT
 *
 * TEXTURE: which texel a pixel of a textured polygon shows. In: the camera, once a frame; a record's mapping, once
 * a polygon; a span. Out: the span's pixels. Memory: the caller's structs.
 *
 * A mapping is affine in space: u = a . p + b on the plane n . p = d. The ray through a pixel is eye + z D with D
 * affine on the screen, so it meets the plane at z = h / (n . D), where h = d - n . eye, and shows
 *
 *     u = (a . eye + b) + h (a . D) / (n . D):
 *
 * two affine functions of the screen and a division. Vertices, clipping and splits have no part in it, so
 * polygons of one mapping agree wherever they meet.
 *
 * Between divisions texels are taken along a straight line, as far as that is off by no more than LIM_TEXTURE_OFF: over
 * all of a polygon that is small or that the eye sees from the front, else over a stretch of a line. */
#ifndef LIM_TEXTURE_H
#define LIM_TEXTURE_H

#include "camera.h"
#include "pixels/sky.h"
#include "pixels/texels.h"
#include "pixels/texture_planes.h"

/* A line of a polygon, stretch by stretch: from pixel x to the one before `end`, which may lie behind the line's own,
 * texels advance evenly. */
struct lim_texture_line {
    const struct lim_texturing *texturing;
    struct lim_gradients *gradients; /* their level is that of the stretch */
    struct lim_texture_walk walk;    /* from pixel `middle` on, and back */
    int32_t x, end;
    int32_t middle, next;      /* of the stretch, and behind it */
    uint32_t step_after;       /* of what is bent, from its middle on */
    int32_t depth, uv[2];      /* the planes where x is 0 */
    uint32_t middle_depth;     /* of the stretch, no less than depth_min */
    uint32_t n_px, bits, bent; /* of a stretch, 2^bits; 1: only halves of it are even */
    uint16_t divisions;        /* so far */
};

/* Once a frame, after lim_view_begin(), with the camera's axes, of lim_orientation_set(); and once an object that moves
 * and whose textures are those of the frame's scene, with view, camera and axes as it sees them. */
void lim_texture_begin(struct lim_texturing *texturing, const struct lim_scene *scene, const struct lim_view *view,
                       const struct lim_camera *camera, const int32_t axes_q30[9]);

/* What moves has moved: no object has begun. */
static inline void lim_texture_forget_moved(struct lim_texturing *frame)
{
    *frame->moved = NULL;
    *frame->numbers = 0;
}

/* The textured polygons of an object, so many, are numbered behind all that there are so far. false: 16 bits do not
 * count them. */
static inline bool lim_texture_add_moved(struct lim_texturing *frame, struct lim_texturing *texturing, lim_index first,
                                         lim_index numbers)
{
    const lim_index from = *frame->moved ? *frame->numbers : first;

    *texturing->first_texture = LIM_NONE;
    if (from >= LIM_NONE || numbers > (lim_index)LIM_NONE - from) return false;
    *texturing->first_texture = (uint16_t)from;
    *texturing->moved = *frame->moved;
    if (LIM_HAS_SKY) *texturing->sky = *frame->sky;
    *frame->moved = texturing;
    *frame->numbers = (uint16_t)(from + numbers);
    return true;
}

/* Once a polygon; `number` as lim_screen_polygon.texture, or of an object's behind lim_texturing.first_texture. `at`:
 * its n corners on the screen; none of a piece, whose lines alone are known. */
void lim_texture_set(const struct lim_texturing *texturing, uint16_t number, const struct lim_point *at, uint8_t n,
                     struct lim_gradients *out);

/* The stretch of the line that pixel x is in, left <= x < right, on the screen; the next one. Stretches begin at left,
 * or the screen's side, whatever of the line is visible: all orders of drawing paint the same. */
void lim_texture_line_begin(struct lim_texture_line *line, const struct lim_textured_span *span, int16_t x);
void lim_texture_line_next(struct lim_texture_line *line);

/* The place that pixel x of the stretch shows. */
static inline uint32_t lim_texture_place(const struct lim_texture_line *line, int32_t x)
{
    return line->walk.place + line->walk.step * (uint32_t)(x - line->middle);
}

/* Of a polygon that is even all over. */
static inline uint32_t lim_texture_even_place(const struct lim_texture_even *even, uint32_t step, int32_t x, int32_t y)
{
    return even->place + step * (uint32_t)x + even->y * (uint32_t)y;
}

/* Paints pixels x0 <= x < x1 of a line that is not even. Returns how often it divided, if LIM_HAS_STATS. */
uint16_t lim_texture_fill_flat(const struct lim_textured_span *span, uint16_t *pixels, int32_t x0, int32_t x1);
uint16_t lim_texture_fill_slanted(const struct lim_textured_span *span, uint16_t *pixels, int32_t x0, int32_t x1);

static inline uint16_t lim_texture_fill_stretches(const struct lim_textured_span *span, uint16_t *pixels, int32_t x0,
                                                  int32_t x1)
{
    if (!span->gradients->planes.depth.x) return lim_texture_fill_flat(span, pixels, x0, x1);
    return lim_texture_fill_slanted(span, pixels, x0, x1);
}

/* Of any line. */
static inline void lim_texture_fill(const struct lim_textured_span *span, uint16_t *pixels, uint16_t x0, uint16_t x1,
                                    struct lim_stats *stats)
{
    const struct lim_gradients *const gradients = span->gradients;

    if (gradients->is_even) {
        if (LIM_HAS_SKY && gradients->pace == LIM_PACE_SKY) {
            lim_sky_fill(span, pixels, x0, x1);
            return;
        }
        gradients->paint(pixels + x1, (uint_fast16_t)(x1 - x0),
                         lim_texture_even_place(&gradients->even, gradients->level.step, x0, span->y),
                         &gradients->level);
        return;
    }
    const uint16_t divisions = lim_texture_fill_stretches(span, pixels, x0, x1);
    if (LIM_HAS_STATS) stats->divisions += divisions;
}

#endif
