/* SPDX-License-Identifier: MIT
 *
 * esp_lcd on SPI: the pixels of a call are read by DMA as late as they may be, which is when the next call, or who
 * waits for the callback, finds them not sent yet. */
#include "esp_lcd_panel_ops.h"
#include "fake_display.h"
#include "freertos/semphr.h"

#include <string.h>

static struct {
    esp_lcd_panel_io_color_trans_done_cb_t done;
    void *done_ctx;
    const uint8_t *pixels; /* on their way, or NULL */
    int n_px;
    uint8_t as_given[2 * FAKE_W_PX * FAKE_H_PX];
    int fail_at;
    esp_err_t failure;
} lcd = {.fail_at = -1};

static bool fails(void)
{
    return lcd.fail_at >= 0 && lcd.fail_at-- == 0;
}

esp_err_t esp_lcd_panel_io_register_event_callbacks(esp_lcd_panel_io_handle_t io,
                                                    const esp_lcd_panel_io_callbacks_t *cbs, void *user_ctx)
{
    if (!io || !cbs) return ESP_ERR_INVALID_ARG;
    if (fails()) return lcd.failure;
    lcd.done = cbs->on_color_trans_done;
    lcd.done_ctx = user_ctx;
    return ESP_OK;
}

void fake_esp_lcd_finish(void)
{
    if (!lcd.pixels) return;
    if (memcmp(lcd.as_given, lcd.pixels, 2 * (size_t)lcd.n_px)) fake_complain("esp_lcd: pixels changed on their way");
    fake_bytes(lcd.pixels, lcd.n_px);
    if (fake_left_px()) fake_complain("esp_lcd: a window was not filled");
    lcd.pixels = NULL;
    if (lcd.done) lcd.done(NULL, NULL, lcd.done_ctx);
}

void fake_esp_lcd_fail(int call, esp_err_t failure)
{
    lcd.fail_at = call;
    lcd.failure = failure;
}

esp_err_t esp_lcd_panel_draw_bitmap(esp_lcd_panel_handle_t panel, int x_start, int y_start, int x_end, int y_end,
                                    const void *color_data)
{
    if (!panel) return ESP_ERR_INVALID_ARG;
    if (fails()) return lcd.failure;
    fake_esp_lcd_finish(); /* before it sends commands */
    fake_window(x_start, y_start, x_end - 1, y_end - 1);
    lcd.n_px = fake_left_px();
    lcd.pixels = color_data;
    memcpy(lcd.as_given, color_data, 2 * (size_t)lcd.n_px);
    return ESP_OK;
}

SemaphoreHandle_t xSemaphoreCreateCountingStatic(UBaseType_t uxMaxCount, UBaseType_t uxInitialCount,
                                                 StaticSemaphore_t *pxSemaphoreBuffer)
{
    pxSemaphoreBuffer->most = uxMaxCount;
    pxSemaphoreBuffer->count = uxInitialCount;
    return pxSemaphoreBuffer;
}

BaseType_t xSemaphoreTake(SemaphoreHandle_t xSemaphore, TickType_t xTicksToWait)
{
    if (!xSemaphore->count && xTicksToWait) fake_esp_lcd_finish();
    if (!xSemaphore->count) {
        if (xTicksToWait == portMAX_DELAY) fake_complain("FreeRTOS: a task waits for ever");
        return pdFALSE;
    }
    xSemaphore->count--;
    return pdTRUE;
}

BaseType_t xSemaphoreGiveFromISR(SemaphoreHandle_t xSemaphore, BaseType_t *pxHigherPriorityTaskWoken)
{
    *pxHigherPriorityTaskWoken = pdTRUE;
    if (xSemaphore->count == xSemaphore->most) return pdFALSE;
    xSemaphore->count++;
    return pdTRUE;
}
