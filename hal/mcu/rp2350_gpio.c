/* SPDX-License-Identifier: MIT */
#include "mcu/rp2350_gpio.h"

/* ISO, bit 8 of a pad, is 0 in all of enum sio_gpio_pad. */
void rp2350_gpio_select(const struct rp2350_gpio *gpio, uint8_t number, enum sio_gpio_function function,
                        enum sio_gpio_pad pad)
{
    gpio->io->gpio[number].ctrl = function;
    gpio->pads->gpio[number] = pad;
}

/* Only ones take effect, so pins do not disturb each other. */
static int rp2350_output_set(void *ctx, bool high)
{
    const struct rp2350_output *output = ctx;

    *(high ? &output->sio->gpio_out_set : &output->sio->gpio_out_clr) = output->mask;
    return 0;
}

struct pin rp2350_gpio_output(struct rp2350_output *output, const struct rp2350_gpio *gpio, uint8_t number, bool high)
{
    *output = (struct rp2350_output){.sio = gpio->sio, .mask = UINT32_C(1) << number};
    (void)rp2350_output_set(output, high);
    gpio->sio->gpio_oe_set = output->mask;
    rp2350_gpio_select(gpio, number, SIO_GPIO_SIO, SIO_GPIO_SLOW);
    return (struct pin){.ctx = output, .set = rp2350_output_set};
}
