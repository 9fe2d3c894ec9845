/* SPDX-License-Identifier: MIT
 *
 * Pins of an ESP32-C3: outputs, and outputs of the peripheral that a pin is wired to directly. Registers: ESP32-C3
 * Technical Reference Manual, "IO MUX and GPIO Matrix"; offsets and bits as in espressif/esp-idf
 * components/soc/esp32c3/register/soc (gpio_reg.h, io_mux_reg.h). */
#ifndef HAL_MCU_ESP32C3_GPIO_H
#define HAL_MCU_ESP32C3_GPIO_H

#include "bus.h"

HAL_C_BEGIN

enum { ESP32C3_PINS = 22, ESP32C3_PIN_DIRECT = 2 };

struct esp32c3_gpio {
    volatile uint32_t bt_select, out, out_w1ts, out_w1tc, reserved_10[4];
    volatile uint32_t enable, enable_w1ts, enable_w1tc, reserved_2c[330];
    volatile uint32_t func_out_sel[ESP32C3_PINS];
};

struct esp32c3_io_mux {
    volatile uint32_t pin_ctrl, pins[ESP32C3_PINS];
};

#define ESP32C3_GPIO ((struct esp32c3_gpio *)UINT32_C(0x60004000))
#define ESP32C3_IO_MUX ((struct esp32c3_io_mux *)UINT32_C(0x60009000))

struct esp32c3_pin {
    struct esp32c3_gpio *gpio;
    struct esp32c3_io_mux *mux;
    uint8_t number; /* GPIO0 .. GPIO21 */
    bool inverted;  /* high is low at the pin */
};

/* Makes it an output that begins at the level; *pin must outlive what is returned. */
struct pin esp32c3_gpio_output(const struct esp32c3_pin *pin, bool high);

/* Lends it to the peripheral that is its function 2: SPI2 has its clock at GPIO6, what it sends at GPIO7. */
void esp32c3_gpio_lend(const struct esp32c3_pin *pin);

HAL_C_END

#endif
