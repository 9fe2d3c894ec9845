/* SPDX-License-Identifier: MIT
 *
 * Sets of polygons without a tree, put together by hand in whole units and drawn by the renderer's own functions: one
 * leaf, each record with a plane of its own, its colour a number or a letter that names it. The eye is at the origin.
 */
#ifndef TESTS_SET_RIG_H
#define TESTS_SET_RIG_H

#include "accuracy/compare.h"
#include "limner.h"

enum { SET_POLYGONS = 600, SET_VERTICES = 4 * SET_POLYGONS, SET_SIDE_PX = 64 };

struct set {
    struct lim_vertex vertices[SET_VERTICES];
    struct lim_plane planes[SET_POLYGONS];
    struct lim_plane_exact exact[SET_POLYGONS];
    lim_index polygons[SET_POLYGONS * 8];
    struct lim_node leaf;
    struct lim_scene scene;
    lim_index last; /* the last record */
    uint8_t alpha;  /* of what is added; 0: opaque */
};

/* Where a set is drawn. */
struct set_view {
    struct lim lim;
    void *mem;
    uint16_t pixels[SET_SIDE_PX][SET_SIDE_PX]; /* colours as they lie in memory */
    uint32_t done_px;
};

void set_init(struct set *set);

/* Corners run counter-clockwise as seen from the side that it faces, and lie in one plane: that of the first three. 3
 * or 4 of them, coordinates within 4096 units. */
void set_add(struct set *set, lim_index name, int count, const int16_t (*corners)[3]);

/* A camera at the origin that looks along -z, or along +z; 90 degrees wide and high. */
struct lim_camera set_camera(bool along_plus_z);

/* Draws with room for `pieces`, or what lim_mem_b() says if negative; fails the test if the frame fails or a pixel is
 * not painted once. `options`: NULL, the default. set_view_free() it. */
void set_draw(const struct set *set, enum lim_method method, const struct lim_newell_options *options, int pieces,
              const struct lim_camera *camera, struct set_view *view);
void set_view_free(struct set_view *view);

/* The same as one sees them: x to the right, y up, the depth ahead. */
void set_add_seen(struct set *set, lim_index name, bool along_plus_z, int count, const int16_t (*corners)[3]);

/* What the reference says of a picture of polygons named 1, 2, 3 ... in their order. */
struct compare_counts set_compare(const struct set *set, const struct set_view *view, bool along_plus_z);

/* The names in the order in which a painter would take them, farthest first; a piece's name is its polygon's. */
void set_order(const struct set_view *view, char *names);

#endif
