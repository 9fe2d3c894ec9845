/* SPDX-License-Identifier: MIT
 *
 * A face has one colour: the mean of its corners' colours, and whether these are the same for the eye. */
#ifndef SIM_MEAN_COLOUR_H
#define SIM_MEAN_COLOUR_H

#include <stdbool.h>
#include <stddef.h>

/* Of nothing, if it is all zeros. Channels are red, green, blue and opacity. */
struct mean_colour {
    double sum[4], least[4], most[4];
    size_t count;
};

void mean_colour_add(struct mean_colour *mean, const double rgba[4]);

/* Of a channel; 1 if there is nothing to take the mean of. */
double mean_colour_of(const struct mean_colour *mean, int channel);

/* How far apart the most different two values of a channel are: red, green or blue. */
double mean_colour_spread(const struct mean_colour *mean);

/* A spread, in parts of the whole range, that a display of 8 bits a channel shows. */
bool mean_colour_varies(double spread);

#endif
