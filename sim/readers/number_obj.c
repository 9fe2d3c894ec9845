/* SPDX-License-Identifier: MIT
 *
 * Wavefront OBJ. Vertices are `v x y z`, with a weight or with a colour behind. What is written has vertices, texture
 * coordinates, faces and their materials; all else means nothing here, or is counted. Source: Wavefront, Advanced
 * Visualizer manual, appendix B. */
#include "readers/numbering.h"

#include "readers/obj.h"
#include "readers/obj_lines.h"

#include <math.h>
#include <string.h>

enum { MOST_NUMBERS = 7, WEIGHTED = 4, COLOURED = 6, WITH_ALPHA = 7 };

struct pass {
    struct numbering *work;
    struct obj_lines lines;
    struct word material; /* what the last usemtl named, if no library defines it; in `name` */
    char name[256];
};

typedef bool statement(struct pass *pass);

/* Vertices --------------------------------------------------------------------------------------------------------- */

static bool write_colour(struct pass *pass, const struct word *words)
{
    struct numbering *work = pass->work;
    for (int i = 0; i < 3; i++) {
        double value = work->obj->full_colour; /* white: what has no colour of its own has its material's */
        if (words && !numbering_parse(work, &words[i], &value)) return false;
        numbering_print(work, " %.9g", value / work->obj->full_colour);
    }
    return true;
}

static bool count_weight(struct pass *pass, const struct word *word)
{
    double weight;
    if (!numbering_parse(pass->work, word, &weight)) return false;
    pass->work->obj->weights += weight != 1;
    return true;
}

static bool number_vertex(struct pass *pass)
{
    struct numbering *work = pass->work;
    struct word words[MOST_NUMBERS];
    double point[3];
    const size_t count = obj_lines_words(&pass->lines, words, MOST_NUMBERS);
    if (count != 3 && count != WEIGHTED && count != COLOURED && count != WITH_ALPHA)
        return error_set(work->err,
                         "%s:%zu: a vertex of %zu numbers; it has three, a weight behind them or a colour of three",
                         work->path, work->line, count);
    for (int i = 0; i < 3; i++)
        if (!numbering_parse(work, &words[i], &point[i])) return false;
    numbering_write(work, "v ", 2);
    if (!numbering_vertex(work, point)) return false;
    if (count == WEIGHTED && !count_weight(pass, &words[3])) return false;
    return !work->obj->has_colours || write_colour(pass, count >= COLOURED ? words + 3 : NULL);
}

static bool is_no_number(const struct word *word)
{
    const size_t sign = word->text[0] == '-' || word->text[0] == '+';
    const struct word bare = {word->text + sign, word->length - sign};
    return word_is(&bare, "nan") || word_is(&bare, "inf") || word_is(&bare, "infinity") || word_is(&bare, "1.#qnan") ||
           word_is(&bare, "1.#ind");
}

/* Of a third number, of textures in space, there is no use. */
static bool number_place(struct pass *pass)
{
    struct numbering *work = pass->work;
    struct word words[2];
    double uv[2] = {0, 0};
    const size_t count = obj_lines_words(&pass->lines, words, 2);
    for (size_t i = 0; i < 2 && i < count; i++)
        if (is_no_number(&words[i]))
            uv[i] = PLACE_NO_NUMBER;
        else if (!numbering_parse(work, &words[i], &uv[i]))
            return false;
    work->place_count++;
    numbering_print(work, "vt %.9g %.9g", uv[0], uv[1]);
    return true;
}

/* Faces ------------------------------------------------------------------------------------------------------------ */

static bool number_corners(struct pass *pass)
{
    if (pass->material.text) names_add(&pass->work->obj->unknown, pass->material.text, pass->material.length);
    return number_face(pass->work, pass->lines.rest);
}

static bool number_material(struct pass *pass)
{
    const struct word name = obj_lines_name(&pass->lines);
    const struct obj *obj = pass->work->obj;
    const size_t number = obj_number_of(obj, obj_find(obj, name));
    const size_t length = name.length < sizeof pass->name ? name.length : sizeof pass->name;
    memcpy(pass->name, name.text, length);
    pass->material = (struct word){number ? NULL : pass->name, length};
    if (number)
        numbering_print(pass->work, "usemtl %zu", number);
    else
        numbering_print(pass->work, "usemtl %s", OBJ_NO_MATERIAL);
    return true;
}

/* Others ----------------------------------------------------------------------------------------------------------- */

/* How files are divided, or curves described; normals, as each face has its own; libraries, which are read already. */
static bool pass_over(struct pass *pass)
{
    (void)pass;
    return true;
}

static bool count_curve(struct pass *pass)
{
    pass->work->obj->curves++;
    return true;
}

static bool count_line(struct pass *pass)
{
    pass->work->obj->lines++;
    return true;
}

static bool leave_out(struct pass *pass)
{
    names_add(&pass->work->obj->left_out, pass->lines.statement.text, pass->lines.statement.length);
    return true;
}

static const struct {
    const char *word;
    statement *take;
} STATEMENTS[] = {{"v", number_vertex},
                  {"vt", number_place},
                  {"f", number_corners},
                  {"fo", number_corners},
                  {"usemtl", number_material},
                  {"vn", pass_over},
                  {"g", pass_over},
                  {"o", pass_over},
                  {"s", pass_over},
                  {"mg", pass_over},
                  {"mtllib", pass_over},
                  {"l", count_line},
                  {"p", count_line},
                  {"curv", count_curve},
                  {"curv2", count_curve},
                  {"surf", count_curve},
                  {"bsp", count_curve},
                  {"bzp", count_curve},
                  {"cdc", count_curve},
                  {"cdp", count_curve},
                  {"res", pass_over},
                  {"vp", pass_over},
                  {"cstype", pass_over},
                  {"deg", pass_over},
                  {"bmat", pass_over},
                  {"step", pass_over},
                  {"parm", pass_over},
                  {"trim", pass_over},
                  {"hole", pass_over},
                  {"scrv", pass_over},
                  {"sp", pass_over},
                  {"con", pass_over},
                  {"end", pass_over},
                  {"bevel", pass_over},
                  {"c_interp", pass_over},
                  {"d_interp", pass_over},
                  {"lod", pass_over},
                  {"shadow_obj", pass_over},
                  {"trace_obj", pass_over},
                  {"ctech", pass_over},
                  {"stech", pass_over}};

static bool number_line(struct pass *pass)
{
    for (size_t i = 0; i < sizeof STATEMENTS / sizeof *STATEMENTS; i++)
        if (word_is(&pass->lines.statement, STATEMENTS[i].word)) return STATEMENTS[i].take(pass);
    return leave_out(pass);
}

/* Faces before the first usemtl would get its material. */
static void begin(struct numbering *work)
{
    if (work->obj->mtl.count) numbering_print(work, "mtllib %s\n", OBJ_MATERIALS);
    numbering_print(work, "usemtl %s\n", OBJ_NO_MATERIAL);
    if (work->obj->place_count) numbering_print(work, "vt %.9g %.9g\n", PLACE_NONE, PLACE_NONE);
}

bool number_obj(struct numbering *work, const char *bytes, size_t size_b)
{
    struct pass pass = {.work = work};
    bool ok = true;
    begin(work);
    for (obj_lines_begin(&pass.lines, bytes, size_b); ok && obj_lines_next(&pass.lines);) {
        work->line = pass.lines.number;
        ok = number_line(&pass);
        numbering_write(work, "\n", 1);
    }
    obj_lines_free(&pass.lines);
    return ok;
}
