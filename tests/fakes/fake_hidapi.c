/* SPDX-License-Identifier: MIT */
#include "fake_hidapi.h"

#include "rigs/cmocka_ready.h"

#include <errno.h>
#include <hidapi.h>
#include <stdlib.h>
#include <string.h>

struct fake_hidapi fake_hidapi;

enum { QUIET_MOST_MS = 100 }; /* who waits for no longer waits for nothing to come */

struct hid_device_ {
    struct reports reports;
};

static bool is_listed(const struct fake_place *place)
{
    return place->cable && !place->cable->unplugged;
}

/* The length of reports tells what is plugged in. */
static bool is_kind(const struct fake_place *place, unsigned vendor_id, unsigned product_id)
{
    if (place->cable->report_b == 64) return vendor_id == 0x04D8 && product_id == 0x00DE;
    return vendor_id == 0x1A86 && product_id == 0x55DC;
}

/* A copy that is the caller's, in the library's own types, which are not const. */
static void *copy(const void *data, size_t n_b)
{
    void *to = malloc(n_b);

    assert_non_null(to);
    return memcpy(to, data, n_b);
}

int hid_exit(void)
{
    if (fake_hidapi.opened != fake_hidapi.closed) fake_hidapi.ended_open = true;
    return 0;
}

struct hid_device_info *hid_enumerate(unsigned short vendor_id, unsigned short product_id)
{
    struct hid_device_info *list = NULL;

    for (unsigned i = FAKE_PLACES; i-- > 0;) {
        const struct fake_place *place = &fake_hidapi.places[i];
        if (!is_listed(place) || !is_kind(place, vendor_id, product_id)) continue;
        struct hid_device_info info = {.path = copy(place->path, strlen(place->path) + 1), .next = list};
        if (place->serial) info.serial_number = copy(place->serial, (wcslen(place->serial) + 1) * sizeof(wchar_t));
        list = copy(&info, sizeof info);
        fake_hidapi.listed++;
    }
    return list;
}

void hid_free_enumeration(struct hid_device_info *list)
{
    while (list) {
        struct hid_device_info *next = list->next;
        free(list->path);
        free(list->serial_number);
        free(list);
        list = next;
        fake_hidapi.freed++;
    }
}

hid_device *hid_open_path(const char *path)
{
    for (unsigned i = 0; i < FAKE_PLACES; i++) {
        const struct fake_place *place = &fake_hidapi.places[i];
        if (!is_listed(place) || strcmp(place->path, path) != 0) continue;
        if (place->open_untold) return NULL;
        errno = place->open_errno;
        if (place->open_errno) return NULL;
        fake_hidapi.opened++;
        const hid_device device = {.reports = emulated_cable_reports(place->cable)};
        return copy(&device, sizeof device);
    }
    errno = ENOENT;
    return NULL;
}

void hid_close(hid_device *device)
{
    assert_non_null(device);
    fake_hidapi.closed++;
    free(device);
}

int hid_write(hid_device *device, const unsigned char *data, size_t length)
{
    assert_int_equal(length, 1 + device->reports.report_b);
    assert_int_equal(data[0], 0); /* reports have no numbers */
    if (device->reports.write(device->reports.ctx, data + 1) != 0) return -1;
    errno = EINTR; /* a call that succeeds may leave anything there */
    return fake_hidapi.writes_short ? 7 : (int)length;
}

int hid_read_timeout(hid_device *device, unsigned char *data, size_t length, int milliseconds)
{
    assert_int_equal(length, device->reports.report_b);
    assert_true(milliseconds > 0);
    if (milliseconds > fake_hidapi.longest_ms) fake_hidapi.longest_ms = milliseconds;
    if (milliseconds > QUIET_MOST_MS && milliseconds < fake_hidapi.shortest_ms) fake_hidapi.shortest_ms = milliseconds;
    if (fake_hidapi.interrupted_every && ++fake_hidapi.reads % fake_hidapi.interrupted_every == 0) {
        errno = EINTR;
        return -1;
    }
    const int n_b = device->reports.read(device->reports.ctx, data, (uint32_t)milliseconds);
    return n_b < 0 ? -1 : n_b;
}

const wchar_t *hid_error(hid_device *device)
{
    (void)device;
    return L"a made-up error";
}
