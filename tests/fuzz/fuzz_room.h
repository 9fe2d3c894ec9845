/* SPDX-License-Identifier: MIT
 *
 * A small closed room with solids in it, compiled once: a true scene for the fuzz targets' cameras. */
#ifndef TESTS_FUZZ_ROOM_H
#define TESTS_FUZZ_ROOM_H

#include "scene/compiled.h"

const struct compiled *fuzz_room(void);

#endif
