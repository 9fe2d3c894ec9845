/* SPDX-License-Identifier: MIT
 *
 * Hand-made scenes of quads and triangles, and the reference's picture of them. */
#ifndef TESTS_REFERENCE_RIG_H
#define TESTS_REFERENCE_RIG_H

#include "accuracy/reference.h"

enum { W_PX = 40, H_PX = 30, MOST_POLYGONS = 256 };

extern const struct lens LENS; /* at distance 1 a picture is 2 wide and 1.5 high */
extern const struct viewpoint ALONG_MINUS_Z;

/* A scene, put together by the tests; it starts empty. */
struct scene {
    double points[4 * MOST_POLYGONS][3];
    uint32_t corners[4 * MOST_POLYGONS];
    struct mesh_polygon polygons[MOST_POLYGONS];
    struct mesh mesh;
};

void scene_clear(struct scene *scene);
void scene_add(struct scene *scene, uint32_t face, uint32_t count, double (*corners)[3]);

/* A square around the axis at z = -depth_m that faces the eye, which looks along -z. */
void scene_add_square(struct scene *scene, uint32_t face, double half_m, double depth_m);

/* The picture, W_PX x H_PX or of another size; reference_free() it. */
struct reference draw(const struct scene *scene, const struct viewpoint *viewpoint);
struct reference draw_sized(const struct scene *scene, const struct viewpoint *viewpoint, unsigned w_px, unsigned h_px);

#endif
