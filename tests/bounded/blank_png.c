/* SPDX-License-Identifier: MIT
 *
 * blank_png W H: a valid PNG file of so many black pixels on standard output, a bit each: 400 million take 48 KB. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

static void put_u32(uint8_t *at, unsigned long value)
{
    for (int i = 0; i < 4; i++)
        at[i] = (uint8_t)(value >> (24 - 8 * i));
}

static void put_chunk(const char *type, const void *data, size_t size_b)
{
    uint8_t word[4];
    put_u32(word, (unsigned long)size_b);
    fwrite(word, 1, 4, stdout);
    fwrite(type, 1, 4, stdout);
    if (size_b) fwrite(data, 1, size_b, stdout);
    uLong crc = crc32(crc32(0, NULL, 0), (const Bytef *)type, 4);
    if (size_b) crc = crc32(crc, data, (uInt)size_b);
    put_u32(word, crc);
    fwrite(word, 1, 4, stdout);
}

int main(int argc, char **argv)
{
    uint8_t header[13] = {[8] = 1};
    if (argc != 3) return EXIT_FAILURE;
    const unsigned long w_px = strtoul(argv[1], NULL, 10), h_px = strtoul(argv[2], NULL, 10);
    const uLong size_b = (1 + (w_px + 7) / 8) * h_px;
    uLongf packed_b = compressBound(size_b);
    Bytef *pixels = calloc(size_b + 1, 1), *packed = malloc(packed_b);
    if (!pixels || !packed || compress2(packed, &packed_b, pixels, size_b, 9) != Z_OK) return EXIT_FAILURE;
    put_u32(header, w_px);
    put_u32(header + 4, h_px);
    fwrite("\x89PNG\r\n\x1a\n", 1, 8, stdout);
    put_chunk("IHDR", header, sizeof header);
    put_chunk("IDAT", packed, packed_b);
    put_chunk("IEND", NULL, 0);
    free(pixels);
    free(packed);
    return fflush(stdout) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
