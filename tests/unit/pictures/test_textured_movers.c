/* SPDX-License-Identifier: MIT
 *
 * What moves shows textures. An object that is moved by whole units is drawn as it is when it stands alone and the eye
 * is moved the other way: the same pixels. One that is turned, behind doorways and through planes, is compared with
 * rays in double precision, texel by texel. In all profiles, nearest first and by scan lines. */
#include "base/grow.h"
#include "core/core.h"
#include "model/pose.h"
#include "rigs/cmocka_ready.h"
#include "rigs/mover_rig.h"
#include "rigs/profiles.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE_PX = 16, PIXELS = MOVER_RIG_W_PX * MOVER_RIG_H_PX };
static const struct lens LENS = {.tan_x = 0.8, .tan_y = 0.6, .near_m = 0.02};
static const double BOX_M = 0.5;

enum look { OPAQUE, MASKED, SKY, LOOKS };

/* Red to the right, green down: each texel has a colour of its own. MASKED: every other square of 4 x 4 is clear. */
static void add_picture(struct model *model, enum look look)
{
    model->pictures = grow_zeroed(1, sizeof *model->pictures);
    model->picture_count = 1;
    struct picture *picture = model->pictures;
    strcpy(picture->name, "gradient");
    picture->found_w_px = picture->w_px = picture->found_h_px = picture->h_px = SIDE_PX;
    picture->pixels = grow_zeroed(SIDE_PX * SIDE_PX, sizeof *picture->pixels);
    for (uint32_t i = 0; i < SIDE_PX * SIDE_PX; i++)
        picture->pixels[i] = (i % SIDE_PX * 17) << 16 | (i / SIDE_PX * 17) << 8;
    for (uint32_t i = 0; look == MASKED && i < SIDE_PX * SIDE_PX; i++)
        picture->pixels[i] |= (i / 4 + i / SIDE_PX / 4) % 2 ? PICTURE_CLEAR : 0;
    picture->is_masked = look == MASKED;
    if (look == SKY) picture->sky = (struct sky_look){.times = 2, .horizon = 0.5};
}

/* Affine in space, and over no face of a box in one direction alone; within one picture. */
static void place_of(const double at_m[3], double uv[2])
{
    uv[0] = 0.5 + 0.5 * at_m[0] + 0.3 * at_m[2];
    uv[1] = 0.5 + 0.5 * at_m[1] - 0.25 * at_m[2];
}

/* All that moves shows the picture. */
static void add_texture(struct model *model, enum look look)
{
    add_picture(model, look);
    model->uvs = grow_zeroed(model->point_count, sizeof *model->uvs);
    for (size_t i = 0; i < model->point_count; i++)
        place_of(model->points[i], model->uvs[i]);
    for (size_t i = 0; i < model->face_count; i++) {
        if (!model->faces[i].mover) continue;
        model->faces[i].picture = 1;
        model->faces[i].colour = 0xFFFFFF;
        model->faces[i].transparency = picture_transparency(&model->pictures[0]);
        model->pictures[0].faces++;
    }
}

static void draw(const struct lim_scene *scene, struct moving *moving, const struct simulator_setup *setup,
                 const struct lim_camera *camera, uint16_t *pixels)
{
    struct simulator simulator;
    struct error err;
    if (!simulator_init(&simulator, scene, setup, &err) ||
        (moving && !simulator_set_movers(&simulator, moving->instances, moving->count, &moving->limits, &err)) ||
        !simulator_frame(&simulator, camera, &err))
        fail_msg("%s", err.text);
    memcpy(pixels, simulator.pixels, PIXELS * sizeof *pixels);
    simulator_free(&simulator);
}

static void look(const struct mover_rig *rig, const double eye_m[3], const double target_m[3], struct lim_camera *out)
{
    struct viewpoint viewpoint = {.line = 1};
    struct error err;
    memcpy(viewpoint.eye_m, eye_m, sizeof viewpoint.eye_m);
    memcpy(viewpoint.target_m, target_m, sizeof viewpoint.target_m);
    const struct camera_path path = {"test", &viewpoint, 1};
    if (!camera_path_to_camera(&path, 0, &LENS, &rig->scene.grid, out, &err)) fail_msg("%s", err.text);
}

static const enum lim_method METHODS[] = {LIM_NEAREST_FIRST, LIM_SCANLINE};
enum { METHOD_COUNT = sizeof METHODS / sizeof *METHODS };

/* Coordinates of *rig are as they are to be; all else of it begins. */
static void compile(struct mover_rig *rig, bool doorway, const struct model_pose *pose, enum look look,
                    enum lim_method method, const struct core *core)
{
    *rig = (struct mover_rig){.coordinates = rig->coordinates};
    rig->tree = TREE_BSP;
    mover_rig_add_rooms(rig, doorway);
    mover_rig_add_box(rig, BOX_M, BOX_M, BOX_M, pose);
    add_texture(&rig->model, look);
    mover_rig_compile(rig, method, core);
    assert_non_null(rig->moving.objects[0].words);
}

/* Moved by whole units ------------------------------------------------------------------------ */

/* The eye, in the object's units, and its near plane. */
static void enter(const struct lim_instance *instance, const struct lim_camera *camera, struct lim_camera *own)
{
    *own = *camera;
    for (int i = 0; i < 3; i++)
        own->eye_q8[i] = (camera->eye_q8[i] - instance->at_q8[i]) * (1 << instance->finer_bits);
    own->near_q8 = camera->near_q8 << instance->finer_bits;
}

/* Through holes the room is seen. */
static size_t assert_as_alone(enum look shown, enum lim_method method, const struct core *core)
{
    static uint16_t moved[PIXELS], alone[PIXELS], room[PIXELS];
    const struct model_pose pose = {{0.25, 1.25, 2}, {0, 0, 0, 1}};
    const struct simulator_setup setup = {MOVER_RIG_W_PX, MOVER_RIG_H_PX, method, SIMULATOR_MEMORY, core};
    const struct simulator_setup plain = {MOVER_RIG_W_PX, MOVER_RIG_H_PX, LIM_NEAREST_FIRST, SIMULATOR_MEMORY, core};
    struct mover_rig rig = {.coordinates = COORDINATES_16};
    struct lim_camera camera, own;
    size_t seen = 0, holes = 0;
    compile(&rig, true, &pose, shown, method, core);
    look(&rig, (double[]){-1.5, 2, 3.4}, (double[]){0.25, 1.2, 2}, &camera);
    draw(&rig.scene.scene, NULL, &plain, &camera, room);
    draw(&rig.scene.scene, &rig.moving, &setup, &camera, moved);
    enter(&rig.moving.instances[0], &camera, &own);
    draw(&rig.moving.objects[0].scene.scene, NULL, &plain, &own, alone);
    mover_rig_view(&rig, (double[]){-1.5, 2, 3.4}, (double[]){0.25, 1.2, 2});
    for (size_t i = 0; i < PIXELS; i++) {
        if (!rig.ids.faces[i] || !rig.moving.model.faces[rig.ids.faces[i] - 1].mover) continue;
        seen++;
        holes += moved[i] == room[i];
        if (moved[i] != alone[i] && (shown != MASKED || moved[i] != room[i]))
            fail_msg("%s: pixel %zu, %zu is %04x, alone %04x", core->name, i % MOVER_RIG_W_PX, i / MOVER_RIG_W_PX,
                     moved[i], alone[i]);
    }
    mover_rig_free(&rig);
    assert_true(shown == MASKED ? holes * 4 > seen && holes * 4 < 3 * seen : holes * 100 < seen);
    return seen;
}

static void what_moves_by_whole_units_is_as_it_stands_alone(void **state)
{
    (void)state;
    for (size_t i = 0; cores[i]; i++)
        for (size_t k = 0; k < METHOD_COUNT; k++)
            for (enum look look = OPAQUE; look < LOOKS; look++)
                assert_true(assert_as_alone(look, METHODS[k], cores[i]) > 1000);
}

/* Turned ------------------------------------------------------------------------------------- */

/* Where a ray enters the box, in its coordinates. */
static bool meets_box(const double eye_m[3], const double way[3], double at_m[3])
{
    double begin = 0, end = INFINITY;
    for (int i = 0; i < 3; i++) {
        const double a = (-BOX_M - eye_m[i]) / way[i], b = (BOX_M - eye_m[i]) / way[i];
        begin = fmax(begin, fmin(a, b));
        end = fmin(end, fmax(a, b));
    }
    for (int i = 0; i < 3; i++)
        at_m[i] = eye_m[i] + begin * way[i];
    return begin > 0 && begin < end;
}

/* Away from edges the shown texel is the one that the ray meets, or a neighbour, in whichever level. */
static size_t assert_texels(const struct mover_rig *rig, const struct model_pose *pose, const uint16_t *pixels,
                            const double eye_m[3], const double target_m[3])
{
    double ahead[3], right[3], up[3], own_eye_m[3], axes[3][3];
    size_t seen = 0, off = 0;
    const double length =
        sqrt(pow(target_m[0] - eye_m[0], 2) + pow(target_m[1] - eye_m[1], 2) + pow(target_m[2] - eye_m[2], 2));
    for (int i = 0; i < 3; i++)
        ahead[i] = (target_m[i] - eye_m[i]) / length;
    const double level = hypot(ahead[0], ahead[2]);
    right[0] = -ahead[2] / level, right[1] = 0, right[2] = ahead[0] / level;
    for (int i = 0; i < 3; i++)
        up[i] = right[(i + 1) % 3] * ahead[(i + 2) % 3] - right[(i + 2) % 3] * ahead[(i + 1) % 3];
    pose_enter(pose, eye_m, own_eye_m);
    pose_axes(pose, axes);
    for (size_t i = 0; i < PIXELS; i++) {
        const uint32_t face = rig->ids.faces[i];
        double way[3], own_way[3], at_m[3], uv[2];
        if (!face || !rig->moving.model.faces[face - 1].mover) continue;
        const double x = LENS.tan_x * (2 * (double)(i % MOVER_RIG_W_PX) + 1 - MOVER_RIG_W_PX) / MOVER_RIG_W_PX;
        const double y = LENS.tan_y * (2 * (double)(i / MOVER_RIG_W_PX) + 1 - MOVER_RIG_H_PX) / MOVER_RIG_H_PX;
        for (int k = 0; k < 3; k++)
            way[k] = ahead[k] + x * right[k] - y * up[k];
        for (int k = 0; k < 3; k++)
            own_way[k] = axes[k][0] * way[0] + axes[k][1] * way[1] + axes[k][2] * way[2];
        if (!meets_box(own_eye_m, own_way, at_m)) continue;
        place_of(at_m, uv);
        const double red = (pixels[i] >> 11) / 31.0, green = (pixels[i] >> 5 & 63) / 63.0;
        seen++;
        off += fabs(red - (uv[0] * SIDE_PX - 0.5) / (SIDE_PX - 1)) > 0.13 ||
               fabs(green - (uv[1] * SIDE_PX - 0.5) / (SIDE_PX - 1)) > 0.13;
    }
    if (off * 50 > seen) fail_msg("%zu of %zu pixels show other texels", off, seen);
    return seen;
}

static size_t assert_turned(enum lim_method method, const struct core *core, enum coordinates coordinates)
{
    static uint16_t pixels[PIXELS];
    static const double eyes_m[][3] = {{-1.5, 2, 3.4}, {0.3, 1.4, 3.2}, {1.9, 0.6, 2.6}};
    const struct model_pose pose = mover_rig_pose(0.1, 1.1, 0.35, (double[]){0.4, 1, -0.3}, 0.8); /* in the doorway */
    const struct simulator_setup setup = {MOVER_RIG_W_PX, MOVER_RIG_H_PX, method, SIMULATOR_MEMORY, core};
    struct mover_rig rig = {.coordinates = coordinates};
    struct lim_camera camera;
    size_t seen = 0;
    compile(&rig, true, &pose, OPAQUE, method, core);
    assert_int_equal(rig.scene.grid.is_long, coordinates == COORDINATES_32);
    for (size_t i = 0; i < sizeof eyes_m / sizeof *eyes_m; i++) {
        look(&rig, eyes_m[i], pose.at_m, &camera);
        draw(&rig.scene.scene, &rig.moving, &setup, &camera, pixels);
        mover_rig_view(&rig, eyes_m[i], pose.at_m);
        seen += assert_texels(&rig, &pose, pixels, eyes_m[i], pose.at_m);
    }
    mover_rig_free(&rig);
    return seen;
}

static void what_is_turned_and_cut_shows_the_texels_that_rays_meet(void **state)
{
    (void)state;
    for (size_t i = 0; cores[i]; i++)
        for (size_t k = 0; k < METHOD_COUNT; k++)
            for (enum coordinates bits = COORDINATES_16; bits <= COORDINATES_32; bits++)
                assert_true(assert_turned(METHODS[k], cores[i], bits) > 2000);
}

/* -------------------------------------------------------------------------------------------- */

/* An object with textures of its own has the colours of its records: no index means anything there. */
static void textures_of_others_are_not_shown(void **state)
{
    (void)state;
    static uint16_t pixels[PIXELS], flat[PIXELS];
    const struct model_pose pose = {{0.25, 1.25, 2}, {0, 0, 0, 1}};
    const struct simulator_setup setup = {MOVER_RIG_W_PX, MOVER_RIG_H_PX, LIM_NEAREST_FIRST, SIMULATOR_MEMORY, NULL};
    struct mover_rig rig = {.coordinates = COORDINATES_16};
    struct lim_camera camera;
    compile(&rig, false, &pose, OPAQUE, LIM_NEAREST_FIRST, NULL);
    look(&rig, (double[]){-1.5, 2, 3.4}, pose.at_m, &camera);
    struct lim_texture *const other = grow_zeroed(rig.scene.scene.texture_count, sizeof *other);
    rig.moving.objects[0].scene.scene.textures = other;
    draw(&rig.scene.scene, &rig.moving, &setup, &camera, pixels);
    rig.moving.objects[0].scene.scene.texture_count = 0;
    draw(&rig.scene.scene, &rig.moving, &setup, &camera, flat);
    assert_memory_equal(pixels, flat, sizeof flat);
    free(other);
    mover_rig_free(&rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_moves_by_whole_units_is_as_it_stands_alone),
        cmocka_unit_test(what_is_turned_and_cut_shows_the_texels_that_rays_meet),
        cmocka_unit_test(textures_of_others_are_not_shown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
