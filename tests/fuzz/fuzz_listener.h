/* SPDX-License-Identifier: MIT
 *
 * Text for an emulated display, line by line. */
#ifndef TESTS_FUZZ_LISTENER_H
#define TESTS_FUZZ_LISTENER_H

#include "fuzz.h"
#include "glass/listener.h"

/* Reads a line; false: it is refused, and *err says why. */
typedef bool fuzz_line(struct listener *listener, const char *line, void *ctx, struct error *err);

/* The first line says which module, as options do: `--panel st7789 --size 8x8`. All others go to it, up to the first
 * that is refused or that the chip complains about. Its picture is read after each frame and at the end. The broken
 * promise, or NULL. */
const char *fuzz_listen(struct fuzz_bytes *text, fuzz_line *take, void *ctx);

#endif
