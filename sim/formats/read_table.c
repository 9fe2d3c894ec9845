/* SPDX-License-Identifier: MIT */
#include "formats/read_table.h"

#include "model/note_words.h"

#define NONE                                                                                                           \
    {                                                                                                                  \
        READ_NONE, NULL                                                                                                \
    }
#define DRAWN                                                                                                          \
    {                                                                                                                  \
        READ_DRAWN, NULL                                                                                               \
    }
#define INSTEAD(words)                                                                                                 \
    {                                                                                                                  \
        READ_INSTEAD, words                                                                                            \
    }
#define LEFT_OUT(words)                                                                                                \
    {                                                                                                                  \
        READ_LEFT_OUT, words                                                                                           \
    }
#define REFUSED(words)                                                                                                 \
    {                                                                                                                  \
        READ_REFUSED, words                                                                                            \
    }
#define SILENT                                                                                                         \
    {                                                                                                                  \
        READ_LEFT_OUT, NULL                                                                                            \
    }
#define MEAN INSTEAD(WORDS_MEAN_COLOURS)

/* In the order of enum read_format: OBJ, glTF, PLY, STL, OFF, 3MF, FBX, Collada. */
static const struct read_row ROWS[] = {
    /* clang-format off */
    {"faces of many corners", {DRAWN, NONE, DRAWN, NONE, DRAWN, NONE, DRAWN, DRAWN}},
    {"bent faces", {DRAWN, NONE, DRAWN, NONE, DRAWN, NONE, DRAWN, DRAWN}},
    {"colours of faces", {DRAWN, DRAWN, DRAWN, DRAWN, DRAWN, DRAWN, DRAWN, DRAWN}},
    {"colours of corners", {DRAWN, DRAWN, DRAWN, NONE, DRAWN, DRAWN, DRAWN, DRAWN}},
    {"colours that change", {MEAN, MEAN, MEAN, NONE, MEAN, MEAN, MEAN, MEAN}},
    {"pictures", {DRAWN, DRAWN, DRAWN, NONE, NONE, DRAWN, DRAWN, DRAWN}},
    {"clamped pictures", {DRAWN, DRAWN, NONE, NONE, NONE, INSTEAD(WORDS_REPEATS), SILENT, DRAWN}},
    {"mirrored pictures", {NONE, DRAWN, NONE, NONE, NONE, INSTEAD(WORDS_REPEATS), NONE, DRAWN}},
    {"parts of pictures", {DRAWN, DRAWN, NONE, NONE, NONE, NONE, LEFT_OUT(WORDS_WHOLE_PICTURES),
                           LEFT_OUT(WORDS_WHOLE_PICTURES)}},
    {"opacity", {DRAWN, DRAWN, DRAWN, NONE, DRAWN, DRAWN, DRAWN, DRAWN}},
    {"holes in pictures", {DRAWN, DRAWN, DRAWN, NONE, NONE, DRAWN, DRAWN, DRAWN}},
    {"light of faces", {DRAWN, DRAWN, NONE, NONE, NONE, NONE, DRAWN, DRAWN}},
    {"pictures of light", {DRAWN, DRAWN, NONE, NONE, NONE, NONE, DRAWN, DRAWN}},
    {"faces with two sides", {NONE, DRAWN, NONE, NONE, NONE, NONE, SILENT, DRAWN}},
    {"units", {NONE, NONE, NONE, NONE, NONE, DRAWN, DRAWN, DRAWN}},
    {"up axis", {NONE, NONE, NONE, INSTEAD(WORDS_Z_UP), NONE, DRAWN, DRAWN, DRAWN}},
    {"nodes and instances", {NONE, DRAWN, NONE, NONE, NONE, DRAWN, DRAWN, DRAWN}},
    {"animated nodes", {NONE, DRAWN, NONE, NONE, NONE, NONE, DRAWN, DRAWN}},
    {"skins", {NONE, LEFT_OUT(WORDS_SKINS), NONE, NONE, NONE, NONE, LEFT_OUT(WORDS_SKINS), LEFT_OUT(WORDS_SKINS)}},
    {"morph targets", {NONE, LEFT_OUT(WORDS_MORPHS), NONE, NONE, NONE, NONE, LEFT_OUT(WORDS_MORPHS),
                       REFUSED(WORDS_NO_FACES)}},
    {"lights", {NONE, LEFT_OUT(WORDS_LIGHTS), NONE, NONE, NONE, NONE, LEFT_OUT(WORDS_LIGHTS), LEFT_OUT(WORDS_LIGHTS)}},
    {"cameras", {NONE, SILENT, NONE, NONE, NONE, NONE, SILENT, SILENT}},
    {"lines and points", {LEFT_OUT(WORDS_LINES), LEFT_OUT(WORDS_LISTS_OF_LINES), SILENT, NONE, SILENT,
                          LEFT_OUT(WORDS_BEAMS), LEFT_OUT(WORDS_LINES), LEFT_OUT(WORDS_LINES)}},
    {"curves and surfaces", {LEFT_OUT(WORDS_CURVES), NONE, NONE, NONE, NONE, NONE, NONE, SILENT}},
    {"normals", {SILENT, SILENT, SILENT, SILENT, SILENT, NONE, SILENT, SILENT}},
    {"shine", {SILENT, LEFT_OUT(WORDS_SHINE), NONE, NONE, NONE, NONE, SILENT, SILENT}},
    {"bumps", {SILENT, SILENT, NONE, NONE, NONE, NONE, SILENT, SILENT}},
    /* clang-format on */
};

const char *read_format_name(enum read_format format)
{
    static const char *const names[READ_FORMATS] = {"OBJ", "glTF", "PLY", "STL", "OFF", "3MF", "FBX", "Collada"};
    return names[format];
}

const char *read_fate_name(enum read_fate fate)
{
    static const char *const names[] = {[READ_NONE] = "none",
                                        [READ_DRAWN] = "drawn",
                                        [READ_INSTEAD] = "instead",
                                        [READ_LEFT_OUT] = "left out",
                                        [READ_REFUSED] = "refused"};
    return names[fate];
}

const struct read_row *read_row_at(size_t index)
{
    return index < sizeof ROWS / sizeof *ROWS ? &ROWS[index] : NULL;
}
