/* SPDX-License-Identifier: MIT
 *
 * A loop of known length, so that each run of the counting plugin proves itself: count_check.c. */
#ifndef TARGETS_COUNT_CHECK_H
#define TARGETS_COUNT_CHECK_H

/* count_check_loop() executes two instructions a turn and one to return. */
enum { COUNT_CHECK_TURNS = 54321, COUNT_CHECK_INSTRUCTIONS = 2 * COUNT_CHECK_TURNS + 1 };

#endif
