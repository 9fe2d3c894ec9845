/* SPDX-License-Identifier: MIT
 *
 * Every fixed-point helper at its limits, as text: one line a call, one line with a hash for each
 * series of pseudo-random calls. Needs no library, so that the same source runs on the host and on
 * bare Cortex-M, where the text must be equal. */
#ifndef TESTS_FIXED_VECTORS_H
#define TESTS_FIXED_VECTORS_H

/* `put` receives lines without newline. Returns how many calls did not give the expected value. */
int fixed_vectors_run(void (*put)(const char *line));

#endif
