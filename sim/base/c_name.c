/* SPDX-License-Identifier: MIT
 *
 * File names may hold anything, C identifiers may not. */
#include "base/c_name.h"

#include "base/printable.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

/* Whether C takes the name as it is, and it is none that the renderer has: those begin with lim_. */
static bool stands_alone(const char *file)
{
    if (!isalpha((unsigned char)file[0])) return false;
    return strncasecmp(file, "lim", 3) != 0 || isalnum((unsigned char)file[3]);
}

bool c_name_init(struct c_name *name, const char *path, struct error *err)
{
    const char *slash = strrchr(path, '/');
    name->file = slash ? slash + 1 : path;
    if (!*name->file) return error_set(err, "-o '%s': names a folder, not a scene", path);
    int printed = snprintf(name->symbol, C_NAME_MAX_B, "%s%s", stands_alone(name->file) ? "" : "scene_", name->file);
    if (printed >= C_NAME_MAX_B) return error_set(err, "-o '%s': the name is too long for C symbols", path);
    for (size_t i = 0; i <= strlen(name->symbol); i++) {
        unsigned char letter = (unsigned char)name->symbol[i];
        if (letter && (letter > 0x7F || !isalnum(letter))) name->symbol[i] = '_';
        name->macro[i] = (char)toupper((unsigned char)name->symbol[i]);
    }
    return true;
}

bool c_name_map(char *path)
{
    char *slash = strrchr(path, '/'), *to = slash ? slash + 1 : path;
    bool mapped = false;
    for (size_t length, i = 0; to[i]; i += length)
        if (printable_at(to + i, &length) != PRINTABLE || strchr("\"'\\?", to[i])) {
            memset(to + i, '_', length);
            mapped = true;
        }
    return mapped;
}

bool c_path(char out[C_PATH_MAX_B], const char *path, const char *suffix, struct error *err)
{
    return snprintf(out, C_PATH_MAX_B, "%s%s", path, suffix) < C_PATH_MAX_B ||
           error_set(err, "-o '%.64s...': the path is too long", path);
}
