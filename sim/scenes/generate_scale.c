/* SPDX-License-Identifier: MIT
 *
 * generate_scale rooms N OUTDIR | mesh N OUTDIR | floor N OUTDIR | ground N OUTDIR: scenes of any size, to see how
 * costs and errors grow. Writes roomsN.obj, a building of N x N rooms, meshN.obj (and meshN.mtl), a mesh of about N
 * triangles, floorN.obj, a floor of N m with boxes of 0.1 to 1.5 m, or groundN.obj, the same with boxes of 0.6 m;
 * beside it a camera file of 64 frames, whose views of the building are the same in every one of 6 x 6 rooms or more,
 * and of the boxes on every floor. The same files on every run. */
#include "scale_floor.h"
#include "scale_mesh.h"
#include "scale_rooms.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { NAME_MAX_B = 4096 };

struct output {
    const char *folder, *kind, *size;
};

static FILE *open_output(const struct output *output, const char *suffix)
{
    char path[NAME_MAX_B];
    errno = ENAMETOOLONG;
    FILE *file =
        snprintf(path, sizeof path, "%s/%s%s%s", output->folder, output->kind, output->size, suffix) < NAME_MAX_B
            ? fopen(path, "w")
            : NULL;
    if (!file)
        fprintf(stderr, "generate_scale: %s/%s%s%s: %s\n", output->folder, output->kind, output->size, suffix,
                strerror(errno));
    return file;
}

/* `good`: whether all of it was written. */
static bool close_output(FILE *file, bool good)
{
    if (fclose(file) == 0 && good) return true;
    perror("generate_scale");
    return false;
}

static bool write_rooms(const struct output *output, int n)
{
    FILE *file = open_output(output, ".obj");
    if (!file || !close_output(file, scale_rooms_write(file, n))) return false;
    return (file = open_output(output, ".cam")) && close_output(file, scale_rooms_walk(file, n));
}

static bool write_mesh(const struct output *output, long triangles)
{
    char materials[NAME_MAX_B];
    snprintf(materials, sizeof materials, "%s%s.mtl", output->kind, output->size);
    FILE *file = open_output(output, ".obj");
    if (!file || !close_output(file, scale_mesh_write(file, triangles, materials))) return false;
    if (!(file = open_output(output, ".mtl")) || !close_output(file, scale_mesh_materials(file))) return false;
    return (file = open_output(output, ".cam")) && close_output(file, scale_mesh_flight(file, SCALE_FRAMES));
}

/* A whole number between limits, or -1. */
static long parse(const char *text, long least, long most)
{
    char *end;
    const long number = strtol(text, &end, 10);
    return end != text && *end == '\0' && number >= least && number <= most ? number : -1;
}

static bool write_floor(const struct output *output, long side_m, double least_m, double most_m)
{
    FILE *file = open_output(output, ".obj");
    if (!file || !close_output(file, scale_floor_write(file, side_m, least_m, most_m))) return false;
    return (file = open_output(output, ".cam")) && close_output(file, scale_floor_walk(file, SCALE_FRAMES));
}

static bool write_any(const struct output *output, long n)
{
    switch (*output->kind) {
    case 'r':
        return write_rooms(output, (int)n);
    case 'm':
        return write_mesh(output, n);
    case 'f':
        return write_floor(output, n, 0.1, 1.5);
    default:
        return write_floor(output, n, 0.6, 0.6);
    }
}

int main(int argc, char **argv)
{
    static const struct {
        const char *name;
        long least, most;
    } kinds[] = {{"rooms", 1, SCALE_ROOMS_MAX},
                 {"mesh", SCALE_TRIANGLES_MIN, SCALE_TRIANGLES_MAX},
                 {"floor", SCALE_FLOOR_MIN, SCALE_FLOOR_MAX},
                 {"ground", SCALE_FLOOR_MIN, SCALE_FLOOR_MAX}};
    for (size_t i = 0; argc == 4 && i < sizeof kinds / sizeof *kinds; i++) {
        const struct output output = {argv[3], argv[1], argv[2]};
        const long n = strcmp(argv[1], kinds[i].name) == 0 ? parse(argv[2], kinds[i].least, kinds[i].most) : -1;
        if (n >= 0) return write_any(&output, n) ? EXIT_SUCCESS : EXIT_FAILURE;
    }
    fprintf(stderr,
            "usage: generate_scale rooms 1..%d OUTDIR | mesh %d..%d OUTDIR | floor %d..%d OUTDIR | ground %d..%d "
            "OUTDIR\n",
            SCALE_ROOMS_MAX, SCALE_TRIANGLES_MIN, SCALE_TRIANGLES_MAX, SCALE_FLOOR_MIN, SCALE_FLOOR_MAX,
            SCALE_FLOOR_MIN, SCALE_FLOOR_MAX);
    return EXIT_FAILURE;
}
