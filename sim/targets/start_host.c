/* SPDX-License-Identifier: MIT
 *
 * Stands in for the start-up code where a target has an operating system. */
#include "console.h"

#include <stdio.h>

void console_put(const char *text)
{
    fputs(text, stdout);
    fflush(stdout); /* a program that a signal ends has said it */
}
