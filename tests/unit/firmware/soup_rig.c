/* SPDX-License-Identifier: MIT
 *
 * Scenes without nodes, and renderers on them whose target looks at every call. */
#include "soup_rig.h"

#include "colour.h"
#include "rigs/cmocka_ready.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

/* Scenes ---------------------------------------------------------------------------------------------------------- */

void soup_init(struct soup *soup)
{
    memset(soup, 0, sizeof *soup);
    soup->scene = (struct lim_scene){
        .vertices = soup->vertices, .boxes = &soup->box, .polygons = soup->words, .box_count = 1, .limits.vertices = 3};
}

static int16_t kept(double at)
{
    return (int16_t)lrint(fmax(-32768, fmin(32767, at)));
}

lim_index soup_vertex(struct soup *soup, double x, double y, double z)
{
    assert_true(soup->scene.vertex_count < SOUP_VERTICES);
    soup->vertices[soup->scene.vertex_count] = (struct lim_vertex){kept(x), kept(y), kept(z)};
    return soup->scene.vertex_count++;
}

void soup_triangle(struct soup *soup, lim_index a, lim_index b, lim_index c)
{
    lim_index *words = &soup->words[soup->scene.polygon_words];

    assert_true(soup->scene.polygon_count < SOUP_TRIANGLES);
    words[0] = a;
    words[1] = b;
    words[2] = c;
    words[3] = ++soup->scene.polygon_count;
    soup->scene.polygon_words += LIM_TRIANGLE_WORDS;
}

static int coordinate(const struct lim_vertex *vertex, int axis)
{
    return axis == 0 ? vertex->x : axis == 1 ? vertex->y : vertex->z;
}

void soup_done(struct soup *soup, lim_index deep_from)
{
    for (int axis = 0; axis < 3; axis++) {
        int low = soup->scene.vertex_count ? 32767 : 0, high = soup->scene.vertex_count ? -32768 : 0;
        for (lim_index i = 0; i < soup->scene.vertex_count; i++) {
            const int at = coordinate(&soup->vertices[i], axis);
            low = at < low ? at : low;
            high = at > high ? at : high;
        }
        const int centre = (int)floor((low + high) / 2.0);
        soup->box.centre[axis] = (int16_t)centre;
        soup->box.half[axis] = (uint16_t)(high - centre > centre - low ? high - centre : centre - low);
    }
    *soup->scene.deep_from = *soup->scene.near_deep_from = deep_from;
    soup->scene.limits.active = (uint16_t)soup->scene.polygon_count;
}

static void add_ball(struct soup *soup, struct random *random, double radius)
{
    const int rings = (int)random_in(random, 2, 14), around = (int)random_in(random, 3, 20);
    const double dent = random_unit(random) * 0.5;
    const lim_index top = soup_vertex(soup, 0, radius, 0), bottom = soup_vertex(soup, 0, -radius, 0);
    const lim_index first = soup->scene.vertex_count;

    for (int i = 1; i < rings; i++)
        for (int j = 0; j < around; j++) {
            const double r = radius * (1 - dent * random_unit(random)), a = PI * i / rings, b = 2 * PI * j / around;
            soup_vertex(soup, r * sin(a) * sin(b), r * cos(a), r * sin(a) * cos(b));
        }
    for (int i = 0; i < rings; i++)
        for (int j = 0; j < around; j++) {
            const lim_index upper = first + (lim_index)((i - 1) * around), lower = first + (lim_index)(i * around);
            const lim_index here = (lim_index)j, next = (lim_index)((j + 1) % around);
            if (i + 1 < rings) soup_triangle(soup, i ? upper + here : top, lower + here, lower + next);
            if (i) soup_triangle(soup, upper + here, i + 1 < rings ? lower + next : bottom, upper + next);
        }
}

static double anywhere(struct random *random, double radius)
{
    return (2 * random_unit(random) - 1) * radius;
}

static void add_random(struct soup *soup, struct random *random, double radius, double size, double flat)
{
    const double x = anywhere(random, radius), y = anywhere(random, radius), z = anywhere(random, radius);
    lim_index at[3];

    for (int k = 0; k < 3; k++)
        at[k] = soup_vertex(soup, x + anywhere(random, size), y + anywhere(random, size * flat),
                            z + anywhere(random, size * (random_u64(random) & 1 ? flat : 1)));
    soup_triangle(soup, at[0], at[1], at[2]);
}

static void add_ground(struct soup *soup, struct random *random, double radius)
{
    const double near = -200, far = 32000, below = -60 - 200 * random_unit(random);
    const lim_index corners[4] = {soup_vertex(soup, -far, below, near), soup_vertex(soup, far, below, near),
                                  soup_vertex(soup, far, below, -far), soup_vertex(soup, -far, below, -far)};

    soup_triangle(soup, corners[0], corners[1], corners[2]);
    soup_triangle(soup, corners[0], corners[2], corners[3]);
    for (int i = 0; i < 30; i++)
        add_random(soup, random, radius, radius / 2, 1);
}

void soup_random(struct soup *soup, struct random *random, unsigned kind, double radius)
{
    const int count = kind == 0 || kind == 6 ? 0
                      : kind == 3            ? 1
                      : kind == 4            ? 24
                                             : (int)random_in(random, 2, kind == 5 ? 500 : 80);

    soup_init(soup);
    if (kind == 0) add_ball(soup, random, radius);
    if (kind == 6) add_ground(soup, random, radius);
    for (int i = 0; i < count; i++) {
        const double size = kind == 5 ? radius / 30 : radius, flat = kind == 2 ? 0.002 : 1;
        add_random(soup, random, radius, size, flat);
    }
    soup_done(soup, 0);
}

struct lim_camera soup_camera(struct random *random, double distance)
{
    const uint32_t tan_q28 = (uint32_t)random_in(random, LIM_TAN_MAX_Q28 / 16, LIM_TAN_MAX_Q28 / 2);
    struct lim_camera camera = {.roll = random_u64(random) & 1 ? 0 : (uint32_t)random_u64(random),
                                .tan_x_q28 = tan_q28,
                                .tan_y_q28 = tan_q28 / 4 * (uint32_t)random_in(random, 2, 6),
                                .near_q8 = 256 * (int32_t)random_in(random, 8, 60)};
    const double turn = 2 * PI * random_unit(random), height = anywhere(random, 1), across = sqrt(1 - height * height);
    const double eye[3] = {distance * across * cos(turn), distance * height, distance * across * sin(turn)};
    int32_t eye_q8[3], target_q8[3];

    for (int i = 0; i < 3; i++) {
        eye_q8[i] = (int32_t)lrint(eye[i] * 256);
        target_q8[i] = (int32_t)lrint(anywhere(random, distance * 40 + 1000));
    }
    lim_look_at(&camera, eye_q8, target_q8);
    return camera;
}

/* Views ----------------------------------------------------------------------------------------------------------- */

enum { UNTOUCHED = 0xA5A5 };

static void *lend(void *ctx, uint16_t y_px)
{
    struct soup_view *view = ctx;

    if (view->lends_to >= 0 && y_px >= view->lends_to) return NULL;
    return view->pixels + (size_t)y_px * view->stride_px;
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct soup_view *view = ctx;

    assert_int_equal(y_px, view->done_lines);
    assert_int_equal(x_px, 0);
    assert_int_equal(n_px, view->w_px);
    if (y_px == view->fails_at) return -4711;
    view->done_lines++;
    return 0;
}

int soup_view_init(struct soup_view *view, const struct core *core, const struct soup *soup, enum lim_method method,
                   uint16_t w_px, uint16_t h_px, size_t mem_b, int before)
{
    const struct lim_target target = {
        .w_px = w_px, .h_px = h_px, .format = LIM_RGB565, .method = method, .ctx = view, .lend = lend, .done = done};

    *view = (struct soup_view){.core = core, .w_px = w_px, .h_px = h_px, .fails_at = -1, .lends_to = -1};
    view->stride_px = (w_px + 1u) / 2 * 2 + 2;
    view->mem_b = mem_b ? mem_b : core->mem_b(&soup->scene, &target);
    view->lim = malloc(core->lim_b);
    view->mem = malloc(view->mem_b);
    view->pixels = malloc((size_t)view->stride_px * h_px * sizeof *view->pixels);
    assert_true(view->lim && view->mem && view->pixels);
    memset(view->lim, before, core->lim_b);
    memset(view->mem, before, view->mem_b);
    return core->init(view->lim, &soup->scene, &target, view->mem, view->mem_b);
}

int soup_view_draw(struct soup_view *view, const struct lim_camera *camera)
{
    view->done_lines = 0;
    for (size_t i = 0; i < (size_t)view->stride_px * view->h_px; i++)
        view->pixels[i] = UNTOUCHED;
    const int code = view->core->frame(view->lim, camera);
    if (code) return code;
    assert_int_equal(view->done_lines, view->h_px);
    for (uint32_t y = 0; y < view->h_px; y++)
        for (uint32_t x = view->w_px; x < view->stride_px; x++)
            assert_int_equal(view->pixels[y * view->stride_px + x], UNTOUCHED);
    return code;
}

int soup_view_at(const struct soup_view *view, uint16_t x_px, uint16_t y_px)
{
    return (int)lim_memory_colour(view->pixels[y_px * view->stride_px + x_px]) - 1;
}

void soup_view_free(struct soup_view *view)
{
    free(view->lim);
    free(view->mem);
    free(view->pixels);
}
