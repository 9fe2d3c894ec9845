/* SPDX-License-Identifier: MIT */
#include "readers/model_read.h"

#include "files/picture.h"
#include "files/whole_file.h"
#include "levels/level_path.h"
#include "model/texture_wrap.h"
#include "readers/flat_texture.h"
#include "readers/model_import.h"
#include "readers/picture_crop.h"
#include "readers/source.h"

/* Which way up formats are, that assimp hands over as they are, but for those of 3ds Max. */
static const struct {
    const char *suffix;
    enum up_custom custom;
} CUSTOMS[] = {{".stl", CUSTOM_Z},        {".blend", CUSTOM_ALWAYS_Z}, {".cob", CUSTOM_ALWAYS_Z},
               {".scn", CUSTOM_ALWAYS_Z}, {".3mf", CUSTOM_ALWAYS_Z},   {".amf", CUSTOM_Z},
               {".3ds", CUSTOM_TURNED},   {".ase", CUSTOM_TURNED}};

static enum up_custom custom_of(const char *path)
{
    if (level_path_parse(path, NULL)) return CUSTOM_ALWAYS_Y;
    for (size_t i = 0; i < sizeof CUSTOMS / sizeof *CUSTOMS; i++)
        if (path_has_suffix(path, CUSTOMS[i].suffix)) return CUSTOMS[i].custom;
    return CUSTOM_Y;
}

bool model_read(const char *path, const struct orientation *orientation, struct model *model, struct error *err)
{
    if (!model_import(path, model, err)) return false;
    orientation_apply(orientation, model->says_z_up ? CUSTOM_ALWAYS_Z : custom_of(path), model);
    bool known;
    if (texture_wrap_cuts(model) && !source_find(path, model, &known, err)) {
        model_free(model);
        return false;
    }
    texture_wrap_apply(model);
    model->flat_faces = flat_texture_find(model);
    if (pictures_are_means()) model->mean_faces = flat_texture_take_means(model);
    picture_crop(model);
    return true;
}
