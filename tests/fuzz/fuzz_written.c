/* SPDX-License-Identifier: MIT
 *
 * Model files that are as their formats want them: the importer takes each, with the faces that were written, and every
 * corner where it was written, to the last bit (through nodes within their rounding); and the reference's own reader
 * has the same. */
#include "fuzz_writer.h"
#include "readers/import.h"
#include "readers/source.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double ROUNDING = 1e-12;

static const char *check_points(const struct written *written, const struct model *model, double (*points)[3])
{
    const double most_m = ROUNDING * written->reach_m; /* 0 but for glTF */

    for (size_t i = 0; i < model->face_count; i++) {
        const struct model_face *face = &model->faces[i];
        if (face->count != written->faces[i].count) return "a face of other corners than were written";
        for (uint32_t k = 0; k < face->count; k++) {
            const double *point = points[model->corners[face->first + k]];
            const double *place = written->places[written->faces[i].vertices[k]];
            for (int axis = 0; axis < 3; axis++)
                if (!(fabs(point[axis] - place[axis]) <= most_m)) return "a corner is not where it was written";
        }
    }
    return NULL;
}

static const char *check_both(const struct written *written, const char *path, struct model *model)
{
    struct error err;

    if (model->face_count != written->face_count) return "other faces than were written";
    const char *broken = check_points(written, model, model->points);
    if (broken) return broken;
    if (!source_take(path, model, &err)) {
        fprintf(stderr, "%s\n", err.text);
        return "the reference's reader and the importer differ on a file that is as it should be";
    }
    if (!model->source_points) return written->format == WRITTEN_OFF ? NULL : "the reference's reader knows nothing";
    broken = check_points(written, model, model->source_points);
    return broken ? "the reference's reader has a corner elsewhere" : NULL;
}

static const char *run(const uint8_t *input, size_t size_b)
{
    struct fuzz_bytes bytes = {input, size_b};
    struct written written;
    struct model model;
    struct error err;

    written_make(&written, (enum written_format)fuzz_below(&bytes, WRITTEN_FORMATS), &bytes);
    const char *path = fuzz_as_named_file(written_name(written.format), (const uint8_t *)written.file, written.size_b);
    if (!import_model(path, &model, &err)) {
        fprintf(stderr, "%s\n", err.text);
        return "a file that is as it should be was refused";
    }
    const char *broken = check_both(&written, path, &model);
    model_free(&model);
    return broken;
}

const struct fuzz_target fuzz_written = {"written", run, NULL};
