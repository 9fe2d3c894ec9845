/* SPDX-License-Identifier: MIT
 *
 * From a point in view space to its place on the screen, a coordinate at a time. */
#ifndef LIM_PLACE_H
#define LIM_PLACE_H

#include "view/perspective.h"

/* Where a coordinate lies on the screen, of a point at that depth. */
static inline lim_sub project_x(const struct lim_view *view, int32_t x_qv, struct lim_depth depth)
{
    if (LIM_HAS_TELE) perspective_zoom(&x_qv, &depth, view->rows.zoom_bits[0]);
    return perspective_at(x_qv, depth, &view->width);
}

static inline lim_sub project_y(const struct lim_view *view, int32_t y_qv, struct lim_depth depth)
{
    if (LIM_HAS_TELE) perspective_zoom(&y_qv, &depth, view->rows.zoom_bits[1]);
    return perspective_at(y_qv, depth, &view->height);
}

/* Where the rounding of a projection can carry a point from beyond the last pixels onto them, they have to
 * be left out by a margin. With sub-pixels the last half pixel is margin enough. */
static inline int32_t margin_of(int32_t z_qv)
{
    return LIM_SUB_BITS || z_qv < 0 ? 0 : z_qv >> LIM_DRAFT_MARGIN_BITS;
}

#endif
