/* SPDX-License-Identifier: MIT
 *
 * Every pixel of a square is looked at. */
#include "pictures/enlarged.h"

#include "base/rgb565.h"
#include "pictures/hashes.h"

#include <stdlib.h>

struct shrunk {
    int side; /* of a square */
    int w_px, h_px;
    uint16_t *pixels;
};

static int colour_at(gdImagePtr image, int x, int y)
{
    return gdImageGetTrueColorPixel(image, x, y) & 0xFFFFFF;
}

static bool is_square(gdImagePtr image, int x, int y, int side)
{
    const int colour = colour_at(image, x * side, y * side);
    for (int i = 0; i < side * side; i++)
        if (colour_at(image, x * side + i % side, y * side + i / side) != colour) return false;
    return true;
}

static bool shrink(const struct shrunk *to, gdImagePtr image, const char *path, struct error *err)
{
    for (int i = 0; i < to->w_px * to->h_px; i++) {
        const int x = i % to->w_px, y = i / to->w_px;
        const int colour = colour_at(image, x * to->side, y * to->side);
        const uint8_t rgb[] = {(uint8_t)(colour >> 16), (uint8_t)(colour >> 8), (uint8_t)colour};
        if (!is_square(image, x, y, to->side))
            return error_set(err, "%s: pixel %d,%d has several colours in its %dx%d", path, x, y, to->side, to->side);
        to->pixels[i] = rgb565_from_rgb888(rgb);
    }
    return true;
}

bool enlarged_hash(gdImagePtr image, int side, const char *path, uint64_t *hash, struct error *err)
{
    struct shrunk to = {.side = side, .w_px = gdImageSX(image) / side, .h_px = gdImageSY(image) / side};
    if (gdImageSX(image) % side || gdImageSY(image) % side)
        return error_set(err, "%s: %dx%d pixels are not whole squares of %dx%d", path, gdImageSX(image),
                         gdImageSY(image), side, side);
    const size_t pixel_count = (size_t)to.w_px * (size_t)to.h_px;
    to.pixels = malloc(pixel_count * sizeof to.pixels[0]);
    const bool ok = to.pixels ? shrink(&to, image, path, err) : error_set(err, "%s: out of memory", path);
    if (ok) *hash = hash_pixels(to.pixels, pixel_count);
    free(to.pixels);
    return ok;
}
