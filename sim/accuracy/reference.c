/* SPDX-License-Identifier: MIT
 *
 * A ray d from the eye meets a convex polygon when d . (a - e) x (b - e) has one sign for all
 * edges a -> b. On the screen that is a linear function of the pixel, and so is the inverse depth
 * of the polygon's plane; corners behind the eye need no clipping. Two polygons with a common
 * edge compute exact negatives of the same function, so no ray can slip between them. */
#include "accuracy/reference.h"

#include "accuracy/reference_polygon.h"

#include <math.h>
#include <string.h>

static double edge_at(const struct reference_edge *edge, double u, double v)
{
    return edge->a * u + edge->b * v + edge->c;
}

static double pixel_u(const struct reference_view *view, int x_px)
{
    return (2.0 * (x_px + view->shift_px[0]) + 1.0) / view->w_px - 1.0;
}

static double pixel_v(const struct reference_view *view, int y_px)
{
    return 1.0 - (2.0 * (y_px + view->shift_px[1]) + 1.0) / view->h_px;
}

/* One polygon -------------------------------------------------------------------------------- */

static struct reference_edge edge_from_vector(const struct reference_view *view, const double vector[3], double scale)
{
    return (struct reference_edge){scale * dot(vector, view->right), scale * dot(vector, view->up),
                                   scale * dot(vector, view->forward)};
}

static void polygon_edges(const struct reference_polygon *polygon, double (*points)[3],
                          const struct reference_view *view, bool is_front, struct reference_edge *edges)
{
    for (uint32_t i = 0; i < polygon->count; i++) {
        double a[3], b[3], normal[3];
        subtract(points[i], view->eye_m, a);
        subtract(points[(i + 1) % polygon->count], view->eye_m, b);
        cross(a, b, normal);
        /* Counter-clockwise around the ray, seen against it: these normals point outwards. */
        edges[i] = edge_from_vector(view, normal, is_front ? -1.0 : 1.0);
    }
}

static void bounds_add(const struct reference_view *view, const double p[3], double low[2], double high[2])
{
    const double tan_x_2 = dot(view->right, view->right), tan_y_2 = dot(view->up, view->up);
    const double depth = dot(p, view->forward);
    const double at[2] = {dot(p, view->right) / tan_x_2 / depth, -dot(p, view->up) / tan_y_2 / depth};
    for (int i = 0; i < 2; i++) {
        low[i] = fmin(low[i], at[i]);
        high[i] = fmax(high[i], at[i]);
    }
}

static int clamp_px(double px, int size_px)
{
    return (int)fmax(-1.0, fmin(px, size_px));
}

/* Bounds on the screen of what lies beyond the near plane, a pixel wider; also the depths. */
static struct pixel_rect polygon_bounds(struct reference_polygon *polygon, double (*points)[3],
                                        const struct reference_view *view)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    double a[3], b[3];
    subtract(points[polygon->count - 1], view->eye_m, a);
    double depth_a = dot(a, view->forward);
    polygon->depth_min_m = polygon->depth_max_m = depth_a;
    for (uint32_t i = 0; i < polygon->count; i++) {
        subtract(points[i], view->eye_m, b);
        double depth_b = dot(b, view->forward);
        if ((depth_a < view->near_m) != (depth_b < view->near_m)) {
            double along = (view->near_m - depth_a) / (depth_b - depth_a), crossing[3];
            for (int axis = 0; axis < 3; axis++)
                crossing[axis] = a[axis] + along * (b[axis] - a[axis]);
            bounds_add(view, crossing, low, high);
        }
        if (depth_b >= view->near_m) bounds_add(view, b, low, high);
        polygon->depth_min_m = fmin(polygon->depth_min_m, depth_b);
        polygon->depth_max_m = fmax(polygon->depth_max_m, depth_b);
        memcpy(a, b, sizeof a);
        depth_a = depth_b;
    }
    if (low[0] > high[0]) return (struct pixel_rect){0, 0, -1, -1};
    return (struct pixel_rect){
        .x0 = (int)fmax(0.0, clamp_px((low[0] + 1.0) / 2.0 * view->w_px - 1.0, view->w_px)),
        .y0 = (int)fmax(0.0, clamp_px((low[1] + 1.0) / 2.0 * view->h_px - 1.0, view->h_px)),
        .x1 = (int)fmin(view->w_px - 1, clamp_px((high[0] + 1.0) / 2.0 * view->w_px + 1.0, view->w_px)),
        .y1 = (int)fmin(view->h_px - 1, clamp_px((high[1] + 1.0) / 2.0 * view->h_px + 1.0, view->h_px))};
}

static bool is_inside(const struct reference_edge *edges, uint32_t count, double u, double v)
{
    for (uint32_t i = 0; i < count; i++)
        if (edge_at(&edges[i], u, v) < 0.0) return false;
    return true;
}

/* Narrows the line to the interval between the edges: by division to within a pixel, then by the
 * edge functions themselves, so that the decision is always theirs. */
static void line_interval(const struct reference_edge *edges, uint32_t count, const struct reference_view *view,
                          double v, int *x0_px, int *x1_px)
{
    for (uint32_t i = 0; i < count; i++) {
        double crossing_px = (-(edges[i].b * v + edges[i].c) / edges[i].a + 1.0) / 2.0 * view->w_px;
        if (edges[i].a > 0.0) *x0_px = (int)fmax(*x0_px, clamp_px(crossing_px - 2.0, view->w_px));
        if (edges[i].a < 0.0) *x1_px = (int)fmin(*x1_px, clamp_px(crossing_px + 1.0, view->w_px));
    }
    while (*x0_px <= *x1_px && !is_inside(edges, count, pixel_u(view, *x0_px), v))
        ++*x0_px;
    while (*x0_px <= *x1_px && !is_inside(edges, count, pixel_u(view, *x1_px), v))
        --*x1_px;
}

/* Of faces in one plane, give or take rounding, the later in the file lies over the earlier. */
static bool is_nearer(double depth_m, const struct reference_polygon *polygon, double best_m, uint32_t best_face)
{
    if (depth_m < best_m * (1.0 - polygon->level_share)) return true;
    return depth_m <= best_m * (1.0 + polygon->level_share) && polygon->face > best_face;
}

static void draw_line(struct reference *reference, const struct reference_polygon *polygon,
                      const struct reference_view *view, int y_px, int x0_px, int x1_px)
{
    const double v = pixel_v(view, y_px);
    for (int x_px = x0_px; x_px <= x1_px; x_px++) {
        size_t pixel = (size_t)y_px * reference->w_px + (size_t)x_px;
        double inverse = edge_at(&polygon->inverse_depth, pixel_u(view, x_px), v);
        if (!(inverse > 0.0 && inverse * view->near_m <= 1.0)) continue;
        if (!is_nearer(1.0 / inverse, polygon, reference->depths_m[pixel], reference->faces[pixel])) continue;
        reference->depths_m[pixel] = 1.0 / inverse;
        reference->faces[pixel] = polygon->face;
        if (reference->mappings) reference->mappings[pixel] = polygon->mapping;
    }
}

/* The polygon's plane, seen from the eye. Returns its offset from there, negative for a front. */
static double set_plane(struct reference_polygon *polygon, const struct reference_view *view)
{
    const double offset_m = polygon->offset_m - dot(polygon->normal, view->eye_m);
    polygon->inverse_depth = edge_from_vector(view, polygon->normal, 1.0 / offset_m);
    polygon->level_share = view->level_m * sqrt(dot(polygon->normal, polygon->normal)) / fabs(offset_m);
    return offset_m;
}

static void draw_polygon(struct reference *reference, struct reference_polygon *polygon,
                         const struct reference_view *view, const struct pixel_rect *rect)
{
    const double offset_m = set_plane(polygon, view);
    bool is_front = offset_m < 0.0;
    if (offset_m == 0.0 || (!is_front && !polygon->two_sided)) return;

    polygon_edges(polygon, &reference->points[polygon->first], view, is_front, reference->edges);
    for (int y_px = rect->y0; y_px <= rect->y1; y_px++) {
        int x0_px = rect->x0, x1_px = rect->x1;
        line_interval(reference->edges, polygon->count, view, pixel_v(view, y_px), &x0_px, &x1_px);
        draw_line(reference, polygon, view, y_px, x0_px, x1_px);
    }
}

/* Frames ------------------------------------------------------------------------------------- */

static void wipe(struct reference *reference)
{
    size_t pixel_count = (size_t)reference->w_px * reference->h_px;
    memset(reference->faces, 0, pixel_count * sizeof reference->faces[0]);
    if (reference->mappings) memset(reference->mappings, 0, pixel_count * sizeof reference->mappings[0]);
    for (size_t i = 0; i < pixel_count; i++)
        reference->depths_m[i] = INFINITY;
}

void reference_point(const struct reference *reference, size_t pixel, double out_m[3])
{
    const struct reference_view *view = &reference->view;
    const double u = pixel_u(view, (int)(pixel % reference->w_px)), v = pixel_v(view, (int)(pixel / reference->w_px));
    for (int i = 0; i < 3; i++)
        out_m[i] =
            view->eye_m[i] + reference->depths_m[pixel] * (view->right[i] * u + view->up[i] * v + view->forward[i]);
}

void reference_draw(struct reference *reference, const struct viewpoint *viewpoint, const struct lens *lens)
{
    reference_draw_shifted(reference, viewpoint, lens, (const double[2]){0.0, 0.0});
}

void reference_draw_shifted(struct reference *reference, const struct viewpoint *viewpoint, const struct lens *lens,
                            const double shift_px[2])
{
    struct view_axes axes;
    viewpoint_axes(viewpoint, &axes);
    struct reference_view *view = &reference->view;
    *view = (struct reference_view){.near_m = lens->near_m,
                                    .level_m = reference->level_m,
                                    .w_px = (int)reference->w_px,
                                    .h_px = (int)reference->h_px,
                                    .shift_px = {shift_px[0], shift_px[1]}};
    memcpy(view->eye_m, viewpoint->eye_m, sizeof view->eye_m);
    for (int i = 0; i < 3; i++) {
        view->right[i] = axes.right[i] * lens->tan_x;
        view->up[i] = axes.up[i] * lens->tan_y;
        view->forward[i] = axes.forward[i];
    }
    wipe(reference);
    for (size_t p = 0; p < reference->polygon_count; p++) {
        struct reference_polygon *polygon = &reference->polygons[p];
        reference->bounds[p] = polygon_bounds(polygon, &reference->points[polygon->first], view);
        draw_polygon(reference, polygon, view, &reference->bounds[p]);
    }
    near_tiles_set(&reference->tiles, reference->w_px, reference->h_px, reference->bounds, reference->polygon_count);
}

static uint32_t group_of(const uint32_t *groups, uint32_t face)
{
    return groups && groups[face] ? groups[face] : face; /* 0: it was dropped, and is itself */
}

/* A picture of the two pixels' width around a pixel's centre. */
static struct reference_view close_up(const struct reference *reference, size_t pixel, int size_px)
{
    struct reference_view view = reference->view;
    const double u = pixel_u(&view, (int)(pixel % reference->w_px)), v = pixel_v(&view, (int)(pixel / reference->w_px));
    for (int i = 0; i < 3; i++) {
        view.forward[i] += u * view.right[i] + v * view.up[i];
        view.right[i] *= 2.0 / view.w_px;
        view.up[i] *= 2.0 / view.h_px;
    }
    view.w_px = view.h_px = size_px;
    return view;
}

enum { LOOK_PX = 128 }; /* the size of the closest look */

/* The polygons that may reach into the two pixels' width around a pixel, in the last frame drawn, and more. What lies
 * beside the screen has bounds at its border. */
static void near_lists(const struct reference *reference, size_t pixel, struct near_list lists[NEAR_LISTS])
{
    near_tiles_at(&reference->tiles, (unsigned)(pixel % reference->w_px), (unsigned)(pixel / reference->w_px), lists);
}

static bool is_near(const struct pixel_rect *bounds, int x_px, int y_px)
{
    return x_px >= bounds->x0 - NEAR_TILES_PX && x_px <= bounds->x1 + NEAR_TILES_PX &&
           y_px >= bounds->y0 - NEAR_TILES_PX && y_px <= bounds->y1 + NEAR_TILES_PX;
}

static void draw_near(struct reference *small, const struct reference *reference, const struct near_list *list,
                      size_t pixel, const struct reference_view *view)
{
    const struct pixel_rect all = {0, 0, view->w_px - 1, view->h_px - 1};
    const int x_px = (int)(pixel % reference->w_px), y_px = (int)(pixel / reference->w_px);
    for (size_t i = 0; i < list->count; i++) {
        if (!is_near(&reference->bounds[list->numbers[i]], x_px, y_px)) continue;
        struct reference_polygon polygon = reference->polygons[list->numbers[i]];
        draw_polygon(small, &polygon, view, &all);
    }
}

static bool sees_in(const struct reference *reference, const uint32_t *groups, uint32_t group, size_t pixel,
                    const struct reference_view *view)
{
    uint32_t faces[LOOK_PX * LOOK_PX];
    double depths_m[LOOK_PX * LOOK_PX];
    struct near_list lists[NEAR_LISTS];
    struct reference small = *reference;
    small.w_px = small.h_px = (unsigned)view->w_px;
    small.faces = faces;
    small.mappings = NULL;
    small.depths_m = depths_m;
    wipe(&small);
    near_lists(reference, pixel, lists);
    for (int i = 0; i < NEAR_LISTS; i++)
        draw_near(&small, reference, &lists[i], pixel, view);
    for (int i = 0; i < view->w_px * view->h_px; i++)
        if (group_of(groups, faces[i]) == group) return true;
    return false;
}

/* Whether all four corners of a small view lie within a polygon that faces the eye; sets its inverse depth there. */
static bool fills(const struct reference *reference, const struct reference_polygon *polygon,
                  const struct reference_view *view, double inverse[4])
{
    struct reference_polygon copy = *polygon;
    const bool is_front = set_plane(&copy, view) < 0.0;
    if (!is_front && !copy.two_sided) return false;
    polygon_edges(&copy, &reference->points[copy.first], view, is_front, reference->edges);
    for (int i = 0; i < 4; i++) {
        const double u = i & 1 ? 1.0 : -1.0, v = i & 2 ? 1.0 : -1.0;
        inverse[i] = edge_at(&copy.inverse_depth, u, v);
        if (!is_inside(reference->edges, copy.count, u, v) || inverse[i] * view->near_m > 1.0) return false;
    }
    return true;
}

/* Whether all of a group lies behind the one face that fills the view: inverse depths are linear, so the corners
 * decide. What a wrong order shows is nearly always hidden so. */
static bool is_hidden(const struct reference *reference, const uint32_t *groups, uint32_t group, uint32_t before,
                      const struct reference_view *view)
{
    double covers[4] = {0};
    bool filled = false;
    for (size_t p = 0; p < reference->polygon_count && !filled; p++)
        filled = reference->polygons[p].face == before && fills(reference, &reference->polygons[p], view, covers);
    for (size_t p = 0; p < reference->polygon_count && filled; p++) {
        if (group_of(groups, reference->polygons[p].face) != group) continue;
        struct reference_polygon polygon = reference->polygons[p];
        set_plane(&polygon, view);
        for (int i = 0; i < 4; i++)
            if (!(edge_at(&polygon.inverse_depth, i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0) < covers[i])) return false;
    }
    return filled;
}

bool reference_sees_nearby(const struct reference *reference, const uint32_t *groups, uint32_t group, size_t pixel)
{
    const struct reference_view glance = close_up(reference, pixel, LOOK_PX / 8);
    const struct reference_view look = close_up(reference, pixel, LOOK_PX);
    if (is_hidden(reference, groups, group, reference->faces[pixel], &glance)) return false;
    return sees_in(reference, groups, group, pixel, &glance) || sees_in(reference, groups, group, pixel, &look);
}

double reference_depth_of(const struct reference *reference, const uint32_t *groups, uint32_t group, size_t pixel)
{
    const struct reference_view *view = &reference->view;
    const double u = pixel_u(view, (int)(pixel % reference->w_px)), v = pixel_v(view, (int)(pixel / reference->w_px));
    double nearest_m = INFINITY, least_m = INFINITY, most_m = -INFINITY;
    for (size_t p = 0; p < reference->polygon_count; p++) {
        const struct reference_polygon *polygon = &reference->polygons[p];
        if (group_of(groups, polygon->face) != group) continue;
        const struct reference_edge *plane = &polygon->inverse_depth;
        double inverse = edge_at(plane, u, v) + 2.0 * fabs(plane->a) / view->w_px + 2.0 * fabs(plane->b) / view->h_px;
        nearest_m = fmin(nearest_m, inverse > 0.0 ? 1.0 / inverse : INFINITY);
        least_m = fmin(least_m, polygon->depth_min_m);
        most_m = fmax(most_m, polygon->depth_max_m);
    }
    return least_m > most_m ? INFINITY : fmax(least_m, fmin(nearest_m, most_m));
}
