/* SPDX-License-Identifier: MIT */
#include "readers/model_read.h"

#include "model/flat_texture.h"
#include "readers/model_import.h"
#include "readers/whole_file.h"

bool model_read(const char *path, const struct orientation *orientation, struct model *model, struct error *err)
{
    if (!model_import(path, model, err)) return false;
    flat_texture_find(model);
    orientation_apply(orientation, path_has_suffix(path, ".stl"), model);
    return true;
}
