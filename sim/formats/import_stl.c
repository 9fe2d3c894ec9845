/* SPDX-License-Identifier: MIT
 *
 * STL: facets as words, or as 50 bytes each behind a head of 84, the last four of which count them. The last two bytes
 * of a facet were meant for nothing; two programs put a colour of 15 bits there. Where the head says COLOR=, Magics's:
 * a clear upper bit means a colour of the facet's own, red in the lowest bits. Else VisCAM's and SolidView's: a set
 * upper bit means a colour, blue in the lowest bits. Sources: 3D Systems, StereoLithography Interface Specification,
 * 1988; rp-ml.org, 2001, on colours. */
#include "formats/own_formats.h"

#include "files/text_lines.h"
#include "files/whole_file.h"

#include <stdint.h>
#include <string.h>
#include <strings.h>

enum { HEAD_B = 84, NAME_B = 80, FACET_B = 50, CORNERS_AT_B = 12, CORNER_B = 12, EXTRA_AT_B = 48 };
enum { HAS_BIT_15 = 0x8000, FIVE_BITS = 31, LOOKED_INTO_B = 1024 };

struct stl {
    struct model_build *build;
    const unsigned char *bytes;
    size_t size_b;
    bool is_magics;
    double part[4]; /* Magics: the colour of what has none of its own */
};

static uint32_t little_endian(const unsigned char *at)
{
    return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

static unsigned extra_of(const unsigned char *facet)
{
    return facet[EXTRA_AT_B] | (unsigned)facet[EXTRA_AT_B + 1] << 8;
}

/* Bytes ------------------------------------------------------------------------------------------------------------ */

/* Behind COLOR= are four bytes, and where ,MATERIAL= follows its first four count instead. MeshLab has three bytes and
 * a blank before MATERIAL=, and behind it. */
static void find_part_colour(struct stl *stl)
{
    static const char colour[] = "COLOR=", material[] = ",MATERIAL=", three[] = " MATERIAL=";
    const size_t colour_b = sizeof colour - 1, material_b = sizeof material - 1;
    for (size_t i = 0; i + colour_b + 4 <= NAME_B; i++) {
        if (memcmp(stl->bytes + i, colour, colour_b) != 0) continue;
        const unsigned char *rgba = stl->bytes + i + colour_b;
        const size_t left_b = NAME_B - (i + colour_b + 4);
        const bool has_three = left_b >= material_b + 2 && memcmp(rgba + 3, three, material_b) == 0;
        if (has_three)
            rgba += 3 + material_b;
        else if (left_b >= material_b + 4 && memcmp(rgba + 4, material, material_b) == 0)
            rgba += 4 + material_b;
        stl->is_magics = true;
        for (int channel = 0; channel < 4; channel++)
            stl->part[channel] = channel == 3 && has_three ? 1 : rgba[channel] / 255.0;
        return;
    }
}

/* Programs that know the head alone leave the bytes of all facets at 0: black is not what they mean. */
static bool facets_have_colours(const struct stl *stl, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (extra_of(stl->bytes + HEAD_B + i * FACET_B)) return true;
    return false;
}

static void add_colour(const struct stl *stl, bool has_own, unsigned extra, struct mean_colour *colour)
{
    const double low = (extra & FIVE_BITS) / 31.0, high = (extra >> 10 & FIVE_BITS) / 31.0;
    const double green = (extra >> 5 & FIVE_BITS) / 31.0;
    if (stl->is_magics && (!has_own || extra & HAS_BIT_15))
        mean_colour_add(colour, stl->part);
    else if (stl->is_magics)
        mean_colour_add(colour, (const double[4]){low, green, high, stl->part[3]});
    else if (extra & HAS_BIT_15)
        mean_colour_add(colour, (const double[4]){high, green, low, 1});
}

static bool read_facet(const struct stl *stl, const unsigned char *facet, bool has_own)
{
    struct build_look look = {.picture = 0};
    build_vertices_begin(stl->build);
    for (int k = 0; k < 3; k++) {
        double at_m[3];
        for (int axis = 0; axis < 3; axis++) {
            const uint32_t bits = little_endian(facet + CORNERS_AT_B + k * CORNER_B + axis * 4);
            float number;
            memcpy(&number, &bits, sizeof number);
            at_m[axis] = (double)number;
        }
        if (!build_vertex(stl->build, at_m, true) || !build_corner(stl->build, k, NULL)) return false;
    }
    add_colour(stl, has_own, extra_of(facet), &look.colour);
    return build_face(stl->build, &look);
}

static bool read_bytes(struct stl *stl)
{
    const struct model_build *build = stl->build;
    const uint32_t count = little_endian(stl->bytes + NAME_B);
    const size_t there = (stl->size_b - HEAD_B) / FACET_B;
    if (there < count)
        return error_set(build->err, "%s: truncated: it ends within triangle %zu of %lu", build->path, there + 1,
                         (unsigned long)count);
    find_part_colour(stl);
    const bool has_own = facets_have_colours(stl, count);
    for (uint32_t i = 0; i < count; i++)
        if (!read_facet(stl, stl->bytes + HEAD_B + (size_t)i * FACET_B, has_own)) return false;
    if (there > count)
        model_note(build->model, "its head counts %lu triangles; %zu bytes behind these are not read",
                   (unsigned long)count, stl->size_b - HEAD_B - (size_t)count * FACET_B);
    return true;
}

/* Words ------------------------------------------------------------------------------------------------------------ */

static bool read_vertex(struct text *text, struct model_build *build)
{
    double at_m[3];
    for (int axis = 0; axis < 3; axis++) {
        struct word word;
        if (!text_any_word(text, &word))
            return error_set(text->err, "%s: truncated: it ends before endsolid", text->path);
        if (!text_number(text, &word, &at_m[axis])) return false;
    }
    return build_vertex(build, at_m, false) && build_corner(build, (double)build->vertex_count - 1, NULL);
}

/* A facet ends where its loop does. Behind `solid` and `endsolid` comes a name, which may have any words. */
static bool read_words(struct stl *stl)
{
    static const struct build_look plain = {.picture = 0};
    struct model_build *build = stl->build;
    struct text text;
    struct word word;
    bool is_open = false;
    if (!text_begin(&text, build->path, (const char *)stl->bytes, stl->size_b, build->err)) return false;
    build_vertices_begin(build);
    while (text_any_word(&text, &word)) {
        const bool begins = word_is(&word, "solid"), ends = word_is(&word, "endsolid");
        if (begins || ends) text.at = text.line_end;
        if (word_is(&word, "vertex") && !read_vertex(&text, build)) return false;
        if ((ends || word_is(&word, "endloop") || word_is(&word, "endfacet")) && !build_face(build, &plain))
            return false;
        is_open = !ends && (is_open || word_is(&word, "facet"));
    }
    return !is_open || error_set(build->err, "%s: truncated: it ends before endsolid", build->path);
}

/* Which of both ---------------------------------------------------------------------------------------------------- */

/* A file of bytes may begin with the word `solid` as well: then there is no facet before the first 0. */
static bool is_text(const struct stl *stl)
{
    char begin[LOOKED_INTO_B + 1] = "";
    memcpy(begin, stl->bytes, stl->size_b < LOOKED_INTO_B ? stl->size_b : LOOKED_INTO_B);
    const int mark_b = whole_file_mark_b(begin, strlen(begin));
    const char *at = begin + (mark_b > 0 ? mark_b : 0);
    at += strspn(at, " \t\r\n");
    if (mark_b == WHOLE_FILE_UTF16) return true;
    if (strncasecmp(at, "solid", 5) != 0) return false;
    for (; *at; at++)
        if (strncasecmp(at, "facet", 5) == 0 || strncasecmp(at, "endsolid", 8) == 0) return true;
    return stl->size_b < HEAD_B;
}

static bool read_any(struct stl *stl)
{
    const bool has_head = stl->size_b >= HEAD_B;
    const size_t count = has_head ? little_endian(stl->bytes + NAME_B) : 0;
    if (has_head && stl->size_b == HEAD_B + count * FACET_B) return read_bytes(stl);
    if (is_text(stl)) return read_words(stl);
    return has_head ? read_bytes(stl)
                    : error_set(stl->build->err, "%s: it is no STL file: neither words nor the head of 84 bytes",
                                stl->build->path);
}

bool import_stl(struct model_build *build)
{
    struct whole_file file;
    if (!whole_file_read(build->path, &file, build->err)) return false;
    struct stl stl = {build, (const unsigned char *)file.bytes, file.size_b, false, {1, 1, 1, 1}};
    const bool ok = read_any(&stl);
    whole_file_free(&file);
    return ok;
}
