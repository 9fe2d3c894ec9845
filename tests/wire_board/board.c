/* SPDX-License-Identifier: MIT
 *
 * A board that is this computer: what a display would get goes to standard output as a wire log, and time is what bytes
 * and waits take. Firmware for it ends when nobody reads any more. */
#include "board.h"

#include <inttypes.h>
#include <stdio.h>

struct wires {
    uint64_t now_ns;
    uint32_t byte_ns;
};

static struct wires wires;

static int tell(const struct wires *at)
{
    return printf("t %" PRIu64 "\n", at->now_ns) < 0 ? -1 : 0;
}

static int write_bytes(void *ctx, const uint8_t *data, size_t n_b)
{
    struct wires *to = ctx;
    fputs("b", stdout);
    for (size_t i = 0; i < n_b; i++)
        printf(" %02X", data[i]);
    fputs("\n", stdout);
    to->now_ns += (uint64_t)n_b * to->byte_ns;
    return tell(to);
}

static int delay(void *ctx, uint32_t delay_us)
{
    struct wires *to = ctx;
    to->now_ns += UINT64_C(1000) * delay_us;
    return tell(to);
}

static int set_level(void *ctx, bool high)
{
    return printf("p %s %d\n", (const char *)ctx, high) < 0 ? -1 : 0;
}

int board_init(struct board *board, uint32_t spi_hz, uint8_t spi_modes)
{
    (void)spi_modes;
    wires.byte_ns = (uint32_t)(UINT64_C(8000000000) / spi_hz);
    board->bus = (struct bus){.ctx = &wires, .write = write_bytes};
    board->clock = (struct clock){.ctx = &wires, .delay = delay};
    board->dc = (struct pin){.ctx = "dc", .set = set_level};
    board->reset = (struct pin){.ctx = "reset", .set = set_level};
    board->backlight = (struct pin){.ctx = "backlight", .set = set_level};
    board->select = (struct pin){.ctx = "select", .set = set_level};
    board->led = (struct pin){.ctx = "led", .set = set_level};
    return pin_set(&board->led, false);
}
