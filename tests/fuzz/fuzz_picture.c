/* SPDX-License-Identifier: MIT
 *
 * Any bytes as a picture, out of a model and from a file beside it: what is read is the same both ways, within its
 * bounds, and becomes a texture; what is not has a reason. The mutator seals PNG: the lengths of its chunks, their
 * checksums, and that of the pixels. */
#include "files/companion.h"
#include "files/picture.h"
#include "fuzz.h"

#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum { TEXTURE_BITS = 5, SIDE_MAX_PX = 256, RAW_MAX_PX = 64 };

static const char *check_picture(const struct picture *picture)
{
    const size_t count = (size_t)picture->w_px * picture->h_px;

    if (!memchr(picture->reason, '\0', sizeof picture->reason)) return "a reason without an end";
    if (!picture->pixels) {
        if (count) return "a picture has a size, and no pixels";
        return fuzz_check_refusal(picture->reason, NULL);
    }
    if (picture->reason[0]) return "a picture that was read has a reason why it was not";
    if (picture->w_px < 1 || picture->w_px > TEXTURE_SIDE_MAX_PX || picture->h_px < 1 ||
        picture->h_px > TEXTURE_SIDE_MAX_PX)
        return "a side out of range";
    for (size_t i = 0; i < count; i++)
        if (picture->pixels[i] >> 24) return "a colour of more than 24 bits";
    return NULL;
}

static const char *check_texture(const struct picture *picture)
{
    struct texture texture;

    if (!picture->pixels || picture->w_px > SIDE_MAX_PX || picture->h_px > SIDE_MAX_PX) return NULL;
    if (!texture_make(picture, TEXTURE_BITS, &texture)) return "a small texture needs too much memory";
    const char *broken = NULL;
    if (texture.w_bits > TEXTURE_BITS || texture.h_bits > TEXTURE_BITS || texture.colours > TEXTURE_COLOURS)
        broken = "a texture out of range";
    else if (texture.texel_count > texture_texels(texture.w_bits, texture.h_bits) ||
             texture.levels != texture_levels(texture.w_bits, texture.h_bits))
        broken = "a texture of another length";
    for (size_t i = 0; !broken && i < texture.texel_count; i++)
        if (texture.texels[i] >= texture.colours) broken = "a texel of no colour";
    texture_free(&texture);
    return broken;
}

static bool are_same(const struct picture *a, const struct picture *b)
{
    const size_t size_b = sizeof *a->pixels * a->w_px * a->h_px;

    if (a->w_px != b->w_px || a->h_px != b->h_px || a->has_alpha != b->has_alpha || !a->pixels != !b->pixels)
        return false;
    return !a->pixels || memcmp(a->pixels, b->pixels, size_b) == 0;
}

/* `texture` is the only one that the model holds. */
static struct picture read_from(struct aiTexture *texture, const char *folder, const char *name)
{
    struct aiScene scene = {.mTextures = &texture, .mNumTextures = texture != NULL};
    struct picture picture;

    companions_begin(folder);
    picture_read(&scene, name, &picture);
    return picture;
}

static const char *check_both(const uint8_t *bytes, size_t size_b)
{
    struct aiTexture inside = {.mWidth = (unsigned)size_b, .pcData = (struct aiTexel *)(uintptr_t)bytes};
    const char *path = fuzz_as_named_file("picture.png", bytes, size_b);
    struct picture embedded = read_from(&inside, path, "*0"), beside = read_from(NULL, path, "picture.png");

    const char *broken = check_picture(&embedded);
    if (!broken) broken = check_picture(&beside);
    if (!broken && !are_same(&embedded, &beside)) broken = "a picture is another one in a model and beside it";
    if (!broken) broken = check_texture(&embedded);
    picture_free(&embedded);
    picture_free(&beside);
    return broken;
}

/* Texels of four bytes, as models may hold them; behind "raw". */
static const char *check_raw(struct fuzz_bytes bytes)
{
    const unsigned w_px = fuzz_below(&bytes, RAW_MAX_PX), h_px = 1 + fuzz_below(&bytes, RAW_MAX_PX);
    struct aiTexel *texels = calloc((size_t)w_px * h_px + 1, sizeof *texels);
    struct aiTexture inside = {.mWidth = w_px, .mHeight = h_px, .pcData = texels};

    for (size_t i = 0; i < (size_t)w_px * h_px; i++)
        texels[i] = (struct aiTexel){fuzz_u8(&bytes), fuzz_u8(&bytes), fuzz_u8(&bytes), fuzz_u8(&bytes)};
    struct picture picture = read_from(&inside, "nowhere/model.glb", "*0");
    const char *broken = check_picture(&picture);
    if (!broken && !picture.pixels != !w_px) broken = "texels were refused, or none of them taken";
    if (!broken) broken = check_texture(&picture);
    picture_free(&picture);
    free(texels);
    return broken;
}

/* A name of a picture, as a material may have it, behind "name". */
static const char *check_name(struct fuzz_bytes bytes)
{
    static const uint8_t dot = '.';
    struct aiTexture inside = {.mWidth = 1, .pcData = (struct aiTexel *)(uintptr_t)&dot};
    char *name = fuzz_string(&bytes);
    struct picture picture = read_from(&inside, "/nowhere/folder/model.obj", name);
    const char *broken = check_picture(&picture);

    picture_free(&picture);
    free(name);
    return broken;
}

static const char *run(const uint8_t *bytes, size_t size_b)
{
    if (size_b >= 3 && memcmp(bytes, "raw", 3) == 0) return check_raw((struct fuzz_bytes){bytes + 3, size_b - 3});
    if (size_b >= 4 && memcmp(bytes, "name", 4) == 0) return check_name((struct fuzz_bytes){bytes + 4, size_b - 4});
    return check_both(bytes, size_b);
}

/* PNG: an IHDR of 25 bytes behind the signature, then chunks of length, name, content and CRC ------------------- */

enum { SIGNATURE_B = 8, CHUNK_B = 12, STORED_B = 11, RAW_MAX_B = 1024 };

static uint32_t get_u32(const uint8_t *at)
{
    return (uint32_t)at[0] << 24 | (uint32_t)at[1] << 16 | (uint32_t)at[2] << 8 | at[3];
}

static void put_u32(uint8_t *at, uint32_t value)
{
    for (int i = 0; i < 4; i++)
        at[i] = (uint8_t)(value >> (24 - 8 * i));
}

/* Compressed pixels whose stream is whole but for its checksum get that; others become one stored block. */
static void seal_pixels(uint8_t *content, size_t size_b)
{
    uint8_t raw[RAW_MAX_B];
    z_stream stream = {.next_in = content, .avail_in = (uInt)size_b, .next_out = raw, .avail_out = sizeof raw};

    if (size_b < STORED_B + 1 || inflateInit(&stream) != Z_OK) return;
    const int outcome = inflate(&stream, Z_FINISH);
    const size_t raw_b = sizeof raw - stream.avail_out, used_b = size_b - stream.avail_in;
    inflateEnd(&stream);
    if (outcome == Z_STREAM_END) return;
    if (outcome == Z_DATA_ERROR && stream.msg && strcmp(stream.msg, "incorrect data check") == 0 && used_b <= size_b) {
        put_u32(content + used_b - 4, (uint32_t)adler32(1, raw, (uInt)raw_b));
        return;
    }
    const uint16_t stored_b = (uint16_t)(size_b - STORED_B);
    const uint8_t head[] = {0x78,
                            0x01,
                            1,
                            (uint8_t)stored_b,
                            (uint8_t)(stored_b >> 8),
                            (uint8_t)~stored_b,
                            (uint8_t)((uint16_t)~stored_b >> 8)};
    memcpy(content, head, sizeof head);
    put_u32(content + size_b - 4, (uint32_t)adler32(1, content + sizeof head, stored_b));
}

/* The last chunk reaches to the end, the others as far as they say, if that is there. */
static size_t mend(uint8_t *bytes, size_t size_b, size_t max_b)
{
    (void)max_b;
    if (size_b < SIGNATURE_B + CHUNK_B || memcmp(bytes, "\x89PNG", 4) != 0) return size_b;
    memcpy(bytes, "\x89PNG\r\n\x1A\n", SIGNATURE_B);
    for (size_t at = SIGNATURE_B; size_b - at >= CHUNK_B;) {
        const size_t most_b = size_b - at - CHUNK_B, said_b = get_u32(bytes + at);
        const size_t content_b = said_b <= most_b ? said_b : most_b;
        put_u32(bytes + at, (uint32_t)content_b);
        if (memcmp(bytes + at + 4, "IDAT", 4) == 0) seal_pixels(bytes + at + 8, content_b);
        put_u32(bytes + at + 8 + content_b, (uint32_t)crc32(0, bytes + at + 4, (uInt)content_b + 4));
        at += CHUNK_B + content_b;
    }
    return size_b;
}

const struct fuzz_target fuzz_picture = {"picture", run, mend};
