/* SPDX-License-Identifier: MIT
 *
 * Draws on a panel of ESP-IDF's esp_lcd (5.2 and later), which returns while DMA still reads: lines are gathered in two
 * blocks, of which one is filled while the other is on its way, until on_color_trans_done says that it has arrived:
 *     static uint16_t blocks[2 * 8 * 240]; // 8 lines each, in memory that DMA reads
 *     static struct limner_esp_lcd display = {.memory = &house_memory, .blocks = blocks, .blocks_b = sizeof blocks};
 *     int err = limner_esp_lcd_begin(&display, panel, io);                       // LIM_ERR_MEMORY, -esp_err_t
 *     if (!err) err = house_begin(&house_memory, limner_esp_lcd_send, &display); */
#ifndef LIMNER_ESP_LCD_H
#define LIMNER_ESP_LCD_H
#include "esp_lcd_panel_io.h"
#include "esp_lcd_panel_ops.h"
#include "freertos/FreeRTOS.h"
#include "freertos/semphr.h"
#include "limner.h"
struct limner_esp_lcd {
    const struct lim_memory *memory; /* the picture's size is its */
    uint16_t *blocks;                /* of two lines or more */
    size_t blocks_b;
    int x_px, y_px;               /* where the picture's corner is on the panel */
    esp_lcd_panel_handle_t panel; /* private, as is what follows */
    uint32_t begin_px, sent_px;   /* of the block that is filled; of the frame so far */
    SemaphoreHandle_t arrived;
    StaticSemaphore_t arrived_mem;
};

static inline bool limner_esp_lcd_arrived(esp_lcd_panel_io_handle_t io, esp_lcd_panel_io_event_data_t *data, void *ctx)
{
    BaseType_t woken = pdFALSE;
    return (void)io, (void)data, xSemaphoreGiveFromISR(((struct limner_esp_lcd *)ctx)->arrived, &woken) && woken;
}

static inline int limner_esp_lcd_begin(struct limner_esp_lcd *to, esp_lcd_panel_handle_t panel,
                                       esp_lcd_panel_io_handle_t io)
{
    const esp_lcd_panel_io_callbacks_t callbacks = {limner_esp_lcd_arrived};
    to->panel = panel,
    to->arrived = xSemaphoreCreateCountingStatic(2, 1, &to->arrived_mem); /* the second block is free */
    if (to->blocks_b < 4u * to->memory->w_px) return LIM_ERR_MEMORY;
    const esp_err_t err = esp_lcd_panel_io_register_event_callbacks(io, &callbacks, to);
    return err > 0 ? -err : err;
}

static inline int limner_esp_lcd_send(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px)
{
    struct limner_esp_lcd *const to = (struct limner_esp_lcd *)ctx;
    const uint16_t w_px = to->memory->w_px, rows = (uint16_t)(to->blocks_b / 4 / w_px), row = y_px % rows;
    const uint32_t at_px = (uint32_t)y_px * w_px + x_px;
    if ((at_px && at_px != to->sent_px) || !n_px) return LIM_ERR_TARGET; /* lim_set_visible() leaves pixels out */
    for (to->sent_px = at_px; to->sent_px < at_px + n_px; to->sent_px++)
        to->blocks[to->begin_px + to->sent_px - (uint32_t)(y_px - row) * w_px] = *pixels++;
    if (x_px + n_px < w_px || (row + 1 < rows && y_px + 1 < to->memory->h_px)) return LIM_OK;
    const int x0 = to->x_px, y1 = to->y_px + y_px + 1;
    const int err = esp_lcd_panel_draw_bitmap(to->panel, x0, y1 - row - 1, x0 + w_px, y1, to->blocks + to->begin_px);
    if (err) return err > 0 ? -err : err; /* this block is not on its way */
    xSemaphoreTake(to->arrived, portMAX_DELAY);
    to->begin_px = to->begin_px ? 0 : (uint32_t)rows * w_px; /* the other one has arrived */
    return LIM_OK;
}
#endif
