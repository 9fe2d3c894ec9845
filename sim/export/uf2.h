/* SPDX-License-Identifier: MIT
 *
 * Images in the form that boot drives take: Microsoft's USB Flashing Format, UF2. A file is a row of blocks of 512
 * bytes, each of which says where in flash its own bytes belong, so that a drive may receive them in any order. */
#ifndef SIM_UF2_H
#define SIM_UF2_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum {
    UF2_BLOCK_B = 512,
    UF2_PAYLOAD_B = 256, /* of the image in each block: a page of flash */
};

/* For which chip an image is, that no other takes it. */
struct uf2_family {
    const char *name;
    uint32_t id;
    uint32_t address; /* where its flash begins */
    uint32_t flash_b; /* the most that it can have */
    bool needs_absolute_block;
};

/* NULL and a list of those that there are. */
const struct uf2_family *uf2_family_find(const char *name, struct error *err);

/* Block `index` of an image that begins at the family's address; the last is filled up with zeros. */
void uf2_block(uint8_t block[UF2_BLOCK_B], const struct uf2_family *family, const uint8_t *image, size_t image_b,
               uint32_t index);

uint32_t uf2_block_count(size_t image_b);

/* The first block of a file, before the image's, if the family needs one: an RP2350 whose flash has partitions forgets
 * where they are unless a block for a fixed address comes first (erratum RP2350-E10). Its address is beyond the flash
 * of all boards, and who knows of the erratum ignores it. Source: raspberrypi/picotool, elf2uf2/elf2uf2.cpp. */
bool uf2_absolute_block(uint8_t block[UF2_BLOCK_B], const struct uf2_family *family);

#endif
