/* SPDX-License-Identifier: MIT
 *
 * See esp_lcd_panel_io.h. */
#ifndef FAKE_ESP_LCD_PANEL_OPS_H
#define FAKE_ESP_LCD_PANEL_OPS_H

#include "esp_lcd_panel_io.h"

#ifdef __cplusplus
extern "C" {
#endif

esp_err_t esp_lcd_panel_draw_bitmap(esp_lcd_panel_handle_t panel, int x_start, int y_start, int x_end, int y_end,
                                    const void *color_data);

#ifdef __cplusplus
}
#endif

#endif
