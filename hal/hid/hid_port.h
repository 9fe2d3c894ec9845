/* SPDX-License-Identifier: MIT
 *
 * A port over USB: an MCP2210 through hidapi, by either of its ways on Linux, hidraw and libusb.
 *
 *     struct port port;
 *     int err = hid_port_open(&port, NULL, &(struct bridge_options){.dc = "GP0", .reset = "GP1", .chip_select =
 * "GP3"}); if (err) puts(port.error);
 *
 * Unplugged in the middle of a frame, that frame fails; plugged in again, the next call finds the bridge by its serial
 * number, or if it has none as the only one there is. */
#ifndef HAL_HID_PORT_H
#define HAL_HID_PORT_H

#include "hid/bridge_port.h"

HAL_C_BEGIN

/* serial NULL or "": the only bridge there is. 0 or a negative errno with port->error. Until port_close() *port must
 * not move. */
HAL_MUST_CHECK int hid_port_open(struct port *port, const char *serial, const struct bridge_options *options);

HAL_C_END

#endif
