/* SPDX-License-Identifier: MIT */
#include "mcu/sio_gpio.h"

void sio_gpio_select(const struct sio_gpio *gpio, uint8_t number, enum sio_gpio_function function,
                     enum sio_gpio_pad pad)
{
    gpio->pads->gpio[number] = pad;
    gpio->io->gpio[number].ctrl = function;
}

/* Only ones take effect, so pins do not disturb each other. */
static int output_set(void *ctx, bool high)
{
    const struct sio_output *output = ctx;

    *(high ? &output->sio->gpio_out_set : &output->sio->gpio_out_clr) = output->mask;
    return 0;
}

struct pin sio_gpio_output(struct sio_output *output, const struct sio_gpio *gpio, uint8_t number, bool high)
{
    *output = (struct sio_output){.sio = gpio->sio, .mask = UINT32_C(1) << number};
    (void)output_set(output, high);
    gpio->sio->gpio_oe_set = output->mask;
    sio_gpio_select(gpio, number, SIO_GPIO_SIO, SIO_GPIO_SLOW);
    return (struct pin){.ctx = output, .set = output_set};
}
