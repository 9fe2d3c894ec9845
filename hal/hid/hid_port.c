/* SPDX-License-Identifier: MIT */
#include "hid/hid_port.h"

#include "hid/hid_bridges.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { REPORT_MAX_B = 64 };

struct hid_link {
    hid_device *device; /* NULL: not open */
    struct hid_bridge bridge;
    char serial[HID_SERIAL_B]; /* that is wanted; "": the only one */
    char name[HID_SERIAL_B + 24];
    char why[HID_WHY_B];
};

static void close_device(struct hid_link *link)
{
    if (link->device) hid_close(link->device);
    link->device = NULL;
}

/* Both of hidapi's ways report a bridge that is gone like any other error, but no longer list it. */
static int lost(struct hid_link *link)
{
    struct hid_bridge found[HID_BRIDGES_MAX];

    snprintf(link->why, sizeof link->why, "hidapi: %.150ls; it is opened anew with the next frame",
             hid_error(link->device));
    close_device(link);
    const size_t n = hid_bridges_find(found);
    for (size_t i = 0; i < n; i++)
        if (strcmp(found[i].path, link->bridge.path) == 0) return -EIO;
    snprintf(link->why, sizeof link->why, "unplugged; plug it in again");
    return -ENODEV;
}

static int write_report(void *ctx, const uint8_t *report)
{
    struct hid_link *link = ctx;
    const size_t report_b = link->bridge.kind->report_b;
    uint8_t numbered[1 + REPORT_MAX_B] = {0}; /* the report behind its number, which is 0 */

    memcpy(&numbered[1], report, report_b);
    return hid_write(link->device, numbered, 1 + report_b) == (int)(1 + report_b) ? 0 : lost(link);
}

/* A signal ends the wait early, no more. */
static int read_report(void *ctx, uint8_t *report, uint32_t timeout_ms)
{
    struct hid_link *link = ctx;

    errno = 0;
    const int n_b = hid_read_timeout(link->device, report, link->bridge.kind->report_b, (int)timeout_ms);
    if (n_b >= 0) return n_b;
    return errno == EINTR ? 0 : lost(link);
}

static uint64_t now_ms(void *ctx)
{
    struct timespec now;

    (void)ctx;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * 1000 + (uint64_t)now.tv_nsec / 1000000;
}

static int delay(void *ctx, uint32_t delay_us)
{
    struct timespec left = {.tv_sec = (time_t)(delay_us / 1000000), .tv_nsec = (long)(delay_us % 1000000) * 1000};

    (void)ctx;
    while (nanosleep(&left, &left) != 0)
        if (errno != EINTR) return -errno;
    return 0;
}

static void set_name(struct hid_link *link)
{
    const struct bridge_kind *kind = link->bridge.kind;

    snprintf(link->name, sizeof link->name, "%s%s%s", kind ? kind->name : "USB-HID bridge", link->serial[0] ? " " : "",
             link->serial);
}

/* The first time decides which bridge it is from then on. */
static int open_link(void *ctx, struct reports *reports, const struct bridge_kind **kind)
{
    struct hid_link *link = ctx;

    int err = hid_bridges_choose(link->serial, &link->bridge, link->why);
    if (!err) {
        set_name(link);
        err = hid_bridges_open(&link->bridge, &link->device, link->why);
    }
    if (err) return err;
    memcpy(link->serial, link->bridge.serial, sizeof link->serial);
    set_name(link);
    *kind = link->bridge.kind;
    *reports = (struct reports){.ctx = link,
                                .report_b = link->bridge.kind->report_b,
                                .write = write_report,
                                .read = read_report,
                                .now_ms = now_ms};
    return 0;
}

static void close_link(void *ctx)
{
    close_device(ctx);
}

static void release(void *ctx)
{
    close_link(ctx);
    free(ctx);
}

static const char *name(void *ctx)
{
    return ((const struct hid_link *)ctx)->name;
}

static const char *why(void *ctx)
{
    return ((const struct hid_link *)ctx)->why;
}

int hid_port_open(struct port *port, const char *serial, const struct bridge_options *options)
{
    struct hid_link *link = calloc(1, sizeof *link);

    *port = (struct port){.error = "USB-HID bridge: out of memory"};
    if (!link) return -ENOMEM;
    snprintf(link->serial, sizeof link->serial, "%s", serial ? serial : "");
    set_name(link);
    const struct bridge_link hid = {.ctx = link,
                                    .open = open_link,
                                    .close = close_link,
                                    .release = release,
                                    .name = name,
                                    .why = why,
                                    .clock = (struct clock){.ctx = NULL, .delay = delay}};
    return bridge_port_open(port, &hid, options);
}
