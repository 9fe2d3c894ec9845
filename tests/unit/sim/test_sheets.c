/* SPDX-License-Identifier: MIT
 *
 * Stacks of sheets, decals and posters, from a millionth of a grid unit to one unit apart, or in one plane: drawn in
 * every profile, by every tree, and from either side. What a pixel should show comes from a ray in the sheets' own
 * frame, where each is a rectangle at a height. */
#include "compiler/compile.h"
#include "core/core.h"
#include "render/ids.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/profiles.h"
#include "rigs/random.h"
#include "rigs/tiny_model.h"

#include <math.h>
#include <string.h>

enum { SHEETS_MAX = 9, SIDE_PX = 96, STACKS = 400 };
static const double TANGENT = 0.6;

/* z is up; x and y of a sheet are from the middle of the floor, which is sheet 0 of the heap but not of the file. */
struct sheet {
    double low[2], high[2], z;
};

struct stack {
    struct sheet sheets[SHEETS_MAX]; /* in the file's order */
    int count;
    double half_m;     /* of the floor */
    double turn[3][3]; /* columns: the axes of the sheets' frame */
    bool two_sided;
    double eye[3], target[3]; /* in that frame */
};

static double between(struct random *random, double low, double high)
{
    return low + (high - low) * random_unit(random);
}

/* Three axes at right angles: of a random direction and another one. */
static void turn_at_random(struct random *random, double turn[3][3])
{
    double a[3], b[3], along = 0, length = 0;
    for (int i = 0; i < 3; i++) {
        a[i] = between(random, -1, 1);
        b[i] = between(random, -1, 1);
    }
    for (int i = 0; i < 3; i++)
        length += a[i] * a[i];
    for (int i = 0; i < 3; i++)
        along += a[i] * b[i] / length;
    double across = 0;
    for (int i = 0; i < 3; i++) {
        b[i] -= along * a[i];
        across += b[i] * b[i];
    }
    for (int i = 0; i < 3; i++) {
        turn[i][0] = a[i] / sqrt(length);
        turn[i][1] = b[i] / sqrt(across);
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        turn[i][2] = turn[j][0] * turn[k][1] - turn[k][0] * turn[j][1];
    }
}

static void to_world(const struct stack *stack, const double at[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = stack->turn[i][0] * at[0] + stack->turn[i][1] * at[1] + stack->turn[i][2] * at[2];
}

/* Sheets lie around one place of a floor, `step_m` apart; 0: all in one plane. */
static struct stack stack_at_random(struct random *random, double half_m, double step_m)
{
    struct stack stack = {.count = (int)random_in(random, 3, SHEETS_MAX), .half_m = half_m};
    const double size_m = half_m * between(random, 0.1, 0.3),
                 at_m[2] = {between(random, -half_m / 3, half_m / 3), between(random, -half_m / 3, half_m / 3)};
    const int floor = (int)random_in(random, 0, stack.count - 1), first = (int)random_in(random, 0, stack.count - 1);
    turn_at_random(random, stack.turn);
    stack.two_sided = random_u64(random) & 1;
    for (int i = 0; i < stack.count; i++) {
        struct sheet *sheet = &stack.sheets[i];
        for (int axis = 0; axis < 2; axis++) {
            sheet->low[axis] = i == floor ? -half_m : at_m[axis] - size_m * between(random, 0.2, 1);
            sheet->high[axis] = i == floor ? half_m : at_m[axis] + size_m * between(random, 0.2, 1);
        }
        sheet->z = step_m * (i == floor ? 0 : (i + first) % stack.count - stack.count / 2);
    }
    const bool below = stack.two_sided && random_u64(random) & 1;
    for (int axis = 0; axis < 2; axis++) {
        stack.target[axis] = at_m[axis] + size_m * between(random, -0.2, 0.2);
        stack.eye[axis] = at_m[axis] + size_m * between(random, -1, 1);
    }
    stack.eye[2] = size_m * between(random, 0.8, 1.6) * (below ? -1 : 1);
    return stack;
}

static struct model model_of(const struct stack *stack)
{
    struct model model = {0};
    for (int i = 0; i < stack->count; i++) {
        const struct sheet *sheet = &stack->sheets[i];
        double places[4][3];
        for (int k = 0; k < 4; k++) {
            const double at[3] = {k == 1 || k == 2 ? sheet->high[0] : sheet->low[0],
                                  k >= 2 ? sheet->high[1] : sheet->low[1], sheet->z};
            to_world(stack, at, places[k]);
        }
        tiny_add(&model, 4, (const double(*)[3])places);
        model.faces[i].colour = 0x202020 * (unsigned)(1 + i % 6);
        model.faces[i].two_sided = stack->two_sided;
    }
    return model;
}

/* The face that a ray along `way` from the eye shows, from 1; 0: none. Of those at one height the later one. */
static uint32_t face_along(const struct stack *stack, const double way[3])
{
    uint32_t face = 0;
    double nearest = INFINITY;
    for (int i = 0; i < stack->count; i++) {
        const struct sheet *sheet = &stack->sheets[i];
        const double t = (sheet->z - stack->eye[2]) / way[2];
        const double x = stack->eye[0] + t * way[0], y = stack->eye[1] + t * way[1];
        if (!(t > 0) || t > nearest || x < sheet->low[0] || x > sheet->high[0] || y < sheet->low[1] ||
            y > sheet->high[1])
            continue;
        nearest = t;
        face = (uint32_t)i + 1;
    }
    return face;
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static void normalise(double a[3])
{
    const double length = sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    for (int i = 0; i < 3; i++)
        a[i] /= length;
}

/* Axes of the view in the sheets' frame: the world's up leans them. */
static void aim(const struct stack *stack, double right[3], double up[3], double forward[3])
{
    double world_up[3];
    for (int i = 0; i < 3; i++) {
        world_up[i] = stack->turn[1][i];
        forward[i] = stack->target[i] - stack->eye[i];
    }
    normalise(forward);
    cross(forward, world_up, right);
    normalise(right);
    cross(right, forward, up);
}

/* The rays of a picture: the one in the middle, and what leads to the border. */
struct rays {
    double right[3], up[3], forward[3];
};

static uint32_t face_at(const struct stack *stack, const struct rays *rays, double x_px, double y_px)
{
    const double u = TANGENT * ((2 * x_px + 1) / SIDE_PX - 1), v = TANGENT * (1 - (2 * y_px + 1) / SIDE_PX);
    double way[3];
    for (int i = 0; i < 3; i++)
        way[i] = rays->forward[i] + u * rays->right[i] + v * rays->up[i];
    return face_along(stack, way);
}

/* Whether a face is seen within so many pixels of a pixel's centre, a strip as narrow as a tenth of one too. */
static bool is_nearby(const struct stack *stack, const struct rays *rays, int x_px, int y_px, uint32_t face,
                      int reach_px)
{
    enum { STEPS = 10 };
    for (int j = -STEPS * reach_px; j <= STEPS * reach_px; j++)
        for (int i = -STEPS * reach_px; i <= STEPS * reach_px; i++)
            if (face_at(stack, rays, x_px + (double)i / STEPS, y_px + (double)j / STEPS) == face) return true;
    return false;
}

/* Pixels that show what is not even beside them. */
static size_t count_wrong(const struct stack *stack, const uint32_t *drawn, int reach_px)
{
    struct rays rays;
    size_t wrong = 0;
    aim(stack, rays.right, rays.up, rays.forward);
    for (int y = 0; y < SIDE_PX; y++)
        for (int x = 0; x < SIDE_PX; x++) {
            const uint32_t face = drawn[y * SIDE_PX + x];
            wrong += face_at(stack, &rays, x, y) != face && !is_nearby(stack, &rays, x, y, face, reach_px);
        }
    return wrong;
}

static struct lim_camera camera_of(const struct stack *stack, const struct compiled *scene)
{
    struct viewpoint viewpoint = {.line = 1};
    const struct camera_path path = {"stack", &viewpoint, 1};
    const double fov_deg = 2 * atan(TANGENT) * 57.29577951308232;
    struct lens lens;
    struct lim_camera camera;
    struct error err;
    to_world(stack, stack->eye, viewpoint.eye_m);
    to_world(stack, stack->target, viewpoint.target_m);
    if (!lens_for_grid(&lens, fov_deg, 0, &scene->grid, SIDE_PX, SIDE_PX, &err) ||
        !camera_path_to_camera(&path, 0, &lens, &scene->grid, &camera, &err))
        fail_msg("%s", err.text);
    return camera;
}

struct way {
    enum tree_kind tree;
    enum lim_method method;
    enum coordinates coordinates;
};

static size_t draw_wrong(const struct stack *stack, const struct core *core, const struct way *way, size_t *covered)
{
    const struct compile_options options = {.tolerance_units = 0.5,
                                            .splitter = "auto",
                                            .core = core,
                                            .tree = way->tree,
                                            .coordinates = way->coordinates,
                                            .w_px = SIDE_PX,
                                            .h_px = SIDE_PX};
    const struct simulator_setup setup = {.w_px = SIDE_PX, .h_px = SIDE_PX, .method = way->method, .core = core};
    struct model model = model_of(stack);
    struct compiled scene;
    struct ids ids;
    struct error err;
    if (!compile_part(&model, NULL, &options, &scene, &err) || !ids_init(&ids, &scene, &setup, &err))
        fail_msg("%s", err.text);
    const struct lim_camera camera = camera_of(stack, &scene);
    if (!ids_frame(&ids, &camera, &err)) fail_msg("%s", err.text);
    const size_t wrong = count_wrong(stack, ids.faces, core->profile == LIM_PROFILE_DRAFT ? 2 : 1);
    *covered = scene.report.covered;
    ids_free(&ids);
    compiled_free(&scene);
    model_free(&model);
    return wrong;
}

static const struct way WAYS[] = {
    {TREE_BSP, LIM_NEAREST_FIRST, COORDINATES_16},     {TREE_CLUSTERS, LIM_NEAREST_FIRST, COORDINATES_16},
    {TREE_AXIS, LIM_NEAREST_FIRST, COORDINATES_16},    {TREE_OCTREE, LIM_NEAREST_FIRST, COORDINATES_16},
    {TREE_BSP, LIM_PAINTER, COORDINATES_16},           {TREE_BSP, LIM_SCANLINE, COORDINATES_16},
    {TREE_CLUSTERS, LIM_SCANLINE, COORDINATES_16},     {TREE_BSP, LIM_NEAREST_FIRST, COORDINATES_32},
    {TREE_CLUSTERS, LIM_NEAREST_FIRST, COORDINATES_32}};
static const double HALVES_M[] = {5, 100, 1000, 20000, 500000};

/* Of draft, which has corners and edges off by pixels here and there, a little of a picture. */
static void expect_right(const struct stack *stack, const struct core *core, const struct way *way, int number)
{
    size_t covered;
    const size_t wrong = draw_wrong(stack, core, way, &covered);
    if (wrong > (core->profile == LIM_PROFILE_DRAFT ? SIDE_PX * SIDE_PX / 256 : 0))
        fail_msg("stack %d of %d sheets, %g m, %s, tree %s, method %d, %d bits: %zu pixels are wrong", number,
                 stack->count, stack->half_m, core->name, tree_names[way->tree], way->method,
                 way->coordinates == COORDINATES_32 ? 32 : 16, wrong);
}

static void sheets_are_ordered_by_their_offset_from_either_side(void **state)
{
    struct random random = {.state = 0x5EE7};
    const struct core *profiles[PROFILES_MAX];
    const size_t profile_count = profiles_find(profiles);
    (void)state;
    for (int i = 0; i < effort(STACKS); i++) {
        const struct way *way = &WAYS[i % (int)(sizeof WAYS / sizeof *WAYS)];
        const double half_m = HALVES_M[random_in(&random, 0, 4)];
        const double unit_m = 2 * half_m / 65534;
        const double step_m = unit_m * pow(10, between(&random, way->coordinates == COORDINATES_32 ? -3 : -6, 0));
        const struct stack stack = stack_at_random(&random, half_m, step_m);
        expect_right(&stack, profiles[random_in(&random, 0, (int64_t)profile_count - 1)], way, i);
    }
}

static void of_sheets_in_one_plane_the_later_lies_over_the_earlier(void **state)
{
    struct random random = {.state = 0x1A7E5};
    const struct core *profiles[PROFILES_MAX];
    const size_t profile_count = profiles_find(profiles);
    (void)state;
    for (int i = 0; i < effort(STACKS / 2); i++) {
        const struct stack stack = stack_at_random(&random, HALVES_M[random_in(&random, 0, 4)], 0);
        expect_right(&stack, profiles[random_in(&random, 0, (int64_t)profile_count - 1)],
                     &WAYS[i % (int)(sizeof WAYS / sizeof *WAYS)], i);
    }
}

/* All but the last in the file, which nothing lies over; a step between them, and nobody is in one plane. */
static void those_that_are_covered_are_counted(void **state)
{
    struct random random = {.state = 77};
    (void)state;
    for (int i = 0; i < 10; i++) {
        struct stack stack = stack_at_random(&random, 100, 0);
        size_t covered;
        draw_wrong(&stack, &core_fast, &WAYS[0], &covered);
        assert_int_equal(covered, stack.count - 1);
        for (int k = 0; k < stack.count; k++)
            stack.sheets[k].z = 1e-4 * k;
        draw_wrong(&stack, &core_fast, &WAYS[0], &covered);
        assert_int_equal(covered, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sheets_are_ordered_by_their_offset_from_either_side),
        cmocka_unit_test(of_sheets_in_one_plane_the_later_lies_over_the_earlier),
        cmocka_unit_test(those_that_are_covered_are_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
