/* SPDX-License-Identifier: MIT */
#include "mcu/fe310_gpio.h"

static void set_bit(volatile uint32_t *reg, uint8_t bit, bool high)
{
    const uint32_t mask = UINT32_C(1) << bit;

    *reg = high ? *reg | mask : *reg & ~mask;
}

static int set(void *ctx, bool high)
{
    const struct fe310_pin *pin = ctx;

    set_bit(&pin->port->output_val, pin->bit, high);
    return 0;
}

struct pin fe310_gpio_output(const struct fe310_pin *pin, bool high)
{
    set_bit(&pin->port->output_val, pin->bit, high);
    set_bit(&pin->port->out_xor, pin->bit, pin->inverted);
    set_bit(&pin->port->iof_en, pin->bit, false);
    set_bit(&pin->port->output_en, pin->bit, true);
    return (struct pin){.ctx = (void *)(uintptr_t)pin, .set = set};
}

void fe310_gpio_lend(const struct fe310_pin *pin)
{
    set_bit(&pin->port->out_xor, pin->bit, false);
    set_bit(&pin->port->iof_sel, pin->bit, false);
    set_bit(&pin->port->iof_en, pin->bit, true);
}
