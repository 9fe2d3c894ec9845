/* SPDX-License-Identifier: MIT */
#include "export/boot2.h"

#include <string.h>

#define POLYNOMIAL UINT32_C(0x04C11DB7)
#define TOP_BIT (UINT32_C(1) << 31)

uint32_t boot2_checksum(const uint8_t *bytes, size_t size_b)
{
    uint32_t sum = UINT32_MAX;
    for (size_t i = 0; i < size_b; i++) {
        sum ^= (uint32_t)bytes[i] << 24;
        for (int bit = 0; bit < 8; bit++)
            sum = sum & TOP_BIT ? sum << 1 ^ POLYNOMIAL : sum << 1;
    }
    return sum;
}

void boot2_seal(uint8_t sealed[BOOT2_B], const uint8_t *code, size_t code_b)
{
    memset(sealed, 0, BOOT2_B);
    memcpy(sealed, code, code_b);
    const uint32_t sum = boot2_checksum(sealed, BOOT2_CODE_B);
    for (int i = 0; i < 4; i++)
        sealed[BOOT2_CODE_B + i] = (uint8_t)(sum >> 8 * i);
}
