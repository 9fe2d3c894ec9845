/* SPDX-License-Identifier: MIT
 *
 * A fake of LVGL with the types and signatures of its headers (9.5.0), as far as a widget that paints by itself needs
 * them: it draws stripe by stripe, notes down what is to be painted, and paints it when it is dispatched (fake_lvgl.c).
 */
#ifndef LVGL_H
#define LVGL_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define LVGL_VERSION_MAJOR 9
#define LVGL_VERSION_MINOR 5
#define LV_MIN(a, b) ((a) < (b) ? (a) : (b))
#define LV_MAX(a, b) ((a) > (b) ? (a) : (b))

typedef enum {
    LV_COLOR_FORMAT_UNKNOWN = 0,
    LV_COLOR_FORMAT_RGB888 = 0x0F,
    LV_COLOR_FORMAT_RGB565 = 0x12,
    LV_COLOR_FORMAT_RGB565_SWAPPED = 0x1B
} lv_color_format_t;

typedef enum { LV_EVENT_DRAW_MAIN = 28 } lv_event_code_t;

typedef struct {
    int32_t x1, y1, x2, y2;
} lv_area_t;

typedef struct {
    uint32_t magic : 8;
    uint32_t cf : 8;
    uint32_t flags : 16;
    uint32_t w : 16;
    uint32_t h : 16;
    uint32_t stride : 16;
    uint32_t reserved_2 : 16;
} lv_image_header_t;

typedef struct {
    lv_image_header_t header;
    uint32_t data_size;
    uint8_t *data;
} lv_draw_buf_t;

typedef struct _lv_draw_task_t lv_draw_task_t;

typedef struct _lv_layer_t {
    lv_draw_buf_t *draw_buf;
    lv_draw_task_t *draw_task_head;
    lv_area_t buf_area;
    lv_area_t _clip_area;
} lv_layer_t;

typedef struct _lv_obj_t lv_obj_t;
typedef struct _lv_event_t lv_event_t;
typedef void (*lv_event_cb_t)(lv_event_t *e);

void *lv_event_get_user_data(lv_event_t *e);
void *lv_event_get_target(lv_event_t *e);
lv_layer_t *lv_event_get_layer(lv_event_t *e);
void lv_obj_get_coords(const lv_obj_t *obj, lv_area_t *coords);
void *lv_draw_layer_go_to_xy(lv_layer_t *layer, int32_t x, int32_t y);
void lv_draw_dispatch_wait_for_request(void);
void lv_draw_dispatch(void);

typedef struct _lv_timer_t lv_timer_t;
typedef void (*lv_timer_cb_t)(lv_timer_t *timer);

/* For the example alone, which is compiled and not run. */
lv_obj_t *lv_obj_create(lv_obj_t *parent);
void lv_obj_remove_style_all(lv_obj_t *obj);
void lv_obj_set_size(lv_obj_t *obj, int32_t w, int32_t h);
void lv_obj_invalidate(const lv_obj_t *obj);
void *lv_obj_add_event_cb(lv_obj_t *obj, lv_event_cb_t event_cb, lv_event_code_t filter, void *user_data);
lv_obj_t *lv_label_create(lv_obj_t *parent);
void lv_label_set_text(lv_obj_t *obj, const char *text);
void lv_label_set_text_fmt(lv_obj_t *obj, const char *fmt, ...) __attribute__((format(printf, 2, 3)));
lv_timer_t *lv_timer_create(lv_timer_cb_t timer_xcb, uint32_t period, void *user_data);
void *lv_timer_get_user_data(lv_timer_t *timer);
uint32_t lv_tick_get(void);

/* The fake: redraws an area, `rows` lines at a time, in a format, of a screen with one widget at `coords`; the stripes
 * go to the fake display. */
void fake_lvgl_refresh(lv_color_format_t cf, int32_t rows, lv_area_t area, lv_area_t coords, lv_event_cb_t cb,
                       void *user_data);

#ifdef __cplusplus
}
#endif

#endif
