/* SPDX-License-Identifier: MIT
 *
 * Frames as numbered PNG files, among a command's outputs. */
#ifndef SIM_FRAME_FILE_H
#define SIM_FRAME_FILE_H

#include "outputs/outputs.h"
#include "pictures/image.h"

/* A film of one frame into a file. */
bool frame_file_put(const struct film *frame, const char *path, struct outputs *outputs, struct error *err);

/* A film of one frame into the file that the pattern (outputs.h) gives that number. */
bool frame_file_write(const struct film *frame, const char *pattern, size_t number, struct outputs *outputs,
                      struct error *err);

#endif
