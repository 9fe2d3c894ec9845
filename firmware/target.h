/* SPDX-License-Identifier: MIT
 *
 * A target: what the renderer paints into. A panel with one line of memory is one, and so is a
 * framebuffer. */
#ifndef LIM_TARGET_H
#define LIM_TARGET_H

#include "config.h"

/* What can go wrong at run time. Functions that can fail return 0 or a negative code, and are checked. A target's own
 * negative codes come back unchanged. Any number but 0 from done(), window() or show() ends the frame. */
enum lim_error {
    LIM_OK = 0,
    LIM_ERR_MEMORY = -1001, /* mem_b is below lim_mem_min_b() */
    LIM_ERR_SCENE = -1002,  /* the scene needs more than this build was configured for */
    LIM_ERR_TARGET = -1003, /* the target's size or format is not supported, or it lent no line */
    LIM_ERR_CAMERA = -1004, /* position or lens out of range */
    LIM_ERR_BEGIN = -1005,  /* no frame was begun */
    LIM_ERR_ANSWER = -1006  /* the target returned a positive number, as write() does for what it has written */
};

/* A rectangle of the screen: pixels x0 <= x < x1, y0 <= y < y1. */
struct lim_rect {
    uint16_t x0, y0, x1, y1;
};

enum lim_format {
    LIM_RGB565 /* two bytes a pixel as the bus wants them: the byte with the red bits first */
};

/* A constant colour as the target's memory holds it: lim_memory_colour(). */
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
#define LIM_MEMORY_COLOUR(rgb565) LIM_CAST(uint16_t, (rgb565) << 8 | (rgb565) >> 8)
#else
#define LIM_MEMORY_COLOUR(rgb565) LIM_CAST(uint16_t, rgb565)
#endif

enum lim_method {
    LIM_NEAREST_FIRST, /* every pixel painted once, line by line; no framebuffer needed */
    LIM_PAINTER,       /* back to front; the target lends all its lines at any time */
    LIM_CONVEX,        /* a single convex solid, line by line; the same pixels as nearest first, for less */
    LIM_SCANLINE,  /* line by line, far to near; the same pixels as nearest first, for less where little is hidden */
    LIM_DEPTH,     /* all polygons by their farthest points, whatever the tree says: wrong where that is wrong */
    LIM_NEWELL,    /* the same, then compared and split until nothing is wrong: newell.h */
    LIM_MESH,      /* a mesh without a tree, line by line, triangles by their distance: mesh_frame.h */
    LIM_MESH_DEPTH /* the same, and depths at pixels where the scene says that distance does not do */
};

/* Hidden-line wireframe: polygons are filled with the background, and their edges drawn in their own colours or all in
 * one. Nothing shines through. */
struct lim_wireframe {
    bool on;
    bool one_colour;
    uint16_t colour, background; /* if one_colour, RGB565 as numbers; else the polygons' and the scene's own */
};

/* What sending a part of the picture costs: delta.h. */
struct lim_target_costs {
    uint16_t window_b;   /* opening a window, in bytes; what takes a port longer than its bytes is counted as more */
    uint8_t pixel_bits;  /* on the bus: 1..24 */
    uint8_t page_px;     /* lines that are sent together, as done() finds out by itself; 1, or 8 for bytes that stand */
    uint16_t x_align_px; /* a window's first column and its width are multiples of it, but at the right edge; 1: any */
};

/* A piece of a line in one colour, but for where it begins and ends: lim_target.fill. */
struct lim_piece_look {
    void *ctx;       /* the target's, in its fill() */
    uint16_t colour; /* RGB565 as it lies in memory */
    uint16_t y_px;
};

/* Paints pixels x0_px <= x < x1_px of a line; lim_target.fill, whose `ctx` is a struct lim_piece_look, and what the
 * renderer has of its own. */
typedef void lim_piece_fill(void *ctx, uint16_t x0_px, uint16_t x1_px);

/* Which pixels *x0_px <= x < *x1_px of a line are seen; lim_target.visible. */
typedef void lim_visible(void *ctx, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px);

/* All of a target's pixels in memory, each as lend() has it. */
struct lim_framebuffer {
    void *pixels;       /* of line 0, 4-byte aligned; NULL: there is none */
    uint16_t stride_px; /* from a line to the next: even, w_px at least */
};

/* Where pixels go. Lines are lent from the top down; each is passed to done() before the next is
 * lent, in one or (when a pool was exhausted) several pieces from left to right. The painter
 * alone lends lines in any order, several times, and calls done() once for each at the end. */
struct lim_target {
    uint16_t w_px, h_px; /* 1..LIM_MAX_SIDE_PX each */
    enum lim_format format;
    enum lim_method method;
    void *ctx; /* passed to both functions */
    /* Lends the memory of line y_px, w_px pixels, 4-byte aligned; NULL: cannot (LIM_ERR_TARGET). */
    void *(*lend)(void *ctx, uint16_t y_px);
    /* Pixels x_px .. x_px + n_px - 1 of line y_px are final. 0, or a code that ends the
     * frame. */
    int (*done)(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px);
#if LIM_HAS_ROUND
    lim_visible *visible; /* no other pixels are painted; NULL: all. Neither LIM_PAINTER nor LIM_CONVEX asks */
#endif
#if LIM_HAS_FILL
    /* For targets that keep pixels in a format of their own, instead of lines' memory. A frame that is not made of
     * pieces in one opaque colour each (textures, what is transparent or moves, antialiased, as outlines, as changes)
     * comes by lines as ever; pixels are not counted in struct lim_stats. NULL: lines are lent.
     * show() NULL: the target keeps a line. LIM_CONVEX alone fills it, from the top down: first the background from end
     * to end, then what lies on it, then it calls done().
     * show(): it keeps the whole picture. LIM_NEAREST_FIRST fills pieces in any order, none that `visible` leaves out
     * and each other pixel once, or again where gaps are short or something lies over it (overlay.h); LIM_CONVEX as
     * above, on glass that is not round. When all are there show() is called, and done() is not. */
    lim_piece_fill *fill;
#if LIM_HAS_NEAREST
    int (*show)(void *ctx);
#endif
#endif
#if LIM_HAS_FRAMEBUFFER
    /* LIM_NEAREST_FIRST and LIM_PAINTER paint polygons here as they come, and call done() for each whole line when all
     * are there, from the top down; what `visible` leaves out is whatever it was. Where it lies is taken in by
     * lim_init(). lend() must lend these lines: for frames that are not made of such polygons, as above. */
    struct lim_framebuffer framebuffer;
#endif
#if LIM_HAS_DELTA
    /* The pieces that done() gets next fill this rectangle row by row, or as many rows of it as come; NULL: they are
     * pieces of lines, for which done() opens its own, as ever. Without delta output it is not called, and with
     * page_px > 1 neither. NULL: no delta output. */
    int (*window)(void *ctx, const struct lim_rect *window);
    struct lim_target_costs costs;
#endif
};

#endif
