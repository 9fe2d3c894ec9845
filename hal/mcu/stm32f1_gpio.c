/* SPDX-License-Identifier: MIT
 *
 * Outputs have the slowest edges, 125 ns, the most that PC13 to PC15 may have: a panel reads D/C with the last bit of a
 * byte, 400 ns and more after it was set. */
#include "mcu/stm32f1_gpio.h"

/* CNF and MODE of a pin. */
enum { CR_OUTPUT_2_MHZ = 2, CR_ALTERNATE_50_MHZ = 11, CR_BITS = 4, CR_PINS = 8 };

static void configure(const struct stm32f1_pin *pin, uint32_t kind)
{
    volatile uint32_t *cr = &pin->port->cr[pin->bit / CR_PINS];
    const uint32_t shift = (uint32_t)(pin->bit % CR_PINS * CR_BITS);

    *cr = (*cr & ~(UINT32_C(0xF) << shift)) | kind << shift;
}

static void set_level(const struct stm32f1_pin *pin, bool high)
{
    pin->port->bsrr = UINT32_C(1) << (high == pin->inverted ? pin->bit + 16 : pin->bit);
}

static int set(void *ctx, bool high)
{
    set_level(ctx, high);
    return 0;
}

struct pin stm32f1_gpio_output(const struct stm32f1_pin *pin, bool high)
{
    set_level(pin, high);
    configure(pin, CR_OUTPUT_2_MHZ);
    return (struct pin){.ctx = (void *)(uintptr_t)pin, .set = set};
}

void stm32f1_gpio_lend(const struct stm32f1_pin *pin)
{
    configure(pin, CR_ALTERNATE_50_MHZ);
}
