/* SPDX-License-Identifier: MIT
 *
 * A fake of ESP-IDF's esp_lcd, for the example alone, which is compiled and not run. */
#ifndef FAKE_ESP_LCD_PANEL_VENDOR_H
#define FAKE_ESP_LCD_PANEL_VENDOR_H

#include "esp_lcd_panel_ops.h"

#include <stdlib.h>

#define ESP_ERROR_CHECK(x)                                                                                             \
    do                                                                                                                 \
        if ((x) != ESP_OK) abort();                                                                                    \
    while (0)

typedef int esp_lcd_spi_bus_handle_t;
typedef enum { LCD_RGB_ELEMENT_ORDER_RGB, LCD_RGB_ELEMENT_ORDER_BGR } lcd_rgb_element_order_t;

typedef struct {
    int cs_gpio_num, dc_gpio_num, spi_mode;
    unsigned int pclk_hz;
    size_t trans_queue_depth;
    int lcd_cmd_bits, lcd_param_bits;
} esp_lcd_panel_io_spi_config_t;

typedef struct {
    lcd_rgb_element_order_t rgb_ele_order;
    uint32_t bits_per_pixel;
    int reset_gpio_num;
} esp_lcd_panel_dev_config_t;

esp_err_t esp_lcd_new_panel_io_spi(esp_lcd_spi_bus_handle_t bus, const esp_lcd_panel_io_spi_config_t *io_config,
                                   esp_lcd_panel_io_handle_t *ret_io);
esp_err_t esp_lcd_new_panel_st7789(esp_lcd_panel_io_handle_t io, const esp_lcd_panel_dev_config_t *panel_dev_config,
                                   esp_lcd_panel_handle_t *ret_panel);
esp_err_t esp_lcd_panel_reset(esp_lcd_panel_handle_t panel);
esp_err_t esp_lcd_panel_init(esp_lcd_panel_handle_t panel);
esp_err_t esp_lcd_panel_invert_color(esp_lcd_panel_handle_t panel, bool invert_color_data);
esp_err_t esp_lcd_panel_disp_on_off(esp_lcd_panel_handle_t panel, bool on_off);

#endif
