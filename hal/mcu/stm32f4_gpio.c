/* SPDX-License-Identifier: MIT */
#include "mcu/stm32f4_gpio.h"

enum { MODER_OUTPUT = 1, MODER_ALTERNATE = 2, OSPEEDR_MEDIUM = 1, OSPEEDR_VERY_HIGH = 3 };

static void set_field(volatile uint32_t *control, uint8_t index, uint8_t width_bits, uint32_t value)
{
    const uint32_t mask = (UINT32_C(1) << width_bits) - 1;
    const uint32_t shift = (uint32_t)index * width_bits;

    *control = (*control & ~(mask << shift)) | value << shift;
}

static void set_level(const struct stm32f4_pin *pin, bool high)
{
    pin->port->bsrr = UINT32_C(1) << (high == pin->inverted ? pin->bit + 16 : pin->bit);
}

static int set(void *ctx, bool high)
{
    set_level(ctx, high);
    return 0;
}

static void drive(const struct stm32f4_pin *pin, uint32_t mode, uint32_t speed)
{
    set_field(&pin->port->ospeedr, pin->bit, 2, speed);
    set_field(&pin->port->otyper, pin->bit, 1, 0);
    set_field(&pin->port->pupdr, pin->bit, 2, 0);
    set_field(&pin->port->moder, pin->bit, 2, mode);
}

struct pin stm32f4_gpio_output(const struct stm32f4_pin *pin, bool high)
{
    set_level(pin, high);
    drive(pin, MODER_OUTPUT, OSPEEDR_MEDIUM);
    return (struct pin){.ctx = (void *)(uintptr_t)pin, .set = set};
}

void stm32f4_gpio_lend(const struct stm32f4_pin *pin, uint8_t function)
{
    set_field(&pin->port->afr[pin->bit / 8], pin->bit % 8, 4, function);
    drive(pin, MODER_ALTERNATE, OSPEEDR_VERY_HIGH);
}
