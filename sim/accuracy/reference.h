/* SPDX-License-Identifier: MIT
 *
 * The reference picture: rays through pixel centres against the source polygons in double
 * precision, nearest hit wins. It knows nothing of the tree, the grid, T-vertices or splits, so
 * that it can find fault with all of them. */
#ifndef SIM_REFERENCE_H
#define SIM_REFERENCE_H

#include "accuracy/near_tiles.h"
#include "cameras/camera_path.h"
#include "model/mesh.h"
#include "model/model_orientation.h"

struct reference_polygon;
struct reference_edge;

/* A picture's rays: right * u + up * v + forward, u and v from -1 to 1, v upwards. */
struct reference_view {
    double eye_m[3];
    double right[3], up[3]; /* scaled by the half-sizes of the picture: their length is tan_x, tan_y */
    double forward[3];
    double near_m, level_m;
    int w_px, h_px;
    double shift_px[2]; /* of the rays from the pixels' centres, to the right and down, within half a pixel */
};

struct reference {
    double (*points)[3]; /* metres */
    struct reference_polygon *polygons;
    size_t polygon_count;
    double (*own_points)[3]; /* the same points before a mover's pose */
    size_t point_count;
    double level_m; /* planes that are no farther apart are one: what doubles tell of the largest coordinate */
    uint32_t corners_max;
    struct reference_edge *edges; /* of one polygon at a time */
    unsigned w_px, h_px;
    struct reference_view view; /* of the last frame drawn */
    uint32_t *faces;            /* w_px * h_px face numbers from the top left, 0 = background */
    uint32_t *mappings;         /* what of a texture: mesh_polygon.mapping of the polygon seen; or NULL */
    double *depths_m;           /* along the view axis; infinite for the background */
    struct pixel_rect *bounds;  /* of the polygons on the screen, in the last frame drawn */
    struct near_tiles tiles;    /* the same */
    bool shares_importer;       /* reference_read(): the file's format has no reader in source.h */
};

/* Copies what it needs of the mesh as mesh_clean_fine() leaves it. Allocates for pictures of this size. */
bool reference_init(struct reference *reference, const struct mesh *mesh, unsigned w_px, unsigned h_px,
                    struct error *err);

/* Adds the polygons of a mover, in its own coordinates; its number is 1 or more. reference_pose() places them, before a
 * frame is drawn. */
bool reference_add(struct reference *reference, const struct mesh *mesh, size_t mover, struct error *err);
void reference_pose(struct reference *reference, size_t mover, const struct model_pose *pose);

/* Moves a mover's corners in its own coordinates, before it is placed. */
void reference_bend(struct reference *reference, size_t mover, void (*bend)(double at_m[3], double how), double how);

/* The same from a model file: imported, turned, read once more by the reference's own reader (source.h), and cleaned as
 * mesh_clean_fine() does. */
bool reference_read(struct reference *reference, const char *model_path, const struct orientation *orientation,
                    const struct grid *grid, unsigned w_px, unsigned h_px, struct error *err);

/* Draws into faces and depths_m. Pixel (0, 0) is the top left one; its centre lies at
 * x = -tan_x * (1 - 1 / w_px), y = tan_y * (1 - 1 / h_px) on the plane at distance 1. */
void reference_draw(struct reference *reference, const struct viewpoint *viewpoint, const struct lens *lens);

/* The same with all rays shifted within their pixels: right and down, less than half a pixel. */
void reference_draw_shifted(struct reference *reference, const struct viewpoint *viewpoint, const struct lens *lens,
                            const double shift_px[2]);

/* Where the ray through a pixel's centre ended in the last frame drawn, metres; only where a face is seen. */
void reference_point(const struct reference *reference, size_t pixel, double out_m[3]);

/* The least depth of a group's planes within a pixel of a pixel's centre in the last frame drawn, held within the
 * depths of the group's own corners: seen edge-on a plane alone could be anywhere. `groups` as in compare.h. */
double reference_depth_of(const struct reference *reference, const uint32_t *groups, uint32_t group, size_t pixel);

/* Whether a face of a group (`groups` as in compare.h) is to be seen anywhere within a pixel of a
 * pixel's centre in the last frame drawn, on a lattice of 1/64 pixels: finer than what the pixels around
 * it tell. Slow: for the few pixels that are worth it. */
bool reference_sees_nearby(const struct reference *reference, const uint32_t *groups, uint32_t group, size_t pixel);

void reference_free(struct reference *reference);

#endif
