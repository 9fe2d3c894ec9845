/* SPDX-License-Identifier: MIT
 *
 * struct port over a USB-HID bridge behind any link: hidapi's (hid_port.h), or an emulated cable. The bridge may be
 * unplugged at any moment: the call under way fails, the next one opens the link again and sets the bridge up anew.
 * Whoever draws then calls panel_init(), as after every error of a port, because the display lost its power with the
 * bridge. */
#ifndef HAL_HID_BRIDGE_PORT_H
#define HAL_HID_BRIDGE_PORT_H

#include "hid/bridge.h"
#include "port.h"

HAL_C_BEGIN

/* How a bridge is reached. All functions get ctx; what ctx points to belongs to the port once that is open. */
struct bridge_link {
    void *ctx;
    /* Finds the bridge and opens it: 0, or a negative errno. Called again after an error. */
    int (*open)(void *ctx, struct reports *reports, const struct bridge_kind **kind);
    void (*close)(void *ctx);       /* the bridge, if it is open */
    void (*release)(void *ctx);     /* closes, and frees ctx; NULL: nothing to free */
    const char *(*name)(void *ctx); /* of the bridge, for errors */
    const char *(*why)(void *ctx);  /* what failed last, of open or of reports: reason and remedy */
    struct clock clock;
};

/* Names of pins are GP0 and so on; NULL: not wired. */
struct bridge_options {
    const char *dc, *reset, *backlight;
    const char *select;      /* set by the panel's driver, */
    const char *chip_select; /* or lowered by the bridge for each transaction; with neither the display's is tied low */
    uint32_t bit_rate_hz;    /* what the display takes at most; 0: the bridge's best */
    uint8_t mode;            /* of SPI, 0..3 */
};

/* 0 or a negative errno with port->error; then *port needs no close, and the link has been released. While it is open
 * *port must not move. */
HAL_MUST_CHECK int bridge_port_open(struct port *port, const struct bridge_link *link,
                                    const struct bridge_options *options);

HAL_C_END

#endif
