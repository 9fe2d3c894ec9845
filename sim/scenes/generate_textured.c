/* SPDX-License-Identifier: MIT
 *
 * generate_textured OUTDIR: writes textured.obj, .mtl and .cam with the pictures that they name: a gallery of two
 * rooms, its boards, bricks, wallpaper and paintings drawn by libgd. The same files on every run of one libgd. */
#include "textured_pictures.h"
#include "textured_rooms.h"

#include <stdio.h>
#include <stdlib.h>

enum { PATH_B = 4096 };

static FILE *open_in(const char *folder, const char *name)
{
    char path[PATH_B];
    if (snprintf(path, sizeof path, "%s/%s", folder, name) >= PATH_B) return NULL;
    return fopen(path, "wb");
}

static bool write_file(const char *folder, const char *name, bool (*write)(FILE *file))
{
    FILE *file = open_in(folder, name);
    bool good = file && write(file) && !ferror(file);
    if (file && fclose(file) != 0) good = false;
    if (!good) fprintf(stderr, "generate_textured: %s/%s: cannot be written\n", folder, name);
    return good;
}

int main(int argc, char **argv)
{
    bool good = argc == 2;
    if (!good) fputs("usage: generate_textured OUTDIR\n", stderr);
    for (size_t i = 0; good && i < textured_picture_count; i++)
        good = write_file(argv[1], textured_pictures[i].name, textured_pictures[i].write);
    good = good && write_file(argv[1], "textured.mtl", textured_write_mtl) &&
           write_file(argv[1], "textured.obj", textured_write_obj) &&
           write_file(argv[1], "textured.cam", textured_write_cam);
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
