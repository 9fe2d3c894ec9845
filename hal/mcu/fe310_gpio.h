/* SPDX-License-Identifier: MIT
 *
 * Pins of SiFive's FE310: outputs, and outputs of a peripheral. Registers: FE310-G000 Manual, chapter 17, "General
 * Purpose Input/Output Controller (GPIO)". Only one part of a program may set pins: a level is read, changed, written.
 */
#ifndef HAL_MCU_FE310_GPIO_H
#define HAL_MCU_FE310_GPIO_H

#include "bus.h"

HAL_C_BEGIN

struct fe310_gpio {
    volatile uint32_t input_val, input_en, output_en, output_val, pue, ds;
    volatile uint32_t rise_ie, rise_ip, fall_ie, fall_ip, high_ie, high_ip, low_ie, low_ip;
    volatile uint32_t iof_en, iof_sel, out_xor;
};

#define FE310_GPIO ((struct fe310_gpio *)UINT32_C(0x10012000))

struct fe310_pin {
    struct fe310_gpio *port;
    uint8_t bit;
    bool inverted; /* high is low at the pin */
};

/* Makes it an output that begins at the level; *pin must outlive what is returned. */
struct pin fe310_gpio_output(const struct fe310_pin *pin, bool high);

/* Lends it to the peripheral that is its hardware function 0. */
void fe310_gpio_lend(const struct fe310_pin *pin);

HAL_C_END

#endif
