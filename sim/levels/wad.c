/* SPDX-License-Identifier: MIT
 *
 * A file begins with IWAD or PWAD, the number of lumps, and where their directory is; an entry of it has a lump's
 * place, its size and eight letters of its name. Source: Fell, The Unofficial Doom Specs 1.666, 1994, chapter 2. */
#include "levels/wad.h"

#include "base/grow.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { HEADER_B = 12, ENTRY_B = 16 };

static void name_of(const char *text, size_t length, char name[WAD_NAME_B])
{
    memset(name, 0, WAD_NAME_B);
    for (size_t i = 0; i < length && i + 1 < WAD_NAME_B && text[i]; i++)
        name[i] = (char)toupper((unsigned char)text[i]);
}

void wad_name(const uint8_t bytes[8], char name[WAD_NAME_B])
{
    name_of((const char *)bytes, 8, name);
}

void wad_name_of_text(const char *text, char name[WAD_NAME_B])
{
    name_of(text, strlen(text), name);
}

/* A '+' divides where a name ends in .wad. */
static size_t path_length(const char *paths)
{
    for (const char *at = paths; (at = strchr(at, '+')); at++)
        if (at - paths >= 4 && strncasecmp(at - 4, ".wad", 4) == 0) return (size_t)(at - paths);
    return strlen(paths);
}

const char *wad_path_at(const char *paths, size_t index, char path[WAD_PATH_B])
{
    for (; index; index--) {
        paths += path_length(paths);
        if (!*paths++) return NULL;
    }
    snprintf(path, WAD_PATH_B, "%.*s", (int)path_length(paths), paths);
    return path;
}

/* The directory ------------------------------------------------------------------------------ */

static enum wad_space space_after(const char *name, enum wad_space before)
{
    if (strcmp(name, "F_START") == 0 || strcmp(name, "FF_START") == 0) return WAD_FLATS;
    if (strcmp(name, "F_END") == 0 || strcmp(name, "FF_END") == 0) return WAD_GLOBAL;
    return before;
}

static void add_lump(struct wad *wad, size_t file, const uint8_t *entry, enum wad_space *space)
{
    const struct binary *bytes = &wad->files[file];
    const size_t at = wad_u32(entry), size_b = wad_u32(entry + 4);
    const bool is_within = at <= bytes->size_b && size_b <= bytes->size_b - at;
    wad->lumps = grow(wad->lumps, wad->lump_count, &wad->lump_capacity, sizeof *wad->lumps);
    struct wad_lump *lump = &wad->lumps[wad->lump_count++];
    *lump = (struct wad_lump){.file = (uint8_t)file, .bytes = is_within ? bytes->bytes + at : NULL, .size_b = size_b};
    wad_name(entry + 8, lump->name);
    *space = space_after(lump->name, *space);
    lump->space = *space;
}

static bool read_directory(struct wad *wad, size_t file, struct error *err)
{
    const struct binary *bytes = &wad->files[file];
    const char *path = wad->paths[file];
    enum wad_space space = WAD_GLOBAL;
    if (bytes->size_b < HEADER_B || (memcmp(bytes->bytes, "IWAD", 4) != 0 && memcmp(bytes->bytes, "PWAD", 4) != 0))
        return error_set(err, "%s: is no WAD: it begins with neither IWAD nor PWAD", path);
    const size_t count = wad_u32(bytes->bytes + 4), at = wad_u32(bytes->bytes + 8);
    if (at > bytes->size_b || count > (bytes->size_b - at) / ENTRY_B)
        return error_set(err, "%s: truncated, or no WAD: its directory of %zu lumps is not within the file", path,
                         count);
    if (count + wad->lump_count > WAD_LUMPS_MAX) return error_set(err, "%s: more than %d lumps", path, WAD_LUMPS_MAX);
    for (size_t i = 0; i < count; i++)
        add_lump(wad, file, bytes->bytes + at + i * ENTRY_B, &space);
    return true;
}

static bool open_file(struct wad *wad, const char *path, struct error *err)
{
    if (wad->file_count == WAD_FILES_MAX) return error_set(err, "%s: %d WADs at most", path, WAD_FILES_MAX);
    if (!binary_read(path, WAD_FILE_MOST_B, &wad->files[wad->file_count], err)) return false;
    char *copy = grow_zeroed(strlen(path) + 1, 1);
    wad->paths[wad->file_count] = strcpy(copy, path);
    return read_directory(wad, wad->file_count++, err);
}

bool wad_open(const char *paths, struct wad *out, struct error *err)
{
    char path[WAD_PATH_B];
    bool ok = true;
    *out = (struct wad){0};
    for (size_t i = 0; ok && wad_path_at(paths, i, path); i++)
        ok = open_file(out, path, err);
    if (!ok) wad_close(out);
    return ok;
}

void wad_close(struct wad *wad)
{
    for (size_t i = 0; i < wad->file_count; i++) {
        free(wad->paths[i]);
        free(wad->files[i].bytes);
    }
    free(wad->lumps);
    *wad = (struct wad){0};
}

/* Lumps -------------------------------------------------------------------------------------- */

const struct wad_lump *wad_find(const struct wad *wad, const char *name, enum wad_space space)
{
    for (size_t i = wad->lump_count; i-- > 0;)
        if (wad->lumps[i].space == space && strcmp(wad->lumps[i].name, name) == 0) return &wad->lumps[i];
    return NULL;
}

bool wad_lump_is_whole(const struct wad *wad, const struct wad_lump *lump, struct error *err)
{
    return lump->bytes || error_set(err, "%s: lump %s: truncated: it ends beyond the end of the file",
                                    wad->paths[lump->file], lump->name);
}

const struct wad_lump *wad_take(const struct wad *wad, const char *name, enum wad_space space, struct error *err)
{
    const struct wad_lump *lump = wad_find(wad, name, space);
    if (!lump)
        error_set(err, "%s: there is no lump %s in it%s", wad->paths[wad->file_count - 1], name,
                  wad->file_count == 1 ? "; a PWAD is read over its IWAD: IWAD.wad+PWAD.wad" : "");
    return lump && wad_lump_is_whole(wad, lump, err) ? lump : NULL;
}
