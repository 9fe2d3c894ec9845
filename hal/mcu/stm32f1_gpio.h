/* SPDX-License-Identifier: MIT
 *
 * Pins of the STM32F1: outputs, and outputs of a peripheral. Registers: RM0008 9.2. */
#ifndef HAL_MCU_STM32F1_GPIO_H
#define HAL_MCU_STM32F1_GPIO_H

#include "bus.h"

HAL_C_BEGIN

struct stm32f1_gpio {
    volatile uint32_t cr[2]; /* GPIOx_CRL, GPIOx_CRH */
    volatile uint32_t idr, odr, bsrr, brr, lckr;
};

#define STM32F1_GPIOA ((struct stm32f1_gpio *)UINT32_C(0x40010800))
#define STM32F1_GPIOB ((struct stm32f1_gpio *)UINT32_C(0x40010C00))
#define STM32F1_GPIOC ((struct stm32f1_gpio *)UINT32_C(0x40011000))

struct stm32f1_pin {
    struct stm32f1_gpio *port; /* its clock is on */
    uint8_t bit;
    bool inverted; /* high is low at the pin */
};

/* Makes it an output that begins at the level; *pin must outlive what is returned. */
struct pin stm32f1_gpio_output(const struct stm32f1_pin *pin, bool high);

/* Lends it to the peripheral that the datasheet names for it. Fastest edges. */
void stm32f1_gpio_lend(const struct stm32f1_pin *pin);

HAL_C_END

#endif
