/* SPDX-License-Identifier: MIT
 *
 * Pictures whose pixels are squares: their hash is that of the small picture; a square that is not of one colour, or
 * not whole, is found wherever it is. */
#include "pictures/enlarged.h"
#include "pictures/hashes.h"
#include "rigs/cmocka_ready.h"

#include <string.h>

enum { W_PX = 5, H_PX = 3, SIDE = 4 };

static const uint16_t SMALL[W_PX * H_PX] = {0xF800, 0x07E0, 0x001F, 0xFFFF, 0x0000, 0x8410, 0x4208, 0xC618,
                                            0x1234, 0x4321, 0xABCD, 0xDCBA, 0x0001, 0x0020, 0x0800};

static gdImagePtr enlarge(int side)
{
    gdImagePtr image = gdImageCreateTrueColor(W_PX * side, H_PX * side);
    for (int y = 0; y < H_PX * side; y++)
        for (int x = 0; x < W_PX * side; x++)
            image->tpixels[y][x] = (int)image_rgb888_from_565(SMALL[y / side * W_PX + x / side]);
    return image;
}

static void an_enlarged_picture_has_the_small_ones_hash(void **state)
{
    (void)state;
    for (int side = 1; side <= SIDE; side++) {
        struct error err;
        uint64_t hash = 0;
        gdImagePtr image = enlarge(side);
        assert_true(enlarged_hash(image, side, "x.png", &hash, &err));
        assert_true(hash == hash_pixels(SMALL, W_PX * H_PX));
        gdImageDestroy(image);
    }
}

static void one_pixel_of_another_colour_is_found(void **state)
{
    (void)state;
    for (int i = 0; i < W_PX * H_PX * SIDE * SIDE; i++) {
        struct error err = {""};
        uint64_t hash;
        gdImagePtr image = enlarge(SIDE);
        char said[80];
        image->tpixels[i / (W_PX * SIDE)][i % (W_PX * SIDE)] ^= 1;
        assert_false(enlarged_hash(image, SIDE, "x.png", &hash, &err));
        snprintf(said, sizeof said, "x.png: pixel %d,%d has several colours in its 4x4", i % (W_PX * SIDE) / SIDE,
                 i / (W_PX * SIDE) / SIDE);
        assert_string_equal(err.text, said);
        gdImageDestroy(image);
    }
}

static void sides_that_are_no_whole_squares_are_refused(void **state)
{
    struct error err;
    uint64_t hash;
    gdImagePtr image = enlarge(SIDE);
    (void)state;
    assert_false(enlarged_hash(image, 3, "x.png", &hash, &err));
    assert_string_equal(err.text, "x.png: 20x12 pixels are not whole squares of 3x3");
    assert_false(enlarged_hash(image, 5, "x.png", &hash, &err));
    gdImageDestroy(image);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_enlarged_picture_has_the_small_ones_hash),
        cmocka_unit_test(one_pixel_of_another_colour_is_found),
        cmocka_unit_test(sides_that_are_no_whole_squares_are_refused),
    };
    return cmocka_run_group_tests_name("enlarged pictures", tests, NULL, NULL);
}
