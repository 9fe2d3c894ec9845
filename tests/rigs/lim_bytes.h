/* SPDX-License-Identifier: MIT
 *
 * A scene's file as bytes, to be damaged and read again. What fails ends the test. */
#ifndef TESTS_LIM_BYTES_H
#define TESTS_LIM_BYTES_H

#include "scene/compiled.h"

/* Writes the scene to `path` and reads the file: scene->image_b bytes, the caller's to free. */
unsigned char *lim_bytes_of(const struct compiled *scene, const char *path);

/* Gives them the checksum that they should have. */
void lim_bytes_sign(unsigned char *bytes, size_t count);

/* Writes them to `path` as they are. */
void lim_bytes_write(const unsigned char *bytes, size_t count, const char *path);

#endif
