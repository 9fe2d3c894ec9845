/* SPDX-License-Identifier: MIT */
#include "formats/own_formats.h"

#include "base/input_file.h"
#include "files/whole_file.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

/* Also by another name. */
static bool begins_as_ply(const char *path)
{
    char bytes[4] = "";
    struct error ignored;
    FILE *file = input_open(path, MODEL_FILE_MOST_B, NULL, &ignored);
    const bool is_ply = file && fread(bytes, 1, sizeof bytes, file) == sizeof bytes && memcmp(bytes, "ply", 3) == 0 &&
                        isspace((unsigned char)bytes[3]);
    if (file) fclose(file);
    return is_ply;
}

model_builder *own_format_of(const char *path)
{
    static const struct {
        const char *suffix;
        model_builder *read;
    } formats[] = {{".ply", import_ply}, {".off", import_off}, {".stl", import_stl}, {".3mf", import_3mf}};
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (path_has_suffix(path, formats[i].suffix)) return formats[i].read;
    return begins_as_ply(path) ? import_ply : NULL;
}
