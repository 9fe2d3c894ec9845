/* SPDX-License-Identifier: MIT
 *
 * What walls, floors and ceilings of a WAD's maps look like, by their names: textures, their mean colours, what is
 * clear in them, and light. */
#ifndef SIM_LEVEL_TEXTURES_H
#define SIM_LEVEL_TEXTURES_H

#include "levels/level_patch.h"
#include "model/mipmap.h"

#define LEVEL_SKY_FLAT "F_SKY1"

enum level_look_kind { LOOK_WALL, LOOK_FLAT };

struct level_look {
    enum level_look_kind kind;
    char name[WAD_NAME_B];
    bool is_known;       /* else nothing below */
    unsigned w_px, h_px; /* as the WAD has it */
    uint32_t mean;       /* 0xRRGGBB, of what is not clear */
    double clear;        /* the share that is */
    bool is_one_colour;  /* all texels are equal */
    uint32_t *pixels;    /* 0xRRGGBB, rows from the top, what is clear PICTURE_CLEAR and the mean colour; owned */
};

struct level_textures {
    const struct wad *wad;
    const struct wad_lump *palette, *patch_names, *lists[2]; /* lists: TEXTURE1 and TEXTURE2 */
    struct level_look *looks;
    size_t look_count, look_capacity;
    size_t unknown_count, broken_count; /* textures that there are none of, or of which a part is broken */
    char unknown[WAD_NAME_B], broken[WAD_NAME_B], broken_part[WAD_NAME_B]; /* the first of either */
    double light[32]; /* of a colour map, 0 to 1: its rows, from bright to dark */
};

enum { LEVEL_LIGHT_ROWS = 32 };

/* Refuses a WAD without palette, or with a list of textures that is cut short. */
bool level_textures_open(const struct wad *wad, struct level_textures *out, struct error *err);
void level_textures_close(struct level_textures *textures);

/* The index of a texture or flat, which is composed when it is asked for first. */
size_t level_look(struct level_textures *textures, enum level_look_kind kind, const char *name);

/* As grey 0xVVVVVV, by which colours are multiplied: how light a surface is from the middle distance, in one of Doom's
 * 16 levels of a sector's light, and `contrast` levels more. */
uint32_t level_light(const struct level_textures *textures, int sector_light, int contrast);

/* Whether a flat shows the sky. */
static inline bool level_is_sky(const char *flat)
{
    for (const char *sky = LEVEL_SKY_FLAT; *sky || *flat; sky++, flat++)
        if (*sky != *flat) return false;
    return true;
}

#endif
