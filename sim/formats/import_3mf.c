/* SPDX-License-Identifier: MIT
 *
 * 3MF by lib3mf. Items of the build are objects at a place; an object is a mesh, or other objects at places.
 * Coordinates are float32 numbers of the file's unit, z is up, and a transform that mirrors leaves outsides outside.
 * Drawn is what is to be built: supports for printing, beams and slices are told of. Source: 3MF Core
 * Specification 1.4. */
#include "formats/own_formats.h"

#include "base/grow.h"
#include "files/whole_file.h"
#include "formats/looks_3mf.h"
#include "model/note_words.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_DEEP = 64, SHOWN_B = 200, MOST_KINDS = 8 };

struct package {
    struct model_build *build;
    lib3mf_handle model;
    double unit_m;
    struct looks_3mf looks;
    size_t supports, others, beamed, sliced; /* objects, as often as they are placed */
};

/* p = m * (p, 1) */
struct place {
    double m[3][4];
};

static struct place place_from(const float transform[3][4])
{
    struct place place;
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 4; column++)
            place.m[row][column] = (double)transform[row][column];
    return place;
}

static struct place place_within(const struct place *outer, const struct place *inner)
{
    struct place place;
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 4; column++) {
            double sum = column == 3 ? outer->m[row][3] : 0;
            for (int k = 0; k < 3; k++)
                sum += outer->m[row][k] * inner->m[k][column];
            place.m[row][column] = sum;
        }
    return place;
}

static bool place_mirrors(const struct place *place)
{
    const double(*m)[4] = place->m;
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) <
           0;
}

static bool fail(const struct package *package, const char *what)
{
    return error_set(package->build->err, "%s: damaged: lib3mf finds no %s", package->build->path, what);
}

/* A mesh ----------------------------------------------------------------------------------------------------------- */

static bool add_vertices(struct package *package, lib3mf_handle mesh, const struct place *place)
{
    uint32_t count = 0;
    if (lib3mf_meshobject_getvertexcount(mesh, &count)) return fail(package, "vertices");
    float(*vertices)[3] = grow_zeroed(count, sizeof *vertices);
    bool ok = !lib3mf_meshobject_getvertices(mesh, vertices, count, &count) || fail(package, "vertices");
    build_vertices_begin(package->build);
    for (uint32_t i = 0; ok && i < count; i++) {
        double at_m[3];
        for (int axis = 0; axis < 3; axis++) {
            const double *row = place->m[axis];
            at_m[axis] = package->unit_m * (row[0] * (double)vertices[i][0] + row[1] * (double)vertices[i][1] +
                                            row[2] * (double)vertices[i][2] + row[3]);
        }
        ok = build_vertex(package->build, at_m, true);
    }
    free(vertices);
    return ok;
}

static bool add_triangle(struct package *package, const uint32_t corners[3], struct build_look *look, double uv[3][2],
                         bool is_mirrored)
{
    for (int k = 0; k < 3; k++) {
        const int from = is_mirrored ? 2 - k : k;
        if (!build_corner(package->build, corners[from], look->picture ? uv[from] : NULL)) return false;
    }
    return build_face(package->build, look);
}

static bool add_triangles(struct package *package, lib3mf_handle mesh, const struct place *place, bool is_surface)
{
    uint32_t count = 0;
    if (lib3mf_meshobject_gettrianglecount(mesh, &count)) return fail(package, "triangles");
    uint32_t(*corners)[3] = grow_zeroed(count, sizeof *corners);
    bool ok = !lib3mf_meshobject_gettriangleindices(mesh, corners, count, &count) || fail(package, "triangles");
    struct mesh_looks_3mf looks = looks_3mf_begin(mesh);
    for (uint32_t i = 0; ok && i < count; i++) {
        double uv[3][2];
        struct build_look look = looks_3mf_of(&package->looks, &looks, i, uv);
        look.two_sided = is_surface;
        ok = add_triangle(package, corners[i], &look, uv, place_mirrors(place));
    }
    looks_3mf_end(&looks);
    free(corners);
    return ok;
}

static bool add_mesh(struct package *package, lib3mf_handle mesh, const struct place *place, bool is_surface)
{
    uint32_t beams = 0, slices = 0;
    package->beamed += !lib3mf_meshobject_getbeamcount(mesh, &beams) && beams > 0;
    package->sliced += !lib3mf_meshobject_getslicestackid(mesh, &slices) && slices > 0;
    return add_vertices(package, mesh, place) && add_triangles(package, mesh, place, is_surface);
}

/* Objects of objects ----------------------------------------------------------------------------------------------- */

static bool add_object(struct package *package, lib3mf_handle object, const struct place *place, int depth);

static bool add_component(struct package *package, lib3mf_handle component, const struct place *place, int depth)
{
    float transform[3][4];
    lib3mf_handle object;
    if (lib3mf_component_gettransform(component, transform) || lib3mf_component_getobjectresource(component, &object))
        return fail(package, "object of a component");
    const struct place inner = place_from(transform), here = place_within(place, &inner);
    const bool ok = add_object(package, object, &here, depth + 1);
    lib3mf_release(object);
    return ok;
}

static bool add_components(struct package *package, lib3mf_handle object, const struct place *place, int depth)
{
    uint32_t count = 0;
    if (depth > MOST_DEEP)
        return error_set(package->build->err, "%s: objects within objects are more than %d deep", package->build->path,
                         MOST_DEEP);
    bool ok = !lib3mf_componentsobject_getcomponentcount(object, &count) || fail(package, "components");
    for (uint32_t i = 0; ok && i < count; i++) {
        lib3mf_handle component;
        if (lib3mf_componentsobject_getcomponent(object, i, &component)) return fail(package, "component");
        ok = add_component(package, component, place, depth);
        lib3mf_release(component);
    }
    return ok;
}

static bool add_object(struct package *package, lib3mf_handle object, const struct place *place, int depth)
{
    uint32_t type = LIB3MF_MODEL;
    int is_mesh = 0;
    if (lib3mf_object_gettype(object, &type) || lib3mf_object_ismeshobject(object, &is_mesh))
        return fail(package, "kind of an object");
    const bool is_support = type == LIB3MF_SUPPORT || type == LIB3MF_SOLID_SUPPORT;
    package->supports += is_support;
    package->others += type == LIB3MF_OTHER;
    if (is_support || type == LIB3MF_OTHER) return true;
    return is_mesh ? add_mesh(package, object, place, type == LIB3MF_SURFACE)
                   : add_components(package, object, place, depth);
}

static bool add_item(struct package *package, lib3mf_handle item)
{
    float transform[3][4];
    lib3mf_handle object;
    if (lib3mf_builditem_getobjecttransform(item, transform) || lib3mf_builditem_getobjectresource(item, &object))
        return fail(package, "object of an item");
    const struct place place = place_from(transform);
    const bool ok = add_object(package, object, &place, 0);
    lib3mf_release(object);
    return ok;
}

static bool add_items(struct package *package)
{
    lib3mf_handle items, item;
    int is_there = 0;
    bool ok = true;
    if (lib3mf_model_getbuilditems(package->model, &items)) return fail(package, "items to build");
    while (ok && !lib3mf_builditemiterator_movenext(items, &is_there) && is_there) {
        if (lib3mf_builditemiterator_getcurrent(items, &item)) break;
        ok = add_item(package, item);
        lib3mf_release(item);
    }
    lib3mf_release(items);
    return ok;
}

/* The file --------------------------------------------------------------------------------------------------------- */

static bool take_unit(struct package *package)
{
    static const double units_m[] = {1e-6, 1e-3, 1e-2, 0.0254, 0.3048, 1};
    uint32_t unit = 0;
    if (lib3mf_model_getunit(package->model, &unit) || unit >= sizeof units_m / sizeof *units_m)
        return fail(package, "unit");
    package->unit_m = units_m[unit];
    return true;
}

/* Codes of lib3mf 1.8. */
enum { UNKNOWN_ELEMENT = 0x80A6, UNKNOWN_EXTENSION = 0x8092 };

/* What says nothing of what is drawn: metadata, identifiers, and an object's default where each triangle has its own.
 */
static bool is_harmless(uint32_t code)
{
    static const uint32_t codes[] = {0x805C, 0x805D, 0x80AE, 0x80B2, 0x80B0, 0x80BB};
    for (size_t i = 0; i < sizeof codes / sizeof *codes; i++)
        if (codes[i] == code) return true;
    return false;
}

static void note_warning(struct model *model, uint32_t code, uint32_t times, const char *text)
{
    if (code == UNKNOWN_ELEMENT)
        model_note(model, "%u elements are unknown to lib3mf, as composite materials and multiproperties are; left out",
                   times);
    else if (code == UNKNOWN_EXTENSION)
        model_note(model, "it requires an extension that is not read; what that adds or changes is missing");
    else if (!is_harmless(code))
        model_note(model, "lib3mf warns, %u times: %s", times, text);
}

/* A line a kind. */
static void note_warnings(struct model *model, lib3mf_handle reader)
{
    uint32_t count = 0, codes[MOST_KINDS], times[MOST_KINDS] = {0}, code, needed_b, kind, kinds = 0;
    char texts[MOST_KINDS][SHOWN_B] = {""};
    if (lib3mf_reader_getwarningcount(reader, &count)) return;
    for (uint32_t i = 0; i < count && kinds < MOST_KINDS; i++) {
        if (lib3mf_reader_getwarningutf8(reader, i, &code, texts[kinds], SHOWN_B, &needed_b)) continue;
        codes[kinds] = code;
        for (kind = 0; codes[kind] != code;)
            kind++;
        times[kind]++;
        kinds += kind == kinds;
    }
    for (kind = 0; kind < kinds; kind++)
        note_warning(model, codes[kind], times[kind], texts[kind]);
}

static bool read_bytes(const struct package *package, struct whole_file *file)
{
    lib3mf_handle reader;
    uint32_t code = 0;
    const char *text = NULL;
    if (lib3mf_model_queryreader(package->model, "3mf", &reader)) return fail(package, "reader for it");
    const bool ok = !lib3mf_reader_readfrombuffer(reader, (uint8_t *)file->bytes, file->size_b);
    if (!ok && (lib3mf_getlasterror(reader, &code, &text) || !text)) text = "for a reason that lib3mf does not tell";
    if (!ok)
        error_set(package->build->err, "%s: damaged, or beyond what lib3mf reads: %.*s", package->build->path, SHOWN_B,
                  text);
    if (ok) note_warnings(package->build->model, reader);
    lib3mf_release(reader);
    return ok;
}

static void note_left_out(const struct package *package)
{
    struct model *model = package->build->model;
    if (package->supports) model_note(model, "%zu objects are supports for printing, and left out", package->supports);
    if (package->others) model_note(model, "%zu objects are of the kind 'other', and left out", package->others);
    if (package->beamed) model_note(model, "%zu " WORDS_BEAMS, package->beamed);
    if (package->sliced) model_note(model, "%zu objects have slices; drawn is their mesh", package->sliced);
    looks_3mf_note(&package->looks);
}

/* What is left out may have been all. */
static bool has_faces(const struct package *package)
{
    if (package->build->model->face_count || !(package->supports || package->others || package->beamed)) return true;
    return error_set(
        package->build->err,
        "%s: nothing to draw: of its objects %zu are supports, %zu are of the kind 'other', %zu are of beams",
        package->build->path, package->supports, package->others, package->beamed);
}

bool import_3mf(struct model_build *build)
{
    struct package package = {.build = build};
    struct whole_file file;
    if (!whole_file_read(build->path, &file, build->err)) return false;
    if (lib3mf_createmodel(&package.model)) {
        whole_file_free(&file);
        return error_set(build->err, "%s: lib3mf does not begin", build->path);
    }
    package.looks = (struct looks_3mf){.build = build, .model = package.model};
    const bool ok = read_bytes(&package, &file) && take_unit(&package) && add_items(&package) && has_faces(&package);
    if (ok) note_left_out(&package);
    looks_3mf_free(&package.looks);
    lib3mf_release(package.model);
    whole_file_free(&file);
    return ok;
}
