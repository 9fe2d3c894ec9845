/* SPDX-License-Identifier: MIT
 *
 * A polygon's near / z over the screen, against the depth at which rays in double precision meet the plane of its
 * corners: of what stands still, and of movers turned anyhow, of units up to eight times as fine; any camera, screens
 * of any size.
 *
 * It may be off by what the formats say. The normal has 28 bits at least, and the plane goes through its first corner
 * and, of a mover, as if it went through its origin, too: it tilts by about 2^-27 about these. The camera's axes are
 * right to 8 units of 2^-30, which is as much. A pixel's step is cut to 2^-28, so the ray is off by that for each pixel
 * from the middle on. All this counts as often as the plane is slanted: the length of the normal times that of the ray,
 * by their product. What is stored is cut to units of 2^-30, once for each pixel to the right and down. Of a tilt the
 * worst that is found is a quarter of that standing still, and three quarters moving; twice as much is allowed. What
 * faces the eye, from no nearer than it is large, is within 2^-20 of its depth, but for the steps. */
#include "limner.h"
#include "movers/mover.h"
#include "movers/near_plane.h"
#include "rigs/camera_axes.h"
#include "rigs/cmocka_ready.h"
#include "rigs/moving_mem.h"
#include "rigs/plain_lines.h"
#include "rigs/random_camera.h"
#include "rigs/set_rig.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 200000, MOST_CORNERS = 8, OTHERS = 4, GRID_END = 32767, EYE_END = 1 << 20, LATTICE = 8 };

/* What stands still and what moves: a polygon each. */
struct stage {
    struct set scene, object;
    struct lim_instance instance;
    struct lim lim;
    struct plain_lines lines;
    uint16_t line[LIM_MAX_SIDE_PX];
    struct moving_mem mem;
};

static void stage_open(struct stage *stage)
{
    static const int16_t triangle[3][3] = {{0, 0, 0}, {90, 0, 0}, {0, 90, 0}};
    static const struct lim_movers_limits limits = {1, 1, 0, 0};

    memset(stage, 0, sizeof *stage);
    stage->lines.pixels = stage->line;
    for (int i = 0; i < 2; i++) {
        struct set *set = i ? &stage->object : &stage->scene;
        set_init(set);
        set_add(set, 1, 3, triangle);
        set->scene.limits.vertices = MOST_CORNERS;
    }
    const struct lim_target target = plain_lines_target(&stage->lines, 64, 64, LIM_NEAREST_FIRST);
    moving_mem_init(&stage->mem, &stage->lim, &stage->scene.scene, &target, &limits);
    stage->instance.object = &stage->object.scene;
    lim_instance_turn(&stage->instance, 0, 0, 0);
}

static void stage_close(struct stage *stage)
{
    moving_mem_free(&stage->mem);
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double length_of(const double v[3])
{
    return sqrt(dot(v, v));
}

static double distance(const double a[3], const double b[3])
{
    const double way[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};

    return length_of(way);
}

/* Polygons ----------------------------------------------------------------------------------- */

/* As it lies in the scene. */
struct polygon {
    int n;
    double at[MOST_CORNERS][3], middle[3], normal[3];
    double off_plane; /* how far a corner is from the plane through the middle */
    double origin[3]; /* a mover's; else its first corner */
};

/* The areas that it has along each axis, edge by edge from its middle, where products are smallest. */
static void set_plane(struct polygon *polygon)
{
    memset(polygon->middle, 0, sizeof polygon->middle);
    memset(polygon->normal, 0, sizeof polygon->normal);
    for (int k = 0; k < polygon->n; k++)
        for (int i = 0; i < 3; i++)
            polygon->middle[i] += polygon->at[k][i] / polygon->n;
    for (int k = 0; k < polygon->n; k++) {
        const double *a = polygon->at[k], *b = polygon->at[(k + 1) % polygon->n], *m = polygon->middle;
        for (int i = 0; i < 3; i++) {
            const int p = (i + 1) % 3, q = (i + 2) % 3;
            polygon->normal[i] += (a[p] - m[p]) * (b[q] - m[q]) - (a[q] - m[q]) * (b[p] - m[p]);
        }
    }
    const double length = length_of(polygon->normal), middle = dot(polygon->normal, polygon->middle);
    polygon->off_plane = 0;
    for (int k = 0; k < polygon->n; k++)
        polygon->off_plane = fmax(polygon->off_plane, fabs(dot(polygon->normal, polygon->at[k]) - middle) / length);
}

/* Some corners of an ellipse, counter-clockwise, of halves u and v. */
static void around(double at[MOST_CORNERS][2], int n, struct random *random)
{
    const double from = 6.283185307179586 * random_unit(random);

    for (int k = 0; k < n; k++) {
        const double angle = from + 6.283185307179586 * (k + 0.8 * random_unit(random)) / n;
        at[k][0] = cos(angle);
        at[k][1] = sin(angle);
    }
}

/* Of the grid: a triangle; in a plane, as well as whole units are; or exactly in a plane, of some steps along two ways.
 * false: it does not fit, or is but a line. */
static bool any_corners(int16_t corners[MOST_CORNERS][3], int *n, struct random *random)
{
    const int kind = (int)random_in(random, 0, 2);
    const int64_t reach = INT64_C(1) << random_in(random, kind == 2 ? 1 : 5, kind == 2 ? 11 : 15);
    double middle[3], u[3], v[3], part[MOST_CORNERS][2];

    *n = kind ? (int)random_in(random, 3, MOST_CORNERS) : 3;
    for (int i = 0; i < 3; i++) {
        middle[i] = (double)random_in(random, -GRID_END, GRID_END);
        u[i] = (double)random_in(random, -reach, reach);
        v[i] = (double)random_in(random, -reach, reach);
    }
    around(part, *n, random);
    for (int k = 0; k < *n; k++) {
        for (int i = 0; i < 3; i++) {
            const double x = kind == 2 ? round(LATTICE * part[k][0]) : part[k][0];
            const double y = kind == 2 ? round(LATTICE * part[k][1]) : part[k][1];
            const double at =
                kind ? round(middle[i] + x * u[i] + y * v[i]) : (double)random_in(random, -GRID_END - 1, GRID_END);
            if (fabs(at) > GRID_END) return false;
            corners[k][i] = (int16_t)at;
        }
    }
    return true;
}

/* Into a scene, as its only record. */
static void take_corners(struct set *set, const int16_t corners[MOST_CORNERS][3], int n)
{
    set->polygons[0] = (lim_index)((unsigned)n | LIM_POLYGON_PLANE | LIM_POLYGON_LAST);
    for (int k = 0; k < n; k++) {
        set->polygons[LIM_POLYGON_HEAD_WORDS + k] = (lim_index)k;
        set->vertices[k] = (struct lim_vertex){corners[k][0], corners[k][1], corners[k][2]};
    }
    set->scene.vertex_count = (lim_index)n;
}

/* Where the object's places are, in the scene. */
static void place(const struct lim_instance *instance, const int16_t v[3], double out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = instance->at_q8[i] / 256.0;
        for (int j = 0; j < 3; j++)
            out[i] += ldexp(instance->axes_q30[3 * j + i], -30 - instance->finer_bits) * v[j];
    }
}

static void place_anyhow(struct lim_instance *instance, struct random *random)
{
    const uint32_t yaw = random_angle(random), pitch = random_angle(random), roll = random_angle(random);

    lim_instance_turn(instance, yaw, pitch, roll);
    instance->finer_bits = (uint8_t)random_in(random, 0, 3);
    for (int i = 0; i < 3; i++)
        instance->at_q8[i] = (int32_t)random_in(random, -(1 << 22), 1 << 22);
}

/* false: there is none this time. */
static bool any_polygon(struct stage *stage, bool moves, struct polygon *polygon, struct random *random)
{
    int16_t corners[MOST_CORNERS][3];

    if (!any_corners(corners, &polygon->n, random)) return false;
    take_corners(moves ? &stage->object : &stage->scene, (const int16_t(*)[3])corners, polygon->n);
    if (moves) place_anyhow(&stage->instance, random);
    for (int k = 0; k < polygon->n; k++)
        for (int i = 0; i < 3; i++)
            polygon->at[k][i] = corners[k][i];
    for (int k = 0; moves && k < polygon->n; k++)
        place(&stage->instance, corners[k], polygon->at[k]);
    for (int i = 0; i < 3; i++)
        polygon->origin[i] = moves ? stage->instance.at_q8[i] / 256.0 : polygon->at[0][i];
    set_plane(polygon);
    return length_of(polygon->normal) > 0;
}

static void any_place(const struct polygon *polygon, struct random *random, double at[3])
{
    double parts[MOST_CORNERS], sum = 0;

    for (int k = 0; k < polygon->n; k++)
        sum += parts[k] = random_unit(random) + 1e-3;
    for (int i = 0; i < 3; i++) {
        at[i] = 0;
        for (int k = 0; k < polygon->n; k++)
            at[i] += polygon->at[k][i] * parts[k] / sum;
    }
}

/* Cameras ------------------------------------------------------------------------------------ */

struct look {
    struct lim_camera camera;
    int w_px, h_px;
    double right[3], down[3], ahead[3], eye[3], near;
};

static void ray_through(const struct look *look, int x_px, int y_px, double ray[3])
{
    const double x = ldexp(look->camera.tan_x_q28, -28) * (2 * x_px + 1 - look->w_px) / look->w_px;
    const double y = ldexp(look->camera.tan_y_q28, -28) * (2 * y_px + 1 - look->h_px) / look->h_px;

    for (int i = 0; i < 3; i++)
        ray[i] = look->ahead[i] + x * look->right[i] + y * look->down[i];
}

/* Some pixel of it shows a place of the polygon, at any distance behind the near plane. false: none, from there. */
static bool any_look(struct look *look, const struct polygon *polygon, struct random *random, int pixel[2])
{
    const int near_bits = (int)random_in(random, 0, 14), far_bits = (int)random_in(random, 0, 16);
    long double axes[3][3];
    double ray[3], at[3];

    *look = (struct look){.w_px = (int)random_in(random, 1, LIM_MAX_SIDE_PX), .h_px = (int)random_in(random, 1, 320)};
    struct lim_camera *const camera = &look->camera;
    camera->near_q8 = (int32_t)random_in(random, 1, INT64_C(1) << near_bits);
    camera->yaw = random_angle(random);
    camera->pitch = random_angle(random);
    camera->roll = random_angle(random);
    camera->tan_x_q28 = random_tan_q28(random);
    camera->tan_y_q28 = random_in(random, 0, 1) ? camera->tan_x_q28 : random_tan_q28(random);
    look->near = (camera->near_q8 > 256 ? camera->near_q8 : 256) / 256.0;
    camera_axes_set(camera, axes);
    for (int i = 0; i < 3; i++) {
        look->right[i] = (double)axes[0][i];
        look->down[i] = (double)-axes[1][i];
        look->ahead[i] = (double)axes[2][i];
    }
    pixel[0] = (int)random_in(random, 0, look->w_px - 1);
    pixel[1] = (int)random_in(random, 0, look->h_px - 1);
    ray_through(look, pixel[0], pixel[1], ray);
    any_place(polygon, random, at);
    const double away = look->near * (1.01 + ldexp(random_unit(random), far_bits));
    for (int i = 0; i < 3; i++) {
        const double eye = at[i] - away * ray[i];
        if (fabs(eye) >= EYE_END) return false;
        camera->eye_q8[i] = (int32_t)lround(eye * 256);
        look->eye[i] = camera->eye_q8[i] / 256.0;
    }
    return true;
}

/* Comparing ---------------------------------------------------------------------------------- */

struct found {
    size_t pixels, facing, grazing; /* facing: within 60 degrees; grazing: not compared */
    double worst;                   /* of the tilt that it may have */
    double worst_facing;            /* of a depth: of what faces the eye, from no nearer than its size */
};

/* Whether it is on the same side of all edges, in its plane. */
static bool is_within(const struct polygon *polygon, const double at[3])
{
    for (int k = 0; k < polygon->n; k++) {
        const double *a = polygon->at[k], *b = polygon->at[(k + 1) % polygon->n];
        double side = 0;
        for (int i = 0; i < 3; i++) {
            const int p = (i + 1) % 3, q = (i + 2) % 3;
            side += polygon->normal[i] * ((b[p] - a[p]) * (at[q] - a[q]) - (b[q] - a[q]) * (at[p] - a[p]));
        }
        if (side < 0) return false;
    }
    return true;
}

static void compare(struct found *found, const struct lim_near_plane *plane, const struct polygon *polygon,
                    const struct look *look, int x_px, int y_px)
{
    const double length = length_of(polygon->normal);
    double ray[3], at[3], from_middle[3];

    ray_through(look, x_px, y_px, ray);
    for (int i = 0; i < 3; i++)
        from_middle[i] = look->eye[i] - polygon->middle[i];
    const double before = dot(polygon->normal, from_middle), along = -dot(polygon->normal, ray);
    const double z = before / along;
    if (!(z >= look->near)) return;
    for (int i = 0; i < 3; i++)
        at[i] = look->eye[i] + z * ray[i];
    if (!is_within(polygon, at)) return;
    const double away = z * length_of(ray), slant = length * length_of(ray) / fabs(along);
    const double reach = distance(at, polygon->at[0]) + distance(at, polygon->origin) + 1;
    const double lens = hypot(x_px + 0.5 - look->w_px / 2.0, y_px + 0.5 - look->h_px / 2.0) / length_of(ray);
    const double known = 1.001 * slant * (ldexp(lens, -28) + polygon->off_plane / away); /* 1 / (1 - 2^-10) */
    const double tilt = slant * ldexp(1 + reach / away, -27);
    if (known + tilt > ldexp(1, -10)) {
        found->grazing++;
        return;
    }
    const double expected_q30 = ldexp(look->near / z, 30);
    const struct lim_near_row row = lim_near_row_of(plane, y_px);
    const lim_near_word found_q30 = row.at_q30 + row.x_q30 * (uint32_t)x_px;
    const uint32_t difference = (uint32_t)found_q30 - (uint32_t)llround(expected_q30);
    const double off_q30 = fabs((double)(int32_t)difference), steps = 3 + x_px + y_px;
    found->pixels++;
    found->worst = fmax(found->worst, (off_q30 - steps - known * expected_q30) / (tilt * expected_q30));
    if (slant > 2 || reach > away || known > ldexp(1, -22)) return;
    found->facing++;
    found->worst_facing = fmax(found->worst_facing, (off_q30 - steps) / expected_q30);
}

static struct found compare_many(bool moves, uint64_t seed)
{
    static struct stage stage;
    struct random random = {seed};
    struct found found = {0};

    stage_open(&stage);
    struct lim_movers *const movers = stage.lim.movers;
    for (int round = 0; round < ROUNDS; round++) {
        struct lim_near_plane plane;
        struct polygon polygon;
        struct look look;
        int pixel[2];
        if (!any_polygon(&stage, moves, &polygon, &random) || !any_look(&look, &polygon, &random, pixel)) continue;
        stage.lim.pass.target.w_px = (uint16_t)look.w_px;
        stage.lim.pass.target.h_px = (uint16_t)look.h_px;
        movers->instances = &stage.instance;
        movers->given = movers->count = 1;
        lim_movers_pose(movers, &stage.lim.pass, &look.camera);
        if (moves && movers->movers[0].radius_q12 < 0) continue; /* too far away */
        lim_near_plane_set(&plane, movers, &stage.lim.pass,
                           &(struct lim_met_polygon){moves ? 0 : (uint16_t)LIM_NONE, 0, 0});
        compare(&found, &plane, &polygon, &look, pixel[0], pixel[1]);
        for (int k = 0; k < OTHERS; k++)
            compare(&found, &plane, &polygon, &look, (int)random_in(&random, 0, look.w_px - 1),
                    (int)random_in(&random, 0, look.h_px - 1));
    }
    stage_close(&stage);
    print_message("# %s: %zu pixels, %zu more grazing; at most %.3f of a tilt; of %zu facing %.3g of a depth\n",
                  moves ? "moving" : "still", found.pixels, found.grazing, found.worst, found.facing,
                  found.worst_facing);
    assert_true(found.pixels > ROUNDS / 4 && found.facing > ROUNDS / 100);
    return found;
}

static void what_stands_still_is_where_rays_meet_it(void **state)
{
    (void)state;
    const struct found found = compare_many(false, 901);
    assert_true(found.worst < 0.5);
    assert_true(found.worst_facing < ldexp(1, -20));
}

static void what_moves_is_where_rays_meet_it(void **state)
{
    (void)state;
    const struct found found = compare_many(true, 902);
    assert_true(found.worst < 1.5);
    assert_true(found.worst_facing < ldexp(1, -20));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_stands_still_is_where_rays_meet_it),
        cmocka_unit_test(what_moves_is_where_rays_meet_it),
    };

    return cmocka_run_group_tests_name("near_plane", tests, NULL, NULL);
}
