/* SPDX-License-Identifier: MIT */
#include "fake_display.h"

#include <stdio.h>

static uint16_t shown[FAKE_H_PX][FAKE_W_PX];
static struct {
    int x0, y0, x1, y1, x, y;
} window = {0, 0, -1, -1, 0, 0};
static unsigned complaints;

void fake_complain(const char *what)
{
    if (complaints++ < 5) fprintf(stderr, "fake: %s\n", what);
}

unsigned fake_complaints(void)
{
    return complaints;
}

int fake_left_px(void)
{
    if (window.y > window.y1) return 0;
    return (window.y1 - window.y + 1) * (window.x1 - window.x0 + 1) - (window.x - window.x0);
}

void fake_window(int x0, int y0, int x1, int y1)
{
    const bool inside = x0 >= 0 && y0 >= 0 && x0 <= x1 && y0 <= y1 && x1 < FAKE_W_PX && y1 < FAKE_H_PX;

    if (!inside) fake_complain("a window outside of the display");
    window.x0 = window.x = x0;
    window.y0 = window.y = y0;
    window.x1 = x1;
    window.y1 = inside ? y1 : y0 - 1;
}

void fake_pixel(uint16_t rgb565)
{
    if (window.y > window.y1) {
        fake_complain("a pixel behind the end of the window");
        return;
    }
    shown[window.y][window.x++] = rgb565;
    if (window.x <= window.x1) return;
    window.x = window.x0;
    window.y++;
}

void fake_bytes(const uint8_t *bytes, int n_px)
{
    for (int i = 0; i < n_px; i++)
        fake_pixel((uint16_t)(bytes[2 * i] << 8 | bytes[2 * i + 1]));
}

uint64_t fake_hash(int x0, int y0, int w_px, int h_px)
{
    uint64_t hash = 0xcbf29ce484222325;

    for (int y = y0; y < y0 + h_px; y++)
        for (int x = x0; x < x0 + w_px; x++) {
            hash = (hash ^ (shown[y][x] >> 8)) * 0x100000001b3;
            hash = (hash ^ (shown[y][x] & 0xFF)) * 0x100000001b3;
        }
    return hash;
}

void fake_wipe(void)
{
    for (int y = 0; y < FAKE_H_PX; y++)
        for (int x = 0; x < FAKE_W_PX; x++)
            shown[y][x] = 0xA5A5;
}
