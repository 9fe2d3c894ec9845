/* SPDX-License-Identifier: MIT
 *
 * What all kinds of USB-HID bridges to SPI have in common: bytes out, pins as outputs, over reports. A kind is one file
 * and a line in hid_bridges.c. */
#ifndef HAL_HID_BRIDGE_H
#define HAL_HID_BRIDGE_H

#include "hid/reports.h"

enum { BRIDGE_PATIENCE_MS = 1000 }; /* for an answer, and with a bridge that says it is busy */

/* Pins are bits, GP0 the lowest. */
struct bridge_config {
    uint32_t bit_rate_hz; /* what the display takes at most: a bridge may be slower */
    uint8_t mode;         /* of SPI, 0..3 */
    uint16_t outputs;     /* pins that set() is to change */
    uint16_t levels;      /* theirs from the start */
    uint16_t selects;     /* pins that are low while bytes are sent: chip select */
};

/* All functions return 0 or a negative errno: the transport's own unchanged, -ETIMEDOUT for no answer or a bridge busy
 * without end, -EBUSY where another master has the bus, -EPROTO for answers that such a bridge does not give, -EINVAL
 * for a configuration that it cannot have. After an error what waited is dropped, and the next call first brings the
 * bridge to a known state. */
struct bridge_kind {
    const char *name;         /* as people say it */
    const char *file;         /* in the name of its udev rule */
    const char *experimental; /* NULL, or what is to be said of it */
    uint16_t vendor, product;
    size_t report_b;
    uint16_t transfer_b; /* SPI bytes a report */
    uint8_t pins;        /* GP0 and so on */
    size_t state_b;      /* of what the functions get, all zero before begin() */
    size_t gathered_b;   /* the most that one send() takes */
    /* Ends whatever the bridge was at, and sets up its pins. */
    int (*begin)(void *state, const struct reports *reports, const struct bridge_config *config) HAL_MUST_CHECK;
    /* Sends what was gathered, and returns when all of it has left the bridge. n_b 0: nothing but what an error left to
     * be done. */
    int (*send)(void *state, const uint8_t *data, size_t n_b) HAL_MUST_CHECK;
    /* Sets one of the outputs. */
    int (*set)(void *state, unsigned pin, bool high) HAL_MUST_CHECK;
    /* What failed last, if it was not the transport: then "". */
    const char *(*why)(const void *state);
};

#endif
