/* SPDX-License-Identifier: MIT
 *
 * A map of a Doom WAD as faces: floors, ceilings and walls, convex, seen from inside. Of the Unofficial Doom Specs'
 * lumps it takes the geometry, the light of sectors and the names of textures; no picture is read. For the benchmark
 * alone: doors are closed, and sky is a ceiling. */
#ifndef BENCH_LEVEL_H
#define BENCH_LEVEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* What a face looks like: its texture's name and its sector's light, 0 to 255. */
struct bench_surface {
    const char *texture; /* 8 bytes, without an end where it has 8 letters */
    int light;
};

/* A corner in metres, y up, and in the texture's repetitions. */
struct bench_corner {
    double x_m, y_m, z_m, u, v;
};

typedef void bench_face_sink(void *context, const struct bench_corner *corners, int count,
                             const struct bench_surface *surface);

struct bench_level;

/* NULL, and `*why` says it, where the bytes have no such map or it is broken. The bytes must stay. */
struct bench_level *bench_level_open(const uint8_t *wad, size_t size_b, const char *map, const char **why);
void bench_level_close(struct bench_level *level);

void bench_level_faces(const struct bench_level *level, bench_face_sink *sink, void *context);

/* A camera file: `frames` of the map's things, evenly chosen, at a man's height, looking where the thing looks. */
bool bench_level_cameras(const struct bench_level *level, FILE *cam, int frames);

#endif
