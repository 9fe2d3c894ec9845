/* SPDX-License-Identifier: MIT
 *
 * How the rooms of the demo scene are furnished. */
#ifndef DEMO_ROOMS_H
#define DEMO_ROOMS_H

#include "demo_soup.h"

void rooms_furnish(struct soup *soup);

#endif
