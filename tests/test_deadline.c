/* SPDX-License-Identifier: MIT
 *
 * The time that a command may take, by a clock that the test turns. */
#include "deadline.h"

#include "cmocka_all.h"
