/* SPDX-License-Identifier: MIT
 *
 * Stands in for start.c where a test image's main() is built for the host. */
#include "arm.h"

#include <stdio.h>

void arm_put(const char *text)
{
    fputs(text, stdout);
}
