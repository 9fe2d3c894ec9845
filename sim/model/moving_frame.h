/* SPDX-License-Identifier: MIT
 *
 * What makes a scene wide enough for what moves: objects move in what stands still, which gives them their grid. */
#ifndef SIM_MOVING_FRAME_H
#define SIM_MOVING_FRAME_H

#include "model/model.h"

/* Where nothing stands still, or something moves beyond what firmware draws around that, or is larger, adds two faces
 * that do not move, at opposite ends of the box that all goes through: below, seen from below alone, and above, seen
 * from above. They have the background's colour and are 1/8192 as long as the box: where 1000 pixels show all of it, an
 * eighth of one. Not where the box would be more than 16 times wider than what stands still: that is refused later. */
void moving_frame_add(struct model *model, uint16_t background_rgb565);

#endif
