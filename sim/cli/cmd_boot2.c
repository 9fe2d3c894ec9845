/* SPDX-License-Identifier: MIT
 *
 * `limner boot2 CODE.bin -o NAME.c`: assembled code of an RP2040's second stage -> C of a section .boot2 with its
 * checksum, for linking, so that not only the UF2 file starts but what a debugger writes from the ELF file, too. */
#include "base/arguments.h"
#include "base/binary.h"
#include "cli/commands.h"
#include "export/boot2.h"
#include "scene/scene_files.h"

#include <stdlib.h>

enum { BYTES_A_LINE = 16 };

static bool put(const struct binary *code, const char *path, struct outputs *outputs, struct error *err)
{
    uint8_t sealed[BOOT2_B];
    FILE *file = outputs_open(outputs, path, err);
    if (!file) return false;
    boot2_seal(sealed, code->bytes, code->size_b);
    fprintf(file,
            "/* %zu bytes of code, filled up, and their checksum. */\n"
            "__attribute__((section(\".boot2\"), used)) static const unsigned char boot2[%d] = {\n",
            code->size_b, BOOT2_B);
    for (size_t i = 0; i < BOOT2_B; i++)
        fprintf(file, "%s0x%02x,%s", i % BYTES_A_LINE == 0 ? "    " : " ", sealed[i],
                i % BYTES_A_LINE == BYTES_A_LINE - 1 ? "\n" : "");
    fputs("};\n", file);
    return outputs_close(file, path, err);
}

static bool seal(struct arguments *arguments, struct error *err)
{
    const char *path = NULL;
    struct outputs outputs = {0};
    struct binary code;
    if (!arguments_value(arguments, "-o", &path, err)) return false;
    if (arguments->count != 2) return error_set(err, "boot2: needs one file of code, CODE.bin");
    if (!path) return error_set(err, "boot2: needs -o NAME.c");
    if (!binary_read(arguments->items[1], BOOT2_CODE_B, &code, err)) return false;
    const bool ok = scene_files_finish(&outputs, put(&code, path, &outputs, err), err);
    free(code.bytes);
    return ok;
}

int cmd_boot2(int argc, char **argv)
{
    struct arguments arguments = {argv, argc};
    struct error err;
    const bool ok = seal(&arguments, &err);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
