/* SPDX-License-Identifier: MIT
 *
 * EXPERIMENTAL, not tried on hardware: WCH's CH347T in its HID mode (mode 2, USB 1a86:55dc, interface 1). Its protocol
 * is not published. What is used here is what at least two programs of others, which were made by watching WCH's own,
 * agree upon, and nothing else:
 *
 *   - a report has 512 bytes: the length of what follows (2 bytes, low one first), a command, the length of its data (2
 *     bytes), the data. Answers look alike and repeat the command;
 *   - C0 sets SPI up: 26 bytes, of which clock (60 MHz halved up to seven times), phase and polarity are changed here;
 *   - C1 sets the two chip selects, GP2 and GP5, and is not answered;
 *   - C4 sends bytes to SPI. Up to 504 in one report, which is the most that these programs send so;
 *   - CC sets GP0 to GP7: for each a byte, C0 to change it, 30 for output, 08 for high; it answers 80 for output, 40
 * for high.
 *
 * Not known, and so not relied upon: what a status other than that of success looks like for C4; how a transfer that
 * takes several reports is begun; how one is cancelled; whether the answer to C4 comes when the bytes have left or
 * when they have been taken. If it is the latter, D/C may change too early, and pictures will be wrong. */
#ifndef HAL_HID_CH347_H
#define HAL_HID_CH347_H

#include "hid/bridge.h"

enum {
    CH347_REPORT_B = 512,
    CH347_PINS = 8,
    CH347_TRANSFER_B = 504, /* SPI bytes a report */
    CH347_RATE_MAX_HZ = 60000000,
    CH347_RATE_MIN_HZ = 468750
};

extern const struct bridge_kind ch347;

#endif
