/* SPDX-License-Identifier: MIT
 *
 * How many pixels a PNG, JPEG, GIF or BMP file says that it has, read from its header before a library decodes it: a
 * few kilobytes may ask for gigabytes. */
#ifndef SIM_PICTURE_SIZE_H
#define SIM_PICTURE_SIZE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Of any picture that is decoded: 64 MB as its library holds it. */
enum { PICTURE_MOST_PX = 1 << 24 };

/* Whether it begins as a TGA does, which has no magic. */
bool picture_is_tga(const void *picture, size_t size_b);

/* false: there is no size where one must be. */
bool picture_size(const void *bytes, size_t size_b, uint32_t *w_px, uint32_t *h_px);

/* Whether a picture of that size may be decoded; if not, `reason` says why. */
bool picture_size_check(const void *bytes, size_t size_b, char *reason, size_t reason_b);

#endif
