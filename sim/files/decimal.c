/* SPDX-License-Identifier: MIT
 *
 * strtod() rounds correctly, but takes more than decimals. The program never calls setlocale(), so its decimal point
 * is a point. */
#include "files/decimal.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

static const double LEAST = 1.401298464324817e-45; /* the smallest float32 above 0 */

static size_t digits(const char *text, size_t length, size_t *at)
{
    const size_t first = *at;
    while (*at < length && text[*at] >= '0' && text[*at] <= '9')
        ++*at;
    return *at - first;
}

static void sign(const char *text, size_t length, size_t *at)
{
    if (*at < length && (text[*at] == '-' || text[*at] == '+')) ++*at;
}

static bool is_decimal(const char *text, size_t length)
{
    size_t at = 0, count;
    sign(text, length, &at);
    count = digits(text, length, &at);
    if (at < length && text[at] == '.') {
        at++;
        count += digits(text, length, &at);
    }
    if (!count) return false;
    if (at < length && (text[at] == 'e' || text[at] == 'E')) {
        at++;
        sign(text, length, &at);
        if (!digits(text, length, &at)) return false;
    }
    return at == length;
}

bool decimal_parse(const char *text, size_t length, double *value)
{
    if (!is_decimal(text, length)) return false;
    *value = strtod(text, NULL);
    if (fabs(*value) < LEAST) *value = 0;
    return fabs(*value) <= (double)FLT_MAX;
}
