/* SPDX-License-Identifier: MIT
 *
 * Every picture starts from a seed of its own, and repeats at its borders where the rooms repeat it. */
#include "textured_pictures.h"

#include <gd.h>
#include <math.h>
#include <stdint.h>

static const double TURN = 6.283185307179586;

static uint32_t random_next(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return *state >> 8;
}

/* -range .. range */
static int random_in(uint32_t *state, int range)
{
    return (int)(random_next(state) % (uint32_t)(2 * range + 1)) - range;
}

static int clamped(int value)
{
    return value < 0 ? 0 : value > 255 ? 255 : value;
}

static int shaded(int rgb, int by)
{
    return gdTrueColor(clamped((rgb >> 16 & 255) + by), clamped((rgb >> 8 & 255) + by), clamped((rgb & 255) + by));
}

static bool write_png(gdImagePtr image, FILE *file)
{
    if (!image) return false;
    gdImagePng(image, file);
    gdImageDestroy(image);
    return true;
}

/* Four boards, each with its own tone, grain along it and a joint. */
static bool write_boards(FILE *file)
{
    enum { SIDE = 128, BOARD = SIDE / 4 };
    uint32_t random = 7;
    gdImagePtr image = gdImageCreateTrueColor(SIDE, SIDE);
    for (int board = 0; image && board < 4; board++) {
        const int tone = random_in(&random, 18), joint = (int)(random_next(&random) % SIDE);
        for (int row = 0; row < BOARD; row++) {
            const int y = board * BOARD + row, line = random_in(&random, 9);
            for (int x = 0; x < SIDE; x++) {
                const double wave = sin(TURN * (x * 2 + row * 3) / SIDE + board) * 6;
                const int edge = row < 1 || abs(x - joint) < 1 ? -55 : 0;
                image->tpixels[y][x] = shaded(0xA9713B, tone + line + (int)wave + random_in(&random, 4) + edge);
            }
        }
    }
    return write_png(image, file);
}

/* Bricks in running bond; the sides are no powers of two. */
static bool write_bricks(FILE *file)
{
    enum { W = 120, H = 90, ROWS = 6, A_ROW = 3 };
    uint32_t random = 11;
    int tones[ROWS][A_ROW];
    for (int i = 0; i < ROWS * A_ROW; i++)
        tones[i / A_ROW][i % A_ROW] = random_in(&random, 22);
    gdImagePtr image = gdImageCreateTrueColor(W, H);
    for (int y = 0; image && y < H; y++) {
        const int row = y / (H / ROWS), in_row = y % (H / ROWS);
        for (int x = 0; x < W; x++) {
            const int shifted = (x + row % 2 * W / A_ROW / 2) % W, in_brick = shifted % (W / A_ROW);
            const bool is_mortar = in_row < 2 || in_brick < 2;
            image->tpixels[y][x] = is_mortar
                                       ? shaded(0xB8B0A4, random_in(&random, 10))
                                       : shaded(0x9C4A36, tones[row][shifted / (W / A_ROW)] + random_in(&random, 9));
        }
    }
    return write_png(image, file);
}

static bool write_wallpaper(FILE *file)
{
    enum { SIDE = 64 };
    gdImagePtr image = gdImageCreateTrueColor(SIDE, SIDE);
    if (!image) return false;
    gdImageFilledRectangle(image, 0, 0, SIDE - 1, SIDE - 1, 0xD8CFAE);
    gdImageFilledRectangle(image, 0, 0, SIDE / 2 - 1, SIDE - 1, 0xCDC39C);
    for (int flower = 0; flower < 2; flower++) {
        const int x = SIDE / 4 + flower * SIDE / 2, y = SIDE / 4 + flower * SIDE / 2;
        for (int petal = 0; petal < 6; petal++)
            gdImageFilledEllipse(image, x + (int)lround(5.5 * cos(TURN * petal / 6)),
                                 y + (int)lround(5.5 * sin(TURN * petal / 6)), 7, 7, flower ? 0x5A7396 : 0xA8484E);
        gdImageFilledEllipse(image, x, y, 5, 5, 0xE0B040);
        gdImageFilledEllipse(image, x + 9, y + 9, 8, 4, 0x5F7F4A);
    }
    return write_png(image, file);
}

/* A seascape, as a JPEG. */
static bool write_painting(FILE *file)
{
    enum { W = 256, H = 128, HORIZON = 70 };
    uint32_t random = 3;
    gdImagePtr image = gdImageCreateTrueColor(W, H);
    if (!image) return false;
    for (int y = 0; y < H; y++)
        gdImageLine(image, 0, y, W - 1, y,
                    y < HORIZON ? gdTrueColor(120 + y, 160 + y, 215 + y / 3)
                                : gdTrueColor(30, 90 - (y - HORIZON) / 2, 130 - (y - HORIZON)));
    gdImageFilledEllipse(image, 190, 30, 26, 26, 0xFFE9A0);
    for (int wave = 0; wave < 60; wave++) {
        const int x = (int)(random_next(&random) % W),
                  y = HORIZON + 4 + (int)(random_next(&random) % (H - HORIZON - 6));
        gdImageLine(image, x, y, x + 10, y, 0x9CC0D0);
    }
    gdPoint sail[3] = {{90, 22}, {90, 78}, {126, 78}}, hull[4] = {{70, 82}, {134, 82}, {122, 96}, {80, 96}};
    gdImageFilledPolygon(image, sail, 3, 0xF4EFE2);
    gdImageFilledPolygon(image, hull, 4, 0x5A3320);
    gdImageLine(image, 88, 20, 88, 84, 0x3A2418);
    gdImageJpeg(image, file, 90);
    gdImageDestroy(image);
    return true;
}

static bool write_rug(FILE *file)
{
    enum { W = 128, H = 64 };
    gdImagePtr image = gdImageCreateTrueColor(W, H);
    if (!image) return false;
    gdImageFilledRectangle(image, 0, 0, W - 1, H - 1, 0x7A2430);
    for (int ring = 0; ring < 3; ring++)
        gdImageRectangle(image, 3 + 3 * ring, 3 + 3 * ring, W - 4 - 3 * ring, H - 4 - 3 * ring,
                         ring == 1 ? 0x27406B : 0xD9B36A);
    for (int x = 28; x < W; x += 24)
        for (int size = 8; size > 0; size -= 3) {
            gdPoint diamond[4] = {{x, 32 - 2 * size}, {x + size, 32}, {x, 32 + 2 * size}, {x - size, 32}};
            gdImageFilledPolygon(image, diamond, 4, size == 5 ? 0xD9B36A : size == 8 ? 0x27406B : 0x7A2430);
        }
    return write_png(image, file);
}

const struct textured_picture textured_pictures[] = {{"boards.png", write_boards},
                                                     {"bricks.png", write_bricks},
                                                     {"wallpaper.png", write_wallpaper},
                                                     {"painting.jpg", write_painting},
                                                     {"rug.png", write_rug}};
const size_t textured_picture_count = sizeof textured_pictures / sizeof *textured_pictures;
