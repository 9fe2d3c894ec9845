/* SPDX-License-Identifier: MIT
 *
 * `limner espimage IMAGE.elf -o IMAGE.esp`: a program that is all in RAM -> what the ROM of an Espressif chip loads
 * from the beginning of flash. */
#include "base/arguments.h"
#include "base/binary.h"
#include "cli/commands.h"
#include "export/esp_image.h"
#include "scene/scene_files.h"

#include <stdlib.h>

enum { ELF_MAX_B = 64 << 20 }; /* what debuggers want is in it, too */

static bool make(const char *name, const struct binary *file, const struct esp_chip *chip, struct esp_image *image,
                 struct error *err)
{
    struct elf_program program;

    return (elf_program_read(file, chip->machine, &program, err) && esp_image_make(image, chip, &program, err)) ||
           error_prefix(err, name);
}

static bool put(const struct esp_image *image, const char *path, struct outputs *outputs, struct error *err)
{
    FILE *file = outputs_open(outputs, path, err);

    if (!file) return false;
    fwrite(image->bytes, 1, image->size_b, file);
    return outputs_close(file, path, err);
}

static bool convert(struct arguments *arguments, struct error *err)
{
    const char *path = NULL, *name = "esp32c3";
    struct outputs outputs = {0};
    struct esp_image image = {0};
    struct binary file;

    if (!arguments_value(arguments, "-o", &path, err) || !arguments_value(arguments, "--chip", &name, err))
        return false;
    const struct esp_chip *chip = esp_chip_find(name, err);
    if (!chip) return false;
    if (arguments->count != 2) return error_set(err, "espimage: needs one program, IMAGE.elf");
    if (!path) return error_set(err, "espimage: needs -o IMAGE.esp");
    if (!binary_read(arguments->items[1], ELF_MAX_B, &file, err)) return false;
    const bool ok = make(arguments->items[1], &file, chip, &image, err);
    const bool kept = scene_files_finish(&outputs, ok && put(&image, path, &outputs, err), err);
    free(image.bytes);
    free(file.bytes);
    return kept;
}

int cmd_espimage(int argc, char **argv)
{
    struct arguments arguments = {argv, argc};
    struct error err;
    const bool ok = convert(&arguments, &err);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
