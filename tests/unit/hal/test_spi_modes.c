/* SPDX-License-Identifier: MIT
 *
 * Which of the modes that a display takes a port does: the one that it likes, or else the lowest. */
#include "rigs/cmocka_ready.h"
#include "spi_modes.h"

static void what_is_liked_is_done_if_the_display_takes_it(void **state)
{
    (void)state;
    for (unsigned modes = 1; modes < 16; modes++)
        for (uint8_t liked = 0; liked < 4; liked++) {
            const uint8_t mode = spi_mode_of((uint8_t)modes, liked);
            assert_true(modes >> mode & 1);
            if (modes >> liked & 1) assert_int_equal(mode, liked);
        }
}

static void the_lowest_is_done_otherwise(void **state)
{
    (void)state;
    assert_int_equal(spi_mode_of(SPI_IDLES_LOW, 3), 0);
    assert_int_equal(spi_mode_of(SPI_IDLES_HIGH, 0), 3);
    assert_int_equal(spi_mode_of(SPI_IDLES_ANYHOW, 2), 0);
    assert_int_equal(spi_mode_of(1 << 1 | 1 << 2, 3), 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_liked_is_done_if_the_display_takes_it),
        cmocka_unit_test(the_lowest_is_done_otherwise),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
