/* SPDX-License-Identifier: MIT
 *
 * A face's corners, v, v/vt, v//vn or v/vt/vn; any of the last two numbers may be missing. Numbers count from 1, or
 * backwards from what was last. Normals are left out. The library's first texture coordinate is what stands for none,
 * so others have a number more; that makes it keep all of a mesh that has some. */
#include "readers/numbering.h"

#include "readers/obj.h"

#include <stdlib.h>
#include <string.h>

enum { SHOWN = 40 };

static bool refuse_word(const struct numbering *work, const char *word, size_t length)
{
    return error_set(work->err, "%s:%zu: '%.*s' is no corner of a face", work->path, work->line,
                     length < SHOWN ? (int)length : SHOWN, word);
}

/* Of those that there are, from 1; 0: it is none of them. */
static size_t resolve(long number, size_t so_far, size_t count)
{
    const long forward = number < 0 ? (long)so_far + 1 + number : number;
    return forward < 1 || (size_t)forward > count ? 0 : (size_t)forward;
}

/* The number behind a corner's first /; 1 if there is none that means anything. */
static size_t place_of(const struct numbering *work, const char *behind)
{
    char *rest;
    const long number = *behind == '/' ? strtol(behind + 1, &rest, 10) : 0;
    return resolve(number, work->place_count, work->obj->place_count) + 1;
}

static bool write_corner(struct numbering *work, const char *word, size_t length)
{
    char *rest;
    const long number = strtol(word, &rest, 10);
    const size_t vertex = resolve(number, work->table.count, work->obj->vertex_count);
    const size_t digits = (size_t)(rest - word);
    if (rest == word || (digits < length && *rest != '/')) return refuse_word(work, word, length);
    if (!vertex)
        return error_set(work->err, "%s:%zu: vertex index %ld of a face is out of range, there are %zu", work->path,
                         work->line, number, work->obj->vertex_count);
    if (work->obj->place_count)
        numbering_print(work, " %zu/%zu", vertex, place_of(work, digits < length ? rest : ""));
    else
        numbering_print(work, " %zu", vertex);
    return true;
}

bool number_face(struct numbering *work, const char *corners)
{
    numbering_write(work, "f", 1);
    for (const char *at = corners + strspn(corners, " \t"); *at && *at != '#'; at += strspn(at, " \t")) {
        const size_t length = strcspn(at, " \t#");
        if (!write_corner(work, at, length)) return false;
        at += length;
    }
    return true;
}
