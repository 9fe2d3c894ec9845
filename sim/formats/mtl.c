/* SPDX-License-Identifier: MIT
 *
 * A statement is a word and what is behind it, on a line. */
#include "formats/mtl.h"

#include "base/grow.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double SAME_OPACITY = 1e-3; /* numbers are rounded by who writes them */

static struct mtl_material *last(struct mtl *mtl)
{
    return &mtl->materials[mtl->count - 1];
}

static void add_name(struct names *names, const struct mtl_material *material)
{
    names_add(names, material->name, strlen(material->name));
}

/* Statements ------------------------------------------------------------------------------------------------------- */

typedef bool statement(struct mtl *mtl, struct text *line, const struct word *word);

static bool begin_material(struct mtl *mtl, struct text *line, const struct word *word)
{
    struct word name;
    (void)word;
    text_rest(line, &name);
    if (mtl_find(mtl, name.text, name.length)) names_add(&mtl->doubled, name.text, name.length);
    mtl->materials = grow(mtl->materials, mtl->count, &mtl->capacity, sizeof *mtl->materials);
    mtl->materials[mtl->count++] = (struct mtl_material){.name = grow_zeroed(name.length + 1, 1)};
    memcpy(last(mtl)->name, name.text, name.length);
    return true;
}

static bool is_no_rgb(const struct text *line)
{
    struct text ahead = *line;
    struct word word;
    return text_word(&ahead, &word) && (word_is(&word, "spectral") || word_is(&word, "xyz"));
}

/* One number is grey. */
static bool read_rgb(struct text *line, struct mtl_number rgb[3])
{
    struct word word = {"", 0};
    const size_t count = text_words_left(line);
    if (count != 1 && count < 3)
        return error_set(line->err, "%s:%zu: a colour of %zu numbers; it has one or three", line->path, line->line,
                         count);
    for (int i = 0; i < 3; i++) {
        if (i == 0 || count > 1) text_word(line, &word);
        rgb[i].is_set = text_number(line, &word, &rgb[i].value);
        if (!rgb[i].is_set) return false;
    }
    return true;
}

static bool read_colour(struct mtl *mtl, struct text *line, struct mtl_number rgb[3])
{
    bool is_beyond = false;
    if (is_no_rgb(line)) {
        add_name(&mtl->no_rgb, last(mtl));
        return true;
    }
    if (!read_rgb(line, rgb)) return false;
    for (int i = 0; i < 3; i++)
        is_beyond |= rgb[i].value < 0 || rgb[i].value > 1;
    if (is_beyond) add_name(&mtl->beyond, last(mtl));
    return true;
}

static bool read_number(struct text *line, const struct word *word, struct mtl_number *number)
{
    struct word value;
    if (!text_word(line, &value))
        return error_set(line->err, "%s:%zu: %.*s without a number", line->path, line->line, (int)word->length,
                         word->text);
    number->is_set = text_number(line, &value, &number->value);
    return number->is_set;
}

static bool take_colour(struct mtl *mtl, struct text *line, const struct word *word)
{
    (void)word;
    return read_colour(mtl, line, last(mtl)->colour);
}

static bool take_glow(struct mtl *mtl, struct text *line, const struct word *word)
{
    (void)word;
    return read_colour(mtl, line, last(mtl)->glow);
}

static bool take_opacity(struct mtl *mtl, struct text *line, const struct word *word)
{
    struct text rest = *line;
    struct word option;
    if (text_word(&rest, &option) && word_is(&option, "-halo")) {
        names_add(&mtl->options, option.text, option.length);
        *line = rest;
    }
    return read_number(line, word, &last(mtl)->opacity);
}

static bool take_transparency(struct mtl *mtl, struct text *line, const struct word *word)
{
    return read_number(line, word, &last(mtl)->transparency);
}

static bool take_light(struct mtl *mtl, struct text *line, const struct word *word)
{
    return read_number(line, word, &last(mtl)->light);
}

static bool take_colour_map(struct mtl *mtl, struct text *line, const struct word *word)
{
    (void)word;
    return mtl_map_read(mtl, line, MTL_COLOUR, &last(mtl)->maps[MTL_COLOUR]);
}

static bool take_glow_map(struct mtl *mtl, struct text *line, const struct word *word)
{
    (void)word;
    return mtl_map_read(mtl, line, MTL_GLOW, &last(mtl)->maps[MTL_GLOW]);
}

static bool take_opacity_map(struct mtl *mtl, struct text *line, const struct word *word)
{
    (void)word;
    return mtl_map_read(mtl, line, MTL_OPACITY, &last(mtl)->maps[MTL_OPACITY]);
}

/* Of lights, of shine, of bumps: no flat colour depends on it. */
static bool pass_over(struct mtl *mtl, struct text *line, const struct word *word)
{
    (void)mtl, (void)line, (void)word;
    return true;
}

static bool leave_out(struct mtl *mtl, struct text *line, const struct word *word)
{
    (void)line;
    names_add(&mtl->left_out, word->text, word->length);
    return true;
}

static const struct {
    const char *word;
    statement *take;
} STATEMENTS[] = {{"newmtl", begin_material},  {"kd", take_colour},       {"ke", take_glow},
                  {"d", take_opacity},         {"tr", take_transparency}, {"illum", take_light},
                  {"map_kd", take_colour_map}, {"map_ke", take_glow_map}, {"map_emissive", take_glow_map},
                  {"map_d", take_opacity_map}, {"ka", pass_over},         {"ks", pass_over},
                  {"km", pass_over},           {"ns", pass_over},         {"ni", pass_over},
                  {"tf", pass_over},           {"sharpness", pass_over},  {"pr", pass_over},
                  {"pm", pass_over},           {"ps", pass_over},         {"pc", pass_over},
                  {"pcr", pass_over},          {"aniso", pass_over},      {"anisor", pass_over},
                  {"norm", pass_over},         {"bump", pass_over},       {"disp", pass_over},
                  {"refl", pass_over},         {"map_ka", pass_over},     {"map_ks", pass_over},
                  {"map_ns", pass_over},       {"map_ni", pass_over},     {"map_kn", pass_over},
                  {"map_pr", pass_over},       {"map_pm", pass_over},     {"map_ps", pass_over},
                  {"map_pc", pass_over},       {"map_pcr", pass_over},    {"map_norm", pass_over},
                  {"map_bump", pass_over},     {"map_disp", pass_over},   {"map_refl", pass_over},
                  {"map_rma", pass_over},      {"map_orm", pass_over},    {"map_aat", pass_over}};

static statement *statement_of(const struct word *word)
{
    for (size_t i = 0; i < sizeof STATEMENTS / sizeof *STATEMENTS; i++)
        if (word_is(word, STATEMENTS[i].word)) return STATEMENTS[i].take;
    return leave_out;
}

bool mtl_read(struct mtl *mtl, const char *path, const char *bytes, size_t size_b, struct error *err)
{
    struct text line;
    struct word word;
    const size_t before = mtl->count;
    if (!text_begin(&line, path, bytes, size_b, err)) return false;
    while (text_next_line(&line)) {
        text_word(&line, &word);
        statement *const take = statement_of(&word);
        if (mtl->count == before && take != begin_material)
            names_add(&mtl->early, word.text, word.length);
        else if (!take(mtl, &line, &word))
            return false;
    }
    return true;
}

/* What all of it means --------------------------------------------------------------------------------------------- */

/* Tr is the share of light that passes, but MeshLab's is an opacity. Alone, and 1 for some material and 0 for none, it
 * can only be that: else something would be there that nobody can see. */
static bool is_meshlabs(const struct mtl *mtl)
{
    bool any_one = false;
    for (size_t i = 0; i < mtl->count; i++) {
        const struct mtl_material *material = &mtl->materials[i];
        if (!material->transparency.is_set || material->opacity.is_set) continue;
        if (material->transparency.value <= 0) return false;
        any_one |= material->transparency.value >= 1;
    }
    return any_one;
}

static void settle_opacity(struct mtl *mtl, struct mtl_material *material, bool is_opacity)
{
    const struct mtl_number *transparency = &material->transparency;
    struct mtl_number *opacity = &material->opacity;
    if (!transparency->is_set) return;
    if (opacity->is_set) {
        if (fabs(1 - transparency->value - opacity->value) > SAME_OPACITY) add_name(&mtl->contradicts, material);
        return;
    }
    if (is_opacity) add_name(&mtl->meshlab, material);
    *opacity = (struct mtl_number){is_opacity ? transparency->value : 1 - transparency->value, true};
}

static bool is_black(const struct mtl_material *material)
{
    for (int i = 0; i < 3; i++)
        if (!material->colour[i].is_set || material->colour[i].value > 0) return false;
    return true;
}

const struct mtl_map *mtl_map_of(const struct mtl_material *material)
{
    for (int kind = 0; kind < MTL_PICTURES; kind++)
        if (material->maps[kind].name) return &material->maps[kind];
    return NULL;
}

/* All pictures of a material are seen by the same coordinates. */
static void settle_places(struct mtl *mtl, const struct mtl_material *material)
{
    const struct mtl_map *first = mtl_map_of(material);
    for (int kind = 0; kind < MTL_PICTURES; kind++) {
        const struct mtl_map *map = &material->maps[kind];
        if (!map->name) continue;
        if (memcmp(map->scale, first->scale, sizeof map->scale) != 0) names_add(&mtl->options, "-s", 2);
        if (memcmp(map->offset, first->offset, sizeof map->offset) != 0) names_add(&mtl->options, "-o", 2);
    }
}

void mtl_settle(struct mtl *mtl)
{
    const bool is_opacity = is_meshlabs(mtl);
    for (size_t i = 0; i < mtl->count; i++) {
        struct mtl_material *material = &mtl->materials[i];
        settle_opacity(mtl, material, is_opacity);
        settle_places(mtl, material);
        if (!material->maps[MTL_COLOUR].name) continue;
        if (is_black(material)) add_name(&mtl->black, material);
        for (int k = 0; k < 3 && !material->colour[k].is_set; k++)
            material->colour[k] = (struct mtl_number){1, true}; /* as the picture is */
    }
}

const struct mtl_material *mtl_find(const struct mtl *mtl, const char *name, size_t length)
{
    for (size_t i = 0; i < mtl->count; i++) {
        const struct mtl_material *material = &mtl->materials[i];
        if (strlen(material->name) == length && memcmp(material->name, name, length) == 0) return material;
    }
    return NULL;
}

void mtl_free(struct mtl *mtl)
{
    struct names *kinds[] = {&mtl->early, &mtl->left_out, &mtl->options,     &mtl->no_rgb, &mtl->beyond,
                             &mtl->black, &mtl->doubled,  &mtl->contradicts, &mtl->meshlab};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        names_free(kinds[i]);
    for (size_t i = 0; i < mtl->count; i++) {
        free(mtl->materials[i].name);
        for (int kind = 0; kind < MTL_PICTURES; kind++)
            free(mtl->materials[i].maps[kind].name);
    }
    free(mtl->materials);
    *mtl = (struct mtl){0};
}
