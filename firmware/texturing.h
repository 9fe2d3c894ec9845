/* SPDX-License-Identifier: MIT
 *
 * Private, and complete here as the structs of stages.h are: what texturing keeps of a frame and of a polygon. */
#ifndef LIM_TEXTURING_H
#define LIM_TEXTURING_H

#include "config.h"

struct lim_long_eye;
struct lim_scene;
struct lim_texture;

/* A direction of the camera, high / 2^14 + low / 2^30, in x, y, z, and x again: each two that follow lie together. */
enum { LIM_TEXTURE_AXES = 4 };
struct lim_texture_axis {
    int16_t high_q14[LIM_TEXTURE_AXES], low_q30[LIM_TEXTURE_AXES]; /* |high| <= 2^14 */
};

/* Where the sky's picture is seen along a ray: sky.h. */
struct lim_sky_node {
    uint32_t turn;    /* about the vertical axis, from +x to +z; a full turn is 2^32 */
    int32_t rise_q16; /* above the horizon, in parts of the circumference, on a cylinder; no steeper than 8 */
};

enum { LIM_SKY_NODES = 32 };
struct lim_sky_row {
    int16_t number;    /* from the screen's top; -1: none */
    uint8_t from, end; /* nodes from <= k < end are there */
    struct lim_sky_node nodes[LIM_SKY_NODES];
};

struct lim_sky {
    int32_t first_q24[3], across_q24[3], down_q24[3]; /* the way to the screen's first pixel, and from node to node */
    uint32_t pixel_q16;                               /* how wide a pixel in the middle is, at distance 1 */
    uint8_t across_bits, down_bits;                   /* nodes are 2^these pixels apart */
    struct lim_sky_row rows[2];                       /* of even numbers, of odd ones */
};

LIM_OPTIONAL_BEGIN

/* What all textured polygons of a frame have in common; and likewise those of an object that moves in it. */
struct lim_texturing {
    const struct lim_scene *scene;
    LIM_OPTIONAL(struct lim_sky *, sky, LIM_HAS_SKY);
    struct lim_texture_axis axes[3]; /* what a half-pixel to the right and down adds to the way ahead, and that */
    union {
        int16_t eye_high[LIM_TEXTURE_AXES]; /* with low, the eye: 256 high + low / 256 units */
        const struct lim_long_eye *far;     /* in a long scene (long.h); no low then */
    };
    int16_t eye_low_q8[LIM_TEXTURE_AXES];
    int8_t axis_bits[3]; /* the axes are 2^these times too long */
    uint8_t far_bits;    /* no vertex is 2^far_bits units away or more */
    int16_t w_px, h_px;
    int16_t level_q4; /* what the lens adds to every level of detail, log2 */
    /* Textured polygons that are numbered behind the scene's, up to `numbers`, are those of objects: a list, the last
     * ones first. An object's begin at first_texture. */
    LIM_OPTIONAL(struct lim_texturing *, moved, LIM_HAS_MOVERS);
    LIM_OPTIONAL(uint16_t, numbers, LIM_HAS_MOVERS);
    LIM_OPTIONAL(uint16_t, first_texture, LIM_HAS_MOVERS);
};

LIM_OPTIONAL_END

/* at + x * X + y * Y for X = 2 x_px + 1 - w_px, and Y likewise: half-pixels from the middle of the screen. Within 31
 * bits for X within -3 w_px .. 3 w_px and every line of the screen. */
struct lim_texture_plane {
    int32_t at, x, y;
};

struct lim_texture_level;

/* n pixels of a line, one at least, that end before `end`, from a place in the picture on. What ends at one place takes
 * one jump into stores without a loop, however many there are. */
typedef void lim_texels_painter(uint16_t *end, uint_fast16_t n, uint32_t place, const struct lim_texture_level *level);

/* How to find texels of one level, and how they advance. */
struct lim_texture_level {
    uint32_t step;      /* what a pixel to the right adds to a place */
    uint32_t rows_mask; /* of rows times what a row has, which is 2^w_bits */
    const LIM_FLASH uint8_t *texels;
    const LIM_FLASH uint16_t *palette;
    uint8_t w_bits, number;
};

/* A place in a picture: u in the upper half, v in the lower one, either in 2^-16 of its width. So it wraps where the
 * picture does, which is not higher than wide, and is the same at all levels of detail. */
struct lim_texture_walk {
    uint32_t place, step; /* from pixel to pixel */
};

/* Where a polygon is so flat to the eye that texels advance evenly all over it, by its level's step to the right. */
struct lim_texture_even {
    uint32_t place, y; /* of pixel (0, 0), and what a pixel down adds */
};

enum { LIM_PACE_SKY = 255 }; /* lim_gradients.pace of a sky, for which is_even stands, too */
struct lim_texture_sky {
    int32_t times, horizon_q16; /* round the eye; from the picture's top, in its widths */
};

struct lim_texture_planes {             /* where it is not */
    struct lim_texture_plane depth;     /* n . D, positive where the polygon is: 1 / z but for a factor */
    struct lim_texture_plane uv[2];     /* h (a . D), with one more factor */
    uint32_t eye_place;                 /* the place at the eye, as in struct lim_texture_walk */
    int32_t depth_min;                  /* that of the scene's far end, at least 1 */
    int16_t level_q4;                   /* of detail, less 3/2 log2(depth) but for the constant */
    int16_t even_q4;                    /* log2 of the square of how many pixels are even, less what level_q4 tells */
    uint32_t level_depth, level_depths; /* those that have the level shown last: from where on, how many */
};

/* A polygon's mapping as this frame's camera sees it. */
struct lim_gradients {
    lim_texels_painter *paint;                   /* what paints its width */
    struct lim_texture_level level;              /* the last one that was shown */
    const LIM_FLASH struct lim_texture *texture; /* NULL: of one colour */
    bool is_even;
    int8_t shift;        /* of planes: makes up for the factors, 31 at most */
    uint8_t slope_zeros; /* leading zeros of |depth.x| */
    uint8_t pace;        /* of stretches (lim_texture_pace()), whatever the line; 0: each line has its own */
    union {
        struct lim_texture_even even;
        struct lim_texture_planes planes;
        struct lim_texture_sky sky;
    };
};

/* A line of a textured polygon: pixels left <= x < right, before anything is cut off. */
struct lim_textured_span {
    const struct lim_texturing *texturing;
    struct lim_gradients *gradients;
    int32_t y, left, right;
};

/* A piece with a masked texture: its polygon's mapping, or NULL of a colour, and all of that on the line. */
struct lim_masked {
    struct lim_gradients *gradients;
    int16_t left, right;
};

/* The same of a piece that waits: `at` is where the mapping lies behind lim_layers.own, in bytes; 0: it has a colour. A
 * pointer would want more than the words that memory is cut up in. */
struct lim_masked_layer {
    int32_t at;
    int16_t left, right;
};

LIM_OPTIONAL_BEGIN

/* A piece of a line that waits for what lies behind it. */
struct lim_layer {
    uint16_t x0, x1; /* x0 <= x < x1 */
    uint16_t colour; /* as it lies in memory */
    uint8_t alpha;   /* of a masked texture, how many samples of each pixel its polygon has, as a part of 255 */
    LIM_OPTIONAL(struct lim_masked_layer, masked, LIM_HAS_MASKED);
};

LIM_OPTIONAL_END

#endif
