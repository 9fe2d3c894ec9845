/* SPDX-License-Identifier: MIT
 *
 * A fake of ESP-IDF's esp_lcd with the signatures of its headers (commit 102122904ad, between 5.5 and 6). */
#ifndef FAKE_ESP_LCD_PANEL_IO_H
#define FAKE_ESP_LCD_PANEL_IO_H

#include "esp_err.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct esp_lcd_panel_io_t *esp_lcd_panel_io_handle_t;
typedef struct esp_lcd_panel_t *esp_lcd_panel_handle_t;

typedef struct {
    char fake; /* the real one is empty, which is no C */
} esp_lcd_panel_io_event_data_t;

typedef bool (*esp_lcd_panel_io_color_trans_done_cb_t)(esp_lcd_panel_io_handle_t panel_io,
                                                       esp_lcd_panel_io_event_data_t *edata, void *user_ctx);

typedef struct {
    esp_lcd_panel_io_color_trans_done_cb_t on_color_trans_done;
} esp_lcd_panel_io_callbacks_t;

esp_err_t esp_lcd_panel_io_register_event_callbacks(esp_lcd_panel_io_handle_t io,
                                                    const esp_lcd_panel_io_callbacks_t *cbs, void *user_ctx);

/* The fake: waits for all that is on its way; the next call number `call`, from 0 on, returns `failure`. */
void fake_esp_lcd_finish(void);
void fake_esp_lcd_fail(int call, esp_err_t failure);

#ifdef __cplusplus
}
#endif

#endif
