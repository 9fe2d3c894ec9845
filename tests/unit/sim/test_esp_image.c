/* SPDX-License-Identifier: MIT
 *
 * Images for an ESP32-C3, byte by byte as Espressif's "Firmware Image Format" and esp_app_format.h have them; what they
 * are made of, ELF files that are put together here; and SHA-256, by the examples of FIPS 180-2 and its successors. */
#include "base/sha256.h"
#include "export/esp_image.h"
#include "rigs/cmocka_ready.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TABLE_AT = 52, ROW_B = 32, CONTENT_AT = 1024, FILE_B = 2048, RISCV = 243 };

static struct {
    uint8_t file[FILE_B];
    struct binary binary;
    struct elf_program program;
    struct esp_image image;
    struct error err;
} rig;

static void put(size_t at, uint32_t value, unsigned n_b)
{
    for (unsigned i = 0; i < n_b; i++)
        rig.file[at + i] = (uint8_t)(value >> 8 * i);
}

static void put_segment(unsigned index, uint32_t type, uint32_t address, uint32_t from_b, uint32_t size_b)
{
    const size_t at = TABLE_AT + index * ROW_B;

    put(at, type, 4);
    put(at + 4, from_b, 4);
    put(at + 8, address, 4);
    put(at + 16, size_b, 4);
    put(at + 20, size_b + 100, 4); /* what is cleared is not loaded */
    put(44, index + 1, 2);
}

/* Entry and no segments yet. */
static void begin(uint32_t entry)
{
    static const uint8_t ident[] = {0x7F, 'E', 'L', 'F', 1, 1, 1};

    for (size_t i = 0; i < FILE_B; i++)
        rig.file[i] = (uint8_t)(i * 13 + 5);
    memset(rig.file, 0, CONTENT_AT);
    memcpy(rig.file, ident, sizeof ident);
    put(18, RISCV, 2);
    put(24, entry, 4);
    put(28, TABLE_AT, 4);
    put(42, ROW_B, 2);
    rig.binary = (struct binary){rig.file, FILE_B};
}

static void begin_usual(void)
{
    begin(0x40380000);
    put_segment(0, 0x70000003, 0, CONTENT_AT, 4); /* attributes: not loaded */
    put_segment(1, 1, 0x3FC80100, CONTENT_AT, 10);
    put_segment(2, 1, 0x40380000, CONTENT_AT + 16, 256);
    put_segment(3, 1, 0x3FC80200, CONTENT_AT, 0);
}

static bool make(void)
{
    free(rig.image.bytes);
    rig.image.bytes = NULL;
    return elf_program_read(&rig.binary, RISCV, &rig.program, &rig.err) &&
           esp_image_make(&rig.image, esp_chip_find("esp32c3", &rig.err), &rig.program, &rig.err);
}

static void assert_refused(const char *why)
{
    assert_false(make());
    if (!strstr(rig.err.text, why)) fail_msg("'%s' where '%s' was meant", rig.err.text, why);
}

static void an_image_is_as_its_maker_describes_it(void **state)
{
    static const uint8_t header[24] = {0xE9, 2, 2, 0x20, 0, 0,    0x38, 0x40, 0xEE, 0, 0, 0,
                                       5,    0, 0, 0,    0, 0xFF, 0xFF, 0,    0,    0, 0, 1};
    static const uint8_t data_header[8] = {0x00, 0x01, 0xC8, 0x3F, 12, 0, 0, 0};
    static const uint8_t code_header[8] = {0x00, 0x00, 0x38, 0x40, 0, 1, 0, 0};
    uint8_t checksum = 0xEF, digest[SHA256_B];

    (void)state;
    begin_usual();
    assert_true(make());
    const uint8_t *at = rig.image.bytes;
    assert_memory_equal(at, header, 24);
    assert_memory_equal(at + 24, data_header, 8);
    assert_memory_equal(at + 32, rig.file + CONTENT_AT, 10);
    assert_int_equal(at[42] | at[43], 0);
    assert_memory_equal(at + 44, code_header, 8);
    assert_memory_equal(at + 52, rig.file + CONTENT_AT + 16, 256);
    for (int i = 0; i < 10; i++)
        checksum ^= rig.file[CONTENT_AT + i];
    for (int i = 0; i < 256; i++)
        checksum ^= rig.file[CONTENT_AT + 16 + i];
    for (int i = 308; i < 319; i++)
        assert_int_equal(at[i], 0);
    assert_int_equal(at[319], checksum);
    sha256(digest, at, 320);
    assert_memory_equal(at + 320, digest, 32);
    assert_int_equal(rig.image.size_b, 352);
}

static void the_checksum_has_a_place_whatever_the_length(void **state)
{
    (void)state;
    for (uint32_t size_b = 1; size_b < 70; size_b++) {
        begin(0x40380000);
        put_segment(0, 1, 0x40380000, CONTENT_AT, size_b);
        assert_true(make());
        const size_t least_b = 24 + 8 + (size_b + 3) / 4 * 4 + 1;
        assert_int_equal(rig.image.size_b, (least_b + 15) / 16 * 16 + 32);
    }
}

static void files_that_are_no_programs_are_refused(void **state)
{
    (void)state;
    for (size_t kept_b = 0; kept_b < CONTENT_AT + 16 + 256; kept_b++) {
        begin_usual();
        rig.binary.size_b = kept_b;
        assert_refused(kept_b < 52 ? "is no ELF file" : "is cut off");
    }
    begin_usual();
    put(4, 2, 1);
    assert_refused("is no ELF file of 32 bits");
    begin_usual();
    put(18, 40, 2);
    assert_refused("is for processor 40");
    begin_usual();
    put(42, 56, 2);
    assert_refused("no table of segments");
    begin(0x40380000);
    assert_refused("no segment that is loaded");
    begin_usual();
    put(28, UINT32_MAX - 8, 4);
    assert_refused("is cut off");
    for (unsigned i = 0; i < 17; i++)
        put_segment(i, 1, 0x40380000 + 16 * i, CONTENT_AT, 16);
    put(28, TABLE_AT, 4);
    assert_refused("more than 16 segments");
}

static void what_the_rom_could_not_load_is_refused(void **state)
{
    static const struct {
        uint32_t address, size_b;
        bool fits;
    } places[] = {
        {0x3FC80000, 100, true},  {0x3FC7FFFC, 4, false}, {0x3FC80002, 4, false}, {0x3FCCADFC, 4, true},
        {0x3FCCADFC, 5, false},   {0x3FCCAE00, 4, false}, {0x403CADFC, 4, true},  {0x403CAE00, 4, false},
        {0x42000000, 4, false},   {0x3C000000, 4, false}, {0x00000000, 4, false}, {0xFFFFFFFC, 4, false},
        {0x40380FFC, 4, true},    {0x40381100, 8, false}, {0x3FC81100, 8, false}, {0x3FC810FC, 8, false},
        {0x3FC81000, 256, false}, {0x3FC810FC, 4, false}, {0x3FC80FF8, 9, false}, {0x3FC80FF8, 8, true},
    };

    (void)state;
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        begin(0x40381000);
        put_segment(0, 1, 0x40381000, CONTENT_AT, 264);
        put_segment(1, 1, places[i].address, CONTENT_AT, places[i].size_b);
        if (make() != places[i].fits) fail_msg("place %zu: %s", i, rig.err.text);
    }
    assert_null(esp_chip_find("esp32", &rig.err));
    assert_string_equal(rig.err.text, "--chip: no 'esp32'; there is esp32c3");
}

static void its_entry_is_code(void **state)
{
    (void)state;
    begin(0x40380100);
    put_segment(0, 1, 0x40380000, CONTENT_AT, 256);
    assert_refused("its entry, 0x40380100");
    begin(0x3FC80000);
    put_segment(0, 1, 0x3FC80000, CONTENT_AT, 256);
    assert_refused("its entry, 0x3FC80000");
    begin(0x403800FC);
    put_segment(0, 1, 0x40380000, CONTENT_AT, 256);
    assert_true(make());
}

static void assert_digest(const char *text, size_t n_b, const char *hex)
{
    uint8_t digest[SHA256_B];
    char found[2 * SHA256_B + 1];

    sha256(digest, (const uint8_t *)text, n_b);
    for (int i = 0; i < SHA256_B; i++)
        (void)snprintf(found + 2 * i, 3, "%02x", digest[i]);
    assert_string_equal(found, hex);
}

static void digests_are_those_of_the_standard(void **state)
{
    char *million = malloc(1000000);

    (void)state;
    assert_non_null(million);
    memset(million, 'a', 1000000);
    assert_digest("", 0, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    assert_digest("abc", 3, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    assert_digest("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq", 56,
                  "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    assert_digest(million, 1000000, "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
    free(million);
}

static int tear_down(void **state)
{
    (void)state;
    free(rig.image.bytes);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_image_is_as_its_maker_describes_it),
        cmocka_unit_test(the_checksum_has_a_place_whatever_the_length),
        cmocka_unit_test(files_that_are_no_programs_are_refused),
        cmocka_unit_test(what_the_rom_could_not_load_is_refused),
        cmocka_unit_test(its_entry_is_code),
        cmocka_unit_test(digests_are_those_of_the_standard),
    };
    return cmocka_run_group_tests_name("images for Espressif's ROM", tests, NULL, tear_down);
}
