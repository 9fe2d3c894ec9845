/* SPDX-License-Identifier: MIT
 *
 * What LVGL 9.0 to 9.5 have in common (src/draw/lv_draw.c, src/core/lv_refr.c): each task that is added is followed by
 * a dispatch, which drops tasks that are finished and hands the next one to the draw unit. A unit that has finished
 * requests a dispatch, and so does a dispatch that found nothing to hand out. Who waits for a request takes it away;
 * where there is none, and no unit at work, that wait never ends. Stripes take turns in which kind of unit draws them:
 * one with a thread of its own, here as slow as it may be, or one that finishes before dispatch returns. */
#include "fake_display.h"
#include "lvgl.h"

#include <stdlib.h>
#include <string.h>

struct _lv_obj_t {
    lv_area_t coords;
};

struct _lv_event_t {
    lv_obj_t *target;
    lv_layer_t *layer;
    void *user_data;
};

/* Fills an area. */
struct _lv_draw_task_t {
    lv_draw_task_t *next;
    lv_area_t area;
    uint8_t byte;
    bool is_finished;
};

static uint8_t mem[2 * FAKE_W_PX * FAKE_H_PX + 64];
static lv_layer_t *drawn;
static bool has_thread, is_requested;
static lv_draw_task_t *taken; /* by the unit */

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

static void run_unit(void)
{
    const lv_area_t *const area = &taken->area, *const buf = &drawn->buf_area;

    for (int32_t y = LV_MAX(area->y1, buf->y1); y <= LV_MIN(area->y2, buf->y2); y++)
        for (int32_t x = LV_MAX(area->x1, buf->x1); x <= LV_MIN(area->x2, buf->x2); x++)
            memset(lv_draw_layer_go_to_xy(drawn, x - buf->x1, y - buf->y1), taken->byte, 2);
    taken->is_finished = true;
    taken = NULL;
    is_requested = true;
}

void lv_draw_dispatch_wait_for_request(void)
{
    if (!is_requested && taken) run_unit();
    if (!is_requested) {
        fake_complain("LVGL: waits for ever for a request");
        exit(EXIT_FAILURE);
    }
    is_requested = false;
}

void lv_draw_dispatch(void)
{
    for (lv_draw_task_t **at = &drawn->draw_task_head; *at;)
        if ((*at)->is_finished)
            *at = (*at)->next;
        else
            at = &(*at)->next;
    if (!taken && !drawn->draw_task_head) is_requested = true;
    if (taken || !drawn->draw_task_head) return;
    taken = drawn->draw_task_head;
    if (!has_thread) run_unit();
}

static void add_task(lv_draw_task_t *task, lv_area_t area, uint8_t byte)
{
    lv_draw_task_t **at = &drawn->draw_task_head;

    *task = (lv_draw_task_t){NULL, area, byte, false};
    while (*at)
        at = &(*at)->next;
    *at = task;
    lv_draw_dispatch();
}

static void finish(void)
{
    while (drawn->draw_task_head) {
        lv_draw_dispatch_wait_for_request();
        lv_draw_dispatch();
    }
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

static bool is_in(const lv_area_t *inner, const lv_area_t *outer)
{
    return inner->x1 >= outer->x1 && inner->x2 <= outer->x2 && inner->y1 >= outer->y1 && inner->y2 <= outer->y2;
}

/* Nothing is below a widget that covers the stripe. Above it something lies that has no pixels. No request is left over
 * from the stripe before, as behind a canvas of 9.0 and 9.1. */
static void draw_tasks(lv_layer_t *layer, lv_obj_t *obj, lv_event_cb_t cb, void *user_data)
{
    const lv_area_t nowhere = {0, 0, -1, -1};
    lv_draw_task_t screen, style, above;
    lv_event_t event = {obj, layer, user_data};

    drawn = layer;
    is_requested = false;
    has_thread = !has_thread;
    if (!is_in(&layer->buf_area, &obj->coords)) {
        add_task(&screen, layer->buf_area, 0x11);
        add_task(&style, obj->coords, 0x22);
    }
    if (obj->coords.y1 <= layer->buf_area.y2 && obj->coords.y2 >= layer->buf_area.y1) cb(&event);
    add_task(&above, nowhere, 0);
    finish();
}

static void draw_stripe(lv_layer_t *layer, lv_obj_t *obj, lv_event_cb_t cb, void *user_data)
{
    lv_image_header_t *const header = &layer->draw_buf->header;

    header->w = (uint16_t)(layer->buf_area.x2 - layer->buf_area.x1 + 1);
    header->h = (uint16_t)(layer->buf_area.y2 - layer->buf_area.y1 + 1);
    header->stride = (uint16_t)((header->w * 2u + 3) / 4 * 4); /* a line begins at a multiple of 4 bytes */
    memset(layer->draw_buf->data, 0x5A, header->h * header->stride + 8u);
    layer->_clip_area = layer->buf_area;
    draw_tasks(layer, obj, cb, user_data);
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
