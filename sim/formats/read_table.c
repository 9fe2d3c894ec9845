/* SPDX-License-Identifier: MIT */
#include "formats/read_table.h"

#include "model/note_words.h"

/* clang-format off */
#define NONE {READ_NONE, NULL}
#define DRAWN {READ_DRAWN, NULL}
#define INSTEAD(words) {READ_INSTEAD, words}
#define LEFT_OUT(words) {READ_LEFT_OUT, words}
#define REFUSED(words) {READ_REFUSED, words}
#define SILENT {READ_LEFT_OUT, NULL}
#define MEAN INSTEAD(WORDS_MEAN_COLOURS)
#define MISSING REFUSED(WORDS_NO_FILE WORDS_WITHOUT)

/* In the order of enum read_format: OBJ, glTF, PLY, STL, OFF, 3MF, FBX, Collada, WAD. */
static const struct read_row ROWS[] = {
    {"faces of many corners", {DRAWN, NONE, DRAWN, NONE, DRAWN, NONE, DRAWN, DRAWN, NONE}},
    {"bent faces", {DRAWN, NONE, DRAWN, NONE, DRAWN, NONE, DRAWN, DRAWN, NONE}},
    {"colours of faces", {DRAWN, DRAWN, DRAWN, DRAWN, DRAWN, DRAWN, DRAWN, DRAWN, NONE}},
    {"colours of corners", {DRAWN, DRAWN, DRAWN, NONE, DRAWN, DRAWN, DRAWN, DRAWN, NONE}},
    {"colours that change", {MEAN, MEAN, MEAN, NONE, MEAN, MEAN, MEAN, MEAN, NONE}},
    {"pictures", {DRAWN, DRAWN, DRAWN, NONE, NONE, DRAWN, DRAWN, DRAWN, DRAWN}},
    {"clamped pictures", {DRAWN, DRAWN, NONE, NONE, NONE, INSTEAD(WORDS_REPEATS), SILENT, DRAWN, NONE}},
    {"mirrored pictures", {NONE, DRAWN, NONE, NONE, NONE, INSTEAD(WORDS_REPEATS), NONE, DRAWN, NONE}},
    {"parts of pictures", {DRAWN, DRAWN, NONE, NONE, NONE, NONE, LEFT_OUT(WORDS_WHOLE_PICTURES),
                           LEFT_OUT(WORDS_WHOLE_PICTURES), NONE}},
    {"missing pictures", {MISSING, MISSING, MISSING, NONE, NONE, INSTEAD(WORDS_NOT_IN_IT), MISSING, MISSING,
                          INSTEAD(WORDS_GREY)}},
    {"opacity", {DRAWN, DRAWN, DRAWN, NONE, DRAWN, DRAWN, DRAWN, DRAWN, NONE}},
    {"holes in pictures", {DRAWN, DRAWN, DRAWN, NONE, NONE, DRAWN, DRAWN, DRAWN, DRAWN}},
    {"light of faces", {DRAWN, DRAWN, NONE, NONE, NONE, NONE, DRAWN, DRAWN, NONE}},
    {"pictures of light", {DRAWN, DRAWN, NONE, NONE, NONE, NONE, DRAWN, DRAWN, NONE}},
    {"faces with two sides", {NONE, DRAWN, NONE, NONE, NONE, NONE, SILENT, DRAWN, NONE}},
    {"units", {NONE, NONE, NONE, NONE, NONE, DRAWN, DRAWN, DRAWN, NONE}},
    {"up axis", {NONE, NONE, NONE, INSTEAD(WORDS_Z_UP), NONE, DRAWN, DRAWN, DRAWN, NONE}},
    {"nodes and instances", {NONE, DRAWN, NONE, NONE, NONE, DRAWN, DRAWN, DRAWN, NONE}},
    {"animated nodes", {NONE, DRAWN, NONE, NONE, NONE, NONE, DRAWN, DRAWN, NONE}},
    {"skins", {NONE, LEFT_OUT(WORDS_SKINS), NONE, NONE, NONE, NONE, LEFT_OUT(WORDS_SKINS), LEFT_OUT(WORDS_SKINS),
               NONE}},
    {"morph targets", {NONE, LEFT_OUT(WORDS_MORPHS), NONE, NONE, NONE, NONE, LEFT_OUT(WORDS_MORPHS),
                       REFUSED(WORDS_NO_MORPHS), NONE}},
    {"lights", {NONE, LEFT_OUT(WORDS_LIGHTS), NONE, NONE, NONE, NONE, LEFT_OUT(WORDS_LIGHTS), LEFT_OUT(WORDS_LIGHTS),
                DRAWN}},
    {"cameras", {NONE, SILENT, NONE, NONE, NONE, NONE, SILENT, SILENT, NONE}},
    {"lines and points", {LEFT_OUT(WORDS_LINES), LEFT_OUT(WORDS_LISTS_OF_LINES), LEFT_OUT(WORDS_LINES), NONE,
                          LEFT_OUT(WORDS_LINES), LEFT_OUT(WORDS_BEAMS), LEFT_OUT(WORDS_LINES), LEFT_OUT(WORDS_LINES), NONE}},
    {"curves and surfaces", {LEFT_OUT(WORDS_CURVES), NONE, NONE, NONE, NONE, NONE, NONE, SILENT, NONE}},
    {"normals", {SILENT, SILENT, SILENT, SILENT, SILENT, NONE, SILENT, SILENT, NONE}},
    {"shine", {SILENT, LEFT_OUT(WORDS_SHINE), NONE, NONE, NONE, NONE, SILENT, SILENT, NONE}},
    {"bumps", {SILENT, SILENT, NONE, NONE, NONE, NONE, SILENT, SILENT, NONE}},
    {"other kinds", {NONE, NONE, NONE, NONE, REFUSED(WORDS_OFF_OF_BYTES), NONE, NONE, NONE, REFUSED(WORDS_UDMF)}},
};
/* clang-format on */

const char *read_format_name(enum read_format format)
{
    static const char *const names[READ_FORMATS] = {"OBJ", "glTF", "PLY", "STL", "OFF", "3MF", "FBX", "Collada", "WAD"};
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
