/* SPDX-License-Identifier: MIT
 *
 * The two orders in which a frame can be drawn. Both start from a camera that lim_view_begin() and
 * lim_eye_set() have taken in, and both return 0, an enum lim_error, or the target's error. */
#ifndef LIM_ORDER_H
#define LIM_ORDER_H

#include "limner.h"

/* Nearest first, without a framebuffer: nearest.c. */
LIM_MUST_CHECK int lim_nearest_frame(struct lim *lim);

/* Back to front, into one: painter.c. */
LIM_MUST_CHECK int lim_painter_frame(struct lim *lim);

#endif
