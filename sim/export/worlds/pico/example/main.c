/* @name@ on @panel@: the pins of the Pico's first SPI. */
#include "@name@_display.h"
#include "limner_pico.h"
#include "pico/stdlib.h"

static struct limner_pico wires = {
    .spi = spi0, .sck = 18, .tx = 19, .cs = @cs_17@, .dc = 16, .reset = 22, .backlight = 20, .select = @select_17@};
static struct board board;
static struct lim_camera camera = {
    {0, 0, 0}, 0, 0, 0, @NAME@_DISPLAY_TAN_X_Q28, @NAME@_DISPLAY_TAN_Y_Q28, @SCENE@_M_Q8(@NEAR_M@)};

int main(void)
{
    static const int32_t target_q8[3] = @SCENE@_POINT_Q8(@TARGET_M@);

    limner_pico_board(&wires, &board, @NAME@_DISPLAY_HZ, @NAME@_DISPLAY_SPI_MODES);
    int err = @name@_display_begin(&board);
    for (uint32_t yaw = 0; !err; yaw += LIM_DEGREES(3)) {
        lim_orbit(&camera, target_q8, @SCENE@_M_Q8(@ORBIT_M@), yaw, LIM_DEGREES(-25));
        err = @name@_display_frame(&camera, to_ms_since_boot(get_absolute_time()));
    }
    panic("@name@: error %d; limner_display.h and limner.h say what it is", err);
}
