/* SPDX-License-Identifier: MIT
 *
 * What an RP2040 and an RP2350 are given: UF2 blocks, field by field as Microsoft's specification has them, and the
 * second stage's checksum, which is the CRC-32/MPEG-2 of the catalogues. */
#include "export/boot2.h"
#include "export/uf2.h"
#include "rigs/cmocka_ready.h"

#include <string.h>

static uint32_t word_at(const uint8_t *at)
{
    return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

static void assert_words(const uint8_t *at, const uint32_t *words, size_t count)
{
    for (size_t i = 0; i < count; i++)
        assert_int_equal(word_at(at + 4 * i), words[i]);
}

static void test_a_block_says_where_its_bytes_belong(void **state)
{
    (void)state;
    uint8_t image[600], block[UF2_BLOCK_B];
    struct error err;
    for (size_t i = 0; i < sizeof image; i++)
        image[i] = (uint8_t)(i * 7 + 1);
    uf2_block(block, uf2_family_find("rp2040", &err), image, sizeof image, 1);

    const uint32_t header[] = {0x0A324655, 0x9E5D5157, 0x2000, 0x10000100, 256, 1, 3, 0xE48BFF56};
    assert_words(block, header, 8);
    assert_memory_equal(block + 32, image + 256, 256);
    for (size_t i = 32 + 256; i < 508; i++)
        assert_int_equal(block[i], 0);
    assert_int_equal(word_at(block + 508), 0x0AB16F30);
}

static void test_the_last_block_is_filled_up(void **state)
{
    (void)state;
    uint8_t image[513], block[UF2_BLOCK_B];
    struct error err;
    memset(image, 0xA5, sizeof image);
    memset(block, 0xFF, sizeof block);
    uf2_block(block, uf2_family_find("rp2040", &err), image, sizeof image, 2);

    const uint32_t place[] = {0x10000200, 256, 2, 3};
    assert_words(block + 12, place, 4);
    assert_int_equal(block[32], 0xA5);
    assert_int_equal(block[33], 0);
}

static void test_blocks_are_as_many_as_pages(void **state)
{
    (void)state;
    assert_int_equal(uf2_block_count(1), 1);
    assert_int_equal(uf2_block_count(256), 1);
    assert_int_equal(uf2_block_count(257), 2);
}

static void test_an_unknown_family_is_refused_with_those_known(void **state)
{
    (void)state;
    struct error err;
    assert_null(uf2_family_find("samd51", &err));
    assert_string_equal(err.text, "--family: no 'samd51'; there are rp2040 and rp2350-arm-s");
}

static void test_an_rp2350_is_told_a_fixed_address_first(void **state)
{
    (void)state;
    uint8_t block[UF2_BLOCK_B];
    struct error err;
    memset(block, 0x11, sizeof block);
    assert_false(uf2_absolute_block(block, uf2_family_find("rp2040", &err)));
    assert_int_equal(block[0], 0x11);
    assert_true(uf2_absolute_block(block, uf2_family_find("rp2350-arm-s", &err)));

    const uint32_t header[] = {0x0A324655, 0x9E5D5157, 0xA000, 0x10FFFF00, 256, 0, 2, 0xE48BFF57};
    assert_words(block, header, 8);
    for (size_t i = 32; i < 288; i++)
        assert_int_equal(block[i], 0xEF);
    assert_int_equal(word_at(block + 288), 0x9957E304);
    for (size_t i = 292; i < 508; i++)
        assert_int_equal(block[i], 0);
    assert_int_equal(word_at(block + 508), 0x0AB16F30);
    assert_int_equal(uf2_family_find("rp2350-arm-s", &err)->id, 0xE48BFF59);
}

static void test_the_checksum_is_that_of_the_catalogues(void **state)
{
    (void)state;
    assert_int_equal(boot2_checksum((const uint8_t *)"123456789", 9), 0x0376E6E7);
}

static void test_a_second_stage_ends_with_the_checksum_of_what_precedes(void **state)
{
    (void)state;
    uint8_t code[10], sealed[BOOT2_B];
    memset(code, 0x42, sizeof code);
    boot2_seal(sealed, code, sizeof code);

    assert_memory_equal(sealed, code, sizeof code);
    for (size_t i = sizeof code; i < 252; i++)
        assert_int_equal(sealed[i], 0);
    assert_int_equal(word_at(sealed + 252), boot2_checksum(sealed, 252));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_block_says_where_its_bytes_belong),
        cmocka_unit_test(test_the_last_block_is_filled_up),
        cmocka_unit_test(test_blocks_are_as_many_as_pages),
        cmocka_unit_test(test_an_unknown_family_is_refused_with_those_known),
        cmocka_unit_test(test_an_rp2350_is_told_a_fixed_address_first),
        cmocka_unit_test(test_the_checksum_is_that_of_the_catalogues),
        cmocka_unit_test(test_a_second_stage_ends_with_the_checksum_of_what_precedes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
