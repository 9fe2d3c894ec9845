/* SPDX-License-Identifier: MIT
 *
 * A widget of LVGL (9.0 and later; 9.2: lvgl_private.h first), painted into the stripe that LVGL draws, without a
 * canvas: a frame without the other lines (README.md).
 *
 *     static struct limner_lvgl view = {.frame = draw}; // int draw(void): lim_frame(house_memory.lim, &camera)
 *     int err = house_begin(&house_memory, limner_lvgl_send, &view);
 *     lim_set_visible(house_memory.lim, limner_lvgl_visible); // #if LIM_HAS_ROUND: lines above a stripe cost less
 *     lv_obj_t *obj = lv_obj_create(parent); // of the picture's size; lv_obj_invalidate(obj) for the next frame
 *     lv_obj_add_event_cb(obj, limner_lvgl_draw, LV_EVENT_DRAW_MAIN, &view); */
#ifndef LIMNER_LVGL_H
#define LIMNER_LVGL_H
#include "limner.h"
#include "lvgl.h"
enum { LIMNER_LVGL_ENOUGH = -4001 }; /* ends a frame below its stripe */

struct limner_lvgl {
    int (*frame)(void);
    int err; /* the last one, or 0: what frame() returned, or LIM_ERR_TARGET: LVGL's format there is not RGB565 */
    lv_layer_t *layer;  /* private, as is what follows */
    lv_area_t obj, cut; /* the widget, and what of it is drawn */
};

static inline int limner_lvgl_send(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px)
{
    const struct limner_lvgl *const to = (const struct limner_lvgl *)ctx;
    const lv_layer_t *const on = to->layer;
    const int swap = on->draw_buf->header.cf == LV_COLOR_FORMAT_RGB565; /* the byte with the blue bits first */
    const int32_t y = to->obj.y1 + y_px, x0 = to->obj.x1 + x_px;
    const int32_t begin = LV_MAX(to->cut.x1 - x0, 0), end = LV_MIN(to->cut.x2 + 1 - x0, n_px);
    if (y > to->cut.y2) return LIMNER_LVGL_ENOUGH;
    if (y < to->cut.y1 || begin >= end) return LIM_OK;
    uint8_t *out = (uint8_t *)lv_draw_layer_go_to_xy(to->layer, x0 + begin - on->buf_area.x1, y - on->buf_area.y1);
    for (int32_t i = 2 * begin; i < 2 * end; i++)
        *out++ = ((const uint8_t *)pixels)[i ^ swap];
    return LIM_OK;
}

static inline void limner_lvgl_visible(void *ctx, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px)
{
    const struct limner_lvgl *const to = (const struct limner_lvgl *)((struct lim_sender *)ctx)->ctx;
    const int32_t y = to->obj.y1 + y_px;
    *x0_px = 0, *x1_px = y >= to->cut.y1 && y <= to->cut.y2 ? UINT16_MAX : 0;
}

static inline void limner_lvgl_draw(lv_event_t *event)
{
    struct limner_lvgl *const to = (struct limner_lvgl *)lv_event_get_user_data(event);
    lv_layer_t *const on = to->layer = lv_event_get_layer(event);
    for (; on->draw_task_head; lv_draw_dispatch()) /* what lies below: LVGL only noted it down */
        lv_draw_dispatch_wait_for_request();
    lv_obj_get_coords((lv_obj_t *)lv_event_get_target(event), &to->obj);
    to->cut.x1 = LV_MAX(to->obj.x1, on->_clip_area.x1), to->cut.x2 = LV_MIN(to->obj.x2, on->_clip_area.x2);
    to->cut.y1 = LV_MAX(to->obj.y1, on->_clip_area.y1), to->cut.y2 = LV_MIN(to->obj.y2, on->_clip_area.y2);
    const uint32_t format = on->draw_buf ? on->draw_buf->header.cf : 0u;
    const bool is_16 = format == LV_COLOR_FORMAT_RGB565 || format == 0x1B; /* LV_COLOR_FORMAT_RGB565_SWAPPED, of 9.3 */
    const int err = is_16 ? to->frame() : LIM_ERR_TARGET;
    if (err && err != LIMNER_LVGL_ENOUGH) to->err = err;
}
#endif
