/* SPDX-License-Identifier: MIT
 *
 * From the environment: tests take no arguments. */
#include "effort.h"

#include <stdint.h>
#include <stdlib.h>

int effort(int whole)
{
    const char *text = getenv("TEST_EFFORT");
    const long percent = text ? strtol(text, NULL, 10) : 100;

    if (percent < 1 || percent >= 100) return whole;
    const int part = (int)((int64_t)whole * percent / 100);
    return part ? part : 1;
}
