/* SPDX-License-Identifier: MIT
 *
 * A fake of the Pico SDK: pins. */
#ifndef FAKE_HARDWARE_GPIO_H
#define FAKE_HARDWARE_GPIO_H

#include "pico/time.h"

#define GPIO_OUT true
#define GPIO_IN false

typedef enum gpio_function { GPIO_FUNC_SPI = 1, GPIO_FUNC_SIO = 5, GPIO_FUNC_NULL = 0x1f } gpio_function_t;

static inline void gpio_put(uint gpio, bool value)
{
    wires_level(gpio, value);
}

static inline void gpio_init(uint gpio)
{
    wires_output(gpio, false);
    wires_level(gpio, false);
}

static inline void gpio_set_dir(uint gpio, bool out)
{
    wires_output(gpio, out);
}

static inline void gpio_set_function(uint gpio, gpio_function_t fn)
{
    if (fn != GPIO_FUNC_SPI || (gpio != WIRE_CLOCK && gpio != WIRE_DATA)) wires_complain("Pico: a pin is no SPI's");
}

#endif
