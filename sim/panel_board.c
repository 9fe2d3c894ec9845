/* SPDX-License-Identifier: MIT
 *
 * Glass in the middle of the chip's memory, of the usual kind: IPS, so that a driver that forgets
 * inversion or the offset shows. The bus reads late, as DMA does, so that a line painted over
 * before it was sent shows as well. */
#include "panel_board.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const formats[PANEL_FORMATS] = {"rgb565", "rgb444", "rgb666"};

static bool refuse_panel(const char *text, struct error *err)
{
    char names[128] = "";
    for (size_t i = 0; panels_dcs[i]; i++) {
        strcat(names, panels_dcs[i]->name);
        strcat(names, ", ");
    }
    return error_set(err, "--panel %s: no such panel; there are %sand memory", text, names);
}

static bool parse_format(const char *text, struct panel_choice *out, struct error *err)
{
    char names[64] = "";
    for (int i = 0; i < PANEL_FORMATS; i++) {
        if (!(out->chip->formats >> i & 1)) continue;
        out->format = (enum panel_format)i;
        if (strcmp(text, formats[i]) == 0) return true;
        if (names[0]) strcat(names, ", ");
        strcat(names, formats[i]);
    }
    return error_set(err, "--panel %s:%s: it does not take that format; there are %s", out->chip->name, text, names);
}

bool panel_choice_parse(const char *text, struct panel_choice *out, struct error *err)
{
    const char *colon = strchr(text, ':');
    const size_t length = colon ? (size_t)(colon - text) : strlen(text);
    for (size_t i = 0; panels_dcs[i]; i++) {
        const char *name = panels_dcs[i]->name;
        if (strlen(name) != length || strncmp(name, text, length) != 0) continue;
        *out = (struct panel_choice){panels_dcs[i], panels_dcs[i]->format};
        return !colon || parse_format(colon + 1, out, err);
    }
    return refuse_panel(text, err);
}

bool panel_board_holds(const struct panel_choice *choice, unsigned w_px, unsigned h_px)
{
    return w_px <= choice->chip->mem_w_px && h_px <= choice->chip->mem_h_px;
}

static int switch_on(struct panel_board *board, const struct panel_choice *choice, const struct emulated_module *module)
{
    emulated_dcs_init(&board->chip, module);
    board->chip.deferred = true;
    const struct dcs_config config = {.bus = emulated_dcs_bus(&board->chip),
                                      .dc = emulated_dcs_dc(&board->chip),
                                      .reset = emulated_dcs_reset(&board->chip),
                                      .backlight = emulated_dcs_backlight(&board->chip),
                                      .clock = emulated_dcs_clock(&board->chip),
                                      .w_px = module->w_px,
                                      .h_px = module->h_px,
                                      .ox_px = module->ox_px,
                                      .oy_px = module->oy_px,
                                      .invert = module->ips,
                                      .other_format = true,
                                      .format = choice->format};
    int err = dcs_setup(&board->display, choice->chip, &config);
    if (err) return err;
    return panel_init(&board->display.panel);
}

bool panel_board_init(struct panel_board *board, const struct panel_choice *choice, enum lim_method method,
                      unsigned w_px, unsigned h_px, struct error *err)
{
    const struct dcs_chip *chip = choice->chip;
    const struct emulated_module module = {.kind = emulated_kind_find(chip->name),
                                           .w_px = (uint16_t)w_px,
                                           .h_px = (uint16_t)h_px,
                                           .ox_px = (uint16_t)((chip->mem_w_px - w_px) / 2),
                                           .oy_px = (uint16_t)((chip->mem_h_px - h_px) / 2),
                                           .ips = true};
    const size_t lines_b = SCREEN_WIDE_MEM_B(w_px, method == LIM_PAINTER ? h_px : 2);
    board->lines = malloc(lines_b);
    board->seen = malloc((size_t)3 * w_px * h_px);
    if (!board->lines || !board->seen) {
        panel_board_free(board);
        return error_set(err, "emulated %s: out of memory", chip->name);
    }
    int code = switch_on(board, choice, &module);
    if (!code) code = screen_init(&board->screen, &board->display.panel, method, board->lines, lines_b);
    if (!code) return true;
    panel_board_free(board);
    return error_set(err, "emulated %s: the driver failed with %d", chip->name, code);
}

bool panel_board_read(struct panel_board *board, uint16_t *pixels, struct error *err)
{
    if (board->chip.complaints > 0)
        return error_set(err, "emulated %s: %u complaints, the last: %s", board->chip.kind->name,
                         board->chip.complaints, board->chip.complaint);
    emulated_dcs_show(&board->chip, 0, board->seen, NULL);
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
