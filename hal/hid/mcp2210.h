/* SPDX-License-Identifier: MIT
 *
 * Microchip's MCP2210. Facts from its datasheet, DS22288A: reports of 64 bytes, a command in byte 0 that the answer
 * repeats, a status in byte 1; SPI data 60 bytes a report, in transactions of a length that is set beforehand, with
 * chip select low from end to end.
 *
 * What was gathered leaves as one transaction of exactly that length. A transaction costs a report for its length where
 * that differs from the last one's, one each 60 bytes, and one to learn that its last byte has left, without which no
 * pin may change.
 *
 * Only RAM settings are changed, never those that outlive a power-down. Not tried on hardware. */
#ifndef HAL_HID_MCP2210_H
#define HAL_HID_MCP2210_H

#include "hid/bridge.h"

HAL_C_BEGIN

enum {
    MCP2210_REPORT_B = 64,
    MCP2210_PINS = 9,
    MCP2210_TRANSFER_B = 60,       /* SPI bytes a report */
    MCP2210_TRANSACTION_B = 65520, /* a whole number of reports, within 16 bits */
    MCP2210_RATE_MIN_HZ = 1500,
    MCP2210_RATE_MAX_HZ = 12000000
};

extern const struct bridge_kind mcp2210;

HAL_C_END

#endif
