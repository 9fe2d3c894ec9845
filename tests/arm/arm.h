/* SPDX-License-Identifier: MIT
 *
 * What a test image for Cortex-M may call beside the code that it tests. */
#ifndef TESTS_ARM_H
#define TESTS_ARM_H

/* Prints on the console of the host that runs the image. */
void arm_put(const char *text);

#endif
