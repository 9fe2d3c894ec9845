/* SPDX-License-Identifier: MIT
 *
 * What a screen does instead of waiting for its port. */
#ifndef BOARDS_SCREEN_WORK_H
#define BOARDS_SCREEN_WORK_H

#include <stdbool.h>

/* Does a little, which needs nothing of the screen, and returns whether there is more. */
typedef bool screen_work(void *ctx);

#endif
