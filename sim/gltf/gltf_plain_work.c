/* SPDX-License-Identifier: MIT */
#include "gltf/gltf_plain_work.h"

#include <stdlib.h>
#include <string.h>

size_t gltf_plain_components(const struct gltf_work *work, size_t accessor)
{
    static const char *const types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
    const char *type = json_string_value(json_object_get(gltf_element(work->file, "accessors", accessor), "type"));
    for (size_t i = 0; type && i < sizeof types / sizeof *types; i++)
        if (strcmp(types[i], type) == 0) return i + 1;
    return 0;
}

bool gltf_plain_read(struct gltf_work *work, size_t accessor, const char *array, size_t index, const char *what,
                     size_t components, struct gltf_array *out)
{
    if (gltf_array_read(work->file, &work->buffers, accessor, components, out)) return true;
    free(out->values);
    *out = (struct gltf_array){0};
    return error_set(work->err,
                     "%s: %s[%zu]: its %s (accessor %zu) leads out of its buffer, or is of no type that it "
                     "can have",
                     work->path, array, index, what, accessor);
}
