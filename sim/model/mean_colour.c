/* SPDX-License-Identifier: MIT */
#include "model/mean_colour.h"

#include <math.h>

enum { COLOURS = 3, CHANNELS = 4 };
static const double SHOWN = 1.5 / 255; /* two steps of a byte: one may be rounding */

void mean_colour_add(struct mean_colour *mean, const double rgba[4])
{
    for (int i = 0; i < CHANNELS; i++) {
        mean->least[i] = mean->count ? fmin(mean->least[i], rgba[i]) : rgba[i];
        mean->most[i] = mean->count ? fmax(mean->most[i], rgba[i]) : rgba[i];
        mean->sum[i] += rgba[i];
    }
    mean->count++;
}

double mean_colour_of(const struct mean_colour *mean, int channel)
{
    return mean->count ? mean->sum[channel] / (double)mean->count : 1;
}

double mean_colour_spread(const struct mean_colour *mean)
{
    double spread = 0;
    for (int i = 0; i < COLOURS; i++)
        spread = fmax(spread, mean->most[i] - mean->least[i]);
    return spread;
}

bool mean_colour_varies(double spread)
{
    return spread > SHOWN;
}
