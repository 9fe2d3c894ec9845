/* SPDX-License-Identifier: MIT */
#include "fault_port.h"

#include "cmocka_ready.h"

void fault_port_arm(struct fault_port *port, long fail_at)
{
    port->calls = port->calls_late = port->pin_sets = 0;
    port->late = port->failed = false;
    port->fail_at = fail_at;
    port->code = -7000 - (int)(fail_at % 1000);
}

static int hit(struct fault_port *port)
{
    if (port->failed) port->calls_late++;
    if (port->calls++ != port->fail_at) return 0;
    port->failed = true;
    return port->code;
}

static int write_bytes(void *ctx, const uint8_t *data, size_t n_b)
{
    struct fault_port *port = ctx;
    const int err = hit(port);
    if (!err) return bus_write(&port->bus, data, n_b);
    if (port->late) {
        assert_int_equal(bus_write(&port->bus, data, n_b), 0);
        assert_int_equal(bus_flush(&port->bus), 0);
    }
    *port->pending_b = 0;
    return err;
}

static int flush(void *ctx)
{
    struct fault_port *port = ctx;
    const int err = hit(port);
    if (!err) return bus_flush(&port->bus);
    *port->pending_b = 0;
    return err;
}

static int set(void *ctx, bool high)
{
    struct fault_pin *pin = ctx;
    const int err = hit(pin->port);
    pin->port->pin_sets++;
    if (err && !pin->port->late) return err;
    const int pin_err = pin_set(&pin->inner, high);
    return err ? err : pin_err;
}

static int delay(void *ctx, uint32_t delay_us)
{
    struct fault_port *port = ctx;
    const int err = hit(port);
    return err ? err : clock_delay(&port->clock, delay_us);
}

struct bus fault_port_bus(struct fault_port *port)
{
    return (struct bus){.ctx = port, .write = write_bytes, .flush = flush, .message_b = port->bus.message_b};
}

struct pin fault_port_pin(struct fault_port *port, struct fault_pin *pin)
{
    pin->port = port;
    return (struct pin){pin, set};
}

struct clock fault_port_clock(struct fault_port *port)
{
    return (struct clock){port, delay};
}
