/* SPDX-License-Identifier: MIT
 *
 * What a renderer must contain to draw a scene, or any of several: the configuration of a firmware
 * (config.h). */
#ifndef SIM_NEEDS_H
#define SIM_NEEDS_H

#include "scene/compiled.h"

#include <stdio.h>

struct moving;

struct needs {
    bool nearest, scanline, convex, painter; /* methods */
    bool depth, newell, mesh, mesh_depth;    /* more of them */
    bool leaves, mesh_leaves;                /* ordered clusters; leaves whose order is by distance */
    bool textures, masked, sky;              /* masked: some have clear texels; sky: some are seen around the eye */
    bool tele;                               /* lenses below LIM_TAN_TELE_Q28 */
    bool portals;                            /* what can be seen from where */
    bool wide;                               /* indices of 32 bits */
    bool cull, slanted, large;               /* what the methods have to do with the scene's boxes and planes */
    bool of_32_bits;                         /* coordinates, of scenes of many scales */
    bool transparent;                        /* polygons with alpha */
    bool wireframe;                          /* to be drawn so */
    bool movers, light;                      /* what moves, and whether it is lit in each frame */
    bool antialias;                          /* with smooth edges */
    bool delta, round, fill;                 /* what changes alone; round glass; targets that keep the picture */
    bool overlay;                            /* what lies over frames */
    bool framebuffer;                        /* targets with all pixels in memory */
    unsigned vertices;                       /* most of any polygon */
    unsigned side_px;                        /* longest of any panel that pools were measured for; 0: none */
    const struct core *core;                 /* precision; NULL: not said */
};

/* `moving`: what moves in it, or NULL. */
struct needs needs_of(const struct compiled *scene, const struct moving *moving);

/* All that either needs. Both have the same precision. */
struct needs needs_union(const struct needs *a, const struct needs *b);

/* Whether what is drawn nearest first is painted as it comes, so that nothing waits for its line:
 * firmware/orders/pools.c. */
bool needs_retain_nothing(const struct needs *needs);

/* The limits that a firmware of these needs makes room for: firmware/orders/pools.c. */
struct lim_limits needs_limits(const struct compiled *scene, const struct needs *needs);

/* The least cells that it takes: one polygon retained, clipped. */
uint16_t needs_least_cells(const struct lim_limits *limits);

/* As macros, each of which a build may define itself. */
void needs_write(const struct needs *needs, FILE *file);

#endif
