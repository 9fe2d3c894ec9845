/* SPDX-License-Identifier: MIT
 *
 * The emulated MCP2210 as a device of the tests' kernel: reports come from hidraw (/dev/uhid) or from USB (a HID
 * gadget, /dev/hidg0), answers go back, and what the chip does to its pins is recorded as the tap records a display's
 * wires: GP0 is D/C, GP1 reset, GP2 the backlight, GP3 chip select. Ends, as if the plug were pulled, after so many
 * reports. */
#include "glass/emulated_mcp2210.h"
#include "wire_tap.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/uhid.h>
#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/select.h>
#include <time.h>
#include <unistd.h>

enum { SELECT_PIN = 3, BUSY_EVERY = 7, REPORT_B = EMULATED_MCP2210_REPORT_B };

struct pin_of_bridge {
    struct bridge *bridge;
    uint8_t number;
};

struct bridge {
    struct emulated_mcp2210 chip;
    struct pin_of_bridge pins[SELECT_PIN]; /* those below are wired to lines of the same numbers */
    FILE *record;
    int fd;
    unsigned long answered; /* reports */
};

/* Reports of 64 bytes without a number, of a vendor's own meaning, both ways. */
static const uint8_t DESCRIPTOR[] = {0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x75,
                                     0x08, 0x95, 0x40, 0x09, 0x01, 0x81, 0x02, 0x09, 0x02, 0x91, 0x02, 0xC0};

/* Record ------------------------------------------------------------------------------------- */

static int record(struct bridge *bridge, struct wire_tap_event event, const uint8_t *data)
{
    struct timespec now;

    clock_gettime(CLOCK_MONOTONIC, &now);
    event.time_ns = (uint64_t)now.tv_sec * 1000000000 + (uint64_t)now.tv_nsec;
    const bool ok = fwrite(&event, sizeof event, 1, bridge->record) == 1 &&
                    (event.n_b == 0 || fwrite(data, 1, event.n_b, bridge->record) == event.n_b);
    return ok ? 0 : -errno;
}

static int select_display(struct bridge *bridge, bool selected)
{
    return record(bridge, (struct wire_tap_event){.kind = WIRE_TAP_SELECT, .value = !selected}, NULL);
}

/* Of a display that is not selected the emulated chip itself complains. */
static int send(void *ctx, const uint8_t *data, size_t n_b)
{
    struct bridge *bridge = ctx;
    const struct wire_tap_event event = {.kind = WIRE_TAP_BYTES,
                                         .mode = bridge->chip.mode,
                                         .word_bits = 8,
                                         .value = bridge->chip.bit_rate_hz,
                                         .n_b = (uint32_t)n_b};

    int err = select_display(bridge, true);
    if (!err) err = record(bridge, event, data);
    return err ? err : select_display(bridge, false);
}

static int set(void *ctx, bool high)
{
    const struct pin_of_bridge *pin = ctx;

    return record(pin->bridge, (struct wire_tap_event){.kind = WIRE_TAP_LEVEL, .which = pin->number, .value = high},
                  NULL);
}

static void init(struct bridge *bridge)
{
    emulated_mcp2210_init(&bridge->chip);
    bridge->chip.spi = (struct bus){.ctx = bridge, .write = send};
    bridge->chip.select = SELECT_PIN;
    bridge->chip.busy_every = BUSY_EVERY;
    for (uint8_t i = 0; i < SELECT_PIN; i++) {
        bridge->pins[i] = (struct pin_of_bridge){bridge, i};
        bridge->chip.pins[i] = (struct pin){&bridge->pins[i], set};
    }
}

/* SIGTERM is blocked but here, so that it cannot come unnoticed before a read. */
static bool wait_for_report(const struct bridge *bridge)
{
    fd_set readable;
    sigset_t none;

    FD_ZERO(&readable);
    FD_SET(bridge->fd, &readable);
    sigemptyset(&none);
    return pselect(bridge->fd + 1, &readable, NULL, NULL, NULL, &none) > 0;
}

/* Gadget: a report is a read, its answer a write ------------------------------------------------ */

static bool gadget_answer(struct bridge *bridge)
{
    uint8_t report[REPORT_B], answer[REPORT_B];

    if (read(bridge->fd, report, sizeof report) != REPORT_B) return false;
    emulated_mcp2210_answer(&bridge->chip, report, answer);
    bridge->answered++;
    return write(bridge->fd, answer, sizeof answer) == REPORT_B;
}

/* uhid: events, of which some are reports ------------------------------------------------------- */

static bool uhid_create(int fd)
{
    struct uhid_event event = {.type = UHID_CREATE2};
    struct uhid_create2_req *request = &event.u.create2;

    strcpy((char *)request->name, "Microchip Technology Inc. MCP2210 USB-to-SPI Master");
    strcpy((char *)request->uniq, "0000000001");
    memcpy(request->rd_data, DESCRIPTOR, sizeof DESCRIPTOR);
    request->rd_size = sizeof DESCRIPTOR;
    request->bus = BUS_USB;
    request->vendor = 0x04D8;
    request->product = 0x00DE;
    return write(fd, &event, sizeof event) == sizeof event;
}

/* hidraw passes the number of a report that has none: a zero in front of it. */
static bool uhid_is_report(const struct uhid_event *event)
{
    return event->type == UHID_OUTPUT && event->u.output.size == 1 + REPORT_B && event->u.output.data[0] == 0;
}

static bool uhid_answer(struct bridge *bridge)
{
    struct uhid_event event, answer = {.type = UHID_INPUT2, .u.input2.size = REPORT_B};

    if (read(bridge->fd, &event, sizeof event) < 0) return false;
    if (!uhid_is_report(&event)) return true;
    emulated_mcp2210_answer(&bridge->chip, event.u.output.data + 1, answer.u.input2.data);
    bridge->answered++;
    return write(bridge->fd, &answer, sizeof answer) == sizeof answer;
}

/* Ends early, and well, when a signal interrupts it. */
static bool serve(struct bridge *bridge, bool (*answer)(struct bridge *), unsigned long reports)
{
    while (bridge->answered < reports)
        if (!wait_for_report(bridge) || !answer(bridge)) return errno == EINTR;
    return true;
}

static void interrupt(int signal_number)
{
    (void)signal_number;
}

static void watch_signal(void)
{
    sigset_t blocked;

    sigemptyset(&blocked);
    sigaddset(&blocked, SIGTERM);
    sigprocmask(SIG_BLOCK, &blocked, NULL);
    sigaction(SIGTERM, &(struct sigaction){.sa_handler = interrupt}, NULL);
}

static bool run(struct bridge *bridge, const char *device, unsigned long reports)
{
    const bool is_uhid = strcmp(device, "/dev/uhid") == 0;

    bridge->fd = open(device, O_RDWR);
    if (bridge->fd < 0 || (is_uhid && !uhid_create(bridge->fd))) return false;
    return serve(bridge, is_uhid ? uhid_answer : gadget_answer, reports);
}

int main(int argc, char **argv)
{
    static struct bridge bridge;

    if (argc == 2 && strcmp(argv[1], "descriptor") == 0)
        return fwrite(DESCRIPTOR, sizeof DESCRIPTOR, 1, stdout) == 1 ? EXIT_SUCCESS : EXIT_FAILURE;
    if (argc != 4) {
        fputs("usage: bridge /dev/uhid|/dev/hidgN RECORD REPORTS, or bridge descriptor\n", stderr);
        return EXIT_FAILURE;
    }
    init(&bridge);
    watch_signal();
    bridge.record = fopen(argv[2], "wb");
    const bool ok = bridge.record && run(&bridge, argv[1], strtoul(argv[3], NULL, 10));
    if (!ok) fprintf(stderr, "bridge: %s: %s\n", argv[1], strerror(errno));
    if (bridge.record && fclose(bridge.record) != 0) perror(argv[2]);
    printf("complaints %u%s%s\n", bridge.chip.complaints, bridge.chip.complaints ? ", the last: " : "",
           bridge.chip.complaint);
    return ok && bridge.chip.complaints == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
