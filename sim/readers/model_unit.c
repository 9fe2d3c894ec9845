/* SPDX-License-Identifier: MIT
 *
 * FBX says how many centimetres its unit has; AMF names it, millimetres unless it says otherwise; OpenGEX has metres,
 * unless it has a metric of distance. Sources: the FBX SDK's FbxSystemUnit; ISO/ASTM 52915, table 1; the OpenGEX
 * specification, Metric. */
#include "readers/model_unit.h"

#include "files/whole_file.h"

#include <assimp/metadata.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double CENTIMETRE_M = 0.01, MILLIMETRE_M = 0.001;

static double fbx_unit_m(const struct aiScene *scene)
{
    const struct aiMetadata *metadata = scene->mMetaData;
    for (unsigned i = 0; metadata && i < metadata->mNumProperties; i++) {
        const struct aiMetadataEntry *entry = &metadata->mValues[i];
        if (strcmp(metadata->mKeys[i].data, "UnitScaleFactor") != 0) continue;
        if (entry->mType == AI_FLOAT) return CENTIMETRE_M * (double)*(const float *)entry->mData;
        if (entry->mType == AI_DOUBLE) return CENTIMETRE_M * *(const double *)entry->mData;
    }
    return CENTIMETRE_M;
}

bool model_says_z_up(const char *path, const struct aiScene *scene)
{
    static const int z_axis = 2;
    const struct aiMetadata *metadata = path_has_suffix(path, ".fbx") ? scene->mMetaData : NULL;
    for (unsigned i = 0; metadata && i < metadata->mNumProperties; i++)
        if (strcmp(metadata->mKeys[i].data, "UpAxis") == 0 && metadata->mValues[i].mType == AI_INT32)
            return *(const int32_t *)metadata->mValues[i].mData == z_axis;
    return false;
}

static double amf_unit_m(const char *text)
{
    static const struct {
        const char *name;
        double unit_m;
    } units[] = {{"inch", 0.0254}, {"feet", 0.3048}, {"foot", 0.3048}, {"meter", 1}, {"micr", 1e-6}};
    const char *tag = strstr(text, "<amf"), *unit = tag ? strstr(tag, "unit") : NULL;
    if (!unit || unit > tag + strcspn(tag, ">")) return MILLIMETRE_M;
    unit += strcspn(unit, "\"'");
    for (size_t i = 0; *unit && i < sizeof units / sizeof *units; i++)
        if (strncmp(unit + 1, units[i].name, strlen(units[i].name)) == 0) return units[i].unit_m;
    return MILLIMETRE_M;
}

static double opengex_unit_m(const char *text)
{
    const char *at = strstr(text, "\"distance\"");
    if (at) at = strstr(at, "float");
    if (at) at = strchr(at, '{');
    return at ? strtod(at + 1, NULL) : 1;
}

static double text_unit_m(const char *path, double (*unit_m_of)(const char *text))
{
    struct whole_file file;
    struct error ignored; /* the library has read it */
    if (!whole_file_read(path, &file, &ignored)) return 1;
    const double unit_m = unit_m_of(file.bytes);
    whole_file_free(&file);
    return unit_m;
}

double model_unit_m(const char *path, const struct aiScene *scene)
{
    double unit_m = 1;
    if (path_has_suffix(path, ".fbx")) unit_m = fbx_unit_m(scene);
    if (path_has_suffix(path, ".amf")) unit_m = text_unit_m(path, amf_unit_m);
    if (path_has_suffix(path, ".ogex")) unit_m = text_unit_m(path, opengex_unit_m);
    return isfinite(unit_m) && unit_m > 0 ? unit_m : 1;
}

static void scale(double at_m[3], double unit_m)
{
    for (int axis = 0; axis < 3; axis++)
        at_m[axis] *= unit_m;
}

void model_to_metres(struct model *model, double unit_m)
{
    for (size_t i = 0; i < model->point_count; i++)
        scale(model->points[i], unit_m);
    for (size_t i = 0; i < model->mover_count; i++)
        scale(model->movers[i].rest.at_m, unit_m);
    for (size_t i = 0; i < model->key_count; i++)
        scale(model->keys[i].pose.at_m, unit_m);
}
