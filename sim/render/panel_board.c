/* SPDX-License-Identifier: MIT
 *
 * Glass in the middle of the chip's memory, and of the kind that shows negatives, so that a driver
 * that forgets inversion or the offset shows. */
#include "render/panel_board.h"

#include "linux/code_words.h"

#include <stdlib.h>

static uint16_t in_the_middle(unsigned free_px, uint16_t step_px)
{
    return (uint16_t)(free_px / 2 / step_px * step_px);
}

static struct display_module upright_module(const struct panel_choice *choice, unsigned w_px, unsigned h_px)
{
    return (struct display_module){.w_px = (uint16_t)w_px,
                                   .h_px = (uint16_t)h_px,
                                   .ox_px = in_the_middle(choice->mem_w_px - w_px, choice->w_step_px),
                                   .oy_px = in_the_middle(choice->mem_h_px - h_px, choice->h_step_px),
                                   .invert = true};
}

/* What the chip cannot turn a board's camera does, so that the glass shows something else than the picture. */
static bool turns_itself(const struct panel_choice *choice, struct error *err)
{
    if (panel_rotation_exchanges(choice->rotation) ? choice->exchanges : choice->flips) return true;
    return error_set(err, "--rotate: %s turns no pictures so, boards turn their camera; --panel memory draws it",
                     choice->name);
}

/* The picture is turned as somebody said, or lies where it does not fit otherwise. */
static enum panel_rotation rotation_of(const struct panel_choice *choice, unsigned w_px, unsigned h_px)
{
    const bool stands = w_px <= choice->mem_w_px && h_px <= choice->mem_h_px;
    const bool can_lie = choice->exchanges && h_px <= choice->mem_w_px && w_px <= choice->mem_h_px;
    if (choice->rotation != PANEL_UPRIGHT) return choice->rotation;
    return !stands && can_lie ? PANEL_TURNED_90 : PANEL_UPRIGHT;
}

static bool module_of(const struct panel_choice *choice, unsigned w_px, unsigned h_px, struct display_module *out,
                      struct error *err)
{
    const enum panel_rotation rotation = rotation_of(choice, w_px, h_px);
    *out = panel_rotation_exchanges(rotation) ? upright_module(choice, h_px, w_px) : upright_module(choice, w_px, h_px);
    out->rotation = rotation;
    return (choice->rotation == PANEL_UPRIGHT || turns_itself(choice, err)) && display_module_check(choice, out, err);
}

bool panel_board_holds(const struct panel_choice *choice, unsigned w_px, unsigned h_px, struct error *err)
{
    struct display_module module;
    return module_of(choice, w_px, h_px, &module, err);
}

bool panel_board_init(struct panel_board *board, const struct panel_choice *choice, enum lim_method method,
                      unsigned w_px, unsigned h_px, struct error *err)
{
    struct display_module module;
    const size_t lines_b = SCREEN_WIDE_MEM_B(w_px, method == LIM_PAINTER ? h_px : 2) + 2 * SCREEN_PAGE_B(w_px);
    if (!module_of(choice, w_px, h_px, &module, err)) return false;
    board->glass = module;
    board->name = choice->name;
    board->lines = malloc(lines_b);
    board->seen = malloc((size_t)3 * w_px * h_px);
    if (!board->lines || !board->seen) {
        panel_board_free(board);
        return error_set(err, "emulated %s: out of memory", board->name);
    }
    emulated_display_choose(&board->module, choice, &module);
    const struct port port = emulated_port_whole(board->module.port);
    if (!display_setup(&board->display, choice, &module, &port, err)) {
        panel_board_free(board);
        return false;
    }
    int code = panel_init(board->display.panel);
    if (!code) code = screen_init(&board->screen, board->display.panel, method, board->lines, lines_b);
    if (!code) return true;
    panel_board_free(board);
    return error_set(err, "emulated %s: %s (%d)", board->name, code_words(code), code);
}

uint64_t panel_board_bus_b(const struct panel_board *board)
{
    return board->module.port->bus_b;
}

bool panel_board_read(struct panel_board *board, uint16_t *pixels, struct error *err)
{
    if (!emulated_display_is_quiet(&board->module, err)) return false;
    emulated_display_read(&board->module, &board->glass, board->seen, pixels);
    return true;
}

void panel_board_free(struct panel_board *board)
{
    free(board->lines);
    free(board->seen);
    board->lines = NULL;
    board->seen = NULL;
}
