/* SPDX-License-Identifier: MIT */
#include "gltf/gltf_extensions.h"

#include "model/note_words.h"

#include <stdio.h>
#include <string.h>

enum fate {
    DRAWN,   /* as it says */
    UNSEEN,  /* nothing of it is to be seen */
    LEFT_OUT /* `words` say what is drawn instead */
};

/* In the order of their names. What shines is not drawn of any format: a face has one colour, from wherever it is seen.
 */
static const struct extension {
    const char *name;
    enum fate fate;
    const char *words;
} EXTENSIONS[] = {
    {"EXT_lights_ies", LEFT_OUT, WORDS_LIGHTS},
    {"EXT_lights_image_based", LEFT_OUT, WORDS_LIGHTS},
    {"EXT_mesh_features", UNSEEN, NULL},
    {"EXT_mesh_gpu_instancing", DRAWN, NULL},
    {"EXT_meshopt_compression", DRAWN, NULL},
    {"EXT_structural_metadata", UNSEEN, NULL},
    {"EXT_texture_avif", DRAWN, NULL},
    {"EXT_texture_webp", DRAWN, NULL},
    {"FB_ngon_encoding", UNSEEN, NULL}, /* how triangles were cut from faces */
    {"GODOT_single_root", UNSEEN, NULL},
    {"KHR_animation_pointer", LEFT_OUT, "what it animates stands still; nodes alone move"},
    {"KHR_audio", UNSEEN, NULL},
    {"KHR_draco_mesh_compression", DRAWN, NULL},
    {"KHR_lights_punctual", LEFT_OUT, WORDS_LIGHTS},
    {"KHR_materials_anisotropy", LEFT_OUT, WORDS_SHINE},
    {"KHR_materials_clearcoat", LEFT_OUT, WORDS_SHINE},
    {"KHR_materials_diffuse_transmission", LEFT_OUT, "what lets light through is drawn opaque"},
    {"KHR_materials_dispersion", LEFT_OUT, "what breaks light is drawn opaque"},
    {"KHR_materials_emissive_strength", DRAWN, NULL},
    {"KHR_materials_ior", LEFT_OUT, WORDS_SHINE},
    {"KHR_materials_iridescence", LEFT_OUT, WORDS_SHINE},
    {"KHR_materials_pbrSpecularGlossiness", DRAWN, NULL},
    {"KHR_materials_sheen", LEFT_OUT, WORDS_SHINE},
    {"KHR_materials_specular", LEFT_OUT, WORDS_SHINE},
    {"KHR_materials_transmission", LEFT_OUT, "glass is drawn opaque; alphaMode BLEND makes it clear"},
    {"KHR_materials_unlit", DRAWN, NULL},
    {"KHR_materials_variants", LEFT_OUT, "the materials that meshes name themselves are drawn, not the variants"},
    {"KHR_materials_volume", LEFT_OUT, "glass is drawn opaque; alphaMode BLEND makes it clear"},
    {"KHR_mesh_quantization", DRAWN, NULL},
    {"KHR_meshopt_compression", DRAWN, NULL},
    {"KHR_node_hoverability", UNSEEN, NULL},
    {"KHR_node_selectability", UNSEEN, NULL},
    {"KHR_node_visibility", LEFT_OUT, "nodes that it hides are drawn"},
    {"KHR_texture_basisu", DRAWN, NULL}, /* where there is another picture; else that picture is refused */
    {"KHR_texture_transform", DRAWN, NULL},
    {"KHR_xmp", UNSEEN, NULL},
    {"KHR_xmp_json_ld", UNSEEN, NULL},
    {"MSFT_lod", LEFT_OUT, "the finest level of each thing is drawn"},
    {"MSFT_texture_dds", DRAWN, NULL}, /* likewise */
    {"VRM", UNSEEN, NULL},
};

static const struct extension *find(const char *name)
{
    for (size_t i = 0; i < sizeof EXTENSIONS / sizeof *EXTENSIONS; i++)
        if (strcmp(EXTENSIONS[i].name, name) == 0) return &EXTENSIONS[i];
    return NULL;
}

static bool check_required(const char *path, const struct gltf_file *file, struct error *err)
{
    size_t i;
    json_t *entry;
    json_array_foreach(json_object_get(file->root, "extensionsRequired"), i, entry)
    {
        const char *name = json_string_value(entry);
        if (name && !find(name))
            return error_set(err, "%s: it requires the extension %s, which is not read; export it without that", path,
                             name);
    }
    return true;
}

/* NULL: of those that are not known. */
static bool are_for(const char *words, const char *name)
{
    const struct extension *known = find(name);
    if (!known || !words) return !known && !words;
    return known->words && strcmp(known->words, words) == 0;
}

/* Whether anything in the file has it: that it is listed as used does not say so. */
static bool is_anywhere(const json_t *in, const char *name)
{
    const char *key;
    json_t *value;
    size_t i;
    if (json_object_get(json_object_get(in, "extensions"), name)) return true;
    json_object_foreach((json_t *)in, key, value)
    {
        if (is_anywhere(value, name)) return true;
    }
    json_array_foreach(in, i, value)
    {
        if (is_anywhere(value, name)) return true;
    }
    return false;
}

/* All that are used, of which the same is to be said: in one line. */
static void note_words(const struct gltf_file *file, const char *words, struct model *model)
{
    char names[512] = "";
    size_t i, length = 0;
    json_t *entry;
    json_array_foreach(json_object_get(file->root, "extensionsUsed"), i, entry)
    {
        const char *name = json_string_value(entry);
        if (!name || !are_for(words, name) || !is_anywhere(file->root, name)) continue;
        if (length < sizeof names)
            length += (size_t)snprintf(names + length, sizeof names - length, "%s%s", length ? ", " : "", name);
    }
    if (length) model_note(model, "%s: %s", names, words ? words : "not known, and not drawn");
}

static bool is_first_with_words(size_t index)
{
    for (size_t i = 0; i < index; i++)
        if (are_for(EXTENSIONS[index].words, EXTENSIONS[i].name)) return false;
    return true;
}

bool gltf_extensions_check(const char *path, const struct gltf_file *file, struct model *model, struct error *err)
{
    if (!check_required(path, file, err)) return false;
    for (size_t i = 0; i < sizeof EXTENSIONS / sizeof *EXTENSIONS; i++)
        if (EXTENSIONS[i].words && is_first_with_words(i)) note_words(file, EXTENSIONS[i].words, model);
    note_words(file, NULL, model);
    return true;
}

const char *gltf_extension_at(size_t index, bool *is_drawn, const char **words)
{
    if (index >= sizeof EXTENSIONS / sizeof *EXTENSIONS) return NULL;
    *is_drawn = EXTENSIONS[index].fate == DRAWN;
    *words = EXTENSIONS[index].words;
    return EXTENSIONS[index].name;
}
