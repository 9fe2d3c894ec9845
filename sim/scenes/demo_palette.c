/* SPDX-License-Identifier: MIT
 *
 * Median cut (Heckbert): the box of colours that is widest in one channel is halved at its middle
 * value until there are as many boxes as the palette may hold. Each box becomes the mean of its
 * colours, rounded to the levels of a 5-6-5 bit panel. */
#include "demo_palette.h"

#include <stdlib.h>

enum { PALETTE = 320 };

/* The colours of a few polygons, and their extent in each channel. */
struct shades {
    int lo[3], hi[3];
    size_t count;
};

static int channel(uint32_t colour, int i)
{
    return (int)(colour >> (16 - 8 * i) & 255);
}

static void shades_add(struct shades *group, uint32_t colour)
{
    for (int i = 0; i < 3; i++) {
        int c = channel(colour, i);
        group->lo[i] = group->count && group->lo[i] < c ? group->lo[i] : c;
        group->hi[i] = group->count && group->hi[i] > c ? group->hi[i] : c;
    }
    group->count++;
}

static int shades_widest(const struct shades *group)
{
    int widest = 0;
    for (int i = 1; i < 3; i++)
        if (group->hi[i] - group->lo[i] > group->hi[widest] - group->lo[widest]) widest = i;
    return widest;
}

static int shades_width(const struct shades *group)
{
    int widest = shades_widest(group);
    return group->hi[widest] - group->lo[widest];
}

/* Moves the polygons in the upper half of the box to a new one. */
static void shades_halve(struct shades *groups, int lower, int upper, const struct soup *soup, int *group_of)
{
    int axis = shades_widest(&groups[lower]), middle = (groups[lower].lo[axis] + groups[lower].hi[axis]) / 2;
    groups[lower] = groups[upper] = (struct shades){.count = 0};
    for (size_t i = 0; i < soup->count; i++) {
        if (group_of[i] != lower) continue;
        if (channel(soup->polygons[i].colour, axis) > middle) group_of[i] = upper;
        shades_add(&groups[group_of[i]], soup->polygons[i].colour);
    }
}

static void split_all(struct shades *groups, const struct soup *soup, int *group_of)
{
    int count = 1;
    for (size_t i = 0; i < soup->count; i++)
        shades_add(&groups[0], soup->polygons[i].colour);
    while (count < PALETTE) {
        int worst = 0;
        for (int i = 1; i < count; i++)
            if (shades_width(&groups[i]) > shades_width(&groups[worst])) worst = i;
        if (shades_width(&groups[worst]) == 0) break;
        shades_halve(groups, worst, count, soup, group_of);
        count++;
    }
}

/* To the nearest level of so many bits, and back to 8 bits as a panel widens it. */
static uint32_t round_channel(double value, int bits)
{
    uint32_t level = (uint32_t)(value * ((1 << bits) - 1) / 255 + 0.5);
    return level << (8 - bits) | level >> (2 * bits - 8);
}

void palette_reduce(struct soup *soup)
{
    struct shades groups[PALETTE] = {{.count = 0}};
    double sum[PALETTE][3] = {{0}};
    int *group_of = demo_realloc(NULL, soup->count * sizeof *group_of);
    for (size_t i = 0; i < soup->count; i++)
        group_of[i] = 0;
    split_all(groups, soup, group_of);
    for (size_t i = 0; i < soup->count; i++)
        for (int c = 0; c < 3; c++)
            sum[group_of[i]][c] += channel(soup->polygons[i].colour, c);
    for (size_t i = 0; i < soup->count; i++) {
        const double *group_sum = sum[group_of[i]];
        double count = (double)groups[group_of[i]].count;
        soup->polygons[i].colour = round_channel(group_sum[0] / count, 5) << 16 |
                                   round_channel(group_sum[1] / count, 6) << 8 | round_channel(group_sum[2] / count, 5);
    }
    free(group_of);
}
