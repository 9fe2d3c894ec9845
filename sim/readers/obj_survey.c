/* SPDX-License-Identifier: MIT */
#include "readers/obj_survey.h"

#include "files/decimal.h"
#include "readers/obj_library.h"
#include "readers/obj_lines.h"

#include <math.h>

enum { COLOURED_NUMBERS = 6, MOST_NUMBERS = 7 };
static const double BYTE_MOST = 255;

/* Some programs write the colours of vertices as whole numbers up to 255. */
static void survey_colour(struct obj *obj, const struct word *words, bool *any_fraction)
{
    for (int i = 3; i < COLOURED_NUMBERS; i++) {
        double value;
        if (!decimal_parse(words[i].text, words[i].length, &value)) continue;
        if (value > 1) obj->full_colour = BYTE_MOST;
        *any_fraction |= value != floor(value) || value > BYTE_MOST;
    }
    obj->has_colours = true;
}

static void survey_vertex(struct obj *obj, const struct obj_lines *lines, bool *any_fraction)
{
    struct word words[MOST_NUMBERS];
    obj->vertex_count++;
    if (obj_lines_words(lines, words, MOST_NUMBERS) >= COLOURED_NUMBERS) survey_colour(obj, words, any_fraction);
}

bool obj_survey(struct obj *obj, const char *path, const char *bytes, size_t size_b, struct error *err)
{
    struct obj_lines lines;
    bool ok = true, any_fraction = false;
    *obj = (struct obj){.path = path, .full_colour = 1};
    for (obj_lines_begin(&lines, bytes, size_b); ok && obj_lines_next(&lines);) {
        const struct word *statement = &lines.statement;
        if (word_is(statement, "v"))
            survey_vertex(obj, &lines, &any_fraction);
        else if (word_is(statement, "vt"))
            obj->place_count++;
        else if (word_is(statement, "mtllib"))
            ok = obj_libraries_read(obj, obj_lines_name(&lines), err);
    }
    if (any_fraction) obj->full_colour = 1;
    obj_lines_free(&lines);
    mtl_settle(&obj->mtl);
    return ok;
}
