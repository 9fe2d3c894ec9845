/* SPDX-License-Identifier: MIT
 *
 * What is one thing and does not hang together: eyes in a head, legs at a body. Planes between such parts would split
 * both. */
#ifndef SIM_PARTS_GATHER_H
#define SIM_PARTS_GATHER_H

#include "trees/parts_survey.h"

/* Joins parts whose boxes overlap: a sixteenth of the smaller one's lies in the other, which is smaller than half the
 * model. Not where a polygon would be too large for what comes of it. */
void parts_gather(struct survey *surveys, uint32_t *leaders, size_t polygon_count);

#endif
