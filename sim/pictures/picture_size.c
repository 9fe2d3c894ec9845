/* SPDX-License-Identifier: MIT
 *
 * Sources: PNG (ISO/IEC 15948) 11.2.2; GIF89a, 18 and 20; JPEG (ITU T.81) B.1.1 and B.2.2; BITMAPCOREHEADER and
 * BITMAPINFOHEADER; RFC 9649 (WebP) 2.5 to 2.7, RFC 6386 (VP8) 9.1; ISO/IEC 23008-12 (ImageSpatialExtentsProperty). */
#include "pictures/picture_size.h"

#include <stdio.h>
#include <string.h>

struct bytes {
    const uint8_t *at;
    size_t size_b;
};

static bool has(const struct bytes *bytes, size_t from, size_t count)
{
    return from <= bytes->size_b && count <= bytes->size_b - from;
}

static uint32_t little(const uint8_t *at, int count)
{
    uint32_t value = 0;
    for (int i = count; i-- > 0;)
        value = value << 8 | at[i];
    return value;
}

static uint32_t big(const uint8_t *at, int count)
{
    uint32_t value = 0;
    for (int i = 0; i < count; i++)
        value = value << 8 | at[i];
    return value;
}

static bool png_size(const struct bytes *bytes, uint32_t *w_px, uint32_t *h_px)
{
    if (!has(bytes, 8, 16) || memcmp(bytes->at + 12, "IHDR", 4) != 0) return false;
    *w_px = big(bytes->at + 16, 4);
    *h_px = big(bytes->at + 20, 4);
    return true;
}

static uint32_t absolute(uint32_t value)
{
    return value & UINT32_C(0x80000000) ? ~value + 1 : value;
}

/* A negative height: from the top down. */
static bool bmp_size(const struct bytes *bytes, uint32_t *w_px, uint32_t *h_px)
{
    if (!has(bytes, 14, 12)) return false;
    const bool is_core = little(bytes->at + 14, 4) == 12;
    *w_px = little(bytes->at + 18, is_core ? 2 : 4);
    *h_px = absolute(little(bytes->at + (is_core ? 20 : 22), is_core ? 2 : 4));
    return true;
}

/* Behind a colour table whose size is in the lower bits of `flags`. */
static size_t behind_colours(size_t at, uint8_t flags)
{
    return at + (flags & 0x80 ? (size_t)3 << ((flags & 7) + 1) : 0);
}

/* Behind an extension, whose blocks end with an empty one. */
static size_t behind_blocks(const struct bytes *bytes, size_t at)
{
    while (has(bytes, at, 1) && bytes->at[at])
        at += 1u + bytes->at[at];
    return at + 1;
}

/* The larger of the screen and of the first image on it: libraries differ in what they make of it. */
static bool gif_size(const struct bytes *bytes, uint32_t *w_px, uint32_t *h_px)
{
    if (!has(bytes, 6, 7)) return false;
    size_t at = behind_colours(13, bytes->at[10]);
    while (has(bytes, at, 2) && bytes->at[at] == 0x21)
        at = behind_blocks(bytes, at + 2);
    if (!has(bytes, at, 9) || bytes->at[at] != 0x2C) return false;
    const uint32_t screen_w_px = little(bytes->at + 6, 2), screen_h_px = little(bytes->at + 8, 2);
    *w_px = little(bytes->at + at + 5, 2);
    *h_px = little(bytes->at + at + 7, 2);
    if (*w_px < screen_w_px) *w_px = screen_w_px;
    if (*h_px < screen_h_px) *h_px = screen_h_px;
    return true;
}

/* SOF0 to SOF15, but for the three numbers in between that mean something else. */
static bool is_frame_header(uint8_t marker)
{
    return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

static bool jpeg_size(const struct bytes *bytes, uint32_t *w_px, uint32_t *h_px)
{
    size_t at = 2;
    while (has(bytes, at, 4)) {
        if (bytes->at[at] != 0xFF) return false;
        const uint8_t marker = bytes->at[at + 1];
        if (is_frame_header(marker) && has(bytes, at, 9)) {
            *h_px = big(bytes->at + at + 5, 2);
            *w_px = big(bytes->at + at + 7, 2);
            return true;
        }
        at += marker == 0xFF ? 1u : 2u + big(bytes->at + at + 2, 2);
    }
    return false;
}

/* Truevision TGA 2.0, 4.3 to 4.5: it has no magic, so whatever else can be asked of its header is. */
bool picture_is_tga(const void *picture, size_t size_b)
{
    const struct bytes bytes = {picture, size_b};
    if (!has(&bytes, 0, 18)) return false;
    const uint8_t *at = bytes.at, kind = at[2] & 0xF7, depth = at[16];
    const bool is_depth = depth == 8 || depth == 15 || depth == 16 || depth == 24 || depth == 32;
    return at[1] <= 1 && kind >= 1 && kind <= 3 && at[1] == (kind == 1) && is_depth && !(at[17] & 0xC0) &&
           little(at + 12, 2) && little(at + 14, 2);
}

static bool tga_size(const struct bytes *bytes, uint32_t *w_px, uint32_t *h_px)
{
    *w_px = little(bytes->at + 12, 2);
    *h_px = little(bytes->at + 14, 2);
    return true;
}

/* VP8, VP8L or VP8X is its first chunk. */
static bool webp_size(const struct bytes *bytes, uint32_t *w_px, uint32_t *h_px)
{
    enum { SIDE = 0x3FFF };
    if (!has(bytes, 12, 18)) return false;
    const uint8_t *at = bytes->at, kind = at[15];
    if (kind == 'X') {
        *w_px = little(at + 24, 3) + 1;
        *h_px = little(at + 27, 3) + 1;
    } else if (kind == 'L') {
        const uint32_t bits = little(at + 21, 4);
        *w_px = (bits & SIDE) + 1;
        *h_px = (bits >> 14 & SIDE) + 1;
    } else {
        *w_px = little(at + 26, 2) & SIDE;
        *h_px = little(at + 28, 2) & SIDE;
    }
    return true;
}

/* The largest of what its images say: tiles and thumbnails are smaller. */
static bool avif_size(const struct bytes *bytes, uint32_t *w_px, uint32_t *h_px)
{
    enum { WORD_B = 4, BODY_B = 12 };
    *w_px = *h_px = 0;
    for (size_t at = 0; has(bytes, at, WORD_B + BODY_B); at++) {
        if (memcmp(bytes->at + at, "ispe", WORD_B) != 0) continue;
        const uint32_t w = big(bytes->at + at + 8, 4), h = big(bytes->at + at + 12, 4);
        if (w > *w_px) *w_px = w;
        if (h > *h_px) *h_px = h;
    }
    return true;
}

bool picture_size(const void *picture, size_t size_b, uint32_t *w_px, uint32_t *h_px)
{
    static const struct {
        size_t at_b; /* where the magic is */
        const char *magic;
        bool (*size)(const struct bytes *bytes, uint32_t *w_px, uint32_t *h_px);
    } formats[] = {{0, "\x89PNG", png_size}, {0, "\xFF\xD8\xFF", jpeg_size}, {0, "GIF8", gif_size},
                   {0, "BM", bmp_size},      {8, "WEBPVP8", webp_size},      {4, "ftypavif", avif_size}};
    const struct bytes bytes = {picture, size_b};
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        const size_t magic_b = strlen(formats[i].magic);
        if (size_b >= formats[i].at_b + magic_b && memcmp(bytes.at + formats[i].at_b, formats[i].magic, magic_b) == 0)
            return formats[i].size(&bytes, w_px, h_px);
    }
    return picture_is_tga(picture, size_b) && tga_size(&bytes, w_px, h_px);
}

bool picture_size_check(const void *bytes, size_t size_b, char *reason, size_t reason_b)
{
    uint32_t w_px = 0, h_px = 0;
    if (!picture_size(bytes, size_b, &w_px, &h_px) || w_px == 0 || h_px == 0) {
        snprintf(reason, reason_b, "damaged: it has no size");
        return false;
    }
    if (w_px <= PICTURE_MOST_PX && h_px <= PICTURE_MOST_PX / w_px) return true;
    snprintf(reason, reason_b, "%lux%lu pixels, %d are the most", (unsigned long)w_px, (unsigned long)h_px,
             PICTURE_MOST_PX);
    return false;
}
