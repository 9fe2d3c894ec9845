/* SPDX-License-Identifier: MIT
 *
 * Microchip's MCP2210 over any transport of reports (reports.h): bytes to SPI, and GP0..GP8 as outputs. Facts from its
 * datasheet, DS22288A: reports of 64 bytes, a command in byte 0 that the answer repeats, a status in byte 1; SPI data
 * 60 bytes a report, in transactions of a length that is set beforehand, with chip select low from end to end.
 *
 * What is written is gathered, and leaves when the buffer is full or with a flush, as one transaction of exactly that
 * length. A transaction costs a report for its length where that differs from the last one's, one each 60 bytes, and
 * one to learn that its last byte has left, without which no pin may change.
 *
 * Only RAM settings are changed, never those that outlive a power-down. Not tried on hardware. */
#ifndef HAL_HID_MCP2210_H
#define HAL_HID_MCP2210_H

#include "hid/reports.h"

enum {
    MCP2210_VENDOR = 0x04D8,
    MCP2210_PRODUCT = 0x00DE,
    MCP2210_REPORT_B = 64,
    MCP2210_PINS = 9,
    MCP2210_TRANSFER_B = 60,       /* SPI bytes a report */
    MCP2210_TRANSACTION_B = 65520, /* a whole number of reports, within 16 bits */
    MCP2210_RATE_MIN_HZ = 1500,
    MCP2210_RATE_MAX_HZ = 12000000,
    MCP2210_PATIENCE_MS = 1000, /* for an answer, and with a bridge that says it is busy */
    MCP2210_WHY_B = 128
};

/* Pins are bits, GP0 the lowest. */
struct mcp2210_config {
    uint32_t bit_rate_hz; /* 1500 to 12000000 */
    uint8_t mode;         /* of SPI, 0..3 */
    uint16_t outputs;     /* pins that mcp2210_set() is to change */
    uint16_t levels;      /* theirs from the start */
    uint16_t selects;     /* pins that are low during transactions: chip select */
};

/* Private but for `why`. */
struct mcp2210 {
    struct reports reports;
    struct mcp2210_config config;
    char why[MCP2210_WHY_B]; /* what failed last, if it was not the transport: then empty */
    uint16_t levels;         /* of all pins, as far as they are outputs */
    uint16_t transaction_b;  /* that the bridge is set to; 0: unknown */
    bool begun;              /* pins are set up */
    bool in_doubt;           /* after an error: answers may be on their way, a transaction may be open */
    uint8_t report[MCP2210_REPORT_B], answer[MCP2210_REPORT_B];
    size_t waiting_b;
    uint8_t waiting[MCP2210_TRANSACTION_B];
};

/* All functions return 0 or a negative errno: the transport's own unchanged, -ETIMEDOUT for no answer or a bridge busy
 * (0xF8) without end, -EBUSY where another master has the bus (0xF7), -EPROTO for answers that an MCP2210 does not
 * give, -EINVAL for a configuration that it cannot have. After an error what waited is dropped, and the next call first
 * cancels what the bridge may be at and reads away what is left of its answers. */

/* Large: *bridge belongs on the heap. Ends whatever the bridge was at, and sets up its pins. */
HAL_MUST_CHECK int mcp2210_begin(struct mcp2210 *bridge, const struct reports *reports,
                                 const struct mcp2210_config *config);

/* data is free at the return. */
HAL_MUST_CHECK int mcp2210_write(struct mcp2210 *bridge, const uint8_t *data, size_t n_b);

/* Returns when all bytes have left the bridge. */
HAL_MUST_CHECK int mcp2210_flush(struct mcp2210 *bridge);

/* Flushes, then sets one of the outputs. */
HAL_MUST_CHECK int mcp2210_set(struct mcp2210 *bridge, unsigned pin, bool high);

#endif
