/* SPDX-License-Identifier: MIT
 *
 * A list that several primitives share is written once. What KHR_draco_mesh_compression has packed the library unpacks,
 * so such a primitive keeps its accessors' descriptions; then no position has a stand-in, as the unpacked ones have
 * none. */
#include "gltf/gltf_plain_work.h"

#include "base/grow.h"
#include "base/map.h"
#include "model/note_words.h"

#include <stdlib.h>
#include <string.h>

enum { POINTS_AND_LINES = 4 /* modes below */, MODES = 7 };
static const char DRACO[] = "KHR_draco_mesh_compression";

/* What an accessor is written as: keys of gltf_meshes.written are accessor * KINDS + kind. */
enum { POSITIONS, COLOURS, INDICES, COORDINATES /* and one for each material and texture */ };

struct meshes {
    struct gltf_work *work;
    struct map written; /* the plain file's accessor, from 1 */
    struct map reach;   /* of an accessor of indices: one more than the largest */
    bool is_packed;     /* by Draco, some of it */
    size_t lines, untransformed, morphed;
    size_t mesh; /* being read */
};

static uint64_t key_of(const struct meshes *meshes, size_t accessor, size_t kind)
{
    return accessor * (COORDINATES + GLTF_LOOKS * (uint64_t)(meshes->work->look_count + 1)) + kind;
}

/* Lists ---------------------------------------------------------------------------------------- */

static bool read_list(struct meshes *meshes, size_t accessor, const char *what, size_t components,
                      struct gltf_array *out)
{
    return gltf_plain_read(meshes->work, accessor, "meshes", meshes->mesh, what, components, out);
}

static size_t write_floats(struct meshes *meshes, const struct gltf_array *from, size_t components)
{
    float *values = grow_zeroed(from->count * components, sizeof *values);
    for (size_t i = 0; i < from->count * components; i++)
        values[i] = (float)from->values[i];
    const size_t accessor = gltf_output_floats(&meshes->work->out, values, from->count, components);
    free(values);
    return accessor;
}

/* What stands for positions, in their place. */
static bool stand_in(struct meshes *meshes, struct gltf_array *positions)
{
    struct vertex_table *table = meshes->work->table;
    if (positions->count > VERTEX_TABLE_MOST - table->count)
        return error_set(meshes->work->err, "%s: more than %d vertices", meshes->work->path, VERTEX_TABLE_MOST);
    for (size_t i = 0; i < positions->count; i++) {
        unsigned numbers[3];
        vertex_table_add(table, &positions->values[3 * i], numbers);
        for (size_t k = 0; k < 3; k++)
            positions->values[3 * i + k] = numbers[k];
    }
    return true;
}

static void transform(const struct gltf_uvs *uvs, struct gltf_array *coordinates)
{
    for (size_t i = 0; i < coordinates->count; i++) {
        double *uv = &coordinates->values[2 * i];
        const double u = uv[0], v = uv[1];
        for (int k = 0; k < 2; k++)
            uv[k] = uvs->rows[k][0] * u + uvs->rows[k][1] * v + uvs->rows[k][2];
    }
}

static bool is_float(const struct gltf_work *work, size_t accessor)
{
    enum { FLOAT = 5126 };
    size_t kind = 0;
    gltf_index(gltf_element(work->file, "accessors", accessor), "componentType", &kind);
    return kind == FLOAT;
}

static size_t reach_of(const struct gltf_array *indices)
{
    double most = -1;
    for (size_t i = 0; i < indices->count; i++)
        most = indices->values[i] > most ? indices->values[i] : most;
    return (size_t)(most + 1);
}

static bool write_positions(struct meshes *meshes, size_t accessor, struct gltf_array *list, size_t *out)
{
    if (!read_list(meshes, accessor, "POSITION", 3, list)) return false;
    *meshes->work->is_float32 |= is_float(meshes->work, accessor);
    if (!meshes->is_packed && !stand_in(meshes, list)) return false;
    *out = write_floats(meshes, list, 3);
    return true;
}

static bool write_colours(struct meshes *meshes, size_t accessor, struct gltf_array *list, size_t *out)
{
    const size_t components = gltf_plain_components(meshes->work, accessor);
    if (!read_list(meshes, accessor, "COLOR_0", components == 4 ? 4 : 3, list)) return false;
    *out = write_floats(meshes, list, components);
    return true;
}

static bool write_indices(struct meshes *meshes, size_t accessor, struct gltf_array *list, size_t *out)
{
    if (!read_list(meshes, accessor, "indices", 1, list)) return false;
    *map_at(&meshes->reach, accessor, 0) = (uint32_t)reach_of(list);
    *out = gltf_output_indices(&meshes->work->out, list->values, list->count);
    return true;
}

static bool write_coordinates(struct meshes *meshes, size_t accessor, const struct gltf_uvs *uvs,
                              struct gltf_array *list, size_t *out)
{
    if (!read_list(meshes, accessor, "TEXCOORD", 2, list)) return false;
    transform(uvs, list);
    *out = write_floats(meshes, list, 2);
    return true;
}

/* The plain file's accessor, once it is written. uvs: of coordinates. */
static bool write_list(struct meshes *meshes, size_t accessor, size_t kind, const struct gltf_uvs *uvs, size_t *out)
{
    const uint32_t *known = map_find(&meshes->written, key_of(meshes, accessor, kind));
    if (known) {
        *out = *known - 1;
        return true;
    }
    struct gltf_array list = {0};
    const bool ok = kind == POSITIONS ? write_positions(meshes, accessor, &list, out)
                    : kind == COLOURS ? write_colours(meshes, accessor, &list, out)
                    : kind == INDICES ? write_indices(meshes, accessor, &list, out)
                                      : write_coordinates(meshes, accessor, uvs, &list, out);
    free(list.values);
    if (ok) *map_at(&meshes->written, key_of(meshes, accessor, kind), 0) = (uint32_t)*out + 1;
    return ok;
}

/* Primitives ----------------------------------------------------------------------------------- */

static size_t count_of(const struct meshes *meshes, size_t accessor)
{
    size_t count = 0;
    gltf_index(gltf_element(meshes->work->file, "accessors", accessor), "count", &count);
    return count;
}

static void set(json_t *object, const char *name, size_t accessor)
{
    json_object_set_new(object, name, json_integer((json_int_t)accessor));
}

static const struct gltf_look *look_of(const struct meshes *meshes, const json_t *primitive, size_t *index)
{
    return gltf_index(primitive, "material", index) && *index < meshes->work->look_count ? &meshes->work->looks[*index]
                                                                                         : NULL;
}

/* An attribute that has as many elements as there are positions. */
static bool add_attribute(struct meshes *meshes, json_t *to, const char *name, size_t accessor, size_t kind,
                          const struct gltf_uvs *uvs, size_t points)
{
    size_t written;
    if (!write_list(meshes, accessor, kind, uvs, &written)) return false;
    if (count_of(meshes, accessor) != points)
        return error_set(meshes->work->err, "%s: meshes[%zu]: its %s is for %zu vertices, and there are %zu",
                         meshes->work->path, meshes->mesh, name, count_of(meshes, accessor), points);
    set(to, name, written);
    return true;
}

/* Those of the textures that its material has. */
static bool add_coordinates(struct meshes *meshes, const json_t *primitive, json_t *to, size_t points)
{
    size_t material, accessor;
    const struct gltf_look *look = look_of(meshes, primitive, &material);
    for (size_t i = 0; look && i < GLTF_LOOKS; i++) {
        char from[32], name[32];
        snprintf(from, sizeof from, "TEXCOORD_%zu", look->uvs[i].set);
        snprintf(name, sizeof name, "TEXCOORD_%u", look->sets[i]);
        if (!look->uvs[i].is_used || json_object_get(to, name)) continue;
        if (!gltf_index(json_object_get(primitive, "attributes"), from, &accessor)) continue;
        const size_t kind = COORDINATES + GLTF_LOOKS * material + i;
        if (!add_attribute(meshes, to, name, accessor, kind, &look->uvs[i], points)) return false;
    }
    return true;
}

static bool add_indices(struct meshes *meshes, const json_t *primitive, json_t *to, size_t points)
{
    size_t accessor, written;
    if (!json_object_get(primitive, "indices")) return true;
    if (!gltf_index(primitive, "indices", &accessor))
        return error_set(meshes->work->err, "%s: meshes[%zu]: its indices are no accessor", meshes->work->path,
                         meshes->mesh);
    if (!write_list(meshes, accessor, INDICES, NULL, &written)) return false;
    if (*map_at(&meshes->reach, accessor, 0) > points)
        return error_set(meshes->work->err, "%s: vertex indices of some faces are out of range", meshes->work->path);
    set(to, "indices", written);
    return true;
}

static bool add_lists(struct meshes *meshes, const json_t *primitive, size_t positions, json_t *to)
{
    const json_t *attributes = json_object_get(primitive, "attributes");
    json_t *lists = json_object_get(to, "attributes");
    const size_t points = count_of(meshes, positions);
    size_t colours;
    return add_attribute(meshes, lists, "POSITION", positions, POSITIONS, NULL, points) &&
           (!gltf_index(attributes, "COLOR_0", &colours) ||
            add_attribute(meshes, lists, "COLOR_0", colours, COLOURS, NULL, points)) &&
           add_coordinates(meshes, primitive, lists, points) && add_indices(meshes, primitive, to, points);
}

/* Packed ones ---------------------------------------------------------------------------------- */

static const json_t *draco_of(const json_t *primitive)
{
    return json_object_get(json_object_get(primitive, "extensions"), DRACO);
}

/* An accessor's description, whose numbers the library unpacks. */
static size_t describe(struct meshes *meshes, size_t accessor)
{
    json_t *copy = json_copy(gltf_element(meshes->work->file, "accessors", accessor));
    json_object_del(copy, "bufferView");
    json_object_del(copy, "byteOffset");
    json_object_del(copy, "sparse");
    return gltf_output_accessor(&meshes->work->out, copy ? copy : json_object());
}

static void describe_attribute(struct meshes *meshes, const json_t *primitive, const char *from, const char *name,
                               json_t *to, json_t *packed)
{
    size_t accessor;
    json_t *place = json_object_get(json_object_get(draco_of(primitive), "attributes"), from);
    if (!place || !gltf_index(json_object_get(primitive, "attributes"), from, &accessor)) return;
    set(json_object_get(to, "attributes"), name, describe(meshes, accessor));
    json_object_set(packed, name, place);
}

static bool is_identity(const struct gltf_uvs *uvs)
{
    static const double identity[2][3] = {{1, 0, 0}, {0, 1, 0}};
    return memcmp(uvs->rows, identity, sizeof identity) == 0;
}

static void describe_coordinates(struct meshes *meshes, const json_t *primitive, json_t *to, json_t *packed)
{
    size_t material;
    const struct gltf_look *look = look_of(meshes, primitive, &material);
    for (size_t i = 0; look && i < GLTF_LOOKS; i++) {
        char from[32], name[32];
        snprintf(from, sizeof from, "TEXCOORD_%zu", look->uvs[i].set);
        snprintf(name, sizeof name, "TEXCOORD_%u", look->sets[i]);
        if (look->uvs[i].is_used) describe_attribute(meshes, primitive, from, name, to, packed);
        meshes->untransformed += look->uvs[i].is_used && !is_identity(&look->uvs[i]);
    }
}

static bool add_packed(struct meshes *meshes, const json_t *primitive, json_t *to)
{
    struct gltf_work *work = meshes->work;
    size_t number, buffer, start_b = 0, size_b = 0, indices;
    const json_t *view =
        gltf_index(draco_of(primitive), "bufferView", &number) ? gltf_element(work->file, "bufferViews", number) : NULL;
    gltf_index(view, "byteOffset", &start_b);
    if (!gltf_index(view, "buffer", &buffer) || buffer >= work->buffers.count ||
        !gltf_index(view, "byteLength", &size_b) || start_b > work->buffers.items[buffer].size_b ||
        size_b > work->buffers.items[buffer].size_b - start_b)
        return error_set(work->err, "%s: meshes[%zu]: what Draco has packed leads out of its buffer", work->path,
                         meshes->mesh);
    json_t *packed = json_object();
    describe_attribute(meshes, primitive, "POSITION", "POSITION", to, packed);
    describe_attribute(meshes, primitive, "COLOR_0", "COLOR_0", to, packed);
    describe_coordinates(meshes, primitive, to, packed);
    if (gltf_index(primitive, "indices", &indices)) set(to, "indices", describe(meshes, indices));
    const size_t copy = gltf_output_view(&work->out, work->buffers.items[buffer].bytes + start_b, size_b);
    json_object_set_new(to, "extensions",
                        json_pack("{s:{s:I, s:o}}", DRACO, "bufferView", (json_int_t)copy, "attributes", packed));
    *work->is_float32 = true;
    return true;
}

/* Meshes --------------------------------------------------------------------------------------- */

/* Appends it to the list, if it has faces. */
static bool make_primitive(struct meshes *meshes, const json_t *primitive, json_t *list)
{
    size_t mode = POINTS_AND_LINES, positions;
    gltf_index(primitive, "mode", &mode);
    if (mode >= MODES)
        return error_set(meshes->work->err, "%s: meshes[%zu]: a primitive's mode is %zu, %d are the most",
                         meshes->work->path, meshes->mesh, mode, MODES - 1);
    meshes->lines += mode < POINTS_AND_LINES;
    if (mode < POINTS_AND_LINES) return true;
    if (!gltf_index(json_object_get(primitive, "attributes"), "POSITION", &positions)) return true;
    json_t *to = json_pack("{s:{}, s:I}", "attributes", "mode", (json_int_t)mode);
    json_t *material = json_object_get(primitive, "material");
    if (material) json_object_set(to, "material", material);
    json_array_append_new(list, to);
    return draco_of(primitive) ? add_packed(meshes, primitive, to) : add_lists(meshes, primitive, positions, to);
}

static bool make_mesh(struct meshes *meshes, json_t *mesh)
{
    size_t i;
    json_t *primitive, *list = json_array();
    bool ok = true;
    json_array_foreach(json_object_get(mesh, "primitives"), i, primitive) ok =
        ok && make_primitive(meshes, primitive, list);
    json_object_set_new(mesh, "primitives", list);
    json_object_del(mesh, "weights");
    json_object_del(mesh, "extensions");
    json_object_del(mesh, "extras");
    return ok;
}

/* Whether its shape is another one than its positions say. */
static bool is_morphed(const json_t *weights)
{
    size_t i;
    const json_t *weight;
    json_array_foreach(weights, i, weight) if (json_number_value(weight) != 0) return true;
    return false;
}

static bool any_is_packed(const json_t *all)
{
    size_t i, k;
    const json_t *mesh, *primitive;
    json_array_foreach(all, i, mesh) json_array_foreach(json_object_get(mesh, "primitives"), k, primitive)
    {
        if (draco_of(primitive)) return true;
    }
    return false;
}

static void note_what_is_left_out(const struct meshes *meshes)
{
    struct model *model = meshes->work->model;
    if (meshes->lines) model_note(model, "%zu " WORDS_LISTS_OF_LINES, meshes->lines);
    if (meshes->morphed) model_note(model, "%zu " WORDS_MORPHS, meshes->morphed);
    if (meshes->untransformed)
        model_note(model,
                   "%zu textures of what Draco has packed are drawn without KHR_texture_transform; export it without "
                   "one of the two",
                   meshes->untransformed);
}

bool gltf_plain_meshes(struct gltf_work *work)
{
    struct meshes meshes = {.work = work};
    json_t *all = json_object_get(work->file->root, "meshes"), *mesh;
    bool ok = true;
    meshes.is_packed = any_is_packed(all);
    json_array_foreach(all, meshes.mesh, mesh)
    {
        meshes.morphed += is_morphed(json_object_get(mesh, "weights"));
        ok = ok && make_mesh(&meshes, mesh);
    }
    if (ok) note_what_is_left_out(&meshes);
    map_free(&meshes.written);
    map_free(&meshes.reach);
    return ok;
}
