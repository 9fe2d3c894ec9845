/* SPDX-License-Identifier: MIT
 *
 * Pictures of a display that somebody else emulates, perhaps enlarged: each pixel a square of one colour. */
#ifndef SIM_ENLARGED_H
#define SIM_ENLARGED_H

#include "pictures/image.h"

/* The hash of the display's pixels, as hashes.h has it; `side` of a square, in the picture's pixels. An error, which
 * names the path: the picture is not made of whole squares of one colour. */
bool enlarged_hash(gdImagePtr image, int side, const char *path, uint64_t *hash, struct error *err);

#endif
