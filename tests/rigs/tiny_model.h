/* SPDX-License-Identifier: MIT
 *
 * Models of a few faces, written out in a test. */
#ifndef TESTS_TINY_MODEL_H
#define TESTS_TINY_MODEL_H

#include "model/model.h"

#include <stdlib.h>
#include <string.h>

/* Adds a face with `count` corners of its own at these places. Start from a zeroed model. */
static inline void tiny_add(struct model *model, size_t count, const double (*places)[3])
{
    model->points = realloc(model->points, (model->point_count + count) * sizeof *model->points);
    model->corners = realloc(model->corners, (model->corner_count + count) * sizeof *model->corners);
    model->faces = realloc(model->faces, (model->face_count + 1) * sizeof *model->faces);
    model->faces[model->face_count++] =
        (struct model_face){.first = (uint32_t)model->corner_count, .count = (uint32_t)count, .colour = 0x808080};
    for (size_t i = 0; i < count; i++) {
        memcpy(model->points[model->point_count], places[i], sizeof *places);
        model->corners[model->corner_count++] = (uint32_t)model->point_count++;
    }
}

/* The same for literal places: TINY(&model, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}); */
#define TINY(model, ...)                                                                                               \
    tiny_add((model), sizeof((const double[][3]){__VA_ARGS__}) / sizeof(double[3]), (const double[][3]){__VA_ARGS__})

#endif
