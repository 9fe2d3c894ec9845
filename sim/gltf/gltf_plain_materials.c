/* SPDX-License-Identifier: MIT
 *
 * KHR_texture_transform turns coordinates from u towards -v, as all programs that draw it have it. The matrix in its
 * own text turns the other way round. */
#include "gltf/gltf_plain_work.h"

#include "base/grow.h"

#include <math.h>
#include <string.h>

/* How textures are seen ------------------------------------------------------------------------ */

static void set_transform(const json_t *extension, double rows[2][3])
{
    double offset[2] = {0, 0}, scale[2] = {1, 1};
    const double turn = json_number_value(json_object_get(extension, "rotation"));
    gltf_numbers(extension, "offset", 2, offset);
    gltf_numbers(extension, "scale", 2, scale);
    const double c = cos(turn), s = sin(turn);
    const double turned[2][2] = {{c, s}, {-s, c}};
    for (int i = 0; i < 2; i++) {
        for (int k = 0; k < 2; k++)
            rows[i][k] = turned[i][k] * scale[k];
        rows[i][2] = offset[i];
    }
}

static struct gltf_uvs uvs_of(const json_t *texture)
{
    struct gltf_uvs out = {.is_used = texture != NULL, .rows = {{1, 0, 0}, {0, 1, 0}}};
    const json_t *extension = json_object_get(json_object_get(texture, "extensions"), "KHR_texture_transform");
    gltf_index(texture, "texCoord", &out.set);
    if (!extension) return out;
    set_transform(extension, out.rows);
    gltf_index(extension, "texCoord", &out.set);
    return out;
}

static bool are_alike(const struct gltf_uvs *a, const struct gltf_uvs *b)
{
    return a->set == b->set && memcmp(a->rows, b->rows, sizeof a->rows) == 0;
}

static void set_texture(json_t *texture, unsigned set)
{
    json_object_del(texture, "extensions");
    json_object_set_new(texture, "texCoord", json_integer(set));
}

/* What a material has -------------------------------------------------------------------------- */

static void move(json_t *from, const char *name, json_t *to, const char *new_name)
{
    json_t *value = json_object_get(from, name);
    if (value) json_object_set(to, new_name, value);
}

static json_t *member(json_t *object, const char *name)
{
    if (!json_is_object(json_object_get(object, name))) json_object_set_new(object, name, json_object());
    return json_object_get(object, name);
}

/* Its diffuse colour is what is drawn of either kind. */
static void take_diffuse(json_t *material)
{
    json_t *from = json_object_get(json_object_get(material, "extensions"), "KHR_materials_pbrSpecularGlossiness");
    if (!json_is_object(from)) return;
    json_object_set_new(material, "pbrMetallicRoughness", json_object());
    json_t *to = json_object_get(material, "pbrMetallicRoughness");
    move(from, "diffuseFactor", to, "baseColorFactor");
    move(from, "diffuseTexture", to, "baseColorTexture");
}

static void take_strength(json_t *material)
{
    double factor[3];
    const json_t *strength =
        json_object_get(json_object_get(json_object_get(material, "extensions"), "KHR_materials_emissive_strength"),
                        "emissiveStrength");
    if (!json_is_number(strength) || !gltf_numbers(material, "emissiveFactor", 3, factor)) return;
    const double by = json_number_value(strength);
    json_object_set_new(material, "emissiveFactor",
                        json_pack("[f, f, f]", by * factor[0], by * factor[1], by * factor[2]));
}

/* Of its extensions KHR_materials_unlit stays. */
static void leave_out(json_t *material)
{
    json_t *pbr = json_object_get(material, "pbrMetallicRoughness");
    const bool is_unlit = json_object_get(json_object_get(material, "extensions"), "KHR_materials_unlit");
    json_object_del(material, "normalTexture");
    json_object_del(material, "occlusionTexture");
    json_object_del(material, "extensions");
    json_object_del(pbr, "metallicRoughnessTexture");
    if (is_unlit) json_object_set_new(material, "extensions", json_pack("{s:{}}", "KHR_materials_unlit"));
}

static void make_material(json_t *material, struct gltf_look *look)
{
    take_diffuse(material);
    take_strength(material);
    leave_out(material);
    json_t *colour = json_object_get(member(material, "pbrMetallicRoughness"), "baseColorTexture");
    json_t *emission = json_object_get(material, "emissiveTexture");
    *look = (struct gltf_look){.uvs = {uvs_of(colour), uvs_of(emission)}};
    look->sets[GLTF_EMISSION] = colour && !are_alike(&look->uvs[GLTF_COLOUR], &look->uvs[GLTF_EMISSION]);
    set_texture(colour, look->sets[GLTF_COLOUR]);
    set_texture(emission, look->sets[GLTF_EMISSION]);
}

/* Pictures ------------------------------------------------------------------------------------- */

/* A texture may have two pictures: one for all readers, and one that is packed in another way. Packed in a way that is
 * not read it is taken where there is no other, so that the picture is refused by its name. */
static void choose_source(json_t *texture)
{
    static const struct {
        const char *extension;
        bool is_read;
    } kinds[] = {{"EXT_texture_webp", true},
                 {"EXT_texture_avif", true},
                 {"KHR_texture_basisu", false},
                 {"MSFT_texture_dds", false}};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        json_t *source =
            json_object_get(json_object_get(json_object_get(texture, "extensions"), kinds[i].extension), "source");
        if (source && (kinds[i].is_read || !json_object_get(texture, "source")))
            json_object_set(texture, "source", source);
    }
    json_object_del(texture, "extensions");
}

/* A picture that lies in a buffer; false: it leads out of it. */
static bool copy_picture(struct gltf_work *work, json_t *image)
{
    size_t number, buffer, start_b = 0, size_b;
    if (!gltf_index(image, "bufferView", &number)) return true;
    const json_t *view = gltf_element(work->file, "bufferViews", number);
    if (!gltf_index(view, "buffer", &buffer) || buffer >= work->buffers.count) return false;
    if (!gltf_index(view, "byteLength", &size_b)) return false;
    gltf_index(view, "byteOffset", &start_b);
    const struct gltf_buffer *from = &work->buffers.items[buffer];
    if (!from->bytes || start_b > from->size_b || size_b > from->size_b - start_b) return false;
    const size_t copy = gltf_output_view(&work->out, from->bytes + start_b, size_b);
    json_object_set_new(image, "bufferView", json_integer((json_int_t)copy));
    json_object_set_new(image, "mimeType", json_string("image/png")); /* what it is its bytes say */
    return true;
}

void gltf_plain_materials(struct gltf_work *work)
{
    size_t i;
    json_t *item;
    json_t *materials = json_object_get(work->file->root, "materials");
    work->look_count = json_array_size(materials);
    work->looks = grow_zeroed(work->look_count, sizeof *work->looks);
    json_array_foreach(materials, i, item) make_material(item, &work->looks[i]);
    json_array_foreach(json_object_get(work->file->root, "textures"), i, item) choose_source(item);
    json_array_foreach(json_object_get(work->file->root, "images"), i, item)
    {
        if (!copy_picture(work, item)) json_object_clear(item); /* it is no picture, then */
    }
}
