/* SPDX-License-Identifier: MIT
 *
 * Grounds and walls from 2^16 to 2^29 units wide, and an eye from 1 to 2^20 units before them: nothing of them may be
 * missing. What is to be seen is told by a ray for each pixel, from corners and eye in whole numbers: products of 128
 * bits are exact, and long doubles have only to point them. That shares nothing with the compiler or the renderer but
 * what the fields of a camera mean. */
#include "compiler/compile_mesh.h"
#include "render/ids.h"
#include "rigs/camera_axes.h"
#include "rigs/cmocka_ready.h"
#include "rigs/effort.h"
#include "rigs/profiles.h"
#include "rigs/random.h"
#include "rigs/tiny_model.h"

#include <math.h>
#include <stdio.h>

enum { FLATS = 32, CORNERS = 5, FRAMES = 5, SLOPE_BITS = 6, UNITS_Q8 = 256, LOOKS = 4 };
static const int64_t GRID_END = (INT64_C(1) << 29) - 2;

__extension__ typedef __int128 wide;

/* A convex face in whole units, counter-clockwise as seen from its front. */
struct flat {
    int64_t at[CORNERS][3];
    int n;
};

/* Face k + 1 of the model is flat k. */
struct horizon {
    struct flat flats[FLATS];
    int count;
    int turned;       /* which axis is up: 1, or the next ones */
    int64_t slope[2]; /* of the ground, in 2^-SLOPE_BITS, along the two others */
    double lens_deg;  /* vertical */
    unsigned w_px, h_px;
};

/* What is there ---------------------------------------------------------------------------------- */

/* The place of (u, v) on the ground, or that high above it. */
static void place(const struct horizon *horizon, int64_t u, int64_t v, int64_t high, int64_t out[3])
{
    const int64_t rise = u * horizon->slope[0] + v * horizon->slope[1];
    const int64_t at[3] = {u, high + rise / (1 << SLOPE_BITS), v};

    for (int i = 0; i < 3; i++)
        out[(i + horizon->turned) % 3] = at[i];
}

/* Corners (u, v), which are in the plane exactly where they are multiples of 2^SLOPE_BITS; the front is up. */
static void add_flat(struct horizon *horizon, int n, const int64_t (*uv)[2])
{
    struct flat *flat = &horizon->flats[horizon->count++];

    assert_true(horizon->count <= FLATS && n <= CORNERS);
    flat->n = n;
    for (int k = 0; k < n; k++)
        place(horizon, uv[k][0], uv[k][1], 0, flat->at[k]);
}

static void add_rectangle(struct horizon *horizon, const int64_t low[2], const int64_t high[2])
{
    const int64_t uv[4][2] = {{low[0], high[1]}, {high[0], high[1]}, {high[0], low[1]}, {low[0], low[1]}};

    add_flat(horizon, 4, uv);
}

static int64_t on_plane(int64_t x)
{
    return x & -(INT64_C(1) << SLOPE_BITS);
}

static void ground_of_one(struct horizon *horizon, struct random *random, int64_t reach)
{
    const int64_t low[2] = {-reach, -reach}, high[2] = {reach, reach};

    (void)random;
    add_rectangle(horizon, low, high);
}

static void ground_of_triangles(struct horizon *horizon, struct random *random, int64_t reach)
{
    const int64_t one[3][2] = {{-reach, reach}, {reach, reach}, {reach, -reach}};
    const int64_t other[3][2] = {{-reach, reach}, {reach, -reach}, {-reach, -reach}};

    (void)random;
    add_flat(horizon, 3, one);
    add_flat(horizon, 3, other);
}

/* Around a corner not far from the middle: some edges are short, some lead to the horizon. */
static void ground_of_a_fan(struct horizon *horizon, struct random *random, int64_t reach)
{
    const int64_t end = INT64_C(1) << random_in(random, 6, 15);
    const int64_t apex[2] = {on_plane(random_in(random, -end, end)), on_plane(random_in(random, -end, end))};
    const int64_t rim[8][2] = {{-reach, reach}, {0, reach},  {reach, reach},   {reach, 0},
                               {reach, -reach}, {0, -reach}, {-reach, -reach}, {-reach, 0}};

    for (int k = 0; k < 8; k++) {
        const int64_t uv[3][2] = {
            {apex[0], apex[1]}, {rim[k][0], rim[k][1]}, {rim[(k + 1) % 8][0], rim[(k + 1) % 8][1]}};
        add_flat(horizon, 3, uv);
    }
}

/* Strips from a width of some units to the horizon, each cut across somewhere. */
static void ground_of_strips(struct horizon *horizon, struct random *random, int64_t reach)
{
    int64_t from = -reach;

    for (int k = 0; k < 6; k++) {
        const int64_t size = on_plane(INT64_C(1) << random_in(random, 6, 15)),
                      across = on_plane(random_in(random, -size, size));
        const int64_t to = k == 5 ? reach : k == 0 ? -on_plane(random_in(random, 64, 4096)) : from + size;
        add_rectangle(horizon, (const int64_t[2]){from, -reach}, (const int64_t[2]){to, across});
        add_rectangle(horizon, (const int64_t[2]){from, across}, (const int64_t[2]){to, reach});
        from = to;
    }
}

/* The inside of a box, the eye not far from its lower sides: there is no background at all. */
static void room_of_six(struct horizon *horizon, struct random *random, int64_t reach)
{
    (void)random;
    horizon->slope[0] = horizon->slope[1] = 0;
    for (int axis = 0; axis < 3; axis++) {
        for (int far = 0; far < 2; far++) {
            struct flat *flat = &horizon->flats[horizon->count++];
            flat->n = 4;
            for (int k = 0; k < 4; k++) {
                const int turn = far ? 3 - k : k;
                int64_t at[3];
                at[axis] = far ? 2 * reach : 0;
                at[(axis + 1) % 3] = turn == 1 || turn == 2 ? 2 * reach : 0;
                at[(axis + 2) % 3] = turn >= 2 ? 2 * reach : 0;
                for (int i = 0; i < 3; i++)
                    flat->at[k][i] = at[i] - reach;
            }
        }
    }
}

struct kind {
    const char *name;
    void (*build)(struct horizon *horizon, struct random *random, int64_t reach);
    bool is_room;
};

static const struct kind kinds[] = {
    {"a square", ground_of_one, false}, {"two triangles", ground_of_triangles, false},
    {"a fan", ground_of_a_fan, false},  {"strips", ground_of_strips, false},
    {"a room", room_of_six, true},
};
enum { KINDS = sizeof kinds / sizeof *kinds };

static void model_of(const struct horizon *horizon, struct model *model)
{
    *model = (struct model){0};
    for (int f = 0; f < horizon->count; f++) {
        double corners[CORNERS][3];
        for (int k = 0; k < horizon->flats[f].n; k++)
            for (int i = 0; i < 3; i++)
                corners[k][i] = (double)horizon->flats[f].at[k][i];
        tiny_add(model, (size_t)horizon->flats[f].n, (const double(*)[3])corners);
    }
}

/* What is to be seen ----------------------------------------------------------------------------- */

/* The ways from the eye to a flat's corners make planes, an edge each: what is on one side of all of them is seen
 * through the flat. */
struct seen_flat {
    long double edges[CORNERS][3], normal[3], before; /* how far its plane is, in lengths of the normal */
    int n;
    bool is_front;
};

struct truth {
    struct seen_flat flats[FLATS];
    int count;
    long double axes[3][3]; /* right, up, ahead */
    long double tan_x, tan_y, near;
    unsigned w_px, h_px;
};

static void cross_of(const int64_t a[3], const int64_t b[3], wide out[3])
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = (wide)a[j] * b[k] - (wide)a[k] * b[j];
    }
}

static void see_flat(const struct flat *flat, const int64_t eye_q8[3], struct seen_flat *out)
{
    int64_t ways_q8[CORNERS][3], sides[2][3];
    wide normal[3], before_q8 = 0;

    *out = (struct seen_flat){.n = flat->n};
    for (int k = 0; k < flat->n; k++)
        for (int i = 0; i < 3; i++)
            ways_q8[k][i] = flat->at[k][i] * UNITS_Q8 - eye_q8[i];
    for (int i = 0; i < 3; i++) {
        sides[0][i] = flat->at[1][i] - flat->at[0][i];
        sides[1][i] = flat->at[2][i] - flat->at[0][i];
    }
    cross_of(sides[0], sides[1], normal);
    for (int i = 0; i < 3; i++)
        before_q8 += normal[i] * ways_q8[0][i];
    out->is_front = before_q8 < 0;
    out->before = (long double)before_q8 / UNITS_Q8;
    for (int k = 0; k < flat->n; k++) {
        wide edge[3];
        cross_of(ways_q8[k], ways_q8[(k + 1) % flat->n], edge);
        for (int i = 0; i < 3; i++)
            out->edges[k][i] = (long double)edge[i];
    }
    for (int i = 0; i < 3; i++)
        out->normal[i] = (long double)normal[i];
}

static void truth_set(struct truth *truth, const struct horizon *horizon, const struct lim_camera *camera)
{
    int64_t eye_q8[3];

    for (int i = 0; i < 3; i++)
        eye_q8[i] = (int64_t)camera->origin[i] * UNITS_Q8 + camera->eye_q8[i];
    truth->count = horizon->count;
    for (int f = 0; f < horizon->count; f++)
        see_flat(&horizon->flats[f], eye_q8, &truth->flats[f]);
    camera_axes_set(camera, truth->axes);
    truth->tan_x = ldexpl(camera->tan_x_q28, -28);
    truth->tan_y = ldexpl(camera->tan_y_q28, -28);
    truth->near = camera->near_q8 / 256.0L;
    truth->w_px = horizon->w_px;
    truth->h_px = horizon->h_px;
}

static long double dot_of(const long double a[3], const long double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* How far ahead a ray meets a flat; infinite: it does not. */
static long double depth_of(const struct seen_flat *flat, const long double ray[3])
{
    const long double fall = dot_of(flat->normal, ray);

    if (!flat->is_front || !(fall < 0)) return INFINITY;
    for (int k = 0; k < flat->n; k++)
        if (dot_of(flat->edges[k], ray) > 0) return INFINITY;
    return flat->before / fall;
}

static void ray_at(const struct truth *truth, long double x_px, long double y_px, long double ray[3])
{
    const long double u = ((2 * x_px + 1) / truth->w_px - 1) * truth->tan_x;
    const long double v = (1 - (2 * y_px + 1) / truth->h_px) * truth->tan_y;

    for (int i = 0; i < 3; i++)
        ray[i] = truth->axes[2][i] + u * truth->axes[0][i] + v * truth->axes[1][i];
}

/* The number of the face at a place in pixels, the centre of the first one at 0. */
static uint32_t face_at(const struct truth *truth, long double x_px, long double y_px)
{
    long double ray[3], least = INFINITY;
    uint32_t face = 0;

    ray_at(truth, x_px, y_px, ray);
    for (int f = 0; f < truth->count; f++) {
        const long double depth = depth_of(&truth->flats[f], ray);
        if (!(depth >= truth->near && depth < least)) continue;
        least = depth;
        face = (uint32_t)f + 1;
    }
    return face;
}

/* Whether a ray passes no edge of a flat by more than so many pixels on its outside. No flat hides another one. */
static bool is_about(const struct truth *truth, const struct seen_flat *flat, const long double ray[3],
                     long double most_px)
{
    const long double pixel = hypotl(2 * truth->tan_x / truth->w_px, 2 * truth->tan_y / truth->h_px);

    for (int k = 0; k < flat->n; k++)
        if (dot_of(flat->edges[k], ray) > most_px * pixel * sqrtl(dot_of(flat->edges[k], flat->edges[k]))) return false;
    return flat->is_front;
}

/* Whether a ray is so near to an edge that either side may be shown: from above an edge, whole columns of pixels are.
 */
static bool is_tie(const struct truth *truth, size_t pixel, uint32_t face, uint32_t shown)
{
    const long double tie_px = 1.0L / 4096;
    long double ray[3];

    ray_at(truth, pixel % truth->w_px, (long double)(pixel / truth->w_px), ray);
    return shown ? is_about(truth, &truth->flats[shown - 1], ray, tie_px)
                 : !is_about(truth, &truth->flats[face - 1], ray, -tie_px);
}

/* What is drawn ---------------------------------------------------------------------------------- */

struct count {
    size_t pixels, frames, ground, wrong;
    size_t misplaced; /* wrong, and nowhere to be seen within a pixel */
    size_t holes;     /* of these, background */
};

static bool is_around(const struct truth *truth, size_t pixel, uint32_t face)
{
    const long double x_px = pixel % truth->w_px, y_px = (long double)(pixel / truth->w_px);
    long double ray[3];

    ray_at(truth, x_px, y_px, ray);
    if (face) return is_about(truth, &truth->flats[face - 1], ray, 1);
    for (int y = -LOOKS; y <= LOOKS; y++)
        for (int x = -LOOKS; x <= LOOKS; x++)
            if (!face_at(truth, x_px + (long double)x / LOOKS, y_px + (long double)y / LOOKS)) return true;
    return false;
}

static void count_frame(const struct truth *truth, const uint32_t *faces, struct count *count)
{
    const size_t pixels = (size_t)truth->w_px * truth->h_px;

    count->frames++;
    count->pixels += pixels;
    for (size_t pixel = 0; pixel < pixels; pixel++) {
        const uint32_t face = face_at(truth, pixel % truth->w_px, (long double)(pixel / truth->w_px));
        count->ground += face != 0;
        if (face == faces[pixel] || is_tie(truth, pixel, face, faces[pixel])) continue;
        count->wrong++;
        if (is_around(truth, pixel, faces[pixel])) continue;
        count->misplaced++;
        count->holes += !faces[pixel];
    }
}

struct drawn {
    struct mesh mesh;
    struct compiled scene;
    struct ids ids;
};

/* A unit is one of the model's. */
static void drawn_open(struct drawn *drawn, const struct horizon *horizon, const struct core *profile)
{
    const struct grid grid = {.units_per_m = 1, .is_long = true};
    const struct compile_options options = {.tolerance_units = 0.5,
                                            .splitter = "fewest",
                                            .keep_faces = true,
                                            .core = profile,
                                            .w_px = horizon->w_px,
                                            .h_px = horizon->h_px,
                                            .fov_deg = horizon->lens_deg,
                                            .coordinates = COORDINATES_32};
    const struct simulator_setup setup = {.w_px = horizon->w_px, .h_px = horizon->h_px, .core = profile};
    struct model model;
    struct error err;

    model_of(horizon, &model);
    if (!mesh_clean_on(&model, &grid, &drawn->mesh, &err) || !mesh_insert_t_vertices(&drawn->mesh, &err) ||
        !compile_mesh(&drawn->mesh, &options, &drawn->scene, &err) ||
        !ids_init(&drawn->ids, &drawn->scene, &setup, &err))
        fail_msg("%s", err.text);
    model_free(&model);
}

static void drawn_close(struct drawn *drawn)
{
    ids_free(&drawn->ids);
    compiled_free(&drawn->scene);
    mesh_free(&drawn->mesh);
}

/* Where to look from ----------------------------------------------------------------------------- */

/* Somewhere near the middle; exactly above a corner, or above an edge; or beside the ground. */
static void stand(const struct horizon *horizon, struct random *random, int64_t reach, int64_t out[2])
{
    const int64_t end = INT64_C(1) << random_in(random, 4, 16);
    const int64_t near[2] = {random_in(random, -end, end), random_in(random, -end, end)};
    const int64_t corner[2] = {random_u64(random) % 2 ? reach : -reach, random_u64(random) % 2 ? reach : -reach};
    const int u = horizon->turned, v = (2 + horizon->turned) % 3;

    switch (random_u64(random) % 5) {
    case 0: { /* above a corner that two flats may share */
        const struct flat *flat = &horizon->flats[random_u64(random) % (uint64_t)horizon->count];
        const int64_t *at = flat->at[random_u64(random) % (uint64_t)flat->n];
        out[0] = at[u], out[1] = at[v];
        break;
    }
    case 1: /* above an outer edge */
        out[0] = corner[0], out[1] = on_plane(near[1]);
        break;
    case 2: /* just inside of a corner, or outside */
        out[0] = corner[0] + near[0], out[1] = corner[1] + near[1];
        break;
    default:
        out[0] = near[0], out[1] = near[1];
    }
}

/* So far from each of three sides of a room. */
static void stand_in_room(struct random *random, int64_t reach, int64_t high_q8, struct lim_camera *camera)
{
    for (int i = 0; i < 3; i++) {
        const int64_t way_q8 =
            random_u64(random) % 4 ? random_in(random, 1, high_q8) : random_in(random, 1, reach * UNITS_Q8);
        const int64_t at_q8 = random_u64(random) % 2 ? way_q8 - reach * UNITS_Q8 : reach * UNITS_Q8 - way_q8;
        camera->origin[i] = (int32_t)(at_q8 >> 8);
        camera->eye_q8[i] = (int32_t)(at_q8 & 255);
    }
}

static uint32_t any_angle(struct random *random, uint32_t most)
{
    return (uint32_t)random_in(random, -(int64_t)most, most);
}

static void set_lens(const struct horizon *horizon, struct random *random, int64_t high_q8, struct lim_camera *camera)
{
    const double tan_y = tan(horizon->lens_deg * acos(-1) / 360),
                 tan_x = fmin(4, tan_y * horizon->w_px / horizon->h_px);
    const double least = 2.1 / (fmin(tan_x, tan_y) < 0.125 ? 0.5 : fmin(1, fmin(tan_x, tan_y)));
    const double parts[] = {0, 0.5, 0.97}, wanted = (double)high_q8 / UNITS_Q8 * parts[random_u64(random) % 3];

    camera->tan_x_q28 = (uint32_t)(ldexp(tan_x, 28) + 0.5);
    camera->tan_y_q28 = (uint32_t)(ldexp(tan_y, 28) + 0.5);
    camera->near_q8 = (int32_t)(256 * fmin(fmax(least, wanted), 14000));
}

static struct lim_camera look(const struct horizon *horizon, bool is_room, struct random *random, int64_t reach,
                              int64_t high)
{
    static const uint32_t pitches[] = {0, 1u << 24, 1u << 27, 1u << 30, 1u << 30};
    const int64_t high_q8 = high * UNITS_Q8 + (random_u64(random) % 2 ? random_in(random, 0, 255) : 0);
    struct lim_camera camera = {0};
    int64_t on[2], at[3];

    set_lens(horizon, random, high_q8, &camera);
    if (is_room) {
        stand_in_room(random, reach, high_q8, &camera);
    } else {
        stand(horizon, random, reach, on);
        place(horizon, on[0], on[1], high_q8 >> 8, at);
        for (int i = 0; i < 3; i++)
            camera.origin[i] = (int32_t)at[i];
        camera.eye_q8[(1 + horizon->turned) % 3] = (int32_t)(high_q8 & 255);
    }
    camera.yaw = random_u64(random) % 4 ? any_angle(random, UINT32_MAX / 2) : (uint32_t)random_in(random, 0, 7) << 29;
    camera.pitch = any_angle(random, pitches[random_u64(random) % 5]);
    if (random_u64(random) % 4 == 0) camera.pitch = -(1u << 30); /* straight down */
    camera.roll = random_u64(random) % 2 ? any_angle(random, UINT32_MAX / 2) : 0;
    return camera;
}

static void draw(const struct horizon *horizon, const struct kind *kind, const struct core *profile, uint64_t seed,
                 int bits, struct count *count)
{
    static const int highs[] = {0, 1, 2, 3, 4, 5, 7, 10, 15, 20};
    const int64_t reach = on_plane(INT64_C(1) << bits > GRID_END ? GRID_END : INT64_C(1) << bits);
    struct random random = {seed};
    struct drawn drawn;
    struct error err;

    drawn_open(&drawn, horizon, profile);
    for (size_t k = 0; k < sizeof highs / sizeof *highs; k++) {
        for (int f = 0; f < effort(FRAMES); f++) {
            const struct lim_camera camera = look(horizon, kind->is_room, &random, reach, INT64_C(1) << highs[k]);
            struct truth truth;
            if (highs[k] >= bits) continue;
            truth_set(&truth, horizon, &camera);
            if (!ids_frame(&drawn.ids, &camera, &err)) fail_msg("%s", err.text);
            count_frame(&truth, drawn.ids.faces, count);
        }
    }
    drawn_close(&drawn);
}

/* In percent, but of draft, which promises that nothing is missing. */
static double most_wrong(const struct core *profile)
{
    return profile->profile == LIM_PROFILE_FAST ? 0.1 : profile->profile == LIM_PROFILE_FINE ? 0.05 : 0.01;
}

static size_t judge(const char *name, const struct core *profile, const struct count *count)
{
    const double wrong = 100.0 * (double)count->wrong / (double)count->pixels;

    printf("# %s, %s: %zu pixels of %zu frames, %.0f %% ground; %zu holes, %zu misplaced, %.4f %% wrong\n", name,
           profile->name, count->pixels, count->frames, 100.0 * (double)count->ground / (double)count->pixels,
           count->holes, count->misplaced, wrong);
    return count->holes + (profile->sub_bits > 0 && (count->misplaced || wrong > most_wrong(profile)));
}

/* A picture's sides and its lens; all sizes of all kinds, flat or slanted, whichever way is up. */
static void nothing_is_missing(unsigned w_px, unsigned h_px, double lens_deg)
{
    static const int sizes[] = {16, 20, 24, 27, 29};
    const struct core *profiles[PROFILES_MAX];
    const size_t count = profiles_find(profiles);
    size_t failed = 0;

    for (size_t p = 0; p < count; p++) {
        struct random random = {211};
        for (int k = 0; k < KINDS; k++) {
            struct count sum = {0};
            for (size_t s = 0; s < 2 * sizeof sizes / sizeof *sizes; s++) {
                const int bits = sizes[s / 2];
                struct horizon horizon = {
                    .turned = (int)random_in(&random, 0, 2), .lens_deg = lens_deg, .w_px = w_px, .h_px = h_px};
                for (int i = 0; s % 2 && i < 2; i++)
                    horizon.slope[i] = random_in(&random, -20, 20);
                kinds[k].build(&horizon, &random,
                               on_plane(INT64_C(1) << bits > GRID_END ? GRID_END : INT64_C(1) << bits));
                draw(&horizon, &kinds[k], profiles[p], random_u64(&random) | 1, bits, &sum);
            }
            failed += judge(kinds[k].name, profiles[p], &sum);
        }
    }
    assert_int_equal(failed, 0);
}

static void by_an_ordinary_lens(void **state)
{
    (void)state;
    nothing_is_missing(64, 64, 60);
}

static void by_a_wide_lens(void **state)
{
    (void)state;
    nothing_is_missing(64, 64, 150);
}

static void by_a_long_lens(void **state)
{
    (void)state;
    nothing_is_missing(64, 64, 1);
}

static void on_a_wide_display(void **state)
{
    (void)state;
    nothing_is_missing(160, 20, 45);
}

static void on_a_tall_display(void **state)
{
    (void)state;
    nothing_is_missing(20, 160, 75);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(by_an_ordinary_lens), cmocka_unit_test(by_a_wide_lens),    cmocka_unit_test(by_a_long_lens),
        cmocka_unit_test(on_a_wide_display),   cmocka_unit_test(on_a_tall_display),
    };

    return cmocka_run_group_tests_name("grounds to the horizon", tests, NULL, NULL);
}
