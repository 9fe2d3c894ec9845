/* SPDX-License-Identifier: MIT
 *
 * Pins of AVR microcontrollers. No interrupt may use the same port meanwhile: a pin is set by reading and writing.
 * Manual: Atmel-7766, ATmega16U4/ATmega32U4, section 10, "I/O-Ports". Not tried on hardware. */
#ifndef HAL_MCU_AVR_GPIO_H
#define HAL_MCU_AVR_GPIO_H

#include "bus.h"

HAL_C_BEGIN

struct avr_gpio_registers {
    uint8_t pin;  /* what the pins are at */
    uint8_t ddr;  /* 1: output */
    uint8_t port; /* an output's level, an input's pull-up */
};

/* ATmega32U4's. */
#define AVR_GPIO_B_REGISTERS ((volatile struct avr_gpio_registers *)0x23)
#define AVR_GPIO_D_REGISTERS ((volatile struct avr_gpio_registers *)0x29)
#define AVR_GPIO_E_REGISTERS ((volatile struct avr_gpio_registers *)0x2C)
#define AVR_GPIO_F_REGISTERS ((volatile struct avr_gpio_registers *)0x2F)

struct avr_output {
    volatile struct avr_gpio_registers *registers;
    uint8_t mask;
    bool inverted; /* high means a low level */
};

/* Makes pin `number` of a port an output that begins so. *output must outlive it. */
struct pin avr_gpio_output(struct avr_output *output, volatile struct avr_gpio_registers *registers, uint8_t number,
                           bool high);

/* The same of something that lights when its pin is low; dark at first. */
struct pin avr_gpio_sink(struct avr_output *output, volatile struct avr_gpio_registers *registers, uint8_t number);

/* Makes pins inputs with pull-ups: bits of a mask. */
void avr_gpio_inputs(volatile struct avr_gpio_registers *registers, uint8_t mask);

HAL_C_END

#endif
