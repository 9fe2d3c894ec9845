/* SPDX-License-Identifier: MIT */
#include "glass/emulated_port.h"

#include <stdio.h>

bool emulated_port_is_before(const struct emulated_port *port, uint64_t at_us)
{
    return !port->timeless && port->now_us < at_us;
}

bool emulated_port_notes(struct emulated_port *port, const char *format, va_list args)
{
    if (!port->foreign) return false;
    vsnprintf(port->notice, sizeof port->notice, format, args);
    port->notices++;
    return true;
}

void emulated_port_store(struct emulated_port *port, struct emulated_place place)
{
    port->stores++;
    port->stored = place;
}

static void receive(struct emulated_port *port)
{
    port->bus_b += port->pending_b;
    if (port->reset_low && port->pending_b) port->lost(port->chip, port->pending_b);
    for (size_t i = 0; i < port->pending_b && !port->reset_low; i++)
        (port->dc_high ? port->data : port->command)(port->chip, port->pending[i]);
    port->pending_b = 0;
}

static int flush(void *ctx)
{
    receive(ctx);
    return 0;
}

static int write_bytes(void *ctx, const uint8_t *data, size_t n_b)
{
    struct emulated_port *port = ctx;
    receive(port);
    port->pending = data;
    port->pending_b = n_b;
    if (!port->deferred) receive(port);
    return 0;
}

static int set_dc(void *ctx, bool high)
{
    struct emulated_port *port = ctx;
    port->dc_high = high;
    return 0;
}

static int set_reset(void *ctx, bool high)
{
    struct emulated_port *port = ctx;
    if (!high && !port->reset_low) port->reset_low_us = port->now_us;
    if (high && port->reset_low)
        port->reset(port->chip, port->timeless ? UINT64_MAX : port->now_us - port->reset_low_us);
    port->reset_low = !high;
    return 0;
}

static int set_backlight(void *ctx, bool high)
{
    struct emulated_port *port = ctx;
    port->backlight_low = !high;
    return 0;
}

static int set_select(void *ctx, bool high)
{
    struct emulated_port *port = ctx;
    port->select(port->chip, high);
    return 0;
}

static int wait_edge(void *ctx, uint32_t timeout_us)
{
    struct emulated_port *port = ctx;
    uint64_t at_us;
    const bool comes = port->edge(port->chip, &at_us) && at_us - port->now_us <= timeout_us;
    port->now_us = comes ? at_us : port->now_us + timeout_us;
    return comes;
}

static int delay(void *ctx, uint32_t delay_us)
{
    struct emulated_port *port = ctx;
    port->now_us += delay_us;
    return 0;
}

struct bus emulated_port_bus(struct emulated_port *port)
{
    return (struct bus){.ctx = port, .write = write_bytes, .flush = flush};
}

struct pin emulated_port_dc(struct emulated_port *port)
{
    return (struct pin){.ctx = port, .set = set_dc};
}

struct pin emulated_port_reset(struct emulated_port *port)
{
    return (struct pin){.ctx = port, .set = port->reset ? set_reset : NULL};
}

struct pin emulated_port_backlight(struct emulated_port *port)
{
    return (struct pin){.ctx = port, .set = set_backlight};
}

struct pin emulated_port_select(struct emulated_port *port)
{
    return (struct pin){.ctx = port, .set = port->select ? set_select : NULL};
}

struct edge emulated_port_tearing(struct emulated_port *port)
{
    return (struct edge){.ctx = port, .wait = port->edge ? wait_edge : NULL};
}

struct clock emulated_port_clock(struct emulated_port *port)
{
    return (struct clock){.ctx = port, .delay = delay};
}

struct port emulated_port_whole(struct emulated_port *port)
{
    return (struct port){.bus = emulated_port_bus(port),
                         .dc = emulated_port_dc(port),
                         .reset = emulated_port_reset(port),
                         .backlight = emulated_port_backlight(port),
                         .select = emulated_port_select(port),
                         .clock = emulated_port_clock(port)};
}
