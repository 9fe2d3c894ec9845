/* SPDX-License-Identifier: MIT
 *
 * The best that portals could show: for each camera the polygons that its picture shows. No visible set is smaller, as
 * a set holds what is seen from a whole room in all directions. */
#ifndef SIM_PORTAL_BEST_H
#define SIM_PORTAL_BEST_H

#include "portals/set_boxes.h"
#include "render/ids.h"

struct portal_best {
    struct lim_scene scene; /* a copy that has one place, everywhere, with the set of the last camera */
    struct lim_place place;
    const struct compiled *compiled;
    struct ids ids;
    struct boxes boxes;
    lim_index *box_of_record; /* by ordinal */
    uint8_t *bits, *packed;   /* the set */
};

/* Of a scene that pvs_may_be(). It must outlive this, and *best stay where it is. */
bool portal_best_init(struct portal_best *best, const struct compiled *scene, const struct simulator_setup *setup,
                      struct error *err);

/* best->scene shows what this camera sees from here on. */
bool portal_best_see(struct portal_best *best, const struct lim_camera *camera, struct error *err);
void portal_best_free(struct portal_best *best);

#endif
