/* SPDX-License-Identifier: MIT */
#include "fault_port.h"

#include "rigs/cmocka_ready.h"

void fault_port_arm(struct fault_port *port, long fail_at)
{
    port->calls = port->calls_late = port->pin_sets = 0;
    port->fault = FAULT_AT_ONCE;
    port->failed = false;
    port->fail_at = fail_at;
    port->code = -7000 - (int)(fail_at % 1000);
}

/* The code to return; a slow call has taken its time then. */
static int hit(struct fault_port *port)
{
    if (port->failed && port->code) port->calls_late++;
    if (port->calls++ != port->fail_at) return 0;
    port->failed = true;
    if (port->fault == FAULT_SLOW) {
        assert_int_equal(clock_delay(&port->clock, FAULT_SLOW_US), 0);
        port->code = 0;
    }
    return port->code;
}

static void lose_pending(struct fault_port *port)
{
    if (port->pending_b) *port->pending_b = 0;
}

static int write_bytes(void *ctx, const uint8_t *data, size_t n_b)
{
    struct fault_port *port = ctx;
    const int err = hit(port);
    if (!err) return bus_write(&port->bus, data, n_b);
    if (port->fault != FAULT_AT_ONCE) {
        assert_int_equal(bus_write(&port->bus, data, port->fault == FAULT_SHORT ? n_b / 2 : n_b), 0);
        assert_int_equal(bus_flush(&port->bus), 0);
    }
    lose_pending(port);
    return err;
}

static int flush(void *ctx)
{
    struct fault_port *port = ctx;
    const int err = hit(port);
    if (!err) return bus_flush(&port->bus);
    if (port->fault == FAULT_LATE) assert_int_equal(bus_flush(&port->bus), 0);
    lose_pending(port);
    return err;
}

static int set(void *ctx, bool high)
{
    struct fault_pin *pin = ctx;
    const int err = hit(pin->port);
    pin->port->pin_sets++;
    if (err && pin->port->fault != FAULT_LATE) return err;
    const int pin_err = pin_set(&pin->inner, high);
    return err ? err : pin_err;
}

static int wait(void *ctx, uint32_t timeout_us)
{
    struct fault_port *port = ctx;
    const int err = hit(port);
    if (err && port->fault != FAULT_LATE) return err;
    const int came = edge_wait(&port->tearing, timeout_us);
    return err ? err : came;
}

static int delay(void *ctx, uint32_t delay_us)
{
    struct fault_port *port = ctx;
    const int err = hit(port);
    if (err && port->fault != FAULT_LATE) return err;
    const int clock_err = clock_delay(&port->clock, delay_us);
    return err ? err : clock_err;
}

struct bus fault_port_bus(struct fault_port *port)
{
    return (struct bus){.ctx = port, .write = write_bytes, .flush = flush, .message_b = port->bus.message_b};
}

struct pin fault_port_pin(struct fault_port *port, struct fault_pin *pin)
{
    pin->port = port;
    return (struct pin){pin, pin_is_wired(&pin->inner) ? set : NULL};
}

struct edge fault_port_tearing(struct fault_port *port)
{
    return (struct edge){port, edge_is_wired(&port->tearing) ? wait : NULL};
}

struct clock fault_port_clock(struct fault_port *port)
{
    return (struct clock){port, delay};
}

struct port fault_port_over(struct fault_port *fault, const struct port *port, size_t *pending_b)
{
    *fault = (struct fault_port){.bus = port->bus,
                                 .dc = {.inner = port->dc},
                                 .reset = {.inner = port->reset},
                                 .backlight = {.inner = port->backlight},
                                 .select = {.inner = port->select},
                                 .tearing = port->tearing,
                                 .clock = port->clock,
                                 .pending_b = pending_b};
    fault_port_arm(fault, -1);
    return (struct port){.bus = fault_port_bus(fault),
                         .dc = fault_port_pin(fault, &fault->dc),
                         .reset = fault_port_pin(fault, &fault->reset),
                         .backlight = fault_port_pin(fault, &fault->backlight),
                         .select = fault_port_pin(fault, &fault->select),
                         .tearing = fault_port_tearing(fault),
                         .clock = fault_port_clock(fault)};
}
