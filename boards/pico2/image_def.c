/* SPDX-License-Identifier: MIT
 *
 * What the RP2350's boot ROM looks for in the first 4 KB of flash: a block that says what image this is, an executable
 * for Arm in secure state. It says no more, so the image begins with its vector table, from which the ROM takes the
 * stack pointer and the entry. The block is alone in its loop: the next one is itself.
 * Source: RP2350 Datasheet, 5.1.4 and 5.9 (blocks, items, image types); raspberrypi/pico-sdk,
 * src/common/boot_picobin_headers/include/boot/picobin.h. */
#include <stdint.h>

#define BLOCK_BEGIN UINT32_C(0xFFFFDED3)
#define BLOCK_END UINT32_C(0xAB123579)

/* An item: its kind, its words and, here, what it holds. */
#define ITEM(kind, words, data) ((uint32_t)(kind) | (uint32_t)(words) << 8 | (uint32_t)(data) << 16)

enum { ITEM_IMAGE_TYPE = 0x42, TYPE_EXECUTABLE = 1, SECURITY_SECURE = 2 << 4, CPU_ARM = 0 << 8, CHIP_RP2350 = 1 << 12 };

/* The last item's words are in two bytes, and are those of all before it. */
#define LAST_ITEM(words) (UINT32_C(0xFF) | (uint32_t)(words) << 8)

__attribute__((section(".image_def"), used)) static const uint32_t image_def[] = {
    BLOCK_BEGIN,  ITEM(ITEM_IMAGE_TYPE, 1, TYPE_EXECUTABLE | SECURITY_SECURE | CPU_ARM | CHIP_RP2350),
    LAST_ITEM(1), 0, /* bytes to the next block */
    BLOCK_END,
};
