/* SPDX-License-Identifier: MIT */
#include "mcu/lm3s_gpio.h"

static int output_set(void *ctx, bool high)
{
    const struct lm3s_output *output = (const struct lm3s_output *)ctx;

    *output->data = high ? UINT8_MAX : 0;
    return 0;
}

struct pin lm3s_gpio_output(struct lm3s_output *output, volatile struct lm3s_gpio_registers *port, uint8_t number,
                            bool high)
{
    const uint32_t mask = UINT32_C(1) << number;
    const struct pin pin = {.ctx = output, .set = output_set};

    output->data = &port->data[mask];
    port->afsel &= ~mask;
    (void)output_set(output, high);
    port->dir |= mask;
    port->den |= mask;
    return pin;
}

void lm3s_gpio_inputs(volatile struct lm3s_gpio_registers *port, uint8_t mask)
{
    port->afsel &= ~(uint32_t)mask;
    port->dir &= ~(uint32_t)mask;
    port->pur |= mask;
    port->den |= mask;
}

void lm3s_gpio_alternate(volatile struct lm3s_gpio_registers *port, uint8_t mask)
{
    port->afsel |= mask;
    port->den |= mask;
}
