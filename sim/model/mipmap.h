/* SPDX-License-Identifier: MIT
 *
 * A texture as the scene has it: a picture whose sides are powers of two, the same in half the size and so on,
 * all in one palette of 256 colours. Made of any picture that an importer found. */
#ifndef SIM_MIPMAP_H
#define SIM_MIPMAP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { TEXTURE_SIDE_MAX_PX = 1024, TEXTURE_COLOURS = 256, TEXTURE_NAME_B = 96 };

/* A picture as it was found, or why it was not. */
struct picture {
    char name[TEXTURE_NAME_B];   /* as the model names it */
    char reason[TEXTURE_NAME_B]; /* why there are no pixels; empty if there are */
    uint32_t found_w_px, found_h_px;
    uint32_t w_px, h_px; /* the same, or less: no side is longer than TEXTURE_SIDE_MAX_PX */
    uint32_t *pixels;    /* 0xRRGGBB, rows from the top; owned */
    bool left_out;       /* by the user's wish: there are no pixels, and that is no error */
    bool has_alpha;      /* not all of it is opaque, as it was found */
    size_t faces;        /* that show it */
    uint8_t
        w_bits_end; /* its texture has fewer bits of width than that, by leaving out levels; 0: as many as it likes */
    char became[TEXTURE_NAME_B + 32]; /* for --texture-budget, for people; empty: nothing */
    size_t clear_faces;               /* whose transparency it has, by its alpha or as their mask, which is not drawn */
};

struct texture {
    uint8_t w_bits, h_bits, levels; /* as in struct lim_texture */
    bool transposed;                /* the picture's rows are columns: none is higher than wide */
    size_t texel_count;             /* of all levels */
    uint8_t *texels;                /* owned */
    uint32_t palette[TEXTURE_COLOURS], colours;
    uint32_t mean; /* 0xRRGGBB: what shows it where it cannot be shown */
};

/* The power of two that is nearest to a side: 2^result, never above `most_bits`. */
uint8_t texture_side_bits(uint32_t side_px, uint8_t most_bits);

/* Resizes, halves and quantises. No side gets longer than 2^most_bits. false: out of memory. */
bool texture_make(const struct picture *picture, uint8_t most_bits, struct texture *out);
void texture_free(struct texture *texture);

/* Texels of all levels of such a texture, filled up to whole blocks (scene.h). */
size_t texture_texels(uint8_t w_bits, uint8_t h_bits);
uint8_t texture_levels(uint8_t w_bits, uint8_t h_bits);

#endif
