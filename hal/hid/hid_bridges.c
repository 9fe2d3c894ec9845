/* SPDX-License-Identifier: MIT */
#include "hid/hid_bridges.h"

#include "hid/mcp2210.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

/* Serial numbers are digits; what is not ASCII is not theirs. */
static void copy_serial(char out[HID_SERIAL_B], const wchar_t *serial)
{
    size_t n = 0;

    for (; serial && serial[n] && n < HID_SERIAL_B - 1; n++)
        out[n] = serial[n] > ' ' && serial[n] < 127 ? (char)serial[n] : '?';
    out[n] = '\0';
}

static size_t find_kind(const struct bridge_kind *kind, struct hid_bridge found[HID_BRIDGES_MAX])
{
    size_t n = 0;
    struct hid_device_info *const list = hid_enumerate(kind->vendor, kind->product);

    for (const struct hid_device_info *info = list; info && n < HID_BRIDGES_MAX; info = info->next) {
        if (strlen(info->path) >= HID_PATH_B) continue;
        found[n].kind = kind;
        copy_serial(found[n].serial, info->serial_number);
        strcpy(found[n++].path, info->path);
    }
    hid_free_enumeration(list);
    return n;
}

size_t hid_bridges_find(struct hid_bridge found[HID_BRIDGES_MAX])
{
    (void)hid_exit();
    return find_kind(&mcp2210, found);
}

/* Of one bridge at least. */
static void list_serials(const struct hid_bridge *found, size_t n, char *text, size_t text_b)
{
    size_t used_b = 0;

    for (size_t i = 0; i < n && used_b < text_b; i++)
        used_b += (size_t)snprintf(text + used_b, text_b - used_b, "%s%s", i ? ", " : "",
                                   found[i].serial[0] ? found[i].serial : "one without a readable serial number");
}

int hid_bridges_choose(const char *serial, struct hid_bridge *out, char why[HID_WHY_B])
{
    struct hid_bridge found[HID_BRIDGES_MAX];
    const size_t n = hid_bridges_find(found);
    const bool is_any = !serial || !serial[0];
    char serials[HID_WHY_B / 2];

    if (n == 0) {
        snprintf(why, HID_WHY_B, "none is plugged in (an MCP2210 is USB 04d8:00de)");
        return -ENODEV;
    }
    list_serials(found, n, serials, sizeof serials);
    if (is_any && n > 1) {
        snprintf(why, HID_WHY_B, "there are several; choose by serial number: %s", serials);
        return -EEXIST;
    }
    for (size_t i = 0; i < n; i++)
        if (is_any || strcmp(found[i].serial, serial) == 0) {
            *out = found[i];
            return 0;
        }
    snprintf(why, HID_WHY_B, "none has that serial number; there is %s", serials);
    return -ENODEV;
}

/* By hidraw, hidapi keeps open()'s errno, but does not promise to; by libusb it tells nothing. */
int hid_bridges_open(const struct hid_bridge *bridge, hid_device **device, char why[HID_WHY_B])
{
    errno = 0;
    *device = hid_open_path(bridge->path);
    if (*device) return 0;
    const int err = errno ? errno : EIO;
    const bool is_untold = errno == 0;
    if (is_untold || err == EACCES || err == EPERM)
        snprintf(why, HID_WHY_B,
                 "%s; put ATTRS{idVendor}==\"%04x\", ATTRS{idProduct}==\"%04x\", MODE=\"0666\" into "
                 "/etc/udev/rules.d/70-%s.rules and plug it in again",
                 is_untold ? "cannot be opened, mostly for want of permission" : "no permission", bridge->kind->vendor,
                 bridge->kind->product, bridge->kind->file);
    else
        snprintf(why, HID_WHY_B, "%.60s cannot be opened: %s", bridge->path, strerror(err));
    return err == EPERM ? -EACCES : -err;
}
