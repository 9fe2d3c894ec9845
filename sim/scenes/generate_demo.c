/* SPDX-License-Identifier: MIT
 *
 * generate_demo OUTDIR: writes demo.obj, demo.mtl and demo.cam, the house of a painter of
 * miniatures with its light baked into flat colours, and a walk round it. The same files on
 * every run. Files are written beside their names first: no half-written one is left behind. */
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

static bool write_file(const char *folder, const struct output *output, const struct soup *soup)
{
    char path[NAME_MAX_B], part[NAME_MAX_B + 8];
    if (snprintf(path, sizeof path, "%s/%s", folder, output->name) >= (int)sizeof path) {
        fprintf(stderr, "generate_demo: %s: name too long\n", folder);
        return false;
    }
    snprintf(part, sizeof part, "%s.part", path);
    FILE *file = fopen(part, "w");
    bool good = file && output->write(file, soup);
    if (file && fclose(file) != 0) good = false;
    if (good && rename(part, path) == 0) return true;
    fprintf(stderr, "generate_demo: %s: %s\n", path, strerror(errno));
    if (file) remove(part);
    return false;
}

int main(int argc, char **argv)
{
    static const struct output outputs[] = {{"demo.obj", write_obj}, {"demo.mtl", write_mtl}, {"demo.cam", write_cam}};
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
    bool good = true;
    for (size_t i = 0; good && i < sizeof outputs / sizeof *outputs; i++)
        good = write_file(argv[1], &outputs[i], &soup);
    soup_free(&soup);
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
