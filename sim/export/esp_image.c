/* SPDX-License-Identifier: MIT
 *
 * The ESP32-C3's RAM begins where its cache's ends, and ends for an image where the ROM's buffers for a download begin
 * (espressif/esp-idf components/bootloader/subproject/main/ld/esp32c3/bootloader.memory.ld.in). The header tells the
 * ROM to read flash by two lines, at 40 MHz: its slower rate that images usually have. */
#include "export/esp_image.h"

#include "base/sha256.h"

#include <stdlib.h>
#include <string.h>

enum {
    MAGIC = 0xE9,
    FLASH_DIO = 2,
    FLASH_4_MB_40_MHZ = 0x20,
    NO_WRITE_PROTECT_PIN = 0xEE,
    HEADER_B = 24,
    ENTRY_AT = 4,
    WRITE_PROTECT_AT = 8,
    CHIP_AT = 12,
    LAST_REVISION_AT = 17, /* any */
    DIGEST_AT = 23,
    SEGMENT_HEADER_B = 8,
    CHECKSUM_SEED = 0xEF,
    ALIGNMENT_B = 16 /* with the checksum, its last byte */
};

static const struct esp_chip CHIPS[] = {{"esp32c3", 5, ELF_RISCV, 0x40380000, 0x3FC80000, 0x4AE00}};

const struct esp_chip *esp_chip_find(const char *name, struct error *err)
{
    for (size_t i = 0; i < sizeof CHIPS / sizeof CHIPS[0]; i++)
        if (strcmp(CHIPS[i].name, name) == 0) return &CHIPS[i];
    error_set(err, "--chip: no '%s'; there is esp32c3", name);
    return NULL;
}

/* Segments are whole words. */
static uint32_t padded_b(const struct elf_segment *segment)
{
    return (segment->size_b + 3) / 4 * 4;
}

/* Where in RAM it begins, by either address; ram_b: nowhere, or it is too long. */
static uint32_t place_b(const struct esp_chip *chip, const struct elf_segment *segment)
{
    const uint32_t in_code_b = segment->address - chip->code_at, in_data_b = segment->address - chip->data_at;
    const uint32_t at_b = in_code_b < chip->ram_b ? in_code_b : in_data_b;

    return at_b % 4 == 0 && at_b < chip->ram_b && padded_b(segment) <= chip->ram_b - at_b ? at_b : chip->ram_b;
}

static bool overlap(const struct esp_chip *chip, const struct elf_segment *a, const struct elf_segment *b)
{
    const uint32_t a_b = place_b(chip, a), b_b = place_b(chip, b);
    return a_b < b_b + padded_b(b) && b_b < a_b + padded_b(a);
}

static bool check_segment(const struct esp_chip *chip, const struct elf_program *program, unsigned index,
                          struct error *err)
{
    const struct elf_segment *segment = &program->segments[index];

    if (place_b(chip, segment) == chip->ram_b)
        return error_set(err, "0x%08X, %u bytes: not whole words in the RAM of %s that its ROM leaves free",
                         (unsigned)segment->address, (unsigned)segment->size_b, chip->name);
    for (unsigned i = 0; i < index; i++)
        if (overlap(chip, segment, &program->segments[i]))
            return error_set(err, "0x%08X and 0x%08X are the same RAM of %s", (unsigned)program->segments[i].address,
                             (unsigned)segment->address, chip->name);
    return true;
}

static bool check(const struct esp_chip *chip, const struct elf_program *program, struct error *err)
{
    bool begins = false;

    for (unsigned i = 0; i < program->count; i++) {
        const struct elf_segment *segment = &program->segments[i];
        if (!check_segment(chip, program, i, err)) return false;
        begins = begins || (segment->address - chip->code_at < chip->ram_b &&
                            program->entry - segment->address < segment->size_b);
    }
    return begins || error_set(err, "its entry, 0x%08X, is not in what is loaded as code", (unsigned)program->entry);
}

static void put_word(uint8_t *at, uint32_t word)
{
    for (int i = 0; i < 4; i++, word >>= 8)
        at[i] = (uint8_t)word;
}

static void put_header(uint8_t *at, const struct esp_chip *chip, const struct elf_program *program)
{
    at[0] = MAGIC;
    at[1] = (uint8_t)program->count;
    at[2] = FLASH_DIO;
    at[3] = FLASH_4_MB_40_MHZ;
    put_word(at + ENTRY_AT, program->entry);
    at[WRITE_PROTECT_AT] = NO_WRITE_PROTECT_PIN;
    at[CHIP_AT] = (uint8_t)chip->id;
    at[CHIP_AT + 1] = (uint8_t)(chip->id >> 8);
    at[LAST_REVISION_AT] = at[LAST_REVISION_AT + 1] = 0xFF;
    at[DIGEST_AT] = 1;
}

static size_t sealed_b(const struct elf_program *program)
{
    size_t size_b = HEADER_B;

    for (unsigned i = 0; i < program->count; i++)
        size_b += SEGMENT_HEADER_B + padded_b(&program->segments[i]);
    return (size_b + ALIGNMENT_B) / ALIGNMENT_B * ALIGNMENT_B;
}

static uint8_t put_segments(uint8_t *at, const struct elf_program *program)
{
    uint8_t checksum = CHECKSUM_SEED;

    for (unsigned i = 0; i < program->count; i++) {
        const struct elf_segment *segment = &program->segments[i];
        put_word(at, segment->address);
        put_word(at + 4, padded_b(segment));
        memcpy(at + SEGMENT_HEADER_B, segment->bytes, segment->size_b);
        for (uint32_t k = 0; k < segment->size_b; k++)
            checksum ^= segment->bytes[k];
        at += SEGMENT_HEADER_B + padded_b(segment);
    }
    return checksum;
}

bool esp_image_make(struct esp_image *image, const struct esp_chip *chip, const struct elf_program *program,
                    struct error *err)
{
    if (!check(chip, program, err)) return false;
    const size_t before_digest_b = sealed_b(program);
    image->size_b = before_digest_b + SHA256_B;
    image->bytes = calloc(1, image->size_b);
    if (!image->bytes) return error_set(err, "out of memory");
    put_header(image->bytes, chip, program);
    image->bytes[before_digest_b - 1] = put_segments(image->bytes + HEADER_B, program);
    sha256(image->bytes + before_digest_b, image->bytes, before_digest_b);
    return true;
}
