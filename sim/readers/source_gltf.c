/* SPDX-License-Identifier: MIT
 *
 * glTF 2.0 for the reference: nodes of the scene, parents first; triangles of their meshes' primitives. A corner goes
 * up through one node after the other, which is other arithmetic than the product of their matrices. */
#include "readers/source.h"

#include "gltf/gltf_file.h"
#include "readers/source_gltf_motion.h"
#include "readers/source_gltf_numbers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEEPEST = 2000 };
enum { TRIANGLES = 4, TRIANGLE_STRIP = 5, TRIANGLE_FAN = 6 };

struct reading {
    const char *path;
    const struct gltf_file *file;
    struct gltf_buffers buffers;
    struct source *source;
    struct error *err;
    enum source_result result;
};

/* A node below its parents. */
struct place {
    const json_t *node;
    const struct source_node *animated; /* NULL: nothing is known of it */
    const struct place *above;
    unsigned depth;
};

static bool fail(struct reading *work, const char *what)
{
    work->result = SOURCE_BAD;
    return error_set(work->err, "%s: %s", work->path, what);
}

static bool cannot_read(struct reading *work)
{
    work->result = SOURCE_UNKNOWN;
    return false;
}

/* Transforms --------------------------------------------------------------------------------- */

static void turn(const double q[4], double v[3])
{
    double once[3], twice[3];
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        once[i] = q[j] * v[k] - q[k] * v[j];
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        twice[i] = q[j] * once[k] - q[k] * once[j];
    }
    for (int i = 0; i < 3; i++)
        v[i] += 2 * (q[3] * once[i] + twice[i]);
}

/* One of a node's own, or what its animation keeps that at. */
static bool find_part(const struct place *place, const char *name, enum source_part part, size_t width, double *out)
{
    if (!place->animated || !place->animated->kept[part]) return gltf_numbers(place->node, name, width, out);
    memcpy(out, place->animated->parts[part], width * sizeof *out);
    return true;
}

/* Out of a node's coordinates; a direction stays where it is. */
static void leave(const struct place *place, bool is_point, double v[3])
{
    double m[16], q[4], s[3], t[3];
    if (gltf_numbers(place->node, "matrix", 16, m)) {
        const double from[3] = {v[0], v[1], v[2]};
        for (int i = 0; i < 3; i++)
            v[i] = m[i] * from[0] + m[4 + i] * from[1] + m[8 + i] * from[2] + (is_point ? m[12 + i] : 0);
        return;
    }
    for (int i = 0; i < 3 && find_part(place, "scale", SOURCE_SCALE, 3, s); i++)
        v[i] *= s[i];
    if (find_part(place, "rotation", SOURCE_TURN, 4, q)) turn(q, v);
    for (int i = 0; i < 3 && is_point && find_part(place, "translation", SOURCE_AT, 3, t); i++)
        v[i] += t[i];
}

static void to_scene(struct source *source, const struct place *place, bool is_point, double v[3])
{
    for (; place; place = place->above) {
        leave(place, is_point, v);
        for (int i = 0; i < 3 && is_point; i++)
            source->reach_m = fmax(source->reach_m, fabs(v[i]));
    }
}

static bool is_mirrored(struct source *source, const struct place *place)
{
    double x[3] = {1, 0, 0}, y[3] = {0, 1, 0}, z[3] = {0, 0, 1};
    to_scene(source, place, false, x);
    to_scene(source, place, false, y);
    to_scene(source, place, false, z);
    return x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) +
               x[2] * (y[0] * z[1] - y[1] * z[0]) <
           0;
}

/* Faces -------------------------------------------------------------------------------------- */

struct triangles {
    struct source_numbers points, indices; /* indices.values == NULL: corners are the points in their order */
    const struct place *place;
    bool mirrored;
};

static bool add_triangle(struct reading *work, const struct triangles *triangles, const size_t at[3])
{
    for (int k = 0; k < 3; k++) {
        const size_t corner = at[triangles->mirrored ? 2 - k : k];
        const double index = triangles->indices.values ? triangles->indices.values[corner] : (double)corner;
        if (!(index < (double)triangles->points.count)) return fail(work, "an index of a corner is out of range");
        double p[3];
        memcpy(p, &triangles->points.values[3 * (size_t)index], sizeof p);
        to_scene(work->source, triangles->place, true, p);
        source_corner(work->source, p);
    }
    source_face(work->source);
    return true;
}

static bool add_triangles(struct reading *work, const struct triangles *triangles, size_t mode)
{
    const size_t count = triangles->indices.values ? triangles->indices.count : triangles->points.count;
    const size_t faces = mode == TRIANGLES ? count / 3 : count > 2 ? count - 2 : 0;
    for (size_t i = 0; i < faces; i++) {
        size_t at[3] = {3 * i, 3 * i + 1, 3 * i + 2};
        if (mode == TRIANGLE_STRIP) memcpy(at, (const size_t[3]){i + i % 2, i + 1 - i % 2, i + 2}, sizeof at);
        if (mode == TRIANGLE_FAN) memcpy(at, (const size_t[3]){0, i + 1, i + 2}, sizeof at);
        if (!add_triangle(work, triangles, at)) return false;
    }
    return true;
}

static bool add_primitive(struct reading *work, const json_t *primitive, const struct place *place)
{
    struct triangles triangles = {.place = place, .mirrored = is_mirrored(work->source, place)};
    size_t mode = TRIANGLES, points, indices;
    gltf_index(primitive, "mode", &mode);
    if (mode < TRIANGLES || mode > TRIANGLE_FAN) return true;
    if (json_object_get(json_object_get(primitive, "extensions"), "KHR_draco_mesh_compression"))
        return cannot_read(work);
    if (!gltf_index(json_object_get(primitive, "attributes"), "POSITION", &points)) return true;
    const bool has_indices = gltf_index(primitive, "indices", &indices);
    bool ok = source_numbers_read(work->file, &work->buffers, points, 3, &triangles.points) &&
              (!has_indices || source_numbers_read(work->file, &work->buffers, indices, 1, &triangles.indices));
    if (!ok)
        fail(work, "the reference's reader finds an accessor that leads out of its buffer");
    else
        ok = add_triangles(work, &triangles, mode);
    source_numbers_free(&triangles.points);
    source_numbers_free(&triangles.indices);
    return ok;
}

static bool add_mesh(struct reading *work, size_t mesh, const struct place *place)
{
    const json_t *primitives = json_object_get(gltf_element(work->file, "meshes", mesh), "primitives");
    for (size_t k = 0; k < json_array_size(primitives); k++)
        if (!add_primitive(work, json_array_get(primitives, k), place)) return false;
    return true;
}

/* Instances ---------------------------------------------------------------------------------- */

/* What moves them, in the order of GPU instancing's text. */
enum { AT, TURN, SCALE, INSTANCE_PARTS };

static const json_t *instances_of(const json_t *node)
{
    const json_t *extensions = json_object_get(node, "extensions");
    return json_object_get(json_object_get(extensions, "EXT_mesh_gpu_instancing"), "attributes");
}

/* A node that has the place of instance i. */
static json_t *instance_node(const struct source_numbers parts[INSTANCE_PARTS], size_t i)
{
    const double *at = parts[AT].values, *scale = parts[SCALE].values, *turns = parts[TURN].values;
    json_t *node = json_object();
    if (at) json_object_set_new(node, "translation", json_pack("[f,f,f]", at[3 * i], at[3 * i + 1], at[3 * i + 2]));
    if (scale)
        json_object_set_new(node, "scale", json_pack("[f,f,f]", scale[3 * i], scale[3 * i + 1], scale[3 * i + 2]));
    if (turns) {
        const double *q = &turns[4 * i], length = hypot(hypot(q[0], q[1]), hypot(q[2], q[3]));
        json_object_set_new(node, "rotation",
                            json_pack("[f,f,f,f]", q[0] / length, q[1] / length, q[2] / length, q[3] / length));
    }
    return node;
}

static bool add_instances(struct reading *work, const json_t *attributes, size_t mesh, const struct place *below)
{
    static const char *const names[INSTANCE_PARTS] = {"TRANSLATION", "ROTATION", "SCALE"};
    struct source_numbers parts[INSTANCE_PARTS] = {{0}};
    size_t accessor, count = 1;
    bool ok = true;
    for (int i = 0; ok && i < INSTANCE_PARTS; i++) {
        if (!gltf_index(attributes, names[i], &accessor)) continue;
        ok = source_numbers_read(work->file, &work->buffers, accessor, i == TURN ? 4 : 3, &parts[i]);
        count = parts[i].count;
    }
    for (int i = 0; ok && i < INSTANCE_PARTS; i++)
        ok = !parts[i].values || parts[i].count == count;
    if (!ok) fail(work, "the reference's reader finds no instances where they should be");
    for (size_t i = 0; ok && i < count; i++) {
        json_t *node = instance_node(parts, i);
        const struct place place = {.node = node, .above = below, .depth = below->depth + 1};
        ok = add_mesh(work, mesh, &place);
        json_decref(node);
    }
    for (int i = 0; i < INSTANCE_PARTS; i++)
        source_numbers_free(&parts[i]);
    return ok;
}

/* Nodes -------------------------------------------------------------------------------------- */

static bool add_nodes(struct reading *work, const json_t *indices, const struct place *above)
{
    size_t i, mesh;
    json_t *index;
    const unsigned depth = above ? above->depth + 1 : 0;
    if (depth > DEEPEST) return fail(work, "its nodes are nested too deeply");
    json_array_foreach(indices, i, index)
    {
        const size_t number = (size_t)json_integer_value(index);
        const struct source_motion *motion = &work->source->motion;
        const struct place place = {gltf_element(work->file, "nodes", number),
                                    number < motion->count ? &motion->nodes[number] : NULL, above, depth};
        if (!place.node) return fail(work, "a node that it names is not in it");
        if (gltf_index(place.node, "mesh", &mesh)) {
            const json_t *instances = instances_of(place.node);
            if (!(instances ? add_instances(work, instances, mesh, &place) : add_mesh(work, mesh, &place)))
                return false;
        }
        if (!add_nodes(work, json_object_get(place.node, "children"), &place)) return false;
    }
    return true;
}

enum source_result source_gltf_read(const char *path, struct source *source, struct error *err)
{
    struct gltf_file file;
    if (!gltf_file_read(path, &file, err)) return SOURCE_BAD;
    struct reading work = {.path = path, .file = &file, .source = source, .err = err, .result = SOURCE_READ};
    if (!gltf_file_is_2(&file))
        work.result = SOURCE_UNKNOWN;
    else if (!gltf_buffers_read(path, &file, &work.buffers, err))
        work.result = SOURCE_BAD;
    else {
        source_gltf_motion_read(&file, &work.buffers, &source->motion);
        add_nodes(&work, gltf_scene_nodes(&file), NULL);
    }
    gltf_buffers_free(&work.buffers);
    gltf_file_free(&file);
    return work.result;
}
