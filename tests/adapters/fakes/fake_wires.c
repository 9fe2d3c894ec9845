/* SPDX-License-Identifier: MIT */
#include "fake_wires.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

enum { DMA_MOST_B = 1 << 18, PROGRESS_B = 40 };

static const char *const names[WIRE_COUNT] = {NULL, "cs", "dc", "reset", "backlight", "select", NULL, NULL};
static struct {
    bool output[WIRE_COUNT], high[WIRE_COUNT];
    uint64_t now_ns;
    uint32_t byte_ns;
    int mode;
    const uint8_t *data; /* that DMA is to read, or NULL */
    size_t n_b, at_b;
    bool busy;
    unsigned complaints;
    int fail_at, failure;
} wires = {.mode = -1, .fail_at = -1};
static uint8_t as_given[DMA_MOST_B];

void wires_complain(const char *what)
{
    if (wires.complaints++ < 5) fprintf(stderr, "fake: %s\n", what);
}

unsigned wires_complaints(void)
{
    return wires.complaints;
}

void wires_fail(int call, int failure)
{
    wires.fail_at = call;
    wires.failure = failure;
}

int wires_failure(void)
{
    return wires.fail_at >= 0 && wires.fail_at-- == 0 ? wires.failure : 0;
}

static void tell_level(unsigned pin)
{
    if (pin < WIRE_COUNT && names[pin] && wires.output[pin]) printf("p %s %d\n", names[pin], wires.high[pin]);
}

void wires_output(unsigned pin, bool is_output)
{
    if (pin >= WIRE_COUNT || pin == WIRE_NONE) {
        wires_complain("a pin that is none");
        return;
    }
    if (is_output && wires.output[pin]) return;
    wires.output[pin] = is_output;
    tell_level(pin);
}

void wires_level(unsigned pin, bool high)
{
    if (pin >= WIRE_COUNT || pin == WIRE_NONE) {
        wires_complain("a pin that is none");
        return;
    }
    if (wires.high[pin] == high) return;
    if (wires.data || wires.busy) wires_complain("a pin changes while bytes are on their way");
    wires.high[pin] = high;
    tell_level(pin);
}

void wires_pass(uint64_t time_us)
{
    wires.now_ns += 1000 * time_us;
    printf("t %" PRIu64 "\n", wires.now_ns);
}

uint64_t wires_now_us(void)
{
    return wires.now_ns / 1000;
}

void wires_bus(uint32_t hz, int mode)
{
    if (!hz) wires_complain("a bus without a rate");
    wires.byte_ns = (uint32_t)(UINT64_C(8000000000) / (hz ? hz : 1));
    wires.mode = mode;
}

int wires_mode(void)
{
    return wires.mode;
}

void wires_send(const uint8_t *data, size_t n_b)
{
    if (wires.mode != 0 && wires.mode != 3) wires_complain("a bus in a mode that displays do not take");
    if (wires.output[WIRE_CS] ? wires.high[WIRE_CS] : !wires.output[WIRE_SELECT])
        wires_complain("bytes while the display is not selected");
    if (!n_b) return;
    fputs("b", stdout);
    for (size_t i = 0; i < n_b; i++)
        printf(" %02X", data[i]);
    fputs("\n", stdout);
    wires.now_ns += (uint64_t)n_b * wires.byte_ns;
    printf("t %" PRIu64 "\n", wires.now_ns);
}

void wires_dma(const uint8_t *data, size_t n_b)
{
    if (wires.data) wires_complain("a transfer while another one runs");
    if (n_b > DMA_MOST_B) wires_complain("a transfer too long");
    wires.data = data;
    wires.n_b = n_b;
    wires.at_b = 0;
    memcpy(as_given, data, n_b);
}

static void progress(size_t n_b)
{
    if (!wires.data) return;
    if (n_b > wires.n_b - wires.at_b) n_b = wires.n_b - wires.at_b;
    if (memcmp(as_given + wires.at_b, wires.data + wires.at_b, n_b)) wires_complain("bytes changed on their way");
    wires_send(wires.data + wires.at_b, n_b);
    wires.at_b += n_b;
    if (wires.at_b < wires.n_b) return;
    wires.data = NULL;
    wires.busy = true;
}

size_t wires_dma_left_b(void)
{
    progress(PROGRESS_B);
    return wires.data ? wires.n_b - wires.at_b : 0;
}

void wires_dma_wait(void)
{
    progress(wires.n_b);
}

bool wires_busy(void)
{
    const bool was_busy = wires.busy && !wires.data; /* nothing has come from DMA yet */

    if (was_busy) wires.busy = false;
    return was_busy;
}
