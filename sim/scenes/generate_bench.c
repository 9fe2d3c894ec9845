/* SPDX-License-Identifier: MIT
 *
 * generate_bench solid NAME | level NAME WAD MAP: scenes of the benchmark, flat as NAME.obj and textured as
 * NAMEtex.obj, NAME with its folder. The textures are t0.png to t5.png beside them (sim/scenes/mapped). A level has
 * NAME.cam too. The same files on every run. */
#include "bench_level.h"
#include "bench_solid.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NAME_MAX_B = 4096, TEXTURES = 6, FRAMES = 64, TONES = 15 };

static FILE *open_file(const char *name, const char *suffix)
{
    char path[NAME_MAX_B];
    errno = ENAMETOOLONG;
    FILE *file = snprintf(path, sizeof path, "%s%s", name, suffix) < NAME_MAX_B ? fopen(path, "w") : NULL;
    if (!file) fprintf(stderr, "generate_bench: %s%s: %s\n", name, suffix, strerror(errno));
    return file;
}

/* `good`: whether all of it was written. */
static bool close_file(FILE *file, bool good)
{
    if (fclose(file) == 0 && good) return true;
    perror("generate_bench");
    return false;
}

static const char *last_part(const char *name)
{
    const char *slash = strrchr(name, '/');
    return slash ? slash + 1 : name;
}

static bool write_texture_materials(const char *name)
{
    FILE *mtl = open_file(name, "tex.mtl");
    for (int i = 0; mtl && i < TEXTURES; i++)
        fprintf(mtl, "newmtl %d\nKd 1 1 1\nmap_Kd t%d.png\n", i, i);
    return mtl && close_file(mtl, !ferror(mtl));
}

static bool write_solid(const char *name)
{
    char materials[NAME_MAX_B];
    snprintf(materials, sizeof materials, "%stex.mtl", last_part(name));
    FILE *obj = open_file(name, ".obj");
    if (!obj || !close_file(obj, bench_solid_write(obj, NULL))) return false;
    if (!(obj = open_file(name, "tex.obj")) || !close_file(obj, bench_solid_write(obj, materials))) return false;
    return write_texture_materials(name);
}

/* Levels ------------------------------------------------------------------------------------- */

struct level_file {
    FILE *obj, *mtl;                                /* of flat colours where there is an mtl, else textured */
    bool has_tone[TONES + 1][TONES + 1][TONES + 1]; /* in the mtl */
    long vertices;
};

static unsigned hash_of(const char *texture)
{
    unsigned hash = 2166136261u;
    for (int i = 0; i < 8 && texture[i]; i++)
        hash = (hash ^ (unsigned char)texture[i]) * 16777619u;
    return hash ^ hash >> 15;
}

/* Its tone, 0 to TONES each of red, green and blue, is the material, which is written when it is new. */
static void use_tone(struct level_file *file, const struct bench_surface *surface)
{
    const unsigned hash = hash_of(surface->texture);
    long tone[3];
    for (int i = 0; i < 3; i++) {
        const double full = 0.35 + 0.5 * (double)(hash >> 8 * i & 255u) / 255;
        tone[i] = lround(TONES * full * (0.2 + 0.8 * surface->light / 255));
    }
    fprintf(file->obj, "usemtl c%ld_%ld_%ld\n", tone[0], tone[1], tone[2]);
    bool *has_tone = &file->has_tone[tone[0]][tone[1]][tone[2]];
    if (*has_tone) return;
    *has_tone = true;
    fprintf(file->mtl, "newmtl c%ld_%ld_%ld\nKd %.4f %.4f %.4f\n", tone[0], tone[1], tone[2], (double)tone[0] / TONES,
            (double)tone[1] / TONES, (double)tone[2] / TONES);
}

static bench_face_sink write_face;

static void write_face(void *context, const struct bench_corner *corners, int count,
                       const struct bench_surface *surface)
{
    struct level_file *file = context;
    if (file->mtl)
        use_tone(file, surface);
    else
        fprintf(file->obj, "usemtl %u\n", hash_of(surface->texture) % TEXTURES);
    for (int i = 0; i < count; i++) {
        fprintf(file->obj, "v %.6f %.6f %.6f\n", corners[i].x_m, corners[i].y_m, corners[i].z_m);
        if (!file->mtl) fprintf(file->obj, "vt %.6f %.6f\n", corners[i].u, corners[i].v);
    }
    fputc('f', file->obj);
    for (int i = 0; i < count; i++) {
        fprintf(file->obj, " %ld", ++file->vertices);
        if (!file->mtl) fprintf(file->obj, "/%ld", file->vertices);
    }
    fputc('\n', file->obj);
}

static bool write_level_file(const char *name, bool textured, const struct bench_level *level)
{
    struct level_file file = {.obj = open_file(name, textured ? "tex.obj" : ".obj")};
    if (!file.obj) return false;
    if (!textured && !(file.mtl = open_file(name, ".mtl"))) return close_file(file.obj, false);
    fprintf(file.obj, "# Written by generate_bench\nmtllib %s%s.mtl\n", last_part(name), textured ? "tex" : "");
    bench_level_faces(level, write_face, &file);
    const bool wrote = !file.mtl || close_file(file.mtl, !ferror(file.mtl));
    return close_file(file.obj, !ferror(file.obj)) && wrote;
}

static bool write_level(const char *name, const struct bench_level *level)
{
    FILE *cam = open_file(name, ".cam");
    return cam && close_file(cam, bench_level_cameras(level, cam, FRAMES)) && write_level_file(name, false, level) &&
           write_level_file(name, true, level) && write_texture_materials(name);
}

static uint8_t *read_file(const char *path, size_t *size_b)
{
    FILE *file = fopen(path, "rb");
    uint8_t *bytes = NULL;
    long end = -1;
    if (file && fseek(file, 0, SEEK_END) == 0 && (end = ftell(file)) > 0) {
        rewind(file);
        bytes = malloc((size_t)end);
        if (bytes && fread(bytes, 1, (size_t)end, file) != (size_t)end) {
            free(bytes);
            bytes = NULL;
        }
    }
    if (file) fclose(file);
    *size_b = bytes ? (size_t)end : 0;
    return bytes;
}

static bool write_map(const char *name, const char *wad_path, const char *map)
{
    size_t size_b;
    uint8_t *wad = read_file(wad_path, &size_b);
    const char *why = "cannot be read";
    struct bench_level *level = wad ? bench_level_open(wad, size_b, map, &why) : NULL;
    if (!level) fprintf(stderr, "generate_bench: %s, %s: %s\n", wad_path, map, why);
    const bool ok = level && write_level(name, level);
    bench_level_close(level);
    free(wad);
    return ok;
}

int main(int argc, char **argv)
{
    if (argc == 3 && strcmp(argv[1], "solid") == 0) return write_solid(argv[2]) ? EXIT_SUCCESS : EXIT_FAILURE;
    if (argc == 5 && strcmp(argv[1], "level") == 0)
        return write_map(argv[2], argv[3], argv[4]) ? EXIT_SUCCESS : EXIT_FAILURE;
    fputs("usage: generate_bench solid NAME | level NAME WAD MAP\n", stderr);
    return EXIT_FAILURE;
}
