/* SPDX-License-Identifier: MIT
 *
 * Pins of the RP2040: outputs and inputs by the processor's single-cycle I/O, and what else a pin can be.
 * Manual: RP2040 Datasheet, 2.3.1.7 (SIO), 2.19.6.1 (IO_BANK0), 2.19.6.3 (PADS_BANK0). IO_BANK0 and PADS_BANK0 must be
 * out of reset (rp2040_clocks.h). Not tried on hardware. */
#ifndef HAL_MCU_SIO_GPIO_H
#define HAL_MCU_SIO_GPIO_H

#include "bus.h"

HAL_C_BEGIN

enum { SIO_GPIO_PINS = 30 };

struct sio_registers {
    uint32_t cpuid;
    uint32_t gpio_in, gpio_hi_in;
    uint32_t reserved;
    uint32_t gpio_out, gpio_out_set, gpio_out_clr, gpio_out_xor;
    uint32_t gpio_oe, gpio_oe_set, gpio_oe_clr, gpio_oe_xor;
};

struct io_bank0_registers {
    struct {
        uint32_t status, ctrl;
    } gpio[SIO_GPIO_PINS];
};

struct pads_bank0_registers {
    uint32_t voltage_select;
    uint32_t gpio[SIO_GPIO_PINS];
};

#define SIO_REGISTERS ((volatile struct sio_registers *)UINT32_C(0xD0000000))
#define IO_BANK0_REGISTERS ((volatile struct io_bank0_registers *)UINT32_C(0x40014000))
#define PADS_BANK0_REGISTERS ((volatile struct pads_bank0_registers *)UINT32_C(0x4001C000))

struct sio_gpio {
    volatile struct sio_registers *sio;
    volatile struct io_bank0_registers *io;
    volatile struct pads_bank0_registers *pads;
};

/* GPIOx_CTRL.FUNCSEL, 2.19.2. */
enum sio_gpio_function { SIO_GPIO_SPI = 1, SIO_GPIO_SIO = 5 };

/* How a pin drives: GPIOx of PADS_BANK0. */
enum sio_gpio_pad {
    SIO_GPIO_SLOW = 0x52,   /* 4 mA, slow slew rate, readable, no pull */
    SIO_GPIO_FAST = 0x53,   /* the same with fast slew rate: a clock of more than 30 MHz */
    SIO_GPIO_BUTTON = 0x4A, /* readable, pulled up */
};

/* Gives pin `number` to a peripheral. */
void sio_gpio_select(const struct sio_gpio *gpio, uint8_t number, enum sio_gpio_function function,
                     enum sio_gpio_pad pad);

/* The level of a pin that was given to SIO_GPIO_SIO. */
static inline bool sio_gpio_read(const struct sio_gpio *gpio, uint8_t number)
{
    return gpio->sio->gpio_in >> number & 1u;
}

/* One output, whose state lives as long as the struct pin. */
struct sio_output {
    volatile struct sio_registers *sio;
    uint32_t mask;
};

/* Makes pin `number` an output that has the level `high` from its first moment. */
struct pin sio_gpio_output(struct sio_output *output, const struct sio_gpio *gpio, uint8_t number, bool high);

HAL_C_END

#endif
