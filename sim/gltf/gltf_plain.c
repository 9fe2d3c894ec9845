/* SPDX-License-Identifier: MIT */
#include "gltf/gltf_plain.h"

#include "base/grow.h"
#include "base/inputs.h"
#include "gltf/gltf_extensions.h"
#include "gltf/gltf_plain_work.h"
#include "gltf/gltf_types.h"

#include <stdlib.h>
#include <string.h>

static const char SUFFIX[] = ".glb"; /* by which the library knows how to read it */

/* What the library need not see. */
static void leave_out(json_t *root)
{
    static const char *const members[] = {"extensions", "extensionsRequired", "skins", "cameras", "extras"};
    for (size_t i = 0; i < sizeof members / sizeof *members; i++)
        json_object_del(root, members[i]);
    json_object_set_new(root, "extensionsUsed",
                        json_pack("[s, s]", "KHR_materials_unlit", "KHR_draco_mesh_compression"));
}

static bool make(struct gltf_work *work, struct whole_file *glb)
{
    gltf_plain_materials(work);
    if (!gltf_plain_instances(work) || !gltf_plain_meshes(work) || !gltf_plain_animations(work)) return false;
    gltf_plain_nodes(work);
    leave_out(work->file->root);
    return gltf_output_write(&work->out, work->file->root, glb) ||
           error_set(work->err, "%s: not enough memory", work->path);
}

static bool read_and_make(const char *path, struct gltf_plain *plain, struct model *model, struct error *err)
{
    struct gltf_work work = {.path = path,
                             .file = &plain->file,
                             .table = &plain->table,
                             .is_float32 = &plain->is_float32,
                             .model = model,
                             .err = err};
    gltf_output_begin(&work.out);
    const bool ok = gltf_types_check(path, &plain->file, err) &&
                    gltf_extensions_check(path, &plain->file, model, err) &&
                    gltf_buffers_read(path, &plain->file, &work.buffers, err) && make(&work, &plain->glb);
    gltf_output_free(&work.out);
    gltf_buffers_free(&work.buffers);
    free(work.looks);
    return ok;
}

static char *path_with_suffix(const char *path)
{
    char *out = grow_zeroed(strlen(path) + sizeof SUFFIX, 1);
    memcpy(out, path, strlen(path));
    memcpy(out + strlen(path), SUFFIX, sizeof SUFFIX);
    return out;
}

bool gltf_plain_make(const char *path, struct gltf_plain *plain, struct model *model, struct error *err)
{
    *plain = (struct gltf_plain){0};
    if (!gltf_is_named(path)) return true;
    if (!gltf_file_read(path, &plain->file, err)) return false;
    if (!gltf_file_is_2(&plain->file)) {
        gltf_file_free(&plain->file);
        return true;
    }
    inputs_note(path);
    if (!read_and_make(path, plain, model, err)) {
        gltf_plain_free(plain);
        return false;
    }
    plain->path = path_with_suffix(path);
    return true;
}

void gltf_plain_free(struct gltf_plain *plain)
{
    free(plain->path);
    gltf_file_free(&plain->file);
    whole_file_free(&plain->glb);
    vertex_table_free(&plain->table);
    *plain = (struct gltf_plain){0};
}
