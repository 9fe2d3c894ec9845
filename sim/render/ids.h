/* SPDX-License-Identifier: MIT
 *
 * Which face each pixel shows: the same firmware renders a copy of the scene whose colours are
 * the polygons' numbers, so the answer is the renderer's own and not a model of it. */
#ifndef SIM_IDS_H
#define SIM_IDS_H

#include "render/simulator.h"
#include "scene/moving.h"

struct ids {
    struct simulator simulator; /* into plain memory */
    struct lim_scene scene;     /* the copy */
    lim_index *polygons;        /* its records, colour = number: ordinal + 1 */
    uint32_t *face_of_colour;   /* colours + 1 entries; [0] is the background, 0 */
    size_t colours;             /* records in all */
    /* With movers: copies of the objects, numbered on, and of the instances. */
    const struct moving *moving;
    struct lim_scene *objects;
    lim_index **object_polygons;
    struct lim_instance *instances;
    uint32_t *numbers; /* the last frame: of records, 0 = background */
    uint32_t *faces;   /* the last frame: w_px * h_px face numbers, 0 = background */
};

/* Drawn as `setup` says, but always into plain memory. */
bool ids_init(struct ids *ids, const struct compiled *scene, const struct simulator_setup *setup, struct error *err);
/* The objects too. They are drawn where moving->instances has them. */
bool ids_set_movers(struct ids *ids, const struct moving *moving, struct error *err);
bool ids_frame(struct ids *ids, const struct lim_camera *camera, struct error *err);

/* Appends the last frame to a file: uint32 little-endian a pixel. */
bool ids_write(const struct ids *ids, FILE *file);

void ids_free(struct ids *ids);

#endif
