/* SPDX-License-Identifier: MIT
 *
 * Pins of the STM32F4: outputs, and outputs of a peripheral. Registers: RM0090 8.4. */
#ifndef HAL_MCU_STM32F4_GPIO_H
#define HAL_MCU_STM32F4_GPIO_H

#include "bus.h"

HAL_C_BEGIN

struct stm32f4_gpio {
    volatile uint32_t moder, otyper, ospeedr, pupdr, idr, odr, bsrr, lckr, afr[2];
};

#define STM32F4_GPIOA ((struct stm32f4_gpio *)UINT32_C(0x40020000))
#define STM32F4_GPIOC ((struct stm32f4_gpio *)UINT32_C(0x40020800))

struct stm32f4_pin {
    struct stm32f4_gpio *port; /* its clock is on */
    uint8_t bit;
    bool inverted; /* high is low at the pin */
};

/* Makes it an output that begins at the level; *pin must outlive what is returned. */
struct pin stm32f4_gpio_output(const struct stm32f4_pin *pin, bool high);

/* Lends it to a peripheral: function 0 .. 15 is the datasheet's AF0 .. AF15. Fastest edges. */
void stm32f4_gpio_lend(const struct stm32f4_pin *pin, uint8_t function);

HAL_C_END

#endif
