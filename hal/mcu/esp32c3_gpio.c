/* SPDX-License-Identifier: MIT */
#include "mcu/esp32c3_gpio.h"

enum {
    SIGNAL_OUT_REGISTER = 128, /* in the place of a peripheral's */
    INVERTED = 1 << 8,
    ENABLE_BY_REGISTER = 1 << 9,
    DRIVE_20_MA = 2 << 10, /* as after a reset; neither pulled nor read */
    FUNCTION_AT = 12,
    FUNCTION_MATRIX = 1,
};

static int set(void *ctx, bool high)
{
    const struct esp32c3_pin *pin = ctx;
    const uint32_t bit = UINT32_C(1) << pin->number;

    if (high)
        pin->gpio->out_w1ts = bit;
    else
        pin->gpio->out_w1tc = bit;
    return 0;
}

struct pin esp32c3_gpio_output(const struct esp32c3_pin *pin, bool high)
{
    struct pin output = {.ctx = (void *)(uintptr_t)pin, .set = set};

    (void)set(output.ctx, high);
    pin->gpio->func_out_sel[pin->number] =
        SIGNAL_OUT_REGISTER | ENABLE_BY_REGISTER | (uint32_t)(pin->inverted ? INVERTED : 0);
    pin->mux->pins[pin->number] = FUNCTION_MATRIX << FUNCTION_AT | DRIVE_20_MA;
    pin->gpio->enable_w1ts = UINT32_C(1) << pin->number;
    return output;
}

void esp32c3_gpio_lend(const struct esp32c3_pin *pin)
{
    pin->mux->pins[pin->number] = ESP32C3_PIN_DIRECT << FUNCTION_AT | DRIVE_20_MA;
}
