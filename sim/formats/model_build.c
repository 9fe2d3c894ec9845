/* SPDX-License-Identifier: MIT */
#include "formats/model_build.h"

#include "base/grow.h"
#include "base/inputs.h"
#include "files/companion.h"
#include "files/picture.h"
#include "formats/float_step.h"
#include "formats/model_limits.h"
#include "model/note_words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WHITE = 0xFFFFFF };
static const double HOLE_BELOW = 0.5; /* of a picture's alpha */

/* Vertices and corners --------------------------------------------------------------------------------------------- */

void build_vertices_begin(struct model_build *build)
{
    build->vertex_first = build->model->point_count;
    build->vertex_count = 0;
}

static void add_point(struct model_build *build, const double at_m[3], const double uv[2])
{
    struct model *model = build->model;
    double own_m[3];
    memcpy(own_m, at_m, sizeof own_m); /* it may be one of those that move */
    model->points = grow(model->points, model->point_count, &build->point_capacity, sizeof *model->points);
    build->uvs = grow(build->uvs, model->point_count, &build->uv_capacity, sizeof *build->uvs);
    memcpy(build->uvs[model->point_count], uv, sizeof *build->uvs);
    memcpy(model->points[model->point_count++], own_m, sizeof own_m);
}

bool build_vertex(struct model_build *build, const double at_m[3], bool is_float32)
{
    static const double none[2] = {NAN, NAN};
    if (build->model->point_count == MOST_CORNERS)
        return error_set(build->err, "%s: more than %d corners or vertices", build->path, MOST_CORNERS);
    for (int axis = 0; axis < 3 && is_float32; axis++)
        build->step_m = fmax(build->step_m, float_step_at(fabs(at_m[axis])));
    add_point(build, at_m, none);
    build->vertex_count++;
    return true;
}

void build_vertex_uv(struct model_build *build, const double uv[2])
{
    memcpy(build->uvs[build->model->point_count - 1], uv, sizeof *build->uvs);
}

static bool add_corner(struct model_build *build, uint32_t point)
{
    struct model *model = build->model;
    const size_t face = model->face_count + 1;
    if (model->corner_count == MOST_CORNERS || model->point_count > MOST_CORNERS)
        return error_set(build->err, "%s: more than %d corners or vertices", build->path, MOST_CORNERS);
    if (model->corner_count - build->first_corner == MOST_FACE_CORNERS)
        return error_set(build->err, "%s: face %zu has more than %d corners", build->path, face, MOST_FACE_CORNERS);
    for (int axis = 0; axis < 3; axis++)
        if (!isfinite(model->points[point][axis]))
            return error_set(build->err, "%s: face %zu has a corner whose coordinates are NaN or infinite", build->path,
                             face);
    model->corners = grow(model->corners, model->corner_count, &build->corner_capacity, sizeof *model->corners);
    model->corners[model->corner_count++] = point;
    return true;
}

bool build_corner(struct model_build *build, double index, const double uv[2])
{
    struct model *model = build->model;
    if (!(index >= 0 && index < (double)build->vertex_count && index == floor(index)))
        return error_set(build->err, "%s: face %zu: vertex index %.10g is out of range, there are %zu", build->path,
                         model->face_count + 1, index, build->vertex_count);
    size_t point = build->vertex_first + (size_t)index;
    if (uv) {
        add_point(build, model->points[point], uv);
        point = model->point_count - 1;
    }
    return add_corner(build, (uint32_t)point);
}

/* Faces ------------------------------------------------------------------------------------------------------------ */

static void add_colour(struct model_build *build, const struct mean_colour *mean)
{
    struct build_colour *colour;
    build->colours = grow(build->colours, build->model->face_count, &build->colour_capacity, sizeof *build->colours);
    colour = &build->colours[build->model->face_count];
    colour->is_set = mean->count > 0;
    for (int i = 0; i < 4; i++)
        colour->rgba[i] = (float)mean_colour_of(mean, i);
    colour->spread = (float)mean_colour_spread(mean);
}

/* What has a picture, and says nothing of colours, is as the picture is. */
static uint32_t default_colour(const struct model *model, const struct build_look *look)
{
    return look->picture && !model->pictures[look->picture - 1].left_out ? WHITE : MODEL_DEFAULT_COLOUR;
}

bool build_face(struct model_build *build, const struct build_look *look)
{
    struct model *model = build->model;
    const size_t first = build->first_corner, count = model->corner_count - first;
    if (count < 3) model->corner_count = first;
    build->lines += count == 1 || count == 2;
    build->first_corner = model->corner_count;
    if (count < 3) return true;
    if (model->face_count == MOST_FACES)
        return error_set(build->err, "%s: more than %d faces", build->path, MOST_FACES);
    model->faces = grow(model->faces, model->face_count, &build->face_capacity, sizeof *model->faces);
    add_colour(build, &look->colour);
    model->faces[model->face_count++] = (struct model_face){.first = (uint32_t)first,
                                                            .count = (uint32_t)count,
                                                            .colour = default_colour(model, look),
                                                            .picture = look->picture,
                                                            .two_sided = look->two_sided};
    if (look->picture) model->pictures[look->picture - 1].faces++;
    return true;
}

/* Pictures --------------------------------------------------------------------------------------------------------- */

static struct picture *next_picture(struct model_build *build)
{
    struct model *model = build->model;
    model->pictures = grow(model->pictures, model->picture_count, &build->picture_capacity, sizeof *model->pictures);
    return &model->pictures[model->picture_count++];
}

uint32_t build_picture_file(struct model_build *build, const char *name)
{
    picture_read_file(name, next_picture(build));
    return (uint32_t)build->model->picture_count;
}

uint32_t build_picture_bytes(struct model_build *build, const char *name, void *bytes, size_t size_b)
{
    picture_read_bytes(name, bytes, size_b, next_picture(build));
    return (uint32_t)build->model->picture_count;
}

/* What is clear in a picture is a hole, as in those of other formats that do not say what alpha means. */
static void cut_holes(struct model_build *build)
{
    struct model *model = build->model;
    struct masked_pictures masked = {0};
    const size_t count = model->picture_count;
    uint32_t *number = grow_zeroed(count, sizeof *number);
    for (size_t i = 0; i < count; i++) {
        number[i] = (uint32_t)i + 1;
        if (!model->pictures[i].has_alpha) continue;
        next_picture(build);
        model->picture_count--;
        const struct mask_of of = {number[i], number[i], HOLE_BELOW};
        number[i] = masked_picture_make(&masked, &of, model->pictures, (uint32_t)model->picture_count);
        model->picture_count += number[i] > model->picture_count;
    }
    for (size_t i = 0; i < model->face_count; i++) {
        struct model_face *face = &model->faces[i];
        if (!face->picture || number[face->picture - 1] == face->picture) continue;
        model->pictures[face->picture - 1].faces--;
        face->picture = number[face->picture - 1];
        model->pictures[face->picture - 1].faces++;
        if (!face->transparency) face->transparency = picture_transparency(&model->pictures[face->picture - 1]);
    }
    free(number);
    masked_pictures_free(&masked);
}

/* The end ---------------------------------------------------------------------------------------------------------- */

static uint32_t byte_from_unit(double c)
{
    return c > 0 ? (uint32_t)(255 * fmin(c, 1) + 0.5) : 0;
}

/* Some programs write numbers up to 255 as numbers with points. */
static void find_full_colour(struct model_build *build)
{
    double most = 0;
    for (size_t i = 0; i < build->model->face_count; i++)
        for (int channel = 0; channel < 4; channel++)
            most = fmax(most, (double)build->colours[i].rgba[channel]);
    if (build->full_colour != 1 || !(most > 1)) return;
    build->full_colour = 255;
    model_note(build->model, "its colours are numbers up to %.4g, which are taken as parts of 255", most);
}

/* How opaque a face is; 1 where nothing is said. */
static double opacity_of(const struct model_build *build, size_t face)
{
    const struct build_colour *colour = &build->colours[face];
    const bool is_said = colour->is_set && !isnan(colour->rgba[3]);
    return is_said ? fmin(fmax((double)colour->rgba[3] / build->full_colour, 0), 1) : 1;
}

/* Nobody draws a model to hide it: some programs leave the fourth number of a colour at 0. */
static bool is_all_clear(const struct model_build *build)
{
    for (size_t i = 0; i < build->model->face_count; i++)
        if (opacity_of(build, i) > 0) return false;
    model_note(build->model, "the alpha of all its colours is 0; they are drawn as opaque");
    return true;
}

static void take_colours(struct model_build *build)
{
    struct model *model = build->model;
    find_full_colour(build);
    const bool is_opaque = is_all_clear(build);
    for (size_t i = 0; i < model->face_count; i++) {
        const struct build_colour *colour = &build->colours[i];
        struct model_face *face = &model->faces[i];
        if (!colour->is_set) continue;
        face->colour = 0;
        for (int channel = 0; channel < 3; channel++)
            face->colour = face->colour << 8 | byte_from_unit((double)colour->rgba[channel] / build->full_colour);
        if (!is_opaque) face->transparency = (uint8_t)(255 - byte_from_unit(opacity_of(build, i)));
        model->faces_of_many_colours += mean_colour_varies((double)colour->spread / build->full_colour);
    }
}

static bool finish(struct model_build *build)
{
    struct model *model = build->model;
    if (!model->face_count) return error_set(build->err, "%s: " WORDS_NO_FACES, build->path);
    if (build->lines) model_note(model, "%zu " WORDS_LINES, build->lines);
    take_colours(build);
    cut_holes(build);
    if (model->picture_count) {
        model->uvs = build->uvs;
        build->uvs = NULL;
    }
    float_step_note(model, build->step_m);
    return !companions_refused(build->err);
}

bool model_build_from(const char *path, model_builder *read, struct model *model, struct error *err)
{
    struct model_build build = {.path = path, .model = model, .err = err, .full_colour = 1};
    companions_begin(path);
    inputs_note(path);
    const bool ok = read(&build) && finish(&build);
    free(build.colours);
    free(build.uvs);
    if (!ok) model_free(model);
    return ok;
}
