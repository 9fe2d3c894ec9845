/* SPDX-License-Identifier: MIT */
#include "gltf/gltf_file.h"

#include <stdint.h>
#include <string.h>

enum { HEAD_B = 12, CHUNK_HEAD_B = 8 };
static const uint32_t MAGIC = 0x46546C67, JSON_CHUNK = 0x4E4F534A, BINARY_CHUNK = 0x004E4942;

bool gltf_is_named(const char *path)
{
    return path_has_suffix(path, ".gltf") || path_has_suffix(path, ".glb") || path_has_suffix(path, ".vrm");
}

static uint32_t word_at(const char *bytes)
{
    const unsigned char *b = (const unsigned char *)bytes;
    return b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

/* The chunk of a .glb at `at`; false: the file ends before it does. */
static bool chunk_at(const struct whole_file *file, size_t at, uint32_t kind, const char **bytes, size_t *size_b)
{
    if (at > file->size_b || file->size_b - at < CHUNK_HEAD_B) return false;
    *size_b = word_at(file->bytes + at);
    *bytes = file->bytes + at + CHUNK_HEAD_B;
    return word_at(file->bytes + at + 4) == kind && *size_b <= file->size_b - at - CHUNK_HEAD_B;
}

static void find_parts(struct gltf_file *out, const char **text, size_t *text_b)
{
    const struct whole_file *file = &out->file;
    *text = file->bytes;
    *text_b = file->size_b;
    if (file->size_b < HEAD_B || word_at(file->bytes) != MAGIC) return;
    if (!chunk_at(file, HEAD_B, JSON_CHUNK, text, text_b)) return;
    const size_t behind = HEAD_B + CHUNK_HEAD_B + *text_b, aligned = (behind + 3) & ~(size_t)3;
    if (!chunk_at(file, aligned, BINARY_CHUNK, &out->binary, &out->binary_b) &&
        !chunk_at(file, behind, BINARY_CHUNK, &out->binary, &out->binary_b))
        out->binary = NULL;
}

bool gltf_file_read(const char *path, struct gltf_file *out, struct error *err)
{
    json_error_t reason;
    const char *text;
    size_t text_b;
    *out = (struct gltf_file){0};
    if (!whole_file_read(path, &out->file, err)) return false;
    find_parts(out, &text, &text_b);
    const size_t mark_b = whole_file_mark_b(text, text_b) == WHOLE_FILE_UTF8_B ? WHOLE_FILE_UTF8_B : 0;
    out->root = json_loadb(text + mark_b, text_b - mark_b, JSON_DISABLE_EOF_CHECK, &reason);
    if (out->root) return true;
    gltf_file_free(out);
    const bool has_nul = strstr(reason.text, "JSON_ALLOW_NUL") != NULL; /* the library's flag is nobody's help */
    return error_set(err, "%s:%d: %s", path, reason.line,
                     has_nul ? "a text in it has the character \\u0000" : reason.text);
}

void gltf_file_free(struct gltf_file *file)
{
    json_decref(file->root);
    whole_file_free(&file->file);
    *file = (struct gltf_file){0};
}

bool gltf_file_is_2(const struct gltf_file *file)
{
    const char *version = json_string_value(json_object_get(json_object_get(file->root, "asset"), "version"));
    return version && version[0] == '2';
}

json_t *gltf_element(const struct gltf_file *file, const char *array, size_t index)
{
    return json_array_get(json_object_get(file->root, array), index);
}

bool gltf_index(const json_t *object, const char *name, size_t *out)
{
    const json_t *number = json_object_get(object, name);
    if (!json_is_integer(number) || json_integer_value(number) < 0) return false;
    *out = (size_t)json_integer_value(number);
    return true;
}

bool gltf_numbers(const json_t *object, const char *name, size_t count, double *out)
{
    const json_t *array = json_object_get(object, name);
    if (!json_is_array(array) || json_array_size(array) != count) return false;
    for (size_t i = 0; i < count; i++) {
        const json_t *number = json_array_get(array, i);
        if (!json_is_number(number)) return false;
        out[i] = json_number_value(number);
    }
    return true;
}

json_t *gltf_scene_nodes(const struct gltf_file *file)
{
    size_t scene = 0;
    gltf_index(file->root, "scene", &scene);
    return json_object_get(gltf_element(file, "scenes", scene), "nodes");
}
