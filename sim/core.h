/* SPDX-License-Identifier: MIT
 *
 * The renderer in each of its precision profiles. Target firmware has one; the host has all, each
 * built from the same sources and reached through such a table. */
#ifndef SIM_CORE_H
#define SIM_CORE_H

#include "limner.h"

struct core {
    const char *name;
    size_t lim_b; /* of the state, struct lim in its own build */
    size_t (*mem_b)(const struct lim_scene *scene, const struct lim_target *target);
    /* lim_init(), lim_frame() and lim_stats(); `lim` is lim_b bytes of the caller's. */
    int (*init)(void *lim, const struct lim_scene *scene, const struct lim_target *target, void *mem, size_t mem_b);
    int (*frame)(void *lim, const struct lim_camera *camera);
    const struct lim_stats *(*stats)(const void *lim);
};

extern const struct core core_fast, core_fine;

/* By name, or NULL. */
const struct core *core_find(const char *name);

#endif
