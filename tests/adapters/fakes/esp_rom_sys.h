/* SPDX-License-Identifier: MIT
 *
 * A fake of ESP-IDF: the ROM's wait. */
#ifndef FAKE_ESP_ROM_SYS_H
#define FAKE_ESP_ROM_SYS_H

#include "fake_wires.h"

static inline void esp_rom_delay_us(uint32_t us)
{
    wires_pass(us);
}

#endif
