/* SPDX-License-Identifier: MIT
 *
 * The directory of a WAD: Doom's archive of named lumps. Several files are one directory, an IWAD and the PWADs over
 * it; of two lumps of one name the later one counts. */
#ifndef SIM_WAD_H
#define SIM_WAD_H

#include "base/binary.h"

enum { WAD_NAME_B = 9, WAD_FILES_MAX = 8, WAD_FILE_MOST_B = 256 << 20, WAD_LUMPS_MAX = 1 << 17 };

/* Between F_START and F_END, or FF_START and FF_END, are flats. */
enum wad_space { WAD_GLOBAL, WAD_FLATS };

struct wad_lump {
    char name[WAD_NAME_B]; /* in capitals */
    enum wad_space space;
    uint8_t file;         /* index into wad.files */
    const uint8_t *bytes; /* NULL: it is not within its file */
    size_t size_b;
};

struct wad {
    char *paths[WAD_FILES_MAX];
    struct binary files[WAD_FILES_MAX];
    size_t file_count;
    struct wad_lump *lumps;
    size_t lump_count, lump_capacity;
};

/* Paths are joined by '+' behind .wad, the IWAD first: "doom.wad+mine.wad". Refuses what is missing, no WAD, larger
 * than 256 MB, or whose directory is not within the file. On success to be closed. */
bool wad_open(const char *paths, struct wad *out, struct error *err);
void wad_close(struct wad *wad);

/* The path of one of the files, from 0; NULL: there are no more. Up to WAD_PATH_B bytes go to `path`. */
enum { WAD_PATH_B = 4096 };
const char *wad_path_at(const char *paths, size_t index, char path[WAD_PATH_B]);

/* The last lump of that name; NULL: there is none. */
const struct wad_lump *wad_find(const struct wad *wad, const char *name, enum wad_space space);

/* The same, with its bytes; an error names it. */
const struct wad_lump *wad_take(const struct wad *wad, const char *name, enum wad_space space, struct error *err);

/* Refuses a lump that is not within its file. */
bool wad_lump_is_whole(const struct wad *wad, const struct wad_lump *lump, struct error *err);

/* Eight bytes of a name, which a zero may end: in capitals. */
void wad_name(const uint8_t bytes[8], char name[WAD_NAME_B]);
void wad_name_of_text(const char *text, char name[WAD_NAME_B]);

/* Numbers are little-endian. */
static inline uint16_t wad_u16(const uint8_t *at)
{
    return (uint16_t)(at[0] | at[1] << 8);
}

static inline int wad_s16(const uint8_t *at)
{
    return (int16_t)wad_u16(at);
}

static inline uint32_t wad_u32(const uint8_t *at)
{
    return wad_u16(at) | (uint32_t)wad_u16(at + 2) << 16;
}

#endif
