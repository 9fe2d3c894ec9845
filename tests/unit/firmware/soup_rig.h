/* SPDX-License-Identifier: MIT
 *
 * Meshes without a tree, put together by hand in whole units, and what a picture of one may show: corners of the
 * renderer's own projection, covered pixels by integers, distances by doubles. Each triangle's colour is its number and
 * 1, as RGB565; the background is 0. */
#ifndef TESTS_SOUP_RIG_H
#define TESTS_SOUP_RIG_H

#include "core/core.h"
#include "rigs/random.h"

enum { SOUP_TRIANGLES = 600, SOUP_VERTICES = 3 * SOUP_TRIANGLES, SOUP_KINDS = 7, SOUP_CORNERS = 10 };

struct soup {
    struct lim_vertex vertices[SOUP_VERTICES];
    lim_index words[SOUP_TRIANGLES * LIM_TRIANGLE_WORDS];
    struct lim_box box;
    struct lim_scene scene;
};

/* Empty, with a box of nothing. */
void soup_init(struct soup *soup);
lim_index soup_vertex(struct soup *soup, double x, double y, double z); /* rounded, and kept within 16 bits */
void soup_triangle(struct soup *soup, lim_index a, lim_index b, lim_index c);
/* When all is added: the box, the limits, and where depth begins. */
void soup_done(struct soup *soup, lim_index deep_from);

/* Kind 0: a closed bumpy ball; 1: triangles through one another; 2: needles and slivers; 3: one triangle; 4: large ones
 * around the origin; 5: many tiny ones; 6: a ground to the horizon, 100 units below the eye, and what stands in it.
 * About `radius` units large. */
void soup_random(struct soup *soup, struct random *random, unsigned kind, double radius);

/* Looks about towards the origin from `distance` units. */
struct lim_camera soup_camera(struct random *random, double distance);

/* A picture, and a renderer that paints it. */
struct soup_view {
    const struct core *core;
    uint16_t w_px, h_px;
    void *lim, *mem;
    size_t mem_b;
    uint16_t *pixels; /* numbers of colours, as they lie in memory; a row has w_px and stride more */
    uint32_t stride_px;
    uint32_t done_lines;
    int fails_at; /* done() fails at this line; or -1 */
    int lends_to; /* lend() lends nothing from this line on; or -1 */
};

/* mem_b = 0: as much as is comfortable. What is in memory before is `before`. Returns what init() says. */
int soup_view_init(struct soup_view *view, const struct core *core, const struct soup *soup, enum lim_method method,
                   uint16_t w_px, uint16_t h_px, size_t mem_b, int before);
/* Draws and returns the code; if that is LIM_OK, each line was done once and nothing beside it was touched. */
int soup_view_draw(struct soup_view *view, const struct lim_camera *camera);
/* The number of the triangle at a pixel, or -1: the background. */
int soup_view_at(const struct soup_view *view, uint16_t x_px, uint16_t y_px);
void soup_view_free(struct soup_view *view);

/* What a picture is compared with. */
struct soup_counts {
    uint32_t pixels, covered; /* of the screen; with a triangle */
    uint32_t ambiguous;       /* several triangles are as near, within what the renderer's numbers tell apart */
    uint32_t wrong;           /* the picture shows what it may not */
    uint64_t painted;         /* pixels of all triangles that face the eye, each as often as it is covered */
    uint32_t clipped;         /* triangles that the renderer clips: their pixels are known within one */
    uint32_t at_x, at_y;      /* a wrong one */
};
struct soup_counts soup_compare(const struct soup *soup, struct soup_view *view, enum lim_method method,
                                const struct lim_camera *camera);

#endif
