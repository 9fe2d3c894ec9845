/* SPDX-License-Identifier: MIT
 *
 * What a protocol over USB-HID needs of a transport: reports of one length out and in, and a clock for its deadlines.
 * hidapi is one such transport (hid_port.c), an emulated bridge another. The byte with a report's number, which hidapi
 * wants before each report, is the transport's affair. */
#ifndef HAL_HID_REPORTS_H
#define HAL_HID_REPORTS_H

#include "bus.h"

struct reports {
    void *ctx;
    size_t report_b; /* of every report, either way */
    /* Sends report_b bytes. 0 or a negative errno; -ENODEV: the bridge is gone. */
    int (*write)(void *ctx, const uint8_t *report) HAL_MUST_CHECK;
    /* Waits timeout_ms at most for a report of report_b bytes: how many came, or a negative errno. It may return with
     * nothing, or with less than a report, before the time is over. */
    int (*read)(void *ctx, uint8_t *report, uint32_t timeout_ms) HAL_MUST_CHECK;
    /* Milliseconds since whenever; never steps back. */
    uint64_t (*now_ms)(void *ctx);
};

#endif
