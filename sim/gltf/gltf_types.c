/* SPDX-License-Identifier: MIT */
#include "gltf/gltf_types.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum type { OBJECT, ARRAY, STRING, BOOLEAN, NUMBER, WHOLE, NUMBERS_2, NUMBERS_3, NUMBERS_4, NUMBERS_16 };

static const char *const WORDS[] = {
    [OBJECT] = "no object",         [ARRAY] = "no array",          [STRING] = "no string",
    [BOOLEAN] = "no boolean",       [NUMBER] = "no number",        [WHOLE] = "no whole number from 0",
    [NUMBERS_2] = "not 2 numbers",  [NUMBERS_3] = "not 3 numbers", [NUMBERS_4] = "not 4 numbers",
    [NUMBERS_16] = "not 16 numbers"};

/* "[]" is each element of an array, "*" each member of an object. Whatever holds a member has a row of its own before
 * it. */
static const struct row {
    const char *path;
    enum type type;
} ROWS[] = {
    {"extensionsUsed", ARRAY},
    {"extensionsUsed.[]", STRING},
    {"extensionsRequired", ARRAY},
    {"extensionsRequired.[]", STRING},
    {"scene", WHOLE},
    {"scenes", ARRAY},
    {"scenes.[]", OBJECT},
    {"scenes.[].name", STRING},
    {"scenes.[].nodes", ARRAY},
    {"scenes.[].nodes.[]", WHOLE},
    {"nodes", ARRAY},
    {"nodes.[]", OBJECT},
    {"nodes.[].name", STRING},
    {"nodes.[].children", ARRAY},
    {"nodes.[].children.[]", WHOLE},
    {"nodes.[].mesh", WHOLE},
    {"nodes.[].camera", WHOLE},
    {"nodes.[].skin", WHOLE},
    {"nodes.[].matrix", NUMBERS_16},
    {"nodes.[].translation", NUMBERS_3},
    {"nodes.[].rotation", NUMBERS_4},
    {"nodes.[].scale", NUMBERS_3},
    {"nodes.[].extensions", OBJECT},
    {"nodes.[].extensions.*", OBJECT},
    {"nodes.[].extensions.EXT_mesh_gpu_instancing.attributes", OBJECT},
    {"nodes.[].extensions.EXT_mesh_gpu_instancing.attributes.*", WHOLE},
    {"meshes", ARRAY},
    {"meshes.[]", OBJECT},
    {"meshes.[].name", STRING},
    {"meshes.[].primitives", ARRAY},
    {"meshes.[].primitives.[]", OBJECT},
    {"meshes.[].primitives.[].attributes", OBJECT},
    {"meshes.[].primitives.[].attributes.*", WHOLE},
    {"meshes.[].primitives.[].indices", WHOLE},
    {"meshes.[].primitives.[].material", WHOLE},
    {"meshes.[].primitives.[].mode", WHOLE},
    {"meshes.[].primitives.[].targets", ARRAY},
    {"meshes.[].primitives.[].extensions", OBJECT},
    {"meshes.[].primitives.[].extensions.*", OBJECT},
    {"accessors", ARRAY},
    {"accessors.[]", OBJECT},
    {"accessors.[].bufferView", WHOLE},
    {"accessors.[].byteOffset", WHOLE},
    {"accessors.[].componentType", WHOLE},
    {"accessors.[].count", WHOLE},
    {"accessors.[].type", STRING},
    {"accessors.[].normalized", BOOLEAN},
    {"accessors.[].sparse", OBJECT},
    {"accessors.[].sparse.count", WHOLE},
    {"accessors.[].sparse.indices", OBJECT},
    {"accessors.[].sparse.indices.bufferView", WHOLE},
    {"accessors.[].sparse.indices.byteOffset", WHOLE},
    {"accessors.[].sparse.indices.componentType", WHOLE},
    {"accessors.[].sparse.values", OBJECT},
    {"accessors.[].sparse.values.bufferView", WHOLE},
    {"accessors.[].sparse.values.byteOffset", WHOLE},
    {"bufferViews", ARRAY},
    {"bufferViews.[]", OBJECT},
    {"bufferViews.[].buffer", WHOLE},
    {"bufferViews.[].byteOffset", WHOLE},
    {"bufferViews.[].byteLength", WHOLE},
    {"bufferViews.[].byteStride", WHOLE},
    {"bufferViews.[].extensions", OBJECT},
    {"bufferViews.[].extensions.*", OBJECT},
    {"bufferViews.[].extensions.*.buffer", WHOLE},
    {"bufferViews.[].extensions.*.byteOffset", WHOLE},
    {"bufferViews.[].extensions.*.byteLength", WHOLE},
    {"bufferViews.[].extensions.*.byteStride", WHOLE},
    {"bufferViews.[].extensions.*.count", WHOLE},
    {"bufferViews.[].extensions.*.mode", STRING},
    {"bufferViews.[].extensions.*.filter", STRING},
    {"buffers", ARRAY},
    {"buffers.[]", OBJECT},
    {"buffers.[].uri", STRING},
    {"buffers.[].byteLength", WHOLE},
    {"images", ARRAY},
    {"images.[]", OBJECT},
    {"images.[].uri", STRING},
    {"images.[].mimeType", STRING},
    {"images.[].bufferView", WHOLE},
    {"textures", ARRAY},
    {"textures.[]", OBJECT},
    {"textures.[].source", WHOLE},
    {"textures.[].sampler", WHOLE},
    {"textures.[].extensions", OBJECT},
    {"textures.[].extensions.*", OBJECT},
    {"textures.[].extensions.*.source", WHOLE},
    {"samplers", ARRAY},
    {"samplers.[]", OBJECT},
    {"samplers.[].wrapS", WHOLE},
    {"samplers.[].wrapT", WHOLE},
    {"materials", ARRAY},
    {"materials.[]", OBJECT},
    {"materials.[].name", STRING},
    {"materials.[].alphaMode", STRING},
    {"materials.[].alphaCutoff", NUMBER},
    {"materials.[].doubleSided", BOOLEAN},
    {"materials.[].pbrMetallicRoughness", OBJECT},
    {"materials.[].pbrMetallicRoughness.baseColorFactor", NUMBERS_4},
    {"materials.[].emissiveFactor", NUMBERS_3},
    {"materials.[].extensions", OBJECT},
    {"materials.[].extensions.*", OBJECT},
    {"materials.[].extensions.KHR_materials_emissive_strength.emissiveStrength", NUMBER},
    {"materials.[].extensions.KHR_materials_pbrSpecularGlossiness.diffuseFactor", NUMBERS_4},
    {"animations", ARRAY},
    {"animations.[]", OBJECT},
    {"animations.[].name", STRING},
    {"animations.[].channels", ARRAY},
    {"animations.[].channels.[]", OBJECT},
    {"animations.[].channels.[].sampler", WHOLE},
    {"animations.[].channels.[].target", OBJECT},
    {"animations.[].channels.[].target.node", WHOLE},
    {"animations.[].channels.[].target.path", STRING},
    {"animations.[].samplers", ARRAY},
    {"animations.[].samplers.[]", OBJECT},
    {"animations.[].samplers.[].input", WHOLE},
    {"animations.[].samplers.[].output", WHOLE},
    {"animations.[].samplers.[].interpolation", STRING},
    {"cameras", ARRAY},
    {"cameras.[]", OBJECT},
    {"cameras.[].name", STRING},
    {"cameras.[].type", STRING},
    {"cameras.[].perspective", OBJECT},
    {"cameras.[].perspective.yfov", NUMBER},
    {"cameras.[].perspective.aspectRatio", NUMBER},
    {"cameras.[].perspective.znear", NUMBER},
    {"cameras.[].perspective.zfar", NUMBER},
};

/* What is seen by one of these has the rows behind it. */
static const char *const TEXTURES[] = {"materials.[].pbrMetallicRoughness.baseColorTexture",
                                       "materials.[].emissiveTexture",
                                       "materials.[].extensions.KHR_materials_pbrSpecularGlossiness.diffuseTexture"};
static const struct row TEXTURE_ROWS[] = {
    {"", OBJECT},
    {".index", WHOLE},
    {".texCoord", WHOLE},
    {".extensions", OBJECT},
    {".extensions.*", OBJECT},
    {".extensions.KHR_texture_transform.offset", NUMBERS_2},
    {".extensions.KHR_texture_transform.scale", NUMBERS_2},
    {".extensions.KHR_texture_transform.rotation", NUMBER},
    {".extensions.KHR_texture_transform.texCoord", WHOLE},
};

static bool are_numbers(const json_t *value, size_t count)
{
    if (!json_is_array(value) || json_array_size(value) != count) return false;
    for (size_t i = 0; i < count; i++)
        if (!json_is_number(json_array_get(value, i))) return false;
    return true;
}

static bool is_whole(const json_t *value)
{
    static const double most = 9007199254740992.0; /* 2^53 */
    if (json_is_integer(value)) return json_integer_value(value) >= 0;
    const double number = json_number_value(value);
    return json_is_real(value) && number >= 0 && number <= most && number == floor(number);
}

static bool is_of(const json_t *value, enum type type)
{
    switch (type) {
    case OBJECT:
        return json_is_object(value);
    case ARRAY:
        return json_is_array(value);
    case STRING:
        return json_is_string(value);
    case BOOLEAN:
        return json_is_boolean(value);
    case NUMBER:
        return json_is_number(value);
    case WHOLE:
        return is_whole(value);
    case NUMBERS_2:
        return are_numbers(value, 2);
    case NUMBERS_3:
        return are_numbers(value, 3);
    case NUMBERS_4:
        return are_numbers(value, 4);
    case NUMBERS_16:
        return are_numbers(value, 16);
    }
    return false;
}

/* What is told of a member that is wrong. */
struct place {
    char words[256];
    size_t length;
};

static void place_add(struct place *place, const char *words, size_t length_b)
{
    const size_t room_b = sizeof place->words - 1 - place->length;
    const size_t added_b = length_b < room_b ? length_b : room_b;
    memcpy(place->words + place->length, words, added_b);
    place->length += added_b;
    place->words[place->length] = '\0';
}

static void place_add_element(struct place *place, size_t index)
{
    char words[32];
    place_add(place, words, (size_t)snprintf(words, sizeof words, "[%zu]", index));
}

static void place_add_member(struct place *place, const char *name)
{
    if (place->length) place_add(place, ".", 1);
    place_add(place, name, strlen(name));
}

static bool check(json_t *holder, const char *rest, enum type type, struct place place, struct place *wrong);

/* A member, or an element, that the path leads on from, or ends at. */
static bool check_value(json_t *value, const char *rest, enum type type, const struct place *place, struct place *wrong)
{
    if (*rest) return check(value, rest + 1, type, *place, wrong);
    if (is_of(value, type)) return true;
    *wrong = *place;
    return false;
}

static json_t *as_integer(json_t *value)
{
    return json_is_real(value) ? json_integer((json_int_t)json_real_value(value)) : NULL;
}

static bool check_elements(json_t *array, const char *rest, enum type type, const struct place *place,
                           struct place *wrong)
{
    size_t i;
    json_t *value;
    json_array_foreach(array, i, value)
    {
        struct place own = *place;
        place_add_element(&own, i);
        if (!check_value(value, rest, type, &own, wrong)) return false;
        json_t *integer = type == WHOLE && !*rest ? as_integer(value) : NULL;
        if (integer) json_array_set_new(array, i, integer);
    }
    return true;
}

static bool check_members(json_t *object, const char *name, size_t name_b, const char *rest, enum type type,
                          const struct place *place, struct place *wrong)
{
    const bool all = name_b == 1 && *name == '*';
    const char *key;
    json_t *value;
    void *next;
    json_object_foreach_safe(object, next, key, value)
    {
        struct place own = *place;
        if (!all && (strncmp(key, name, name_b) != 0 || key[name_b])) continue;
        place_add_member(&own, key);
        if (!check_value(value, rest, type, &own, wrong)) return false;
        json_t *integer = type == WHOLE && !*rest ? as_integer(value) : NULL;
        if (integer) json_object_set_new(object, key, integer);
    }
    return true;
}

/* As deep as the longest path. */
static bool check(json_t *holder, const char *path, enum type type, struct place place, struct place *wrong)
{
    const size_t name_b = strcspn(path, ".");
    const char *rest = path + name_b;
    if (path[0] == '[') return check_elements(holder, rest, type, &place, wrong);
    return check_members(holder, path, name_b, rest, type, &place, wrong);
}

static bool check_row(const char *path, struct gltf_file *file, const struct row *row, struct error *err)
{
    struct place wrong;
    return check(file->root, row->path, row->type, (struct place){{0}, 0}, &wrong) ||
           error_set(err, "%s: %s is %s", path, wrong.words, WORDS[row->type]);
}

static bool check_texture(const char *path, struct gltf_file *file, const char *texture, struct error *err)
{
    char whole[160];
    for (size_t i = 0; i < sizeof TEXTURE_ROWS / sizeof *TEXTURE_ROWS; i++) {
        snprintf(whole, sizeof whole, "%s%s", texture, TEXTURE_ROWS[i].path);
        if (!check_row(path, file, &(struct row){whole, TEXTURE_ROWS[i].type}, err)) return false;
    }
    return true;
}

bool gltf_types_check(const char *path, struct gltf_file *file, struct error *err)
{
    if (!json_is_object(file->root)) return error_set(err, "%s: its JSON is no object", path);
    for (size_t i = 0; i < sizeof ROWS / sizeof *ROWS; i++)
        if (!check_row(path, file, &ROWS[i], err)) return false;
    for (size_t i = 0; i < sizeof TEXTURES / sizeof *TEXTURES; i++)
        if (!check_texture(path, file, TEXTURES[i], err)) return false;
    return true;
}
