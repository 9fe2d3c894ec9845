/* SPDX-License-Identifier: MIT
 *
 * Hashes of frames, to tell in a script whether any pixel changed. A hash file is text, a line a
 * frame: its number from 0 and the hash in hexadecimal. */
#ifndef SIM_HASHES_H
#define SIM_HASHES_H

#include "base/error.h"

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* FNV-1a, 64 bits, over RGB565 pixels as the bus has them: the byte with the red bits first.
 * http://www.isthe.com/chongo/tech/comp/fnv/ */
uint64_t hash_pixels(const uint16_t *pixels, size_t count);

bool hashes_write(const uint64_t *hashes, size_t count, FILE *file);

/* Compares with a hash file; the error names the first frame that differs. */
bool hashes_check(const uint64_t *hashes, size_t count, const char *path, struct error *err);

/* The same with frames of what is shown for ever, seen from anywhere on: the first may be any of the file's, which goes
 * round. */
bool hashes_check_loop(const uint64_t *hashes, size_t count, const char *path, struct error *err);

#endif
