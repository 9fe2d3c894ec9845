/* SPDX-License-Identifier: MIT */
#include "mcu/avr_gpio.h"

static int set(void *ctx, bool high)
{
    const struct avr_output *output = ctx;
    volatile uint8_t *const port = &output->registers->port;

    *port = (uint8_t)(high != output->inverted ? *port | output->mask : *port & ~output->mask);
    return 0;
}

/* The level first, so that the pin has no other for a moment. */
static struct pin begin(struct avr_output *output, bool high)
{
    volatile struct avr_gpio_registers *const registers = output->registers;

    (void)set(output, high);
    registers->ddr = (uint8_t)(registers->ddr | output->mask);
    return (struct pin){.ctx = output, .set = set};
}

struct pin avr_gpio_output(struct avr_output *output, volatile struct avr_gpio_registers *registers, uint8_t number,
                           bool high)
{
    *output = (struct avr_output){.registers = registers, .mask = (uint8_t)(1u << number)};
    return begin(output, high);
}

struct pin avr_gpio_sink(struct avr_output *output, volatile struct avr_gpio_registers *registers, uint8_t number)
{
    *output = (struct avr_output){.registers = registers, .mask = (uint8_t)(1u << number), .inverted = true};
    return begin(output, false);
}

void avr_gpio_inputs(volatile struct avr_gpio_registers *registers, uint8_t mask)
{
    registers->ddr = (uint8_t)(registers->ddr & ~mask);
    registers->port = (uint8_t)(registers->port | mask);
}
