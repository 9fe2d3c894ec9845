/* SPDX-License-Identifier: MIT
 *
 * Shows an exported scene on its display, from every camera of cameras.h, on a board that tells what goes over its
 * wires (tests/wire_board/board.c). The LED changes with every frame. */
#include "model_display.h"

#include "cameras.h"

#ifndef TIME_MS
#define TIME_MS(frame) (((frame)*UINT32_C(1000) + 7) / 15)
#endif

int board_init(struct board *board, uint32_t spi_hz, uint8_t spi_modes);
int main(void);

int main(void)
{
    struct board board;
    int err = board_init(&board, MODEL_DISPLAY_HZ, MODEL_DISPLAY_SPI_MODES);

    if (!err) err = model_display_begin(&board);
    for (uint16_t frame = 0; !err && frame < CAMERAS_COUNT; frame++) {
        const struct lim_camera camera = cameras[frame];
        err = model_display_frame(&camera, TIME_MS(frame));
        if (!err) err = pin_set(&board.led, frame % 2 == 0);
    }
    return err != 0;
}
