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
 * polygons of one mapping agree wherever they meet. */
#ifndef LIM_TEXTURE_H
#define LIM_TEXTURE_H

#include "camera.h"
#include "stages.h"

/* From one division to the next there are 2^this pixels; in between, texels are taken along a straight line. In draft
 * a polygon's line has none between its ends. */
#if LIM_PROFILE == LIM_PROFILE_DRAFT
#define LIM_TEXTURE_STEP_BITS 12
#elif LIM_PROFILE == LIM_PROFILE_FAST
#define LIM_TEXTURE_STEP_BITS 4
#elif LIM_PROFILE == LIM_PROFILE_FINE
#define LIM_TEXTURE_STEP_BITS 3
#else
#define LIM_TEXTURE_STEP_BITS 2
#endif

/* log2(x) of x = mantissa 2^-zeros, 2^31 <= mantissa < 2^32, in 16ths, is mantissa / 2^27 - 16 zeros and this, straight
 * between the powers of two: at most 1.4 sixteenths short. */
enum { LIM_TEXTURE_LOG2_Q4 = 30 * 16 };

/* Texels at one end of a stretch; texel coordinates of level 0, modulo 2^16. */
struct lim_texel {
    uint32_t uv_q16[2];
    uint8_t level; /* that suits this depth, and that the texture has */
};

/* A line of a polygon, stretch by stretch: from pixel x to the one before `end` texels advance evenly. */
struct lim_texture_line {
    const struct lim_gradients *gradients;
    int32_t depth, uv[2]; /* the planes at X = 0 */
    int16_t w_px, right;  /* right: the pixel behind the line's last */
    int16_t x, end;
    struct lim_texel at, to; /* at the centres of pixel x and of `end`, or of the last one */
    uint8_t level;           /* of the stretch: the finer one of its ends */
    int32_t step_q16[2];
    uint16_t divisions; /* so far */
};

/* Once a frame, after lim_view_begin(). */
void lim_texture_begin(struct lim_texturing *texturing, const struct lim_scene *scene, const struct lim_view *view,
                       const struct lim_camera *camera);

/* Once a polygon; its record names texture and mapping at this word of lim_scene.polygons. */
void lim_texture_set(const struct lim_texturing *texturing, uint16_t word, struct lim_gradients *gradients);

/* A line of a textured polygon: pixels left <= x < right, before anything is cut off. */
struct lim_textured_span {
    const struct lim_texturing *texturing;
    const struct lim_gradients *gradients;
    int16_t y, left, right;
};

/* The stretch of the line that pixel x is in, left <= x < right; the next one. Stretches begin at left and every
 * 2^LIM_TEXTURE_STEP_BITS pixels after, whatever of the line is visible: all orders of drawing paint the same. */
void lim_texture_line_begin(struct lim_texture_line *line, const struct lim_textured_span *span, int16_t x);
void lim_texture_line_next(struct lim_texture_line *line);

/* A place in a picture: v in the upper half, u in the lower one, either in 2^-16 of the side. So it wraps where the
 * picture does, and is the same at all levels of detail. */
struct lim_texture_walk {
    uint32_t at, step; /* from pixel to pixel */
};

/* What pixel x of the stretch shows, and how the stretch goes on. */
struct lim_texture_walk lim_texture_at(const struct lim_texture_line *line, int16_t x);

/* Paints pixels x0 <= x < x1 of it. */
void lim_texture_fill(const struct lim_textured_span *span, uint16_t *pixels, uint16_t x0, uint16_t x1,
                      struct lim_stats *stats);

#endif
