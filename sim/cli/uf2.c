/* SPDX-License-Identifier: MIT */
#include "cli/uf2.h"

#include <string.h>

#define MAGIC_START_0 UINT32_C(0x0A324655) /* "UF2\n" */
#define MAGIC_START_1 UINT32_C(0x9E5D5157)
#define MAGIC_END UINT32_C(0x0AB16F30)
#define FLAG_FAMILY_ID UINT32_C(0x2000)

enum { DATA_AT = 32, MAGIC_END_AT = 508 };

/* The RP2040 maps 16 MB of flash for execution. */
static const struct uf2_family FAMILIES[] = {{"rp2040", 0xE48BFF56, 0x10000000, UINT32_C(16) << 20}};

const struct uf2_family *uf2_family_find(const char *name, struct error *err)
{
    for (size_t i = 0; i < sizeof FAMILIES / sizeof FAMILIES[0]; i++)
        if (strcmp(FAMILIES[i].name, name) == 0) return &FAMILIES[i];
    error_set(err, "--family: no '%s'; there is rp2040", name);
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

void uf2_block(uint8_t block[UF2_BLOCK_B], const struct uf2_family *family, const uint8_t *image, size_t image_b,
               uint32_t index)
{
    const size_t from_b = (size_t)index * UF2_PAYLOAD_B, rest_b = image_b - from_b;
    const uint32_t header[DATA_AT / 4] = {
        MAGIC_START_0, MAGIC_START_1, FLAG_FAMILY_ID,           family->address + (uint32_t)from_b,
        UF2_PAYLOAD_B, index,         uf2_block_count(image_b), family->id,
    };

    memset(block, 0, UF2_BLOCK_B);
    for (size_t i = 0; i < DATA_AT / 4; i++)
        put_word(block + 4 * i, header[i]);
    memcpy(block + DATA_AT, image + from_b, rest_b < UF2_PAYLOAD_B ? rest_b : UF2_PAYLOAD_B);
    put_word(block + MAGIC_END_AT, MAGIC_END);
}
