/* @name@ on @panel@: pins that most ESP32s have free. */
#include "@name@_display.h"
#include "limner_idf.h"

#include "esp_log.h"
#include "esp_timer.h"

static struct limner_idf wires = {
    .host = SPI2_HOST, .sck = 6, .mosi = 7, .cs = @cs_idf@, .dc = 4, .reset = 5, .backlight = GPIO_NUM_NC, .select = @select_idf@};
static struct board board;
static struct lim_camera camera = {
    {0, 0, 0}, 0, 0, 0, @NAME@_DISPLAY_TAN_X_Q28, @NAME@_DISPLAY_TAN_Y_Q28, @SCENE@_M_Q8(@NEAR_M@)};

void app_main(void)
{
    static const int32_t target_q8[3] = @SCENE@_POINT_Q8(@TARGET_M@);

    int err = limner_idf_board(&wires, &board, @NAME@_DISPLAY_HZ, @NAME@_DISPLAY_SPI_MODES);
    if (!err) err = @name@_display_begin(&board);
    for (uint32_t yaw = 0; !err; yaw += LIM_DEGREES(3)) {
        lim_orbit(&camera, target_q8, @SCENE@_M_Q8(@ORBIT_M@), yaw, LIM_DEGREES(-25));
        err = @name@_display_frame(&camera, (uint32_t)(esp_timer_get_time() / 1000));
    }
    ESP_LOGE("@name@", "error %d; limner_display.h and limner.h say what it is", err);
}
