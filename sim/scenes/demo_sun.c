/* SPDX-License-Identifier: MIT
 *
 * Sunlight falls through panes as prisms. Where such a prism meets a surface and the sun indeed
 * gets there, the surface is cut along the prism, so that patches of sun have sharp, true edges
 * although every polygon has only one colour. */
#include "demo_house.h"
#include "demo_joinery.h"
#include "demo_light.h"
#include "demo_rays.h"

static const double far_m = 100;
static const double least_cut_m2 = 0.12; /* smaller surfaces are lit as a whole */

static bool sun_reaches(const struct rays *rays, const struct polygon *polygon)
{
    struct vec3 to_sun = vec_unit(vec_scale(house_sun, -1));
    for (int i = 0; i < 5; i++) {
        static const double at[5][2] = {{0.5, 0.5}, {0.1, 0.3}, {0.9, 0.7}, {0.3, 0.8}, {0.7, 0.2}};
        struct vec3 from = polygon_point(polygon, at[i][0], at[i][1]);
        from = vec_add(from, vec_scale(polygon->normal, 0.001));
        if (!rays_blocked(rays, from, to_sun, far_m)) return true;
    }
    return false;
}

static void cut_by_prism(struct soup *soup, const struct rays *rays, const struct prism *prism)
{
    size_t end = soup->count;
    for (size_t i = 0; i < end; i++) {
        const struct polygon *polygon = &soup->polygons[i];
        if (polygon_area(polygon) < least_cut_m2) continue;
        if (vec_dot(polygon->normal, house_sun) > -1e-3 || materials[polygon->material].emission > 0) continue;
        struct polygon inside = polygon_clip_prism(polygon, prism);
        if (inside.count && polygon_area(&inside) > 4e-4 && sun_reaches(rays, &inside)) soup_cut(soup, i, prism);
    }
}

static void prism_narrow(struct prism *prism, const struct frame *frame, const double x_mm[2], const double y_mm[2],
                         double z_mm)
{
    struct vec3 outline[4] = {frame_point(frame, x_mm[0], y_mm[0], z_mm), frame_point(frame, x_mm[1], y_mm[0], z_mm),
                              frame_point(frame, x_mm[1], y_mm[1], z_mm), frame_point(frame, x_mm[0], y_mm[1], z_mm)};
    struct prism swept = prism_sweep(outline, 4, house_sun);
    for (int i = 0; i < swept.count; i++)
        prism->plane[prism->count++] = swept.plane[i];
}

/* What passes between the bars and then through the wall's inner face. */
static struct prism pane_prism(const struct window *window, int column, int row)
{
    struct prism prism = {.count = 0};
    struct frame frame = window_frame(window);
    double width = window_width_mm(window), height = window_height_mm(window), half = BAR_MM / 2.0;
    double x[2] = {width * column / window->columns - width / 2, width * (column + 1) / window->columns - width / 2};
    double y[2] = {height * row / window->rows, height * (row + 1) / window->rows};
    prism_narrow(&prism, &frame, (const double[2]){-width / 2, width / 2}, (const double[2]){0, height}, WALL_MM);
    if (column) x[0] += half;
    if (column + 1 < window->columns) x[1] -= half;
    if (row) y[0] += half;
    if (row + 1 < window->rows) y[1] -= half;
    prism_narrow(&prism, &frame, x, y, BAR_AT_MM);
    return prism;
}

/* Open towards the sky: bounded only by the edges that cast a shadow. */
static struct prism court_prism(void)
{
    struct prism prism = {.count = 2};
    for (int i = 0; i < prism.count; i++) {
        struct vec3 along = vec_sub(house_court_edges[i][1], house_court_edges[i][0]);
        prism.plane[i] = plane_towards(vec_cross(along, house_sun), house_court_edges[i][0], house_court_lit);
    }
    return prism;
}

void sun_cut(struct soup *soup)
{
    struct soup uncut = {0};
    for (size_t i = 0; i < soup->count; i++)
        soup_add_piece(&uncut, &soup->polygons[i]);
    struct rays rays = rays_build(&uncut);
    for (size_t i = 0; i < house_window_count; i++)
        for (int column = 0; house_windows[i].sunny && column < house_windows[i].columns; column++)
            for (int row = 0; row < house_windows[i].rows; row++) {
                struct prism prism = pane_prism(&house_windows[i], column, row);
                cut_by_prism(soup, &rays, &prism);
            }
    struct prism door = prism_sweep(house_kitchen_door, 4, house_sun), court = court_prism();
    cut_by_prism(soup, &rays, &door);
    cut_by_prism(soup, &rays, &court);
    rays_free(&rays);
    soup_free(&uncut);
}
