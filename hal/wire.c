/* SPDX-License-Identifier: MIT */
#include "wire.h"

#define RESET_PULSE_US UINT32_C(100) /* the slowest of the chips asks for 10 */

enum { LEVEL_UNKNOWN, LEVEL_COMMAND, LEVEL_DATA };

/* Bytes on their way still need the old level: they leave first. */
static int wire_level(struct wire *wire, uint8_t level)
{
    if (wire->level == level) return 0;
    wire->level = LEVEL_UNKNOWN;
    int err = bus_flush(&wire->bus);
    if (err) return err;
    err = pin_set(&wire->dc, level == LEVEL_DATA);
    if (err) return err;
    wire->level = level;
    return 0;
}

int wire_begin(struct wire *wire)
{
    wire->level = LEVEL_UNKNOWN;
    return bus_flush(&wire->bus);
}

int wire_command(struct wire *wire, const uint8_t *command, size_t n_b)
{
    int err = wire_level(wire, LEVEL_COMMAND);
    if (err) return err;
    err = bus_write(&wire->bus, command, n_b);
    if (err) return err;
    return bus_flush(&wire->bus);
}

int wire_data(struct wire *wire, const uint8_t *data, size_t n_b)
{
    int err = wire_level(wire, LEVEL_DATA);
    if (err) return err;
    return bus_write(&wire->bus, data, n_b);
}

int wire_flush(const struct wire *wire)
{
    return bus_flush(&wire->bus);
}

int wire_reset(const struct pin *reset, const struct clock *clock, uint32_t after_us)
{
    int err = pin_set(reset, false);
    if (err) return err;
    err = clock_delay(clock, RESET_PULSE_US);
    if (err) return err;
    err = pin_set(reset, true);
    if (err) return err;
    return clock_delay(clock, after_us);
}

int wire_set(const struct pin *pin, bool high)
{
    return pin_is_wired(pin) ? pin_set(pin, high) : 0;
}
