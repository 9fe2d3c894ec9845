/* SPDX-License-Identifier: MIT
 *
 * The scene glass against rays: each pixel's ray meets all polygons of the model, and what it meets up to the first
 * opaque one is blended in double precision. It knows nothing of tree, spans, order or RGB565. */
#include "base/rgb565.h"
#include "base/vec3.h"
#include "cameras/camera_path.h"
#include "compiler/compile.h"
#include "model/baked_light.h"
#include "readers/model_import.h"
#include "render/simulator.h"
#include "rigs/cmocka_ready.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { W_PX = 96, H_PX = 72, HITS_MAX = 64, FRAME_STEP = 7 };
static const char MODEL[] = "sim/scenes/glass.obj", CAMERAS[] = "sim/scenes/glass.cam";
static const double NEAR_M = 0.1;

struct hit {
    double depth_m;
    const struct mesh_polygon *polygon;
};

struct ray {
    double from[3], along[3];
};

static void cross(double out[3], const double a[3], const double b[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static void ray_through(const struct viewpoint *viewpoint, const struct lens *lens, int x_px, int y_px, struct ray *ray)
{
    const double u = ((2 * x_px + 1.0) / W_PX - 1) * lens->tan_x, v = (1 - (2 * y_px + 1.0) / H_PX) * lens->tan_y;
    struct view_axes axes;

    viewpoint_axes(viewpoint, &axes);
    memcpy(ray->from, viewpoint->eye_m, sizeof ray->from);
    for (int k = 0; k < 3; k++)
        ray->along[k] = axes.forward[k] + u * axes.right[k] + v * axes.up[k];
}

/* Twice the signed volume that a triangle spans with the ray: positive where the ray passes inside of edge a, b. */
static double side_of(const struct ray *ray, const double a[3], const double b[3])
{
    double to_a[3], to_b[3], across[3];

    vec3_sub(to_a, a, ray->from);
    vec3_sub(to_b, b, ray->from);
    cross(across, to_a, to_b);
    return -vec3_dot(across, ray->along);
}

/* Only polygons that face the eye: the glass is there twice. */
static bool meets(const struct mesh *mesh, const struct mesh_polygon *polygon, const struct ray *ray, double *depth_m)
{
    const uint32_t *corners = &mesh->corners[polygon->first];
    const double *a = mesh->points[corners[0]];
    double u[3], v[3], normal[3], to_a[3];

    for (uint32_t k = 0; k < polygon->count; k++)
        if (side_of(ray, mesh->points[corners[k]], mesh->points[corners[(k + 1) % polygon->count]]) < 0) return false;
    vec3_sub(u, mesh->points[corners[1]], a);
    vec3_sub(v, mesh->points[corners[2]], a);
    cross(normal, u, v);
    vec3_sub(to_a, a, ray->from);
    *depth_m = vec3_dot(normal, to_a) / vec3_dot(normal, ray->along);
    return vec3_dot(normal, ray->along) < 0 && *depth_m > NEAR_M;
}

static int nearer_first(const void *left, const void *right)
{
    const struct hit *a = left, *b = right;

    return (a->depth_m > b->depth_m) - (a->depth_m < b->depth_m);
}

/* RGB565 levels; how many transparent layers there are. */
static int look(const struct mesh *mesh, const struct ray *ray, double levels[3])
{
    struct hit hits[HITS_MAX];
    size_t count = 0;
    int layers = 0;

    for (size_t p = 0; p < mesh->polygon_count && count < HITS_MAX; p++)
        if (meets(mesh, &mesh->polygons[p], ray, &hits[count].depth_m)) hits[count++].polygon = &mesh->polygons[p];
    assert_true(count < HITS_MAX);
    qsort(hits, count, sizeof *hits, nearer_first);
    while ((size_t)layers < count && hits[layers].polygon->transparency)
        layers++;
    levels[0] = levels[1] = levels[2] = 0;
    for (size_t i = (size_t)layers < count ? (size_t)layers + 1 : count; i-- > 0;) {
        const uint16_t colour = rgb565_nearest(hits[i].polygon->colour);
        const double own[3] = {colour >> 11, colour >> 5 & 63, colour & 31};
        const double share = 1 - hits[i].polygon->transparency / 255.0;
        for (int k = 0; k < 3; k++)
            levels[k] += (own[k] - levels[k]) * share;
    }
    return layers;
}

struct judgement {
    size_t pixels, wrong, through, deepest; /* through: seen through a layer at least */
    double worst;                           /* of those that are not wrong, levels */
};

static void judge(struct judgement *sum, uint16_t pixel, const double levels[3], int layers)
{
    const double got[3] = {pixel >> 11, pixel >> 5 & 63, pixel & 31};
    double off = 0;

    for (int k = 0; k < 3; k++)
        off = fmax(off, fabs(got[k] - levels[k]));
    sum->pixels++;
    sum->through += layers > 0;
    if ((size_t)layers > sum->deepest) sum->deepest = (size_t)layers;
    if (off > layers + 1e-9)
        sum->wrong++;
    else
        sum->worst = fmax(sum->worst, off);
}

static void load(struct mesh *mesh)
{
    struct model model;
    struct error err;

    if (!model_import(MODEL, &model, &err)) fail_msg("%s", err.text);
    light_bake(&model);
    if (!mesh_clean(&model, mesh, &err)) fail_msg("%s", err.text);
    model_free(&model);
}

/* A wrong pixel is one that rounding moved across an edge: of the glass, or of anything behind it. */
static void pixels_are_what_rays_see_through_the_glass(void **state)
{
    const struct compile_options options = {.tolerance_units = 0.5, .splitter = "auto"};
    const struct simulator_setup setup = {W_PX, H_PX, LIM_NEAREST_FIRST, SIMULATOR_MEMORY, NULL};
    struct judgement sum = {0};
    struct camera_path path = {0};
    struct simulator simulator;
    struct compiled scene;
    struct mesh mesh;
    struct lens lens;
    struct error err;

    (void)state;
    load(&mesh);
    if (!compile_model(MODEL, &options, &scene, &err) || !camera_path_read(CAMERAS, &path, &err) ||
        !lens_init(&lens, 60, NEAR_M, W_PX, H_PX, &err) || !simulator_init(&simulator, &scene.scene, &setup, &err))
        fail_msg("%s", err.text);
    for (size_t f = 0; f < path.count; f += FRAME_STEP) {
        struct lim_camera camera;
        if (!camera_path_to_camera(&path, f, &lens, &scene.grid, &camera, &err) ||
            !simulator_frame(&simulator, &camera, &err))
            fail_msg("%s", err.text);
        for (int i = 0; i < W_PX * H_PX; i++) {
            double levels[3];
            struct ray ray;
            ray_through(&path.frames[f], &lens, i % W_PX, i / W_PX, &ray);
            const int layers = look(&mesh, &ray, levels);
            judge(&sum, simulator.pixels[i], levels, layers);
        }
    }
    printf(
        "# glass: %zu pixels, %zu of them through up to %zu layers; %.4f %% more than a level a layer off, the others "
        "%.2f levels at most\n",
        sum.pixels, sum.through, sum.deepest, 100.0 * (double)sum.wrong / (double)sum.pixels, sum.worst);
    assert_true(sum.through > sum.pixels / 10 && sum.deepest >= 4);
    assert_true(sum.wrong * 1000 < sum.pixels);
    simulator_free(&simulator);
    camera_path_free(&path);
    compiled_free(&scene);
    mesh_free(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(pixels_are_what_rays_see_through_the_glass)};

    return cmocka_run_group_tests_name("glass", tests, NULL, NULL);
}
