/* SPDX-License-Identifier: MIT
 *
 * Instructions by counter, fitted by `sh sim/tools/fit_frame_cost.sh`, which prints the rows below: `limner measure
 * --core m0plus --precision fast` counts stages on rooms, rooms-tilted, teapot and knot, each with four trees, and with
 * one on a small screen, and of a teapot cut to pieces, by both orders; the counters of the same frames that have to do
 * with a stage explain it by least squares, in relative errors and with no factor below 0, the worst errors weighing
 * most. Meshes are counted on the teapot, the knot and meshes of generate_scale, by random cameras, too. The fit of
 * these scenes left hardly anything to a line of the screen, so that convex solids were predicted a third too low.
 * NEAREST_FIRST and SCANLINE are what a search found from there, with two of these beside: least greatest errors, a
 * line of the screen 150 or more. They are off by 4 % at most at 240x240 pixels, by 4.2 at 128x64. MESH and MESH_DEPTH
 * were found likewise, on the teapot, the knot, an icosahedron, a closed mesh of 3,648 triangles, the spider and Wuson
 * from their own cameras and from random ones, and on fels.3ds of assimp's models from random ones: off by 4 % and 6 %
 * at most there, by 4 on WusonBlitz.b3d, which had no part in it, by 22 and 29 on Wuson.ply, many of whose triangles
 * are slivers: lines without pixels are not counted. What a polygon of a mesh leaf costs is about the mean of what four
 * rooms of dense things tell, 60 to 390: it is not fitted. */
#include "render/frame_cost.h"

#include <string.h>

struct frame_cost {
    double node, record, box, vertex, polygon, clipped, seen, line, gap, screen_line, pixel;
    double crossing; /* a polygon that is seen, for each that crosses a line: it finds its place between these */
    double deep;     /* a pixel at which depths are compared */
    double leaf;     /* a polygon of a mesh leaf, whether it faces the eye or not */
};

static const struct frame_cost NEAREST_FIRST = {.node = 70,
                                                .record = 0,
                                                .box = 225,
                                                .vertex = 185,
                                                .polygon = 389,
                                                .clipped = 2335,
                                                .seen = 767,
                                                .line = 96.6,
                                                .gap = 122,
                                                .screen_line = 200,
                                                .pixel = 0.05,
                                                .crossing = 18.04,
                                                .leaf = 220};
static const struct frame_cost SCANLINE = {.node = 70,
                                           .record = 0,
                                           .box = 164,
                                           .vertex = 185,
                                           .polygon = 328,
                                           .clipped = 2157,
                                           .seen = 232,
                                           .line = 65.7,
                                           .gap = 0,
                                           .screen_line = 198,
                                           .pixel = 0.06,
                                           .crossing = 0.45,
                                           .leaf = 220};

static const struct frame_cost MESH = {.node = 0,
                                       .record = 67,
                                       .box = 0,
                                       .vertex = 291,
                                       .polygon = 60,
                                       .clipped = 13550,
                                       .seen = 0,
                                       .line = 62,
                                       .gap = 0,
                                       .screen_line = 216,
                                       .pixel = 0.2,
                                       .crossing = 0.13};

static const struct frame_cost MESH_DEPTH = {.node = 0,
                                             .record = 20,
                                             .box = 0,
                                             .vertex = 382,
                                             .polygon = 60,
                                             .clipped = 12000,
                                             .seen = 0,
                                             .line = 74,
                                             .gap = 0,
                                             .screen_line = 210,
                                             .pixel = 0.2,
                                             .crossing = 0,
                                             .deep = 12.4};

static const struct frame_cost *cost_of(enum lim_method method)
{
    switch (method) {
    case LIM_NEAREST_FIRST:
        return &NEAREST_FIRST;
    case LIM_SCANLINE:
        return &SCANLINE;
    case LIM_MESH:
        return &MESH;
    case LIM_MESH_DEPTH:
        return &MESH_DEPTH;
    default:
        return NULL;
    }
}

bool frame_cost_knows(enum lim_method method)
{
    return cost_of(method) != NULL;
}

void frame_cost_terms(const struct lim_stats *stats, const struct lim_target *target,
                      struct frame_cost_term terms[FRAME_COST_TERMS])
{
    const struct frame_cost *known = cost_of(target->method), *a = known ? known : &NEAREST_FIRST;
    const struct frame_cost_term all[FRAME_COST_TERMS] = {
        {"nodes of the tree visited", stats->nodes, a->node},
        {"records of leaves tested", stats->records - stats->leaf_records, a->record},
        {"bounds of subtrees tested", stats->boxes, a->box},
        {"vertices transformed", stats->vertices, a->vertex},
        {"polygons reached", stats->polygons, a->polygon},
        {"polygons clipped", stats->clipped, a->clipped},
        {"polygons seen", stats->polygons_seen, a->seen},
        {"lines of polygons", stats->lines, a->line},
        {"gaps, at most at a time", stats->gaps_max, a->gap},
        {"lines of the screen", target->h_px, a->screen_line},
        {"pixels written", (double)stats->pixels_painted + stats->pixels_background, a->pixel},
        {"polygons on lines, in order", stats->polygons_seen * (double)stats->lines / target->h_px, a->crossing},
        {"pixels of which depths are compared", stats->pixels_deep, a->deep},
        {"polygons of mesh leaves", stats->leaf_records, a->leaf}};

    memcpy(terms, all, sizeof all);
}

double frame_cost_m0plus(const struct lim_stats *stats, const struct lim_target *target)
{
    struct frame_cost_term terms[FRAME_COST_TERMS];
    double sum = 0.0;

    frame_cost_terms(stats, target, terms);
    for (int i = 0; i < FRAME_COST_TERMS; i++)
        sum += terms[i].count * terms[i].each;
    return sum;
}

/* Of the order of what stages cost that no scene of the fit has: good for telling more from less, and for nothing else.
 */
double frame_cost_work(const struct lim_stats *stats, const struct lim_target *target)
{
    static const double division = 260.0, texel = 12.0, comparison = 60.0, split = 2000.0, line_comparison = 150.0;
    const double texels = stats->divisions ? stats->pixels_painted : 0.0;

    return frame_cost_m0plus(stats, target) + division * stats->divisions + texel * texels +
           comparison * stats->newell.comparisons + split * stats->newell.splits +
           line_comparison * stats->movers.comparisons;
}

static double cost_of_textures(const struct lim_stats *stats, const struct lim_target *target)
{
    static const double PIXEL = 13, DIVISION = 290, LINE = 95, POLYGON = 1550;
    static const double MESH_PIXEL = 11, MESH_LINE = 60, MESH_POLYGON = 600;

    if (target->method == LIM_MESH || target->method == LIM_MESH_DEPTH)
        return MESH_PIXEL * stats->pixels_painted + DIVISION * stats->divisions + MESH_LINE * stats->lines +
               MESH_POLYGON * stats->polygons;
    return PIXEL * stats->pixels_painted + DIVISION * stats->divisions + LINE * stats->lines +
           POLYGON * stats->polygons_seen;
}

double frame_cost_of_mesh_vertices_m0plus(size_t vertices)
{
    return MESH.vertex * (double)vertices;
}

double frame_cost_of_scene_m0plus(const struct lim_stats *stats, const struct lim_target *target,
                                  const struct lim_scene *scene)
{
    return frame_cost_m0plus(stats, target) + (lim_texture_count(scene) ? cost_of_textures(stats, target) : 0.0);
}

bool frame_cost_is_known(const struct lim_scene *scene)
{
    return !scene->limits.layers;
}
