/* SPDX-License-Identifier: MIT
 *
 * Model files that are as their formats want them, written from bytes in many ways: a reader that refuses one, or finds
 * another corner in it, is wrong. */
#ifndef TESTS_FUZZ_WRITER_H
#define TESTS_FUZZ_WRITER_H

#include "fuzz.h"

#include <stdbool.h>

enum { WRITTEN_MAX_B = 4096, WRITTEN_VERTICES_MAX = 9, WRITTEN_FACES_MAX = 6, WRITTEN_CORNERS_MAX = 5 };

enum written_format { WRITTEN_OBJ, WRITTEN_PLY, WRITTEN_STL, WRITTEN_OFF, WRITTEN_GLTF, WRITTEN_GLB, WRITTEN_FORMATS };

struct written {
    enum written_format format;
    char file[WRITTEN_MAX_B];
    size_t size_b;
    double vertices[WRITTEN_VERTICES_MAX][3]; /* as every reader must have them, before nodes move them */
    size_t vertex_count;
    struct {
        size_t count, vertices[WRITTEN_CORNERS_MAX];
    } faces[WRITTEN_FACES_MAX];
    size_t face_count;
    double places[WRITTEN_VERTICES_MAX][3]; /* where nodes bring the vertices; within 1e-12 of reach_m */
    double reach_m;
};

/* Of a file in that format. */
const char *written_name(enum written_format format);

void written_make(struct written *written, enum written_format format, struct fuzz_bytes *bytes);

/* What the formats' writers have in common: text behind text, and bytes that are numbers. */
void written_put(struct written *written, const char *format, ...) __attribute__((format(printf, 2, 3)));
void written_put_bytes(struct written *written, const void *bytes, size_t size_b);
void written_put_whole(struct written *written, uint64_t whole, size_t size_b, bool big_endian);

/* A decimal, in one of the ways of writing it; what it is to be read as. */
double written_put_decimal(struct written *written, struct fuzz_bytes *bytes);

/* The same for JSON, whose numbers have digits on both sides of the point. */
double written_put_json(struct written *written, double value);

void written_gltf(struct written *written, struct fuzz_bytes *bytes);

#endif
