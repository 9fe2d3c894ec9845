/* SPDX-License-Identifier: MIT
 *
 * PLY. Vertices and faces have colours and places in pictures: those of a face, where it has its own, else those of its
 * corners. The body is gone through twice, as faces may come before vertices. A strip's triangles turn one way and the
 * other, and -1 begins a new one. */
#include "formats/own_formats.h"

#include "base/grow.h"
#include "files/whole_file.h"
#include "formats/model_limits.h"
#include "formats/ply_numbers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct numbers {
    double *at;
    size_t count, capacity;
};

struct ply {
    struct ply_header header;
    struct ply_numbers body;
    struct model_build *build;
    double number[PLY_NUMBERS];     /* of the instance that was read; NaN: it has none */
    struct numbers corners, places; /* the same */
    double (*colours)[4];           /* of each vertex, if they have any */
    size_t colour_count, colour_capacity;
    bool is_float32, faces_have_colours;
    size_t ill_placed, unknown_pictures; /* faces */
};

/* An instance ------------------------------------------------------------------------------------------------------ */

static bool fail_early(struct ply *ply, const struct ply_element *element, unsigned long number)
{
    const struct text *text = &ply->body.text;
    const char *at = text->at;
    while (at < text->end && (is_blank(*at) || is_line_end(*at)))
        at++;
    if (ply->body.coding == PLY_TEXT && at < text->end)
        return error_set(text->err, "%s:%zu: the line has fewer numbers than the header says of %s %lu", text->path,
                         text->line, element->name, number);
    return error_set(text->err, "%s: truncated: it ends within %s %lu of %lu", text->path, element->name, number,
                     element->count);
}

/* Parts of 1, of what is a whole number; what has a point is as it is. */
static double unit_from(double value, enum ply_type type)
{
    switch (type) {
    case PLY_USHORT:
        return value / 65535;
    case PLY_SHORT:
        return value / 32767;
    case PLY_FLOAT:
    case PLY_DOUBLE:
        return value;
    default:
        return value / 255;
    }
}

/* A place that the file says is no number is not missing. */
static double said(double value)
{
    return isnan(value) ? (double)INFINITY : value;
}

enum outcome { DONE, EARLY, FAILED };

static enum outcome read_one(struct ply *ply, const struct ply_property *property)
{
    double value;
    if (property->role == PLY_NO_ROLE) return ply_numbers_skip(&ply->body, property->type, 1) ? DONE : EARLY;
    if (!ply_number(&ply->body, property->type, &value)) return EARLY;
    const struct word word = ply_number_word(&ply->body);
    if (property->role <= PLY_Z && isnan(value) && word.length)
        return text_number(&ply->body.text, &word, &value) ? DONE : FAILED;
    if (property->role == PLY_ACROSS || property->role == PLY_UP) value = said(value);
    const bool is_colour = property->role >= PLY_RED && property->role <= PLY_ALPHA;
    ply->is_float32 |= property->role <= PLY_Z && property->type == PLY_FLOAT && ply->body.coding != PLY_TEXT;
    ply->number[property->role] = is_colour ? unit_from(value, property->type) : value;
    return DONE;
}

static enum outcome read_list(struct ply *ply, const struct ply_element *element, const struct ply_property *property)
{
    struct numbers *list = property->role == PLY_CORNERS ? &ply->corners : &ply->places;
    const struct text *text = &ply->body.text;
    double count, value;
    if (!ply_number(&ply->body, property->count, &count)) return EARLY;
    if (!(count >= 0) || count != floor(count)) {
        error_set(text->err, "%s: a list of %s has no whole number in front", text->path, element->name);
        return FAILED;
    }
    if (property->role == PLY_NO_ROLE) return ply_numbers_skip(&ply->body, property->type, count) ? DONE : EARLY;
    if (element->kind == PLY_FACE && count > 2 * MOST_FACE_CORNERS) {
        error_set(text->err, "%s: face %zu has a list of %.0f numbers; %d corners are the most", text->path,
                  ply->build->model->face_count + 1, count, MOST_FACE_CORNERS);
        return FAILED;
    }
    for (; count > 0; count--) {
        if (!ply_number(&ply->body, property->type, &value)) return EARLY;
        list->at = grow(list->at, list->count, &list->capacity, sizeof *list->at);
        list->at[list->count++] = property->role == PLY_PLACES ? said(value) : value;
    }
    return DONE;
}

static bool read_instance(struct ply *ply, const struct ply_element *element, unsigned long number)
{
    ply->corners.count = ply->places.count = 0;
    for (int i = 0; i < PLY_NUMBERS; i++)
        ply->number[i] = NAN;
    if (!element->properties) return true;
    if (!ply_numbers_begin(&ply->body)) return fail_early(ply, element, number);
    for (size_t i = 0; i < element->properties; i++) {
        const struct ply_property *property = &ply->header.properties[element->first + i];
        const enum outcome outcome =
            property->count == PLY_NO_TYPE ? read_one(ply, property) : read_list(ply, element, property);
        if (outcome == FAILED) return false;
        if (outcome == EARLY) return fail_early(ply, element, number);
    }
    return true;
}

/* Vertices --------------------------------------------------------------------------------------------------------- */

static bool has_colours(unsigned roles)
{
    return (roles >> PLY_RED & 7) == 7;
}

static bool take_vertex(struct ply *ply, const struct ply_element *element, unsigned long number)
{
    const double *at_m = &ply->number[PLY_X];
    if (isnan(at_m[0]) || isnan(at_m[1]) || isnan(at_m[2]))
        return error_set(ply->build->err, "%s: vertex %lu: its coordinates are not finite or beyond 3.4e38",
                         ply->build->path, number);
    if (!build_vertex(ply->build, at_m, ply->is_float32)) return false;
    build_vertex_uv(ply->build, (const double[2]){ply->number[PLY_ACROSS], 1 - ply->number[PLY_UP]});
    if (!has_colours(element->roles)) return true;
    ply->colours = grow(ply->colours, ply->colour_count, &ply->colour_capacity, sizeof *ply->colours);
    memcpy(ply->colours[ply->colour_count++], &ply->number[PLY_RED], sizeof *ply->colours);
    return true;
}

/* Faces ------------------------------------------------------------------------------------------------------------ */

/* Numbers that are not there mean the first picture; below 0 is none. */
static uint32_t picture_of(struct ply *ply)
{
    const double number = isnan(ply->number[PLY_PICTURE]) ? 0 : ply->number[PLY_PICTURE];
    if (!ply->header.picture_count || number < 0) return 0;
    if (number < (double)ply->header.picture_count) return (uint32_t)number + 1;
    ply->unknown_pictures++;
    return 0;
}

static bool add_corner(struct ply *ply, double index, const double uv[2], struct build_look *look)
{
    if (!build_corner(ply->build, index, uv)) return false;
    if ((size_t)index < ply->colour_count && !ply->faces_have_colours)
        mean_colour_add(&look->colour, ply->colours[(size_t)index]);
    return true;
}

static bool take_face(struct ply *ply, const struct ply_element *element)
{
    const double *places = ply->places.at;
    const bool has_places = ply->places.count == 2 * ply->corners.count;
    struct build_look look = {.two_sided = true, .picture = picture_of(ply)};
    ply->ill_placed += ply->places.count && !has_places;
    if (has_colours(element->roles)) mean_colour_add(&look.colour, &ply->number[PLY_RED]);
    for (size_t i = 0; i < ply->corners.count; i++) {
        const bool is_placed = has_places && look.picture;
        const double uv[2] = {is_placed ? places[2 * i] : 0, is_placed ? 1 - places[2 * i + 1] : 0};
        if (!add_corner(ply, ply->corners.at[i], is_placed ? uv : NULL, &look)) return false;
    }
    return build_face(ply->build, &look);
}

static bool take_strip_triangle(struct ply *ply, const double corners[3], bool is_odd)
{
    struct build_look look = {.two_sided = true, .picture = picture_of(ply)};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[0] == corners[2]) return true;
    return add_corner(ply, corners[is_odd], NULL, &look) && add_corner(ply, corners[!is_odd], NULL, &look) &&
           add_corner(ply, corners[2], NULL, &look) && build_face(ply->build, &look);
}

static bool take_strips(struct ply *ply)
{
    for (size_t i = 0, length = 0; i < ply->corners.count; i++) {
        length = ply->corners.at[i] == -1 ? 0 : length + 1;
        if (length >= 3 && !take_strip_triangle(ply, &ply->corners.at[i - 2], length % 2 == 0)) return false;
    }
    return true;
}

/* The file --------------------------------------------------------------------------------------------------------- */

static bool take_instance(struct ply *ply, const struct ply_element *element, unsigned long number)
{
    if (element->kind == PLY_VERTEX) return take_vertex(ply, element, number);
    if (element->kind == PLY_FACE) return take_face(ply, element);
    return element->kind != PLY_STRIPS || take_strips(ply);
}

static bool read_body(struct ply *ply, bool vertices)
{
    const struct ply_numbers begin = ply->body;
    for (size_t i = 0; i < ply->header.element_count; i++) {
        const struct ply_element *element = &ply->header.elements[i];
        for (unsigned long number = 1; element->properties && number <= element->count; number++) {
            if (!read_instance(ply, element, number)) return false;
            if ((element->kind == PLY_VERTEX) == vertices && !take_instance(ply, element, number)) return false;
        }
    }
    ply->body = begin;
    return true;
}

static bool check_header(struct ply *ply)
{
    bool vertices_have_colours = false;
    for (size_t i = 0; i < ply->header.element_count; i++) {
        const struct ply_element *element = &ply->header.elements[i];
        if (element->kind == PLY_VERTEX && element->count && (element->roles & 7) != 7)
            return error_set(ply->build->err, "%s: its vertices have no x, y and z", ply->build->path);
        vertices_have_colours |= element->kind == PLY_VERTEX && has_colours(element->roles);
        ply->faces_have_colours |= element->kind == PLY_FACE && has_colours(element->roles);
        if (element->kind == PLY_OTHER && strcmp(element->name, "edge") == 0) ply->build->lines += element->count;
        if (element->kind == PLY_OTHER && element->count && strstr(element->name, "texture"))
            model_note(ply->build->model, "%lu elements '%s' are not read: it has pictures in a way of its own",
                       element->count, element->name);
    }
    if (vertices_have_colours && ply->faces_have_colours)
        model_note(ply->build->model,
                   "both its vertices and its faces have colours; it is drawn in those of the faces");
    return true;
}

static void note_pictures(struct ply *ply)
{
    if (ply->ill_placed)
        model_note(ply->build->model, "%zu faces have lists of texture coordinates that do not fit their corners",
                   ply->ill_placed);
    if (ply->unknown_pictures)
        model_note(ply->build->model, "%zu faces have a picture's number beyond the %zu that it names",
                   ply->unknown_pictures, ply->header.picture_count);
}

static bool read_file(struct ply *ply, const struct whole_file *file)
{
    struct model_build *build = ply->build;
    if (!ply_header_read(build->path, file->bytes, file->size_b, &ply->header, build->err) || !check_header(ply))
        return false;
    const char *body = file->bytes + ply->header.body_at_b;
    ply->body = (struct ply_numbers){
        {build->path, body, file->bytes + file->size_b, NULL, ply->header.lines, build->err}, ply->header.coding};
    for (size_t i = 0; i < ply->header.picture_count; i++)
        build_picture_file(build, ply->header.pictures[i]);
    build_vertices_begin(build);
    if (!read_body(ply, true) || !read_body(ply, false)) return false;
    note_pictures(ply);
    return true;
}

bool import_ply(struct model_build *build)
{
    struct whole_file file;
    if (!whole_file_read(build->path, &file, build->err)) return false;
    struct ply *ply = grow_zeroed(1, sizeof *ply);
    ply->build = build;
    const bool ok = read_file(ply, &file);
    free(ply->colours);
    free(ply->corners.at);
    free(ply->places.at);
    free(ply);
    whole_file_free(&file);
    return ok;
}
