/* SPDX-License-Identifier: MIT */
#include "cameras/gltf_cameras.h"

#include "base/grow.h"
#include "base/notice.h"
#include "base/vec3.h"
#include "model/model_orientation.h"
#include "gltf/gltf_file.h"
#include "readers/node_transforms.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEEPEST = 2000, MOST = 10000 };
static const double ALIKE_DEG = 0.05, UPRIGHT = 1e-3; /* as a sine */

struct gathering {
    const char *path;
    const struct gltf_file *file;
    bool z_is_up;
    double fov_deg;
    struct camera_path *out;
    size_t capacity, visited, leaning, other_fov;
    double first_fov_deg; /* of those */
    struct error *err;
};

bool gltf_cameras_are_named(const char *path)
{
    return gltf_is_named(path);
}

static const char *name_of(const json_t *object)
{
    const char *name = json_string_value(json_object_get(object, "name"));
    return name ? name : "without a name";
}

static void direction(const struct node_transform *place, int axis, double sign, double out[3])
{
    double length = 0;
    for (int i = 0; i < 3; i++)
        length += place->m[i][axis] * place->m[i][axis];
    for (int i = 0; i < 3; i++)
        out[i] = sign * place->m[i][axis] / sqrt(length);
}

/* A camera looks along -z; how far its own right leaves the horizon is what is lost of it. */
static void place_camera(struct gathering *work, const struct node_transform *place)
{
    struct camera_path *out = work->out;
    double forward[3], right[3];
    direction(place, 2, -1, forward);
    direction(place, 0, 1, right);
    out->frames = grow(out->frames, out->count, &work->capacity, sizeof *out->frames);
    struct viewpoint *view = &out->frames[out->count++];
    *view = (struct viewpoint){.line = out->count};
    for (int i = 0; i < 3; i++) {
        view->eye_m[i] = place->m[i][3];
        view->target_m[i] = place->m[i][3] + forward[i];
    }
    work->leaning += fabs(right[work->z_is_up ? 2 : 1]) > UPRIGHT;
    if (!work->z_is_up) return;
    orientation_turn_up(view->eye_m);
    orientation_turn_up(view->target_m);
}

static bool add_camera(struct gathering *work, const json_t *node, size_t number, const struct node_transform *place)
{
    const json_t *camera = gltf_element(work->file, "cameras", number);
    const json_t *lens = json_object_get(camera, "perspective");
    const char *name = name_of(json_object_get(node, "name") ? node : camera);
    if (!lens)
        return error_set(work->err, "%s: camera '%s' is not a perspective one, which alone are drawn", work->path,
                         name);
    if (work->out->count == MOST) return error_set(work->err, "%s: more than %d cameras", work->path, MOST);
    const double fov_deg = json_number_value(json_object_get(lens, "yfov")) * 180 / acos(-1);
    if (fabs(fov_deg - work->fov_deg) > ALIKE_DEG && !work->other_fov++) work->first_fov_deg = fov_deg;
    place_camera(work, place);
    const struct viewpoint *view = &work->out->frames[work->out->count - 1];
    for (int i = 0; i < 3; i++)
        if (!isfinite(view->eye_m[i]) || !isfinite(view->target_m[i]))
            return error_set(work->err, "%s: camera '%s' is nowhere: its node's transform is none", work->path, name);
    return true;
}

static bool gather(struct gathering *work, const json_t *indices, const struct node_transform *above, int depth)
{
    size_t i, camera;
    const json_t *index;
    json_array_foreach(indices, i, index)
    {
        const json_t *node = json_is_integer(index) && json_integer_value(index) >= 0
                                 ? gltf_element(work->file, "nodes", (size_t)json_integer_value(index))
                                 : NULL;
        if (!node || depth == DEEPEST || work->visited++ == json_array_size(json_object_get(work->file->root, "nodes")))
            return error_set(work->err, "%s: its nodes are no tree", work->path);
        const struct node_transform own = node_transform_of_file(node), here = node_transform_times(above, &own);
        if (gltf_index(node, "camera", &camera) && !add_camera(work, node, camera, &here)) return false;
        if (!gather(work, json_object_get(node, "children"), &here, depth + 1)) return false;
    }
    return true;
}

static void tell(const struct gathering *work)
{
    if (work->other_fov)
        notice("%s: %zu cameras have another field of view than the %g degrees that are drawn; --fov %g is that of the "
               "first of them",
               work->path, work->other_fov, work->fov_deg, round(100 * work->first_fov_deg) / 100);
    if (work->leaning) notice("%s: %zu cameras lean to a side; they are drawn upright", work->path, work->leaning);
}

bool gltf_cameras_read(const char *path, bool z_is_up, double fov_deg, struct camera_path *out, struct error *err)
{
    static const struct node_transform world = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
    struct gltf_file file;
    struct gathering work = {
        .path = path, .file = &file, .z_is_up = z_is_up, .fov_deg = fov_deg, .out = out, .err = err};
    *out = (struct camera_path){.name = strdup(path)};
    if (!out->name) return error_set(err, "%s: out of memory", path);
    bool ok = gltf_file_read(path, &file, err);
    if (ok) {
        ok = gather(&work, gltf_scene_nodes(&file), &world, 0) &&
             (out->count || error_set(err, "%s: there is no camera in it", path));
        gltf_file_free(&file);
    }
    if (ok) tell(&work);
    if (!ok) camera_path_free(out);
    return ok;
}
