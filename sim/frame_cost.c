/* SPDX-License-Identifier: MIT
 *
 * Instructions by counter: those of a node, a box, a record, a vertex and a clipped polygon are a stage's count divided
 * by its events; the others, where stages share the work, are a least-squares fit. Both from `limner measure --core
 * m0plus --precision fast` of rooms, rooms-tilted, teapot and knot, each with four trees. */
#include "frame_cost.h"

double frame_cost_m0plus(const struct lim_stats *stats, unsigned w_px, unsigned h_px)
{
    enum {
        A_NODE = 100,
        A_BOX = 240,
        A_RECORD = 60,
        A_VERTEX = 300,
        A_CLIPPED = 4100,
        A_POLYGON = 325,
        A_SEEN = 2670,
        A_LINE = 182,
        A_GAP = 150,
        A_SCREEN_LINE = 770
    };
    const double a_pixel = 1.6;

    return A_NODE * (double)stats->nodes + A_BOX * (double)stats->boxes + A_RECORD * (double)stats->records +
           A_VERTEX * (double)stats->vertices + A_CLIPPED * (double)stats->clipped +
           A_POLYGON * (double)stats->polygons + A_SEEN * (double)stats->polygons_seen + A_LINE * (double)stats->lines +
           A_GAP * (double)stats->gaps_max + A_SCREEN_LINE * (double)h_px + a_pixel * (double)w_px * (double)h_px;
}

bool frame_cost_is_known(const struct lim_scene *scene)
{
    return !scene->limits.layers && !scene->texture_count;
}
