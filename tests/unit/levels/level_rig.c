/* SPDX-License-Identifier: MIT */
#include "unit/levels/level_rig.h"

#include "levels/level_import.h"
#include "rigs/cmocka_ready.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char folder[] = "/tmp/limner-level-XXXXXX";
struct wad_writer level_wad;
struct wad_map level_map;

int level_enter(void **state)
{
    (void)state;
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

int level_leave(void **state)
{
    (void)state;
    (void)unlink("a.wad");
    (void)unlink("b.wad");
    return chdir("/") == 0 && rmdir(folder) == 0 ? 0 : -1;
}

int level_begin(void **state)
{
    (void)state;
    memset(&level_map, 0, sizeof level_map);
    return 0;
}

void level_save(const char *name)
{
    wad_begin(&level_wad, "IWAD");
    wad_write_map(&level_wad, name, &level_map);
    wad_write_looks(&level_wad);
    wad_end(&level_wad);
    wad_save(&level_wad, "a.wad");
}

struct model level_imported(const char *path, bool is_textured)
{
    struct model model;
    struct error err = {""};
    if (!level_import(path, is_textured, &model, &err)) fail_msg("%s", err.text);
    assert_string_equal(model.notice, "");
    return model;
}

struct model level_saved(void)
{
    level_save("MAP01");
    return level_imported("a.wad:MAP01", true);
}

/* Faces -------------------------------------------------------------------------------------- */

const double *level_corner_at(const struct model *model, const struct model_face *face, uint32_t k)
{
    return model->points[model->corners[face->first + k % face->count]];
}

const double *level_uv(const struct model *model, const struct model_face *face, uint32_t k)
{
    return model->uvs[model->corners[face->first + k]];
}

/* Twice the area, by axes: the direction that a face looks. */
void level_normal(const struct model *model, const struct model_face *face, double out[3])
{
    memset(out, 0, 3 * sizeof *out);
    for (uint32_t k = 0; k < face->count; k++) {
        const double *p = level_corner_at(model, face, k), *q = level_corner_at(model, face, k + 1);
        for (int i = 0; i < 3; i++)
            out[i] += p[(i + 1) % 3] * q[(i + 2) % 3] - p[(i + 2) % 3] * q[(i + 1) % 3];
    }
}

/* The wall that looks that way, between two heights in units; NULL: there is none. */
const struct model_face *level_wall(const struct model *model, double x, double z, int low, int high)
{
    for (size_t i = 0; i < model->face_count; i++) {
        const struct model_face *face = &model->faces[i];
        double normal[3], least = INFINITY, most = -INFINITY;
        level_normal(model, face, normal);
        for (uint32_t k = 0; k < face->count; k++) {
            least = fmin(least, level_corner_at(model, face, k)[1]);
            most = fmax(most, level_corner_at(model, face, k)[1]);
        }
        if (normal[0] * x + normal[2] * z > 0 && normal[0] * z == normal[2] * x && fabs(normal[1]) < 1e-9 &&
            least * 32 == low && most * 32 == high)
            return face;
    }
    return NULL;
}

const struct model_face *level_need_wall(const struct model *model, double x, double z, int low, int high)
{
    const struct model_face *face = level_wall(model, x, z, low, high);
    if (!face) fail_msg("no wall looks to %g, %g from %d to %d", x, z, low, high);
    return face;
}

const char *level_picture_of(const struct model *model, const struct model_face *face)
{
    return face->picture ? model->pictures[face->picture - 1].name : "";
}

/* Rays --------------------------------------------------------------------------------------- */

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Twice the area of a corner's triangle, by axes. */
static void cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* Whether a ray passes through the convex face, on whichever side: its edges all turn the same way round it. */
static bool is_hit(const struct model *model, const struct model_face *face, const double eye[3], const double way[3])
{
    int turns = 0;
    for (uint32_t k = 0; k < face->count; k++) {
        double a[3], b[3], normal[3];
        for (int i = 0; i < 3; i++) {
            a[i] = level_corner_at(model, face, k)[i] - eye[i];
            b[i] = level_corner_at(model, face, k + 1)[i] - eye[i];
        }
        cross(a, b, normal);
        const int turn = dot(normal, way) > 0 ? 1 : -1;
        if (turns && turn != turns) return false;
        turns = turn;
    }
    return true;
}

/* Above 0: the nearest face that the ray meets shows its front; below, its back; 0: there is none. */
static double seen(const struct model *model, const double eye[3], const double way[3])
{
    double nearest = INFINITY, front = 0;
    for (size_t i = 0; i < model->face_count; i++) {
        const struct model_face *face = &model->faces[i];
        double normal[3], there[3];
        level_normal(model, face, normal);
        for (int k = 0; k < 3; k++)
            there[k] = level_corner_at(model, face, 0)[k] - eye[k];
        const double distance = dot(normal, there) / dot(normal, way);
        if (face->transparency || !(distance > 0 && distance < nearest) || !is_hit(model, face, eye, way)) continue;
        nearest = distance;
        front = -dot(normal, way);
    }
    return front;
}

bool level_is_closed(const struct model *model, const double eye_m[3], int rays, struct random *random)
{
    for (int i = 0; i < rays; i++) {
        const double way[3] = {random_unit(random) - 0.5, random_unit(random) - 0.5, random_unit(random) - 0.5};
        if (seen(model, eye_m, way) > 0) continue;
        print_error("from %g %g %g towards %g %g %g nothing is in the way\n", eye_m[0], eye_m[1], eye_m[2], way[0],
                    way[1], way[2]);
        return false;
    }
    return true;
}

/* Maps --------------------------------------------------------------------------------------- */

/* A line between two sectors, the right one first; WAD_NO_SIDE: none. */
unsigned level_border(unsigned from, unsigned to, unsigned right, unsigned left)
{
    if (right == WAD_NO_SIDE) return level_border(to, from, left, right);
    const bool is_whole = left == WAD_NO_SIDE;
    const unsigned side = wad_side(&level_map, right, "WALL", "WALL", is_whole ? "WALL" : "-");
    return wad_line(&level_map, from, to, 0, side,
                    is_whole ? WAD_NO_SIDE : wad_side(&level_map, left, "WALL", "WALL", "-"));
}

/* Its lines run counter-clockwise, so their right is outside of it. */
void level_square(int x, int y, int side, unsigned outside, unsigned inside)
{
    const unsigned first = wad_vertex(&level_map, x, y);
    wad_vertex(&level_map, x + side, y);
    wad_vertex(&level_map, x + side, y + side);
    wad_vertex(&level_map, x, y + side);
    for (unsigned k = 0; k < 4; k++)
        level_border(first + k, first + (k + 1) % 4, outside, inside);
}

/* Two sectors in a row along x, the second one higher below and lower above, joined by line 3 of either. */
unsigned level_step(int low, int high)
{
    const unsigned a = wad_sector(&level_map, 0, 256, 255, "FLOOR", "CEIL");
    const unsigned b = wad_sector(&level_map, low, high, 255, "FLOOR", "CEIL");
    wad_vertex(&level_map, 0, 0);
    wad_vertex(&level_map, 0, 128);
    wad_vertex(&level_map, 128, 128);
    wad_vertex(&level_map, 128, 0);
    wad_vertex(&level_map, 256, 128);
    wad_vertex(&level_map, 256, 0);
    level_border(0, 1, a, WAD_NO_SIDE);
    level_border(1, 2, a, WAD_NO_SIDE);
    level_border(3, 0, a, WAD_NO_SIDE);
    level_border(2, 4, b, WAD_NO_SIDE);
    level_border(4, 5, b, WAD_NO_SIDE);
    level_border(5, 3, b, WAD_NO_SIDE);
    return level_border(2, 3, a, b); /* seen from the west */
}
