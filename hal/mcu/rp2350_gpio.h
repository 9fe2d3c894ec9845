/* SPDX-License-Identifier: MIT
 *
 * Pins of the RP2350, GPIO 0 to 29: as the RP2040's (sio_gpio.h), whose functions and pads it has. The single-cycle
 * I/O's registers lie elsewhere, since there may be 48 pins; a pad is isolated after reset, and what the pin is given
 * to reaches it when that ends. IO_BANK0 and PADS_BANK0 must be out of reset (rp2350_clocks.h). Manual: RP2350
 * Datasheet, 3.1.11 (SIO), 9.7 (isolation), 9.11.1 (IO_BANK0), 9.11.3 (PADS_BANK0); numbers: raspberrypi/pico-sdk,
 * src/rp2350/hardware_regs/include/hardware/regs, addressmap.h, sio.h, io_bank0.h, pads_bank0.h. Not tried on hardware.
 */
#ifndef HAL_MCU_RP2350_GPIO_H
#define HAL_MCU_RP2350_GPIO_H

#include "mcu/sio_gpio.h"

HAL_C_BEGIN

/* Each of the low 32 pins is followed by that of the pins above. */
struct rp2350_sio_registers {
    uint32_t cpuid;
    uint32_t gpio_in, gpio_hi_in;
    uint32_t reserved;
    uint32_t gpio_out, gpio_hi_out;
    uint32_t gpio_out_set, gpio_hi_out_set;
    uint32_t gpio_out_clr, gpio_hi_out_clr;
    uint32_t gpio_out_xor, gpio_hi_out_xor;
    uint32_t gpio_oe, gpio_hi_oe;
    uint32_t gpio_oe_set, gpio_hi_oe_set;
};

#define RP2350_SIO_REGISTERS ((volatile struct rp2350_sio_registers *)UINT32_C(0xD0000000))
#define RP2350_IO_BANK0_REGISTERS ((volatile struct io_bank0_registers *)UINT32_C(0x40028000))
#define RP2350_PADS_BANK0_REGISTERS ((volatile struct pads_bank0_registers *)UINT32_C(0x40038000))

struct rp2350_gpio {
    volatile struct rp2350_sio_registers *sio;
    volatile struct io_bank0_registers *io;
    volatile struct pads_bank0_registers *pads;
};

/* Gives pin `number` to a peripheral, and then ends the isolation of its pad. */
void rp2350_gpio_select(const struct rp2350_gpio *gpio, uint8_t number, enum sio_gpio_function function,
                        enum sio_gpio_pad pad);

/* The level of a pin that was given to SIO_GPIO_SIO. */
static inline bool rp2350_gpio_read(const struct rp2350_gpio *gpio, uint8_t number)
{
    return gpio->sio->gpio_in >> number & 1u;
}

/* One output, whose state lives as long as the struct pin. */
struct rp2350_output {
    volatile struct rp2350_sio_registers *sio;
    uint32_t mask;
};

/* Makes pin `number` an output that has the level `high` from its first moment. */
struct pin rp2350_gpio_output(struct rp2350_output *output, const struct rp2350_gpio *gpio, uint8_t number, bool high);

HAL_C_END

#endif
