/* SPDX-License-Identifier: MIT
 *
 * Glass in the middle of the chip's memory, of the usual kind: IPS, so that a driver that forgets
 * inversion or the offset shows. The bus reads late, as DMA does, so that a line painted over
 * before it was sent shows as well. */
#include "panel_board.h"

#include <stdlib.h>

bool panel_board_holds(unsigned w_px, unsigned h_px)
{
    return w_px <= EMULATED_ST7789_W_PX && h_px <= EMULATED_ST7789_H_PX;
}

static int switch_on(struct panel_board *board, const struct emulated_module *module)
{
    emulated_st7789_init(&board->chip, module);
    board->chip.deferred = true;
    const struct dcs_config config = {.bus = emulated_st7789_bus(&board->chip),
                                      .dc = emulated_st7789_dc(&board->chip),
                                      .reset = emulated_st7789_reset(&board->chip),
                                      .backlight = emulated_st7789_backlight(&board->chip),
                                      .clock = emulated_st7789_clock(&board->chip),
                                      .w_px = module->w_px,
                                      .h_px = module->h_px,
                                      .ox_px = module->ox_px,
                                      .oy_px = module->oy_px,
                                      .invert = module->ips};
    int err = st7789_setup(&board->display, &config);
    if (err) return err;
    return panel_init(&board->display.panel);
}

bool panel_board_init(struct panel_board *board, enum lim_method method, unsigned w_px, unsigned h_px,
                      struct error *err)
{
    const struct emulated_module module = {.w_px = (uint16_t)w_px,
                                           .h_px = (uint16_t)h_px,
                                           .ox_px = (uint16_t)((EMULATED_ST7789_W_PX - w_px) / 2),
                                           .oy_px = (uint16_t)((EMULATED_ST7789_H_PX - h_px) / 2),
                                           .ips = true};
    const size_t lines_b = SCREEN_MEM_B(w_px, method == LIM_PAINTER ? h_px : 2);
    board->lines = malloc(lines_b);
    board->seen = malloc((size_t)3 * w_px * h_px);
    if (!board->lines || !board->seen) {
        panel_board_free(board);
        return error_set(err, "emulated st7789: out of memory");
    }
    int code = switch_on(board, &module);
    if (!code) code = screen_init(&board->screen, &board->display.panel, method, board->lines, lines_b);
    if (!code) return true;
    panel_board_free(board);
    return error_set(err, "emulated st7789: the driver failed with %d", code);
}

bool panel_board_read(struct panel_board *board, uint16_t *pixels, struct error *err)
{
    if (board->chip.complaints > 0)
        return error_set(err, "emulated st7789: %u complaints, the last: %s", board->chip.complaints,
                         board->chip.complaint);
    emulated_st7789_show(&board->chip, 0, board->seen, NULL);
    const size_t pixel_count = (size_t)board->display.panel.w_px * board->display.panel.h_px;
    for (size_t i = 0; i < pixel_count; i++) {
        const uint8_t *rgb = &board->seen[3 * i];
        pixels[i] = (uint16_t)((rgb[0] >> 3) << 11 | (rgb[1] >> 2) << 5 | rgb[2] >> 3);
    }
    return true;
}

void panel_board_free(struct panel_board *board)
{
    free(board->lines);
    free(board->seen);
    board->lines = NULL;
    board->seen = NULL;
}
