/* SPDX-License-Identifier: MIT */
#include "fake_display.h"
#include "lvgl.h"

#include <string.h>

struct _lv_obj_t {
    lv_area_t coords;
};

struct _lv_event_t {
    lv_obj_t *target;
    lv_layer_t *layer;
    void *user_data;
};

/* Fills an area, when it is dispatched. */
struct _lv_draw_task_t {
    lv_draw_task_t *next;
    lv_area_t area;
    uint8_t byte;
};

static uint8_t mem[2 * FAKE_W_PX * FAKE_H_PX + 64];
static lv_layer_t *drawn;

void *lv_event_get_user_data(lv_event_t *e)
{
    return e->user_data;
}

void *lv_event_get_target(lv_event_t *e)
{
    return e->target;
}

lv_layer_t *lv_event_get_layer(lv_event_t *e)
{
    return e->layer;
}

void lv_obj_get_coords(const lv_obj_t *obj, lv_area_t *coords)
{
    *coords = obj->coords;
}

void *lv_draw_layer_go_to_xy(lv_layer_t *layer, int32_t x, int32_t y)
{
    if ((uint32_t)x < layer->draw_buf->header.w && (uint32_t)y < layer->draw_buf->header.h)
        return layer->draw_buf->data + (uint32_t)y * layer->draw_buf->header.stride + 2 * x;
    fake_complain("LVGL: coordinates out of range");
    return mem;
}

void lv_draw_dispatch_wait_for_request(void) {}

void lv_draw_dispatch(void)
{
    const lv_draw_task_t *const task = drawn->draw_task_head;

    if (!task) return;
    for (int32_t y = LV_MAX(task->area.y1, drawn->buf_area.y1); y <= LV_MIN(task->area.y2, drawn->buf_area.y2); y++)
        for (int32_t x = LV_MAX(task->area.x1, drawn->buf_area.x1); x <= LV_MIN(task->area.x2, drawn->buf_area.x2); x++)
            memset(lv_draw_layer_go_to_xy(drawn, x - drawn->buf_area.x1, y - drawn->buf_area.y1), task->byte, 2);
    drawn->draw_task_head = task->next;
}

static void finish(void)
{
    while (drawn->draw_task_head)
        lv_draw_dispatch();
}

/* The stripe's pixels in their format; what is behind its end is as it was. */
static void flush(const lv_layer_t *layer)
{
    const lv_image_header_t *const header = &layer->draw_buf->header;
    const uint8_t *const end = layer->draw_buf->data + header->h * header->stride;

    fake_window(layer->buf_area.x1, layer->buf_area.y1, layer->buf_area.x2, layer->buf_area.y2);
    for (uint32_t y = 0; y < header->h; y++)
        for (uint32_t x = 0; x < header->w; x++) {
            const uint8_t *const at = layer->draw_buf->data + y * header->stride + 2 * x;
            const uint8_t bytes[2] = {at[header->cf == LV_COLOR_FORMAT_RGB565],
                                      at[header->cf != LV_COLOR_FORMAT_RGB565]};
            fake_bytes(bytes, 1);
        }
    for (int i = 0; i < 8; i++)
        if (end[i] != 0x5A) fake_complain("LVGL: memory behind the draw buffer was written to");
}

static void draw_stripe(lv_layer_t *layer, lv_obj_t *obj, lv_event_cb_t cb, void *user_data)
{
    lv_draw_task_t style = {NULL, obj->coords, 0x22}, screen = {&style, layer->buf_area, 0x11};
    lv_event_t event = {obj, layer, user_data};
    lv_image_header_t *const header = &layer->draw_buf->header;

    header->w = (uint16_t)(layer->buf_area.x2 - layer->buf_area.x1 + 1);
    header->h = (uint16_t)(layer->buf_area.y2 - layer->buf_area.y1 + 1);
    header->stride = (uint16_t)((header->w * 2u + 3) / 4 * 4); /* a line begins at a multiple of 4 bytes */
    memset(layer->draw_buf->data, 0x5A, header->h * header->stride + 8u);
    layer->_clip_area = layer->buf_area;
    layer->draw_task_head = &screen;
    drawn = layer;
    if (obj->coords.y1 <= layer->buf_area.y2 && obj->coords.y2 >= layer->buf_area.y1) cb(&event);
    finish();
    flush(layer);
}

void fake_lvgl_refresh(lv_color_format_t cf, int32_t rows, lv_area_t area, lv_area_t coords, lv_event_cb_t cb,
                       void *user_data)
{
    lv_draw_buf_t buf = {.header = {.cf = (uint8_t)cf}, .data = mem};
    lv_layer_t layer = {.draw_buf = &buf};
    lv_obj_t obj = {coords};

    for (int32_t y = area.y1; y <= area.y2; y += rows) {
        layer.buf_area = (lv_area_t){area.x1, y, area.x2, LV_MIN(y + rows - 1, area.y2)};
        draw_stripe(&layer, &obj, cb, user_data);
    }
}
