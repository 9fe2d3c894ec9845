/* SPDX-License-Identifier: MIT */
#include "export/uf2.h"

#include <string.h>

#define MAGIC_START_0 UINT32_C(0x0A324655) /* "UF2\n" */
#define MAGIC_START_1 UINT32_C(0x9E5D5157)
#define MAGIC_END UINT32_C(0x0AB16F30)
#define FLAG_FAMILY_ID UINT32_C(0x2000)
#define FLAG_EXTENSION UINT32_C(0x8000)

/* The absolute family, its address, and the extension that says what it is for: raspberrypi/pico-sdk,
 * src/common/boot_uf2_headers/include/boot/uf2.h. */
#define ABSOLUTE_FAMILY UINT32_C(0xE48BFF57)
#define ABSOLUTE_ADDRESS UINT32_C(0x10FFFF00)
#define EXTENSION_IGNORE UINT32_C(0x9957E304)

enum { HEADER_WORDS = 8, DATA_AT = 4 * HEADER_WORDS, MAGIC_END_AT = 508, ABSOLUTE_FILL = 0xEF, ABSOLUTE_BLOCKS = 2 };

/* RP2040 and RP2350 map 16 MB of flash for execution; the latter has as much again for a second chip. Identities: uf2.h
 * of pico-sdk, as above. */
static const struct uf2_family FAMILIES[] = {
    {"rp2040", 0xE48BFF56, 0x10000000, UINT32_C(16) << 20, false},
    {"rp2350-arm-s", 0xE48BFF59, 0x10000000, UINT32_C(16) << 20, true},
};

const struct uf2_family *uf2_family_find(const char *name, struct error *err)
{
    for (size_t i = 0; i < sizeof FAMILIES / sizeof FAMILIES[0]; i++)
        if (strcmp(FAMILIES[i].name, name) == 0) return &FAMILIES[i];
    error_set(err, "--family: no '%s'; there are rp2040 and rp2350-arm-s", name);
    return NULL;
}

uint32_t uf2_block_count(size_t image_b)
{
    return (uint32_t)((image_b + UF2_PAYLOAD_B - 1) / UF2_PAYLOAD_B);
}

static void put_word(uint8_t *at, uint32_t word)
{
    for (int i = 0; i < 4; i++, word >>= 8)
        at[i] = (uint8_t)word;
}

/* All but the data. */
static void put_frame(uint8_t block[UF2_BLOCK_B], const uint32_t header[HEADER_WORDS])
{
    memset(block, 0, UF2_BLOCK_B);
    for (size_t i = 0; i < HEADER_WORDS; i++)
        put_word(block + 4 * i, header[i]);
    put_word(block + MAGIC_END_AT, MAGIC_END);
}

void uf2_block(uint8_t block[UF2_BLOCK_B], const struct uf2_family *family, const uint8_t *image, size_t image_b,
               uint32_t index)
{
    const size_t from_b = (size_t)index * UF2_PAYLOAD_B, rest_b = image_b - from_b;
    const uint32_t header[HEADER_WORDS] = {
        MAGIC_START_0, MAGIC_START_1, FLAG_FAMILY_ID,           family->address + (uint32_t)from_b,
        UF2_PAYLOAD_B, index,         uf2_block_count(image_b), family->id,
    };

    put_frame(block, header);
    memcpy(block + DATA_AT, image + from_b, rest_b < UF2_PAYLOAD_B ? rest_b : UF2_PAYLOAD_B);
}

bool uf2_absolute_block(uint8_t block[UF2_BLOCK_B], const struct uf2_family *family)
{
    static const uint32_t header[HEADER_WORDS] = {
        MAGIC_START_0,   MAGIC_START_1,   FLAG_FAMILY_ID | FLAG_EXTENSION, ABSOLUTE_ADDRESS, UF2_PAYLOAD_B, 0,
        ABSOLUTE_BLOCKS, ABSOLUTE_FAMILY,
    };

    if (!family->needs_absolute_block) return false;
    put_frame(block, header);
    memset(block + DATA_AT, ABSOLUTE_FILL, UF2_PAYLOAD_B);
    put_word(block + DATA_AT + UF2_PAYLOAD_B, EXTENSION_IGNORE);
    return true;
}
