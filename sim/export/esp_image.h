/* SPDX-License-Identifier: MIT
 *
 * Images that the ROM of Espressif's chips loads: a header that says for which chip, segments with the addresses of RAM
 * that they are copied to, a checksum, a digest. Described by Espressif in espressif/esptool
 * docs/en/advanced-topics/firmware-image-format.rst, and in espressif/esp-idf
 * components/bootloader_support/include/esp_app_format.h. All of a program is in RAM here; what flash maps is left out.
 */
#ifndef SIM_ESP_IMAGE_H
#define SIM_ESP_IMAGE_H

#include "base/elf_segments.h"

/* RAM that the ROM leaves free, which code is fetched from at one address, and data at another. */
struct esp_chip {
    const char *name;
    uint16_t id; /* of the header */
    unsigned machine;
    uint32_t code_at, data_at, ram_b;
};

struct esp_image {
    uint8_t *bytes; /* to be freed */
    size_t size_b;
};

/* NULL and a list of those that there are. */
const struct esp_chip *esp_chip_find(const char *name, struct error *err);

/* Refused: a segment outside of the chip's RAM, or over another one; an entry that no segment of code holds. */
bool esp_image_make(struct esp_image *image, const struct esp_chip *chip, const struct elf_program *program,
                    struct error *err);

#endif
