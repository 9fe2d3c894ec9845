/* SPDX-License-Identifier: MIT
 *
 * Rays, boxes and walkers in any valid scene, and cameras that look at any point. Polygons here are not on their
 * planes, so what is promised of true ones is not asked: only that what comes out is in range, and that who is refused
 * has not moved. */
#include "camera.h"
#include "collide.h"
#include "eye.h"
#include "fuzz_scene.h"
#include "scene/lim_check.h"

#include <stdlib.h>
#include <string.h>

enum { TURNS = 4, ROUNDING_Q8 = 4, SKIN_MOST_Q8 = 4 * LIM_SKIN_Q8 };

static int32_t any_size(struct fuzz_bytes *bytes)
{
    return (int32_t)fuzz_u32(bytes) >> fuzz_below(bytes, 32);
}

/* Near one of the vertices, or anywhere. */
static void make_point(int32_t at_q8[3], const struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    const bool is_near = fuzz_below(bytes, 4);
    const struct lim_vertex *vertex = &made->vertices[fuzz_below(bytes, made->scene.vertex_count)];
    const int32_t middle_q8[3] = {vertex->x * 256, vertex->y * 256, vertex->z * 256};

    for (int i = 0; i < 3; i++)
        at_q8[i] = is_near ? middle_q8[i] + any_size(bytes) / 256 : any_size(bytes);
}

static bool is_beyond(const int32_t at_q8[3], int32_t end_q8)
{
    for (int i = 0; i < 3; i++)
        if (at_q8[i] >= end_q8 || at_q8[i] <= -end_q8) return true;
    return false;
}

static bool is_between(const struct lim_hit *hit, const int32_t a_q8[3], const int32_t b_q8[3], int32_t more_q8)
{
    for (int i = 0; i < 3; i++) {
        const int32_t low = a_q8[i] < b_q8[i] ? a_q8[i] : b_q8[i], high = a_q8[i] < b_q8[i] ? b_q8[i] : a_q8[i];
        if (hit->at_q8[i] < low - more_q8 || hit->at_q8[i] > high + more_q8) return false;
    }
    return hit->part_q30 <= UINT32_C(1) << 30;
}

static const char *check_hit(const struct lim_solid *solid, const struct lim_hit *hit)
{
    if (hit->record >= solid->scene->polygon_words) return "what was met is no polygon";
    return hit->normal[0] || hit->normal[1] || hit->normal[2] ? NULL : "a normal without length";
}

static const char *trace(const struct lim_solid *solid, const int32_t ends_q8[2][3], uint8_t flags)
{
    const bool is_out = is_beyond(ends_q8[0], LIM_EYE_MAX_Q8) || is_beyond(ends_q8[1], LIM_EYE_MAX_Q8);
    struct lim_hit hit;
    const int met = lim_trace(solid, ends_q8[0], ends_q8[1], flags, &hit);

    if (is_out) return met == LIM_ERR_CAMERA ? NULL : "a ray out of range was taken";
    if (met < 0 || met > 1) return "a ray was refused";
    if (!met) return NULL;
    if (!is_between(&hit, ends_q8[0], ends_q8[1], ROUNDING_Q8)) return "a ray met what is not on its way";
    return check_hit(solid, &hit);
}

static const char *sweep(const struct lim_solid *solid, const int32_t half_q8[3], const int32_t ends_q8[2][3],
                         uint8_t flags)
{
    struct lim_hit hit;
    const int met = lim_sweep(solid, half_q8, ends_q8[0], ends_q8[1], flags, &hit);

    if (met == LIM_ERR_CAMERA) return NULL;
    if (met < 0 || met > 1) return "a box was refused";
    if (!is_between(&hit, ends_q8[0], ends_q8[1], SKIN_MOST_Q8)) return "a box left its way";
    return met ? check_hit(solid, &hit) : NULL;
}

static const char *slide(const struct lim_solid *solid, const int32_t half_q8[3], const int32_t from_q8[3],
                         const int32_t way_q8[3], uint8_t flags)
{
    int32_t at_q8[3] = {from_q8[0], from_q8[1], from_q8[2]};
    const int stopped = lim_slide(solid, half_q8, at_q8, way_q8, flags);

    if (stopped == LIM_ERR_CAMERA)
        return memcmp(at_q8, from_q8, sizeof at_q8) ? "a box that was refused has moved" : NULL;
    return stopped < 0 || stopped > LIM_SLIDES ? "a box slid too often" : NULL;
}

static const char *walk(const struct lim_solid *solid, struct fuzz_bytes *bytes, struct lim_walker *walker)
{
    const uint8_t near_by = fuzz_below(bytes, 3);

    walker->radius_q8 = 1 + (int32_t)(fuzz_u32(bytes) % LIM_HALF_MAX_Q8 >> fuzz_below(bytes, 24));
    walker->height_q8 = 1 + (int32_t)(fuzz_u32(bytes) % LIM_HALF_MAX_Q8 >> fuzz_below(bytes, 24));
    walker->step_q8 = near_by ? fuzz_u16(bytes) % walker->height_q8 : any_size(bytes);
    walker->gravity_q8 = near_by ? fuzz_u16(bytes) : any_size(bytes);
    for (int turn = 0; turn < TURNS; turn++) {
        const struct lim_walker before = *walker;
        const int32_t x_q8 = near_by ? (int16_t)fuzz_u16(bytes) : any_size(bytes);
        const int32_t z_q8 = near_by ? (int16_t)fuzz_u16(bytes) : any_size(bytes);
        const int err = lim_walker_move(solid, walker, x_q8, z_q8);
        if (err == LIM_ERR_CAMERA && memcmp(before.at_q8, walker->at_q8, sizeof before.at_q8))
            return "a walker that was refused has moved";
        if (err && err != LIM_ERR_CAMERA) return "a walker was refused";
    }
    return NULL;
}

/* Angles are any; but the camera is where it should be. */
static const char *look(struct fuzz_bytes *bytes, const int32_t eye_q8[3], const int32_t target_q8[3])
{
    struct lim_camera camera = {.yaw = fuzz_u32(bytes)};
    int32_t eye[3], target[3];

    lim_look_at(&camera, eye_q8, target_q8);
    if (memcmp(camera.eye_q8, eye_q8, sizeof camera.eye_q8)) return "a camera is not where it was put";
    lim_orbit(&camera, target_q8, any_size(bytes), fuzz_u32(bytes), fuzz_u32(bytes));
    for (int i = 0; i < 3; i++) {
        eye[i] = eye_q8[i] / 2;
        target[i] = target_q8[i] / 2;
    }
    lim_look_at_far(&camera, eye, target);
    if (memcmp(camera.origin, eye, sizeof eye)) return "a far camera is not where it was put";
    lim_orbit_far(&camera, target, any_size(bytes) / 2, fuzz_u32(bytes), fuzz_u32(bytes));
    return NULL;
}

static const char *touch(const struct lim_solid *solid, const struct fuzz_scene *made, struct fuzz_bytes *bytes)
{
    const uint8_t flags = fuzz_below(bytes, 2) ? LIM_STOP_BACKS : 0;
    struct lim_walker walker = {.fall_q8 = (int16_t)fuzz_u16(bytes)};
    int32_t ends_q8[2][3], half_q8[3], way_q8[3];
    const char *broken;

    for (int i = 0; i < 2; i++)
        make_point(ends_q8[i], made, bytes);
    for (int i = 0; i < 3; i++) {
        half_q8[i] = any_size(bytes) % LIM_HALF_MAX_Q8;
        way_q8[i] = any_size(bytes);
        walker.at_q8[i] = ends_q8[0][i];
    }
    if ((broken = trace(solid, ends_q8, flags))) return broken;
    if ((broken = sweep(solid, half_q8, ends_q8, flags))) return broken;
    if ((broken = slide(solid, half_q8, ends_q8[0], way_q8, flags))) return broken;
    if ((broken = walk(solid, bytes, &walker))) return broken;
    return look(bytes, ends_q8[0], ends_q8[1]);
}

static const char *run(const uint8_t *input, size_t size_b)
{
    struct fuzz_bytes bytes = {input, size_b};
    struct fuzz_scene made;
    struct lim_solid solid;
    struct error err;

    fuzz_scene_make(&made, &bytes);
    if (!lim_check(&made.scene, &err)) return "a valid scene was refused";
    const size_t mem_b = made.scene.limits.depth * sizeof(lim_index);
    lim_index *mem = malloc(mem_b ? mem_b : 1); /* to the byte */
    const char *broken = !mem || lim_solid_init(&solid, &made.scene, mem, mem_b) ? "a scene was refused" : NULL;
    if (!broken) broken = touch(&solid, &made, &bytes);
    free(mem);
    return broken;
}

const struct fuzz_target fuzz_touch = {"touch", run, NULL};
