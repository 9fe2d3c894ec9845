/* SPDX-License-Identifier: MIT
 *
 * What holds a scene in which nothing stands still: objects move in one, and it gives them their grid. */
#ifndef SIM_MOVING_FRAME_H
#define SIM_MOVING_FRAME_H

#include "model/model.h"

/* Where every face moves, adds two that do not, at opposite ends of the box that all goes through: below, seen from
 * below alone, and above, seen from above. They have the background's colour and are 1/1024 as long as the box, a
 * quarter of a pixel where 240 show all of it. A notice says so. */
void moving_frame_add(struct model *model, uint16_t background_rgb565);

#endif
