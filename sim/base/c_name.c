/* SPDX-License-Identifier: MIT
 *
 * File names may hold anything, C identifiers may not. */
#include "base/c_name.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

bool c_name_init(struct c_name *name, const char *path, struct error *err)
{
    const char *slash = strrchr(path, '/');
    name->file = slash ? slash + 1 : path;
    if (!*name->file) return error_set(err, "-o '%s': names a folder, not a scene", path);
    bool has_letter = isalpha((unsigned char)name->file[0]) != 0;
    int printed = snprintf(name->symbol, C_NAME_MAX_B, "%s%s", has_letter ? "" : "scene_", name->file);
    if (printed >= C_NAME_MAX_B) return error_set(err, "-o '%s': the name is too long for C symbols", path);
    for (size_t i = 0; i <= strlen(name->symbol); i++) {
        unsigned char letter = (unsigned char)name->symbol[i];
        if (letter && (letter > 0x7F || !isalnum(letter))) name->symbol[i] = '_';
        name->macro[i] = (char)toupper((unsigned char)name->symbol[i]);
    }
    return true;
}

bool c_path(char out[C_PATH_MAX_B], const char *path, const char *suffix, struct error *err)
{
    return snprintf(out, C_PATH_MAX_B, "%s%s", path, suffix) < C_PATH_MAX_B ||
           error_set(err, "-o '%.64s...': the path is too long", path);
}
