/* @name@ on @panel@: all of a program but board_wires(), which is yours. */
#include "@name@_display.h"

/* Fills the bus, the pins and the clock that the display hangs on (limner_display.h). 0, or a negative error. */
int board_wires(struct board *board, uint32_t spi_hz, uint8_t spi_modes);

static struct board board;
static struct lim_camera camera = {
    {0, 0, 0}, 0, 0, 0, @NAME@_DISPLAY_TAN_X_Q28, @NAME@_DISPLAY_TAN_Y_Q28, @SCENE@_M_Q8(@NEAR_M@)};

int main(void)
{
    static const int32_t target_q8[3] = @SCENE@_POINT_Q8(@TARGET_M@);

    int err = board_wires(&board, @NAME@_DISPLAY_HZ, @NAME@_DISPLAY_SPI_MODES);
    if (!err) err = @name@_display_begin(&board);
    for (uint32_t time_ms = 0; !err; time_ms += 40) {
        lim_orbit(&camera, target_q8, @SCENE@_M_Q8(@ORBIT_M@), time_ms / 40 * LIM_DEGREES(3), LIM_DEGREES(-25));
        err = @name@_display_frame(&camera, time_ms);
    }
    return err; /* limner_display.h and limner.h say what it is */
}
