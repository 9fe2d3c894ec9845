/* SPDX-License-Identifier: MIT
 *
 * How much of a long test is run: all of it, unless TEST_EFFORT names a percentage. Slow instruments (the
 * sanitizers) ask for less; what a test promises of each frame it promises all the same. */
#ifndef TESTS_EFFORT_H
#define TESTS_EFFORT_H

/* `whole` frames, scenes or pixels, or the part that is asked for; never 0. */
int effort(int whole);

#endif
