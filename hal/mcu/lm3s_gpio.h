/* SPDX-License-Identifier: MIT
 *
 * Pins of Stellaris LM3S parts: outputs, inputs with pull-ups, and what else a pin can be. Manual: LM3S6965 data sheet,
 * chapter 8 (General-Purpose Input/Outputs), 8.5 (Register Descriptions). The port must be clocked (lm3s_clocks.h). Not
 * tried on hardware. */
#ifndef HAL_MCU_LM3S_GPIO_H
#define HAL_MCU_LM3S_GPIO_H

#include "bus.h"

HAL_C_BEGIN

/* Names without the manual's GPIO. */
struct lm3s_gpio_registers {
    uint32_t data[256]; /* 0x000: bits 9..2 of the address are a mask: the other pins neither change nor read as set */
    uint32_t dir;       /* 0x400 */
    uint32_t is, ibe, iev, im, ris, mis, icr;
    uint32_t afsel; /* 0x420 */
    uint32_t reserved[55];
    uint32_t dr2r; /* 0x500 */
    uint32_t dr4r, dr8r, odr;
    uint32_t pur; /* 0x510 */
    uint32_t pdr, slr;
    uint32_t den; /* 0x51c */
};

#define LM3S_GPIO_A_REGISTERS ((volatile struct lm3s_gpio_registers *)UINT32_C(0x40004000))
#define LM3S_GPIO_C_REGISTERS ((volatile struct lm3s_gpio_registers *)UINT32_C(0x40006000))
#define LM3S_GPIO_E_REGISTERS ((volatile struct lm3s_gpio_registers *)UINT32_C(0x40024000))
#define LM3S_GPIO_F_REGISTERS ((volatile struct lm3s_gpio_registers *)UINT32_C(0x40025000))

/* One output, whose state lives as long as the struct pin. */
struct lm3s_output {
    volatile uint32_t *data; /* where this pin is all of the port */
};

/* Makes pin `number`, 0..7, an output that has the level `high` from its first moment. */
struct pin lm3s_gpio_output(struct lm3s_output *output, volatile struct lm3s_gpio_registers *port, uint8_t number,
                            bool high);

/* Makes the pins of the mask inputs that are pulled up. */
void lm3s_gpio_inputs(volatile struct lm3s_gpio_registers *port, uint8_t mask);

/* Of the pins of the mask, those that are high. */
static inline uint8_t lm3s_gpio_read(const volatile struct lm3s_gpio_registers *port, uint8_t mask)
{
    return (uint8_t)port->data[mask];
}

/* Gives the pins of the mask to the peripheral that can have them. */
void lm3s_gpio_alternate(volatile struct lm3s_gpio_registers *port, uint8_t mask);

HAL_C_END

#endif
