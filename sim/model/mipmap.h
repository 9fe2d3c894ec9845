/* SPDX-License-Identifier: MIT
 *
 * A texture as the scene has it: a picture whose sides are powers of two, the same in half the size and so on,
 * all in one palette of 256 colours. Made of any picture that an importer found. */
#ifndef SIM_MIPMAP_H
#define SIM_MIPMAP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { TEXTURE_SIDE_MAX_PX = 1024, TEXTURE_COLOURS = 256 };

/* Of a name as long as importers hand it over, and of words about a picture. */
enum { PICTURE_NAME_B = 1024, PICTURE_WORDS_B = 192 };

/* Of a picture's pixels: what is behind is seen through it. */
#define PICTURE_CLEAR 0x1000000u

/* A sky is on a cylinder around the eye. */
struct sky_look {
    unsigned times; /* round it, 1..SKY_TIMES_MAX */
    double horizon; /* in heights of the picture, from its top */
};
enum { SKY_TIMES_MAX = 16 };

/* What is seen beyond a picture's borders. */
enum picture_wrap { PICTURE_REPEATS, PICTURE_MIRRORS, PICTURE_CLAMPS };

/* A picture as it was found, or why it was not. */
struct picture {
    char name[PICTURE_NAME_B];    /* as the model names it */
    char reason[PICTURE_WORDS_B]; /* why there are no pixels; empty if there are */
    uint32_t found_w_px, found_h_px;
    uint32_t w_px, h_px; /* the same, or less: no side is longer than TEXTURE_SIDE_MAX_PX */
    uint32_t *pixels;    /* 0xRRGGBB, or more of them PICTURE_CLEAR, rows from the top; owned */
    uint8_t *alpha;      /* of each pixel, 255 is opaque; NULL: of no use any more, or all are; owned */
    bool is_masked;      /* some pixels are clear */
    struct sky_look sky; /* how it is seen around the eye; times is 0: it is not */
    uint8_t wrap[2];     /* enum picture_wrap, across and down: texture_wrap.h makes all of them repeat */
    bool left_out;       /* by the user's wish: there are no pixels, and that is no error */
    bool has_alpha;      /* not all of it is opaque, as it was found */
    size_t faces;        /* that show it */
    uint8_t
        w_bits_end; /* its texture has fewer bits of width than that, by leaving out levels; 0: as many as it likes */
    char became[PICTURE_WORDS_B]; /* for --texture-budget, for people; empty: nothing */
    size_t clear_faces;           /* whose transparency it has, by its alpha or as their mask, and which is not drawn */
};

struct texture {
    uint8_t w_bits, h_bits, levels; /* as in struct lim_texture */
    bool transposed;                /* the picture's rows are columns: none is higher than wide */
    bool is_masked;                 /* texels 0 are clear */
    struct sky_look sky;            /* colours 0 and 1 are seen above and below it then */
    size_t texel_count;             /* of all levels */
    uint8_t *texels;                /* owned */
    uint32_t palette[TEXTURE_COLOURS], colours;
    uint32_t mean; /* 0xRRGGBB, of what is not clear: what shows it where it cannot be shown */
};

/* The share of pixels that are clear, and as a transparency: 255 if all are, 1..254 if some are. */
double picture_clear_share(const struct picture *picture);
uint8_t picture_transparency(const struct picture *picture);

/* The power of two that is nearest to a side: 2^result, never above `most_bits`. */
uint8_t texture_side_bits(uint32_t side_px, uint8_t most_bits);

/* Resizes, halves and quantises. No side gets longer than 2^most_bits. false: out of memory. */
bool texture_make(const struct picture *picture, uint8_t most_bits, struct texture *out);

/* The same bits: a sky is not made as small as what fills the scene, and never lies on its side. */
void texture_bits_of(const struct picture *picture, uint8_t most_bits, uint8_t *w_bits, uint8_t *h_bits);
void texture_free(struct texture *texture);

/* Texels of all levels of such a texture, filled up to whole blocks (scene.h). */
size_t texture_texels(uint8_t w_bits, uint8_t h_bits);
uint8_t texture_levels(uint8_t w_bits, uint8_t h_bits);

#endif
