/* SPDX-License-Identifier: MIT
 *
 * The renderer's state: a stage a member, in the order in which data passes them. Complete here so
 * that callers can place it; its members are private. */
#ifndef LIM_STATE_H
#define LIM_STATE_H

#include "cull.h"
#include "eye.h"
#include "paint.h"
#include "retain.h"
#include "span.h"
#include "stats.h"
#include "target.h"
#include "view.h"
#include "walk.h"

struct lim {
    const struct lim_scene *scene;
    struct lim_target target;
    struct eye eye;
    struct cull cull;
    struct walk walk;
    struct walk_pending *stack;
    struct view view;
    struct spans spans;
    struct retained retained;
    struct paint paint;
    struct lim_stats stats;
};

#endif
