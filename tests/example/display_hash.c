/* SPDX-License-Identifier: MIT
 *
 * The example's display in the tests, on the host and on emulated Arm alike: after each frame it
 * prints a hash of all pixels so far and how many of them were not background. Pixels must come
 * from left to right and from the top down, each once; others are refused. */
#include "display.h"

#include "console.h"

enum { FNV_OFFSET = 0x811C9DC5u, FNV_PRIME = 0x01000193u, BACKGROUND = 0, PIXELS = DISPLAY_W_PX * DISPLAY_H_PX };

static uint32_t hash = FNV_OFFSET; /* FNV-1a of the bytes as the bus gets them */
static uint32_t frame_px, painted;

static void put_number(uint32_t number, uint32_t base)
{
    char digits[12] = {0};
    uint8_t at = sizeof digits - 1;

    do
        digits[--at] = "0123456789abcdef"[number % base];
    while (number /= base);
    console_put(&digits[at]);
}

static void put_frame(void)
{
    console_put("hash ");
    put_number(hash, 16);
    console_put(" painted ");
    put_number(painted, 10);
    console_put("\n");
}

int display_send(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px)
{
    const unsigned char *bytes = (const unsigned char *)pixels;

    if (ctx || frame_px != (uint32_t)y_px * DISPLAY_W_PX + x_px || x_px + n_px > DISPLAY_W_PX) return -1;
    for (uint32_t i = 0; i < 2u * n_px; i++)
        hash = (hash ^ bytes[i]) * FNV_PRIME;
    for (uint16_t i = 0; i < n_px; i++)
        painted += pixels[i] != BACKGROUND;
    frame_px += n_px;
    if (frame_px == PIXELS) {
        put_frame();
        frame_px = 0;
    }
    return 0;
}
