/* SPDX-License-Identifier: MIT
 *
 * The USB-HID bridges that are plugged in, as hidapi finds them, and which one a user means: that of a serial number,
 * or the only one. Reasons are written without the bridge's name in front, and say what helps. */
#ifndef HAL_HID_BRIDGES_H
#define HAL_HID_BRIDGES_H

#include "hid/bridge.h"

#include <hidapi.h>

HAL_C_BEGIN

enum { HID_BRIDGES_MAX = 16, HID_SERIAL_B = 64, HID_PATH_B = 128, HID_WHY_B = 224 };

struct hid_bridge {
    const struct bridge_kind *kind;
    char serial[HID_SERIAL_B]; /* "": it has none, or none that may be read */
    char path[HID_PATH_B];     /* hidapi's */
};

/* How many are plugged in, the first HID_BRIDGES_MAX of them in *found. hidapi is begun anew, since without udev's
 * daemon libusb knows for ever what was there when it began; so no bridge may be open. */
size_t hid_bridges_find(struct hid_bridge found[HID_BRIDGES_MAX]);

/* serial NULL or "": the only one. -ENODEV: there is none such; -EEXIST: several to choose from. */
HAL_MUST_CHECK int hid_bridges_choose(const char *serial, struct hid_bridge *out, char why[HID_WHY_B]);

/* A negative errno, -EACCES among them, whose reason is the udev rule that permits it. */
HAL_MUST_CHECK int hid_bridges_open(const struct hid_bridge *bridge, hid_device **device, char why[HID_WHY_B]);

HAL_C_END

#endif
