/* SPDX-License-Identifier: MIT
 *
 * A fake of ESP-IDF's driver with the signatures of its header (commit 102122904ad): pins. */
#ifndef FAKE_DRIVER_GPIO_H
#define FAKE_DRIVER_GPIO_H

#include "esp_err.h"
#include "fake_wires.h"

typedef enum { GPIO_NUM_NC = -1, GPIO_NUM_0 = 0, GPIO_NUM_MAX = 49 } gpio_num_t;
typedef enum { GPIO_MODE_DISABLE = 0, GPIO_MODE_INPUT = 1, GPIO_MODE_OUTPUT = 2 } gpio_mode_t;

static inline esp_err_t gpio_reset_pin(gpio_num_t gpio_num)
{
    wires_output((unsigned)gpio_num, false);
    return ESP_OK;
}

static inline esp_err_t gpio_set_level(gpio_num_t gpio_num, uint32_t level)
{
    wires_level((unsigned)gpio_num, level != 0);
    return ESP_OK;
}

static inline esp_err_t gpio_set_direction(gpio_num_t gpio_num, gpio_mode_t mode)
{
    wires_output((unsigned)gpio_num, mode == GPIO_MODE_OUTPUT);
    return ESP_OK;
}

#endif
