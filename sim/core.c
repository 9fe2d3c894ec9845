/* SPDX-License-Identifier: MIT
 *
 * Compiled once for each profile, together with the renderer's sources; CORE is the table's name. */
#include "core.h"

#ifndef CORE
#error "CORE and LIM_PROFILE are set by the Makefile"
#endif

#define QUOTE(text) #text
#define PROFILE_NAME(core) (&QUOTE(core)[sizeof "core_" - 1])

static int init(void *lim, const struct lim_scene *scene, const struct lim_target *target, void *mem, size_t mem_b)
{
    return lim_init(lim, scene, target, mem, mem_b);
}

static int frame(void *lim, const struct lim_camera *camera)
{
    return lim_frame(lim, camera);
}

static const struct lim_stats *stats(const void *lim)
{
    return lim_stats(lim);
}

const struct core CORE = {PROFILE_NAME(CORE), sizeof(struct lim), lim_mem_b, init, frame, stats};
