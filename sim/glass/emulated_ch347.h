/* SPDX-License-Identifier: MIT
 *
 * WCH's CH347T in its HID mode, emulated from what hal/hid/ch347.h says that programs of others agree upon: reports of
 * 512 bytes in, answers out, and on the other side SPI bytes and pin levels for an emulated display. As nobody has
 * published the protocol this shows that driver and notes agree, and no more. It complains about what the notes do not
 * have. */
#ifndef SIM_EMULATED_CH347_H
#define SIM_EMULATED_CH347_H

#include "bus.h"

enum { EMULATED_CH347_PINS = 8, EMULATED_CH347_REPORT_B = 512 };

struct emulated_ch347 {
    /* How it is wired, to be filled in after init. */
    struct bus spi;
    struct pin pins[EMULATED_CH347_PINS];
    uint8_t select; /* the display's chip select: 2 or 5 */

    /* To be read. */
    bool is_set_up; /* SPI is */
    uint8_t clock, mode;
    uint8_t outputs, levels; /* a bit a pin */
    bool selected[2];
    uint64_t bus_b;
    unsigned complaints;
    char complaint[96]; /* the last one */
};

void emulated_ch347_init(struct emulated_ch347 *chip);

/* The same chip with its wires, after another power-up. */
void emulated_ch347_power_up(struct emulated_ch347 *chip);

/* One report without its number, and the answer to it; false: there is none. */
bool emulated_ch347_answer(void *chip, const uint8_t *report, uint8_t *answer);

#endif
