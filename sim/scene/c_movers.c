/* SPDX-License-Identifier: MIT
 *
 * What moves in a scene, as C: an object is a scene of its own, its motion a table of keys. */
#include "base/printable.h"
#include "scene/moving.h"
#include "scene/scene_files.h"

#include <stdio.h>
#include <string.h>

/* Of object i, from 0. */
static bool object_name(const struct named_scene *scene, size_t i, char name[C_PATH_MAX_B], struct error *err)
{
    char suffix[32];
    snprintf(suffix, sizeof suffix, "_object%zu", i + 1);
    return c_path(name, scene->name, suffix, err);
}

bool c_movers_share_textures(const struct named_scene *scene)
{
    bool share = false;
    for (size_t i = 0; scene->moving && i < scene->moving->count; i++)
        share = share || scene->moving->objects[i].words;
    return share;
}

/* For the objects' sources. */
static void declare_textures(FILE *file, const struct lim_scene *scene, const char *symbol)
{
    fprintf(file,
            "#if LIM_HAS_TEXTURE\nextern const LIM_FLASH struct lim_texture %s_textures[%u];\n"
            "extern const LIM_FLASH uint16_t %s_palettes[%u];\nextern const LIM_FLASH uint8_t %s_texels[%u];\n#endif\n",
            symbol, (unsigned)scene->texture_count, symbol, (unsigned)scene->palette_colours, symbol,
            scene->texel_blocks * (unsigned)LIM_TEXEL_BLOCK);
}

/* A node may be called anything: what would end the comment, or its line, or turn it round, is left out. */
static void write_in_comment(FILE *file, const char *text)
{
    for (size_t length; *text; text += length)
        if (printable_at(text, &length) == PRINTABLE && !strchr("*\\?", *text)) fwrite(text, 1, length, file);
}

void c_movers_declare(FILE *file, const struct named_scene *scene, const struct c_name *name)
{
    const struct moving *moving = scene->moving;
    const struct lim_movers_limits *limits = &moving->limits;
    fprintf(file, "\n/* What moves in it, in this order:");
    for (size_t i = 0; i < moving->count; i++) {
        fputs(i ? ", '" : " '", file);
        write_in_comment(file, moving->objects[i].name);
        fputs(moving->objects[i].scene.report.mesh_leaves ? "', by distance: an approximate order" : "'", file);
    }
    fprintf(file, ". Initialises struct lim_movers_limits; and bytes for lim_movers_init(). */\n");
    fprintf(file, "#define %s_MOVERS %zu\n", name->macro, moving->count);
    fprintf(file, "#define %s_MOVERS_LIMITS {%u, %u, %u, %u}\n", name->macro, (unsigned)limits->instances,
            (unsigned)limits->depth, (unsigned)limits->leaf_vertices, (unsigned)limits->leaf_polygons);
    fprintf(file, "#define %s_MOVERS_MEM_B (LIM_MOVERS_MEM_B(%u, %u, %u)", name->macro,
            (unsigned)scene->scene->scene.limits.depth, (unsigned)limits->instances, (unsigned)limits->depth);
    if (limits->leaf_polygons)
        fprintf(file, " + LIM_MESH_LEAF_MEM_B(%u, %u)", (unsigned)limits->leaf_vertices,
                (unsigned)limits->leaf_polygons);
    fputs(")\n", file);
    if (moving->light.on)
        fprintf(file, "/* Initialises struct lim_light. */\n#define %s_LIGHT {true, {%d, %d, %d}, %u, %u}\n",
                name->macro, moving->light.to_q14[0], moving->light.to_q14[1], moving->light.to_q14[2],
                (unsigned)moving->light.middle_q8, (unsigned)moving->light.swing_q8);
    fprintf(file, "\nextern const struct lim_moved *const %s_movers;\n", name->symbol);
    if (c_movers_share_textures(scene)) declare_textures(file, &scene->scene->scene, name->symbol);
    for (size_t i = 0; i < moving->count; i++)
        fprintf(file, "extern const struct lim_scene %s_object%zu_scene LIM_AGREES(%s_object%zu_scene);\n",
                name->symbol, i + 1, name->symbol, i + 1);
}

static void write_keys(FILE *file, const struct moving_object *object, const struct c_name *name, size_t i)
{
    fprintf(file, "\nstatic const LIM_FLASH struct lim_motion_key %s_keys%zu[%u] = {", name->symbol, i + 1,
            (unsigned)object->motion.count);
    for (size_t k = 0; k < object->motion.count; k++) {
        const struct lim_motion_key *key = &object->keys[k];
        fprintf(file, "\n    {%luu, {%ld, %ld, %ld}, {%d, %d, %d, %d}, %u},", (unsigned long)key->time_ms,
                (long)key->at_q8[0], (long)key->at_q8[1], (long)key->at_q8[2], key->turn_q15[0], key->turn_q15[1],
                key->turn_q15[2], key->turn_q15[3], (unsigned)key->arc);
    }
    fprintf(file, "\n};\n");
}

/* Where keys of a scene of many scales count from. */
static void write_origins(FILE *file, const struct moving_object *object, const struct c_name *name, size_t i)
{
    fprintf(file, "\nstatic const LIM_FLASH struct lim_long_vertex %s_origins%zu[%u] = {", name->symbol, i + 1,
            (unsigned)object->motion.count);
    for (size_t k = 0; k < object->motion.count; k++)
        fprintf(file, "\n    {{%ld, %ld, %ld}},", (long)object->origins[k].at[0], (long)object->origins[k].at[1],
                (long)object->origins[k].at[2]);
    fprintf(file, "\n};\n");
}

static void write_moved(FILE *file, const struct moving *moving, const struct c_name *name, size_t i)
{
    const struct lim_instance *instance = &moving->instances[i];
    fprintf(file,
            "\n    {.object = &%s_object%zu_scene,\n     .motion = {.keys = %s_keys%zu, .count = %u, .repeats = true",
            name->symbol, i + 1, name->symbol, i + 1, (unsigned)moving->objects[i].motion.count);
    if (moving->objects[i].origins) fprintf(file, ", .origins = {%s_origins%zu}", name->symbol, i + 1);
    fprintf(file, "},\n     .finer_bits = %u", (unsigned)instance->finer_bits);
    if (moving->objects[i].origins) fprintf(file, ",\n     .coarser_bits = {%u}", (unsigned)*instance->coarser_bits);
    fputs("},", file);
}

static void write_movers(FILE *file, const struct named_scene *scene, const struct c_name *name,
                         const struct c_name *header)
{
    const struct moving *moving = scene->moving;
    fprintf(file, "/* What moves in %s, declared in %s.h; written by `limner compile`. */\n", name->file, header->file);
    fprintf(file, "#include \"%s.h\"\n", header->file);
    for (size_t i = 0; i < moving->count; i++)
        write_keys(file, &moving->objects[i], name, i);
    for (size_t i = 0; i < moving->count; i++)
        if (moving->objects[i].origins) write_origins(file, &moving->objects[i], name, i);
    fprintf(file, "\nstatic const struct lim_moved %s_moved[%zu] = {", name->symbol, moving->count);
    for (size_t i = 0; i < moving->count; i++)
        write_moved(file, moving, name, i);
    fprintf(file, "\n};\n\nconst struct lim_moved *const %s_movers = %s_moved;\n", name->symbol, name->symbol);
}

static bool put_objects(const struct named_scene *scene, const char *header, struct outputs *outputs, struct error *err)
{
    for (size_t i = 0; i < scene->moving->count; i++) {
        char name[C_PATH_MAX_B];
        const struct moving_object *own = &scene->moving->objects[i];
        const struct named_scene object = {&own->scene, name, NULL, own->words ? scene->name : NULL};
        if (!object_name(scene, i, name, err) || !c_source_put(&object, header, outputs, err)) return false;
    }
    return true;
}

bool lim_movers_put(const struct named_scene *scene, struct outputs *outputs, struct error *err)
{
    for (size_t i = 0; i < scene->moving->count; i++) {
        char name[C_PATH_MAX_B], path[C_PATH_MAX_B];
        if (!object_name(scene, i, name, err) || !c_path(path, name, ".lim", err) ||
            !lim_file_put(&scene->moving->objects[i].scene, path, outputs, err))
            return false;
    }
    return true;
}

bool c_movers_put(const struct named_scene *scene, const char *header, struct outputs *outputs, struct error *err)
{
    char path[C_PATH_MAX_B];
    struct c_name name, header_name;
    if (!put_objects(scene, header, outputs, err) || !c_path(path, scene->name, "_movers.c", err) ||
        !c_name_init(&name, scene->name, err) || !c_name_init(&header_name, header, err))
        return false;
    FILE *file = outputs_open(outputs, path, err);
    if (!file) return false;
    write_movers(file, scene, &name, &header_name);
    return outputs_close(file, path, err);
}
