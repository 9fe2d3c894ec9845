/* SPDX-License-Identifier: MIT
 *
 * mtl_map_read(): what stands in front of a picture's name, and where the name begins. */
#include "formats/mtl.h"

#include "base/grow.h"
#include "files/companion.h"
#include "files/decimal.h"
#include "model/mipmap.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_VALUES = 3 };

struct option {
    struct word word, values[MOST_VALUES];
    double numbers[MOST_VALUES];
    size_t count;
};

/* What an option does to what is drawn. false: something that is not done. */
typedef bool effect(struct mtl_map *map, enum mtl_picture kind, const struct option *option);

static bool place(double out[2], const struct option *option)
{
    for (size_t i = 0; i < 2 && i < option->count; i++)
        out[i] = option->numbers[i];
    return true;
}

static bool set_scale(struct mtl_map *map, enum mtl_picture kind, const struct option *option)
{
    (void)kind;
    return place(map->scale, option);
}

static bool set_offset(struct mtl_map *map, enum mtl_picture kind, const struct option *option)
{
    (void)kind;
    return place(map->offset, option);
}

static bool set_clamp(struct mtl_map *map, enum mtl_picture kind, const struct option *option)
{
    (void)kind;
    map->clamps = option->count && word_is(&option->values[0], "on");
    return true;
}

/* Of sizes of it, of bumps, of reflections. */
static bool change_nothing(struct mtl_map *map, enum mtl_picture kind, const struct option *option)
{
    (void)map, (void)kind, (void)option;
    return true;
}

static bool be_off(struct mtl_map *map, enum mtl_picture kind, const struct option *option)
{
    (void)map, (void)kind;
    return !option->count || word_is(&option->values[0], "off");
}

static bool be_srgb(struct mtl_map *map, enum mtl_picture kind, const struct option *option)
{
    (void)map;
    return kind == MTL_OPACITY || !option->count || word_is(&option->values[0], "srgb");
}

/* Which channel an opacity is in: luminance and alpha are taken as they are there. */
static bool be_any_channel(struct mtl_map *map, enum mtl_picture kind, const struct option *option)
{
    (void)map;
    return kind != MTL_OPACITY || !option->count || word_is(&option->values[0], "l") ||
           word_is(&option->values[0], "m");
}

static bool be_numbers(const struct option *option, const double neutral[MOST_VALUES])
{
    for (size_t i = 0; i < option->count; i++)
        if (option->numbers[i] != neutral[i]) return false;
    return true;
}

/* A base that is added, and a gain. */
static bool be_unmodified(struct mtl_map *map, enum mtl_picture kind, const struct option *option)
{
    (void)map, (void)kind;
    return be_numbers(option, (const double[MOST_VALUES]){0, 1, 0});
}

static bool be_without_turbulence(struct mtl_map *map, enum mtl_picture kind, const struct option *option)
{
    (void)map, (void)kind;
    return be_numbers(option, (const double[MOST_VALUES]){0, 0, 0});
}

static bool be_unknown(struct mtl_map *map, enum mtl_picture kind, const struct option *option)
{
    (void)map, (void)kind, (void)option;
    return false;
}

struct known {
    const char *word;
    size_t numbers; /* at most; 0: a word */
    effect *apply;
};

static const struct known KNOWN[] = {
    {"-s", 3, set_scale},           {"-o", 3, set_offset},          {"-t", 3, be_without_turbulence},
    {"-mm", 2, be_unmodified},      {"-clamp", 0, set_clamp},       {"-blendu", 0, change_nothing},
    {"-blendv", 0, change_nothing}, {"-boost", 0, change_nothing},  {"-bm", 0, change_nothing},
    {"-texres", 0, change_nothing}, {"-type", 0, change_nothing},   {"-cc", 0, be_off},
    {"-colorspace", 0, be_srgb},    {"-imfchan", 0, be_any_channel}};
static const struct known UNKNOWN = {"", MOST_VALUES, be_unknown};

static const struct known *known_of(const struct word *word)
{
    for (size_t i = 0; i < sizeof KNOWN / sizeof *KNOWN; i++)
        if (word_is(word, KNOWN[i].word)) return &KNOWN[i];
    return &UNKNOWN;
}

/* The next word, unless it is the last one: that belongs to the name. */
static bool next_value(struct text *line, struct word *value)
{
    struct text rest = *line;
    if (text_words_left(&rest) < 2 || !text_word(&rest, value)) return false;
    *line = rest;
    return true;
}

static void take_word(struct text *line, struct option *option)
{
    if (next_value(line, &option->values[0])) option->count = 1;
}

static void take_numbers(struct text *line, size_t most, struct option *option)
{
    while (option->count < most) {
        struct text ahead = *line;
        struct word *value = &option->values[option->count];
        if (!next_value(&ahead, value) || !decimal_parse(value->text, value->length, &option->numbers[option->count]))
            return;
        option->count++;
        *line = ahead;
    }
}

/* How many values it has, nobody knows: numbers, or a word, but not the beginning of a file's name. */
static void take_unknown(struct text *line, struct option *option)
{
    char name[PICTURE_NAME_B];
    struct word rest;
    take_numbers(line, MOST_VALUES, option);
    if (option->count) return;
    text_rest(line, &rest);
    if (rest.length >= sizeof name || rest.text[0] == '-') return;
    memcpy(name, rest.text, rest.length);
    name[rest.length] = '\0';
    if (!companion_is_there(name)) take_word(line, option);
}

/* false: the name comes next. */
static bool take_option(struct text *line, struct option *option, const struct known **known)
{
    struct text ahead = *line;
    *option = (struct option){.count = 0};
    if (!next_value(&ahead, &option->word) || option->word.text[0] != '-') return false;
    *line = ahead;
    *known = known_of(&option->word);
    if (*known == &UNKNOWN)
        take_unknown(line, option);
    else if ((*known)->numbers)
        take_numbers(line, (*known)->numbers, option);
    else
        take_word(line, option);
    return true;
}

/* A comment behind a name has a blank before its #, and a name before that has an ending: `a.png # red`. */
static size_t length_before_comment(const struct word *name)
{
    for (size_t i = 1; i < name->length; i++) {
        size_t end = i, letters = 0;
        if (name->text[i] != '#' || !is_blank(name->text[i - 1])) continue;
        while (end > 0 && is_blank(name->text[end - 1]))
            end--;
        while (letters < end && isalnum((unsigned char)name->text[end - 1 - letters]))
            letters++;
        if (letters >= 3 && letters <= 4 && letters < end && name->text[end - 1 - letters] == '.') return end;
    }
    return name->length;
}

bool mtl_map_read(struct mtl *mtl, struct text *line, enum mtl_picture kind, struct mtl_map *map)
{
    struct option option;
    const struct known *known;
    struct word name;
    free(map->name);
    *map = (struct mtl_map){.scale = {1, 1}};
    while (take_option(line, &option, &known))
        if (!known->apply(map, kind, &option)) names_add(&mtl->options, option.word.text, option.word.length);
    text_rest(line, &name);
    name.length = length_before_comment(&name);
    if (name.length >= PICTURE_NAME_B)
        return error_set(line->err, "%s:%zu: it names a file by a path that is too long", line->path, line->line);
    if (!name.length) return true;
    map->name = grow_zeroed(name.length + 1, 1);
    memcpy(map->name, name.text, name.length);
    companion_note(map->name); /* though it may be left out */
    return true;
}
