/* SPDX-License-Identifier: MIT
 *
 * Nodes, and the keys that move them. */
#include "gltf/gltf_plain_work.h"

#include "base/grow.h"
#include "model/note_words.h"

#include <stdlib.h>

/* Nodes ---------------------------------------------------------------------------------------- */

static bool has_faces(const struct gltf_work *work, const json_t *node)
{
    size_t mesh;
    return gltf_index(node, "mesh", &mesh) &&
           json_array_size(json_object_get(gltf_element(work->file, "meshes", mesh), "primitives")) > 0;
}

static void make_node(struct gltf_work *work, json_t *node)
{
    static const char *const members[] = {"skin", "weights", "camera", "extensions", "extras"};
    for (size_t i = 0; i < sizeof members / sizeof *members; i++)
        json_object_del(node, members[i]);
    if (!has_faces(work, node)) json_object_del(node, "mesh");
}

void gltf_plain_nodes(struct gltf_work *work)
{
    size_t i, skinned = 0;
    json_t *node;
    json_array_foreach(json_object_get(work->file->root, "nodes"), i, node)
    {
        skinned += json_object_get(node, "skin") && has_faces(work, node);
        make_node(work, node);
    }
    if (skinned) model_note(work->model, "%zu " WORDS_SKINS, skinned);
}

/* Animations ----------------------------------------------------------------------------------- */

/* As float32, in the place of an accessor of any kind. */
static bool make_list(struct gltf_work *work, size_t animation, json_t *sampler, const char *name)
{
    size_t accessor;
    struct gltf_array list;
    if (!gltf_index(sampler, name, &accessor)) return true;
    const size_t components = gltf_plain_components(work, accessor);
    if (!gltf_plain_read(work, accessor, "animations", animation, name, components, &list)) return false;
    float *values = grow_zeroed(list.count * components, sizeof *values);
    for (size_t i = 0; i < list.count * components; i++)
        values[i] = (float)list.values[i];
    const size_t written = gltf_output_floats(&work->out, values, list.count, components);
    json_object_set_new(sampler, name, json_integer((json_int_t)written));
    free(values);
    free(list.values);
    return true;
}

bool gltf_plain_animations(struct gltf_work *work)
{
    size_t i, k;
    json_t *animation, *sampler;
    bool ok = true;
    json_array_foreach(json_object_get(work->file->root, "animations"), i, animation)
    {
        json_array_foreach(json_object_get(animation, "samplers"), k, sampler) ok =
            ok && make_list(work, i, sampler, "input") && make_list(work, i, sampler, "output");
    }
    return ok;
}
