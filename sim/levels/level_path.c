/* SPDX-License-Identifier: MIT */
#include "levels/level_path.h"

#include "base/inputs.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

static bool ends_in_wad(const char *path, size_t length)
{
    return length >= 4 && strncasecmp(path + length - 4, ".wad", 4) == 0;
}

const char *level_path_tail(const char *path)
{
    const char *colon = strrchr(path, ':');
    const bool is_map = colon && !strchr(colon, '/') && ends_in_wad(path, (size_t)(colon - path));
    return is_map ? colon : path + strlen(path);
}

bool level_path_parse(const char *path, struct level_path *out)
{
    const char *tail = level_path_tail(path);
    const size_t length = (size_t)(tail - path);
    if (!ends_in_wad(path, length) || length >= WAD_PATH_B) return false;
    if (!out) return true;
    memcpy(out->files, path, length);
    out->files[length] = '\0';
    wad_name_of_text(*tail ? tail + 1 : tail, out->map);
    return true;
}

int level_path_stem(const char *path, char *name, size_t size_b)
{
    struct level_path level;
    if (level_path_parse(path, &level) && *level.map) return snprintf(name, size_b, "%s", level.map);
    const char *slash = strrchr(path, '/'), *file = slash ? slash + 1 : path, *dot = strrchr(file, '.');
    return snprintf(name, size_b, "%.*s", dot ? (int)(dot - file) : (int)strlen(file), file);
}

void level_path_note(const char *path)
{
    struct level_path level = {.files = ""};
    char file[WAD_PATH_B];
    if (!level_path_parse(path, &level)) inputs_note_name(path);
    for (size_t i = 0; *level.files && wad_path_at(level.files, i, file); i++)
        inputs_note_name(file);
}
