/* @name@ in an endless orbit, as a widget of LVGL 9: call @scene@_view(lv_screen_active()) after the display is there. */
#include "@name@.h"
#include "limner_lvgl.h"

@SCENE@_MEMORY(@W@, @H@);
static struct lim_camera camera;
static struct limner_lvgl view;
static lv_obj_t *said;

static int draw(void)
{
    return lim_frame(@scene@_memory.lim, &camera);
}

/* An error is shown in the place of the picture. */
static void turn(lv_timer_t *timer)
{
    static const int32_t target_q8[3] = @SCENE@_POINT_Q8(@TARGET_M@);

    lim_orbit(&camera, target_q8, @SCENE@_M_Q8(@ORBIT_M@), lv_tick_get() * (LIM_DEGREES(45) / 1000), LIM_DEGREES(-20));
    lv_obj_invalidate((lv_obj_t *)lv_timer_get_user_data(timer));
    if (view.err) lv_label_set_text_fmt(said, "limner: error %d", view.err);
}

lv_obj_t *@scene@_view(lv_obj_t *parent)
{
    lv_obj_t *const obj = lv_obj_create(parent);

    lv_obj_remove_style_all(obj);
    lv_obj_set_size(obj, @W@, @H@);
    said = lv_label_create(obj);
    lv_label_set_text(said, "");
    view.frame = draw;
    camera.near_q8 = @SCENE@_M_Q8(@ORBIT_M@ / 20.0);
    view.err = limner_lvgl_begin(&view, &@scene@_memory, &@scene@_scene, @SCENE@_SCENE_METHOD);
    if (!view.err) view.err = lim_camera_set_fov(&camera, LIM_DEGREES(@LENS@), @W@, @H@);
    if (!view.err) lv_obj_add_event_cb(obj, limner_lvgl_draw, LV_EVENT_DRAW_MAIN, &view);
    lv_timer_create(turn, 33, obj);
    return obj;
}
