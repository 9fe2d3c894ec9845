/* SPDX-License-Identifier: MIT */
#include "readers/obj_library.h"

#include "base/grow.h"
#include "files/companion.h"
#include "files/name_forms.h"
#include "files/utf16.h"
#include "readers/model_whole.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* Reading ---------------------------------------------------------------------------------------------------------- */

static bool parse(struct obj *obj, const char *name, struct whole_file *file, struct error *err)
{
    utf8_from_utf16(file);
    return model_text_fits(name, file->bytes, file->size_b, err) &&
           mtl_read(&obj->mtl, name, file->bytes, file->size_b, err);
}

enum found { FOUND, NOT_THERE, UNREADABLE };

static enum found read_library(struct obj *obj, const char *name, struct error *err)
{
    struct whole_file file = {0};
    size_t size_b = 0;
    FILE *stream = companion_open(name, MODEL_FILE_MOST_B, &size_b, err);
    if (!stream) return errno == ENOENT || errno == ENOTDIR ? NOT_THERE : UNREADABLE;
    const bool ok = whole_file_take(name, stream, size_b, &file, err) && parse(obj, name, &file, err);
    whole_file_free(&file);
    return ok ? FOUND : UNREADABLE;
}

/* The model's own name with another ending: what programs write that name it wrongly. */
static bool name_as_model(const struct obj *obj, char out[NAME_FORM_B])
{
    const char *bare = name_bare(obj->path);
    const size_t length = strlen(bare);
    if (length < strlen("obj") || length >= NAME_FORM_B) return false;
    strcpy(out, bare);
    strcpy(out + length - strlen("obj"), "mtl");
    return companion_is_there(out);
}

static bool read_instead(struct obj *obj, const char *name, struct error *err)
{
    char instead[NAME_FORM_B];
    names_add(&obj->missing, name, strlen(name));
    if (!name_as_model(obj, instead) || names_have(&obj->instead, instead, strlen(instead))) return true;
    names_add(&obj->instead, instead, strlen(instead));
    return read_library(obj, instead, err) == FOUND;
}

static bool read_name(struct obj *obj, struct word word, struct error *err)
{
    bool ok = true;
    if (!word.length || names_have(&obj->libraries, word.text, word.length)) return true;
    names_add(&obj->libraries, word.text, word.length);
    char *name = grow_zeroed(word.length + 1, 1);
    memcpy(name, word.text, word.length);
    const enum found found = read_library(obj, name, err);
    if (found == NOT_THERE) ok = read_instead(obj, name, err);
    free(name);
    return ok && found != UNREADABLE;
}

/* Names ------------------------------------------------------------------------------------------------------------ */

static bool is_there(struct word name)
{
    char text[NAME_FORM_B];
    if (!name.length || name.length >= sizeof text) return false;
    memcpy(text, name.text, name.length);
    text[name.length] = '\0';
    return companion_is_there(text);
}

static bool ends_as_library(const char *text, size_t length)
{
    static const char *const ends[] = {".mtl", ".mtl\"", ".mtl'"};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        const size_t end_b = strlen(ends[i]);
        if (length >= end_b && word_is(&(struct word){text + length - end_b, end_b}, ends[i])) return true;
    }
    return false;
}

/* The first name of several: up to an ending, as blanks may be the name's own; all of it where there is none. */
static size_t first_name_b(const char *text, size_t length)
{
    for (size_t end = 1; end < length; end++)
        if (is_blank(text[end]) && ends_as_library(text, end)) return end;
    return length;
}

bool obj_libraries_read(struct obj *obj, struct word names, struct error *err)
{
    obj->names_libraries = true;
    if (is_there(names)) return read_name(obj, names, err);
    for (const char *at = names.text, *end = at + names.length; at < end && *at != '#';) {
        const size_t length = first_name_b(at, (size_t)(end - at));
        if (!read_name(obj, (struct word){at, length}, err)) return false;
        for (at += length; at < end && is_blank(*at);)
            at++;
    }
    return true;
}

/* Writing ---------------------------------------------------------------------------------------------------------- */

static void write_colour(FILE *out, const char *word, const struct mtl_number rgb[3])
{
    if (rgb[0].is_set) fprintf(out, "%s %.9g %.9g %.9g\n", word, rgb[0].value, rgb[1].value, rgb[2].value);
}

/* A name that begins with - would be taken for an option. */
static void write_map(FILE *out, const char *word, const struct mtl_map *map)
{
    if (!map->name) return;
    fprintf(out, "%s %s%s%s\n", word, map->clamps ? "-clamp on " : "", map->name[0] == '-' ? "./" : "", map->name);
}

static void write_material(FILE *out, size_t number, const struct mtl_material *material)
{
    fprintf(out, "newmtl %zu\n", number);
    write_colour(out, "Kd", material->colour);
    write_colour(out, "Ke", material->glow);
    if (material->opacity.is_set) fprintf(out, "d %.9g\n", material->opacity.value);
    if (material->light.is_set && material->light.value == 0) fprintf(out, "illum 0\n");
    write_map(out, "map_Kd", &material->maps[MTL_COLOUR]);
    write_map(out, "map_Ke", &material->maps[MTL_GLOW]);
    write_map(out, "map_d", &material->maps[MTL_OPACITY]);
}

struct whole_file obj_materials_text(const struct obj *obj)
{
    struct whole_file text = {0};
    FILE *out = open_memstream(&text.bytes, &text.size_b);
    for (size_t i = 0; out && i < obj->mtl.count; i++)
        write_material(out, i + 1, &obj->mtl.materials[i]);
    if (out) fprintf(out, "\n");
    if (out) fclose(out);
    return text;
}
