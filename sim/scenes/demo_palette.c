/* SPDX-License-Identifier: MIT
 *
 * First a median cut (Heckbert): the group of colours that is widest in one part is halved at
 * its middle value until there are as many groups as the palette may hold. Then Lloyd's rounds
 * move every colour to the nearest group's mean. Means are rounded to a panel's 5-6-5 bits. */
#include "demo_palette.h"

#include <stdlib.h>

enum { PALETTE = 360, ROUNDS = 12 };

/* Colours that will become one. */
struct group {
    double lo[3], hi[3], mean[3];
    size_t count;
};

struct palette {
    const struct soup *soup;
    struct group groups[PALETTE];
    int count;
    double (*part)[3]; /* of each polygon's colour */
    int *group_of;
};

/* Luma and two colour differences. The differences count double: on a wall a wrong hue strikes
 * the eye more than a wrong brightness. */
static void split_colour(uint32_t colour, double part[3])
{
    double r = colour >> 16, g = colour >> 8 & 255, b = colour & 255;
    part[0] = 0.299 * r + 0.587 * g + 0.114 * b;
    part[1] = 2 * (r - part[0]);
    part[2] = 2 * (b - part[0]);
}

/* To the nearest level of so many bits, and back to 8 bits as a panel widens it. */
static uint32_t round_channel(double value, int bits)
{
    uint32_t level = (uint32_t)(fmin(255, fmax(0, value)) * ((1 << bits) - 1) / 255 + 0.5);
    return level << (8 - bits) | level >> (2 * bits - 8);
}

static uint32_t join_colour(const double part[3])
{
    double r = part[0] + part[1] / 2, b = part[0] + part[2] / 2;
    double g = (part[0] - 0.299 * r - 0.114 * b) / 0.587;
    return round_channel(r, 5) << 16 | round_channel(g, 6) << 8 | round_channel(b, 5);
}

static void measure_groups(struct palette *palette)
{
    for (int i = 0; i < palette->count; i++)
        palette->groups[i] = (struct group){.lo = {999, 999, 999}, .hi = {-999, -999, -999}};
    for (size_t i = 0; i < palette->soup->count; i++) {
        struct group *group = &palette->groups[palette->group_of[i]];
        group->count++;
        for (int j = 0; j < 3; j++) {
            double c = palette->part[i][j];
            if (c < group->lo[j]) group->lo[j] = c;
            if (c > group->hi[j]) group->hi[j] = c;
            group->mean[j] += (c - group->mean[j]) / (double)group->count;
        }
    }
}

static int widest_part(const struct group *group)
{
    int widest = 0;
    for (int i = 1; i < 3; i++)
        if (group->hi[i] - group->lo[i] > group->hi[widest] - group->lo[widest]) widest = i;
    return widest;
}

static double group_width(const struct group *group)
{
    int widest = widest_part(group);
    return group->hi[widest] - group->lo[widest];
}

static int widest_group(const struct palette *palette)
{
    int widest = 0;
    for (int i = 1; i < palette->count; i++)
        if (group_width(&palette->groups[i]) > group_width(&palette->groups[widest])) widest = i;
    return widest;
}

static void median_cut(struct palette *palette)
{
    for (measure_groups(palette); palette->count < PALETTE; measure_groups(palette)) {
        int lower = widest_group(palette), upper = palette->count++;
        int axis = widest_part(&palette->groups[lower]);
        double middle = (palette->groups[lower].lo[axis] + palette->groups[lower].hi[axis]) / 2;
        for (size_t i = 0; i < palette->soup->count; i++)
            if (palette->group_of[i] == lower && palette->part[i][axis] > middle) palette->group_of[i] = upper;
    }
}

static int nearest_group(const struct palette *palette, const double part[3])
{
    int nearest = 0;
    double least = HUGE_VAL;
    for (int i = 0; i < palette->count; i++) {
        double distance = 0;
        for (int j = 0; j < 3; j++) {
            double d = part[j] - palette->groups[i].mean[j];
            distance += d * d;
        }
        if (palette->groups[i].count && distance < least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

void palette_reduce(struct soup *soup)
{
    struct palette palette = {.soup = soup, .count = 1};
    palette.group_of = demo_realloc(NULL, soup->count * sizeof *palette.group_of);
    palette.part = demo_realloc(NULL, soup->count * sizeof *palette.part);
    for (size_t i = 0; i < soup->count; i++) {
        palette.group_of[i] = 0;
        split_colour(soup->polygons[i].colour, palette.part[i]);
    }
    median_cut(&palette);
    for (int round = 0; round < ROUNDS; round++) {
        for (size_t i = 0; i < soup->count; i++)
            palette.group_of[i] = nearest_group(&palette, palette.part[i]);
        measure_groups(&palette);
    }
    for (size_t i = 0; i < soup->count; i++)
        soup->polygons[i].colour = join_colour(palette.groups[palette.group_of[i]].mean);
    free(palette.part);
    free(palette.group_of);
}
