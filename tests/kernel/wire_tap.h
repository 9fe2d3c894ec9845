/* SPDX-License-Identifier: MIT OR GPL-2.0
 *
 * What /dev/wire_tap gives: events in their order, each followed by n_b bytes of data. Shared by the kernel's driver
 * and by the program that plays a record to an emulated panel. */
#ifndef TESTS_WIRE_TAP_H
#define TESTS_WIRE_TAP_H

#ifdef __KERNEL__
#include <linux/types.h>
#else
#include <stdint.h>
#endif

enum wire_line { WIRE_DC, WIRE_RESET, WIRE_BACKLIGHT, WIRE_SELECT, WIRE_LINES };

enum wire_tap_kind {
    WIRE_TAP_LEVEL = 1, /* line `which` is an output of level `value` */
    WIRE_TAP_INPUT,     /* line `which` is an input */
    WIRE_TAP_RELEASED,  /* line `which` belongs to no program any more */
    WIRE_TAP_SELECT,    /* the bus's own chip select `which` has level `value` */
    WIRE_TAP_BYTES,     /* n_b bytes to the chip of select `which`, at `value` Hz */
};

struct wire_tap_event {
    uint64_t time_ns;
    uint32_t value;
    uint32_t n_b;
    uint8_t kind, which;
    uint8_t mode, word_bits; /* of WIRE_TAP_BYTES */
    uint32_t unused;
};

#endif
