/* SPDX-License-Identifier: MIT */
#include "wire.h"

#include "panel.h"

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
    wire->left_px = 0;
    wire->cut = true;
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

int wire_flush(struct wire *wire)
{
    const int err = bus_flush(&wire->bus);

    if (err) wire->left_px = 0;
    return err;
}

static int wire_send_args(struct wire *wire, const uint8_t *args, size_t n_args)
{
    if (wire->args_low) return wire_command(wire, args, n_args);
    int err = wire_data(wire, args, n_args);
    return err ? err : bus_flush(&wire->bus);
}

int wire_send(struct wire *wire, uint8_t command, const uint8_t *args, size_t n_args)
{
    wire->left_px = 0;
    wire->cut = true;
    int err = wire_command(wire, &command, 1);
    if (!err && n_args) err = wire_send_args(wire, args, n_args);
    if (!err) wire->cut = false;
    return err;
}

int wire_send_list(struct wire *wire, const uint8_t *list, size_t list_b)
{
    int err = 0;

    for (size_t i = 0; i < list_b && !err; i += 2u + list[i + 1])
        err = wire_send(wire, list[i], &list[i + 2], list[i + 1]);
    return err;
}

void wire_open(struct wire *wire, uint32_t n_px)
{
    wire->left_px = n_px;
}

int wire_pixels(struct wire *wire, enum panel_format format, const void *data, size_t n_px)
{
    const uint32_t left_px = wire->left_px;

    wire->left_px = 0; /* stays closed after an error */
    if (n_px > left_px) return PANEL_ERR_WINDOW;
    int err = wire_data(wire, data, pixels_b(format, n_px));
    if (!err) wire->left_px = left_px - (uint32_t)n_px;
    return err;
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
