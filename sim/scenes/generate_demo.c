/* SPDX-License-Identifier: MIT
 *
 * generate_demo OUTDIR: writes demo.obj, demo.mtl and demo.cam, the house of a painter of
 * miniatures with its light baked into flat colours, and a walk round it. The same files on
 * every run. All are written as NAME.part first: nothing half-written is left behind. */
#include "demo_house.h"
#include "demo_light.h"
#include "demo_palette.h"
#include "demo_rooms.h"
#include "demo_walk.h"
#include "demo_write.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { NAME_MAX_B = 4096 };

struct output {
    const char *name;
    bool (*write)(FILE *file, const struct soup *soup);
};

static bool write_cam(FILE *file, const struct soup *soup)
{
    (void)soup;
    return walk_write(file);
}

/* The folder's name, the file's, and a suffix: false if that gets too long. */
static bool join_path(char path[NAME_MAX_B], const char *folder, const char *name, const char *suffix)
{
    return snprintf(path, NAME_MAX_B, "%s/%s%s", folder, name, suffix) < NAME_MAX_B;
}

static bool write_part(const char *folder, const struct output *output, const struct soup *soup)
{
    char part[NAME_MAX_B];
    if (!join_path(part, folder, output->name, ".part")) {
        fprintf(stderr, "generate_demo: %s: name too long\n", folder);
        return false;
    }
    FILE *file = fopen(part, "w");
    bool good = file && output->write(file, soup);
    if (file && fclose(file) != 0) good = false;
    if (!good) fprintf(stderr, "generate_demo: %s: %s\n", part, strerror(errno));
    return good;
}

/* Gives a part its name if all is well, else removes it. */
static bool finish_part(const char *folder, const struct output *output, bool good)
{
    char part[NAME_MAX_B], path[NAME_MAX_B];
    if (!join_path(part, folder, output->name, ".part") || !join_path(path, folder, output->name, "")) return false;
    if (good && rename(part, path) == 0) return true;
    if (good) fprintf(stderr, "generate_demo: %s: %s\n", path, strerror(errno));
    remove(part);
    return false;
}

static bool write_all(const char *folder, const struct soup *soup)
{
    static const struct output outputs[] = {{"demo.obj", write_obj}, {"demo.mtl", write_mtl}, {"demo.cam", write_cam}};
    size_t count = sizeof outputs / sizeof *outputs;
    bool good = true;
    for (size_t i = 0; good && i < count; i++)
        good = write_part(folder, &outputs[i], soup);
    for (size_t i = 0; i < count; i++)
        good = finish_part(folder, &outputs[i], good);
    return good;
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fputs("usage: generate_demo OUTDIR\n", stderr);
        return EXIT_FAILURE;
    }
    struct soup soup = {.random = 1653};
    house_build(&soup);
    rooms_furnish(&soup);
    sun_cut(&soup);
    light_bake(&soup);
    palette_reduce(&soup);
    write_prepare(&soup);
    bool good = write_all(argv[1], &soup);
    soup_free(&soup);
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
