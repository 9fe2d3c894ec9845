/* SPDX-License-Identifier: MIT
 *
 * `limner uf2 IMAGE.bin -o IMAGE.uf2`: an image of flash -> the file that is copied to a board's boot drive. */
#include "base/arguments.h"
#include "base/binary.h"
#include "cli/commands.h"
#include "export/uf2.h"
#include "scene/scene_files.h"

#include <stdlib.h>

static bool put(const struct binary *image, const struct uf2_family *family, const char *path, struct outputs *outputs,
                struct error *err)
{
    FILE *file = outputs_open(outputs, path, err);
    uint8_t block[UF2_BLOCK_B];
    if (!file) return false;
    if (uf2_absolute_block(block, family)) fwrite(block, 1, sizeof block, file);
    for (uint32_t i = 0; i < uf2_block_count(image->size_b); i++) {
        uf2_block(block, family, image->bytes, image->size_b, i);
        fwrite(block, 1, sizeof block, file);
    }
    return outputs_close(file, path, err);
}

static bool convert(struct arguments *arguments, struct error *err)
{
    const char *path = NULL, *name = "rp2040";
    struct outputs outputs = {0};
    struct binary image;
    if (!arguments_value(arguments, "-o", &path, err) || !arguments_value(arguments, "--family", &name, err))
        return false;
    const struct uf2_family *family = uf2_family_find(name, err);
    if (!family) return false;
    if (arguments->count != 2) return error_set(err, "uf2: needs one image, IMAGE.bin");
    if (!path) return error_set(err, "uf2: needs -o IMAGE.uf2");
    if (!binary_read(arguments->items[1], family->flash_b, &image, err)) return false;
    const bool ok = scene_files_finish(&outputs, put(&image, family, path, &outputs, err), err);
    free(image.bytes);
    return ok;
}

int cmd_uf2(int argc, char **argv)
{
    struct arguments arguments = {argv, argc};
    struct error err;
    const bool ok = convert(&arguments, &err);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
