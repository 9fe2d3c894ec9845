/* SPDX-License-Identifier: MIT
 *
 * Instructions by counter, fitted by `sh sim/tools/fit_frame_cost.sh`, which prints the rows below: `limner measure
 * --core m0plus --precision fast` counts stages on rooms, rooms-tilted, teapot and knot, each with four trees, and with
 * one on a small screen, and of a teapot cut to pieces, by both orders; the counters of the same frames that have to do
 * with a stage explain it by least squares, in relative errors and with no factor below 0. */
#include "render/frame_cost.h"

struct frame_cost {
    double node, record, box, vertex, polygon, clipped, seen, line, gap, screen_line, pixel;
    double crossing; /* a polygon that is seen, for each that crosses a line: it finds its place between these */
};

static const struct frame_cost NEAREST_FIRST = {.node = 78,
                                                .record = 0,
                                                .box = 229,
                                                .vertex = 167,
                                                .polygon = 20,
                                                .clipped = 2278,
                                                .seen = 1354,
                                                .line = 92,
                                                .gap = 167,
                                                .screen_line = 229,
                                                .pixel = 0.54,
                                                .crossing = 80.28};
static const struct frame_cost SCANLINE = {.node = 77,
                                           .record = 0,
                                           .box = 138,
                                           .vertex = 149,
                                           .polygon = 298,
                                           .clipped = 2120,
                                           .seen = 283,
                                           .line = 82,
                                           .gap = 0,
                                           .screen_line = 127,
                                           .pixel = 0.00,
                                           .crossing = 0.70};

bool frame_cost_knows(enum lim_method method)
{
    return method == LIM_NEAREST_FIRST || method == LIM_SCANLINE;
}

double frame_cost_m0plus(const struct lim_stats *stats, const struct lim_target *target)
{
    const struct frame_cost *a = target->method == LIM_SCANLINE ? &SCANLINE : &NEAREST_FIRST;

    return a->node * stats->nodes + a->record * stats->records + a->box * stats->boxes + a->vertex * stats->vertices +
           a->polygon * stats->polygons + a->clipped * stats->clipped + a->seen * stats->polygons_seen +
           a->line * stats->lines + a->gap * stats->gaps_max + a->screen_line * target->h_px +
           a->pixel * ((double)stats->pixels_painted + stats->pixels_background) +
           a->crossing * stats->polygons_seen * stats->lines / target->h_px;
}

double frame_cost_textures_m0plus(const struct lim_stats *stats)
{
    static const double PIXEL = 13, DIVISION = 170, LINE = 95, POLYGON = 1550;

    return PIXEL * stats->pixels_painted + DIVISION * stats->divisions + LINE * stats->lines +
           POLYGON * stats->polygons_seen;
}

bool frame_cost_is_known(const struct lim_scene *scene)
{
    return !scene->limits.layers;
}
