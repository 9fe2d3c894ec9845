/* SPDX-License-Identifier: MIT
 *
 * Colours for a panel of black and white pixels, which shows a colour as a share of white pixels: its brightness alone
 * counts, and what is darker than a third can hardly be told from the black round it. */
#ifndef SIM_MONO_TONES_H
#define SIM_MONO_TONES_H

#include "model/model.h"

/* Makes the colours of all faces and pictures grey, in place. What a twentieth of the model's area exceeds becomes
 * white, black becomes a third of it. */
void mono_tones(struct model *model);

#endif
