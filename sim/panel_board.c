/* SPDX-License-Identifier: MIT
 *
 * Glass in the middle of the chip's memory, of the usual kind: IPS, so that a driver that forgets
 * inversion or the offset shows. The bus reads late, as DMA does, so that a line painted over
 * before it was sent shows as well. */
#include "panel_board.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const formats[PANEL_FORMATS] = {"usual", "rgb565", "rgb444", "rgb666", "pages"};

const char *panel_choice_name(const struct panel_choice *choice)
{
    return choice->pages ? choice->pages->name : choice->dcs->name;
}

static bool refuse_panel(const char *text, struct error *err)
{
    char names[256] = "";
    size_t used = 0;
    for (size_t i = 0; panels_dcs[i]; i++)
        used += (size_t)snprintf(names + used, sizeof names - used, "%s, ", panels_dcs[i]->name);
    for (size_t i = 0; panels_pages[i]; i++)
        used += (size_t)snprintf(names + used, sizeof names - used, "%s, ", panels_pages[i]->name);
    return error_set(err, "--panel %s: no such panel; there are %sand memory", text, names);
}

static bool parse_format(const char *text, struct panel_choice *out, struct error *err)
{
    char names[64] = "";
    size_t used = 0;
    for (int i = 0; i < PANEL_FORMATS; i++) {
        if (out->pages ? i != PANEL_MONO_PAGES : !(out->dcs->formats >> i & 1)) continue;
        out->format = (enum panel_format)i;
        if (strcmp(text, formats[i]) == 0) return true;
        used += (size_t)snprintf(names + used, sizeof names - used, "%s%s", used ? ", " : "", formats[i]);
    }
    return error_set(err, "--panel %s:%s: it does not take that format; there are %s", panel_choice_name(out), text,
                     names);
}

static bool find_panel(const char *name, size_t length, struct panel_choice *out)
{
    for (size_t i = 0; panels_dcs[i]; i++) {
        *out = (struct panel_choice){panels_dcs[i], NULL, panels_dcs[i]->format};
        if (strlen(panels_dcs[i]->name) == length && strncmp(panels_dcs[i]->name, name, length) == 0) return true;
    }
    for (size_t i = 0; panels_pages[i]; i++) {
        *out = (struct panel_choice){NULL, panels_pages[i], PANEL_MONO_PAGES};
        if (strlen(panels_pages[i]->name) == length && strncmp(panels_pages[i]->name, name, length) == 0) return true;
    }
    return false;
}

bool panel_choice_parse(const char *text, struct panel_choice *out, struct error *err)
{
    const char *colon = strchr(text, ':');
    if (!find_panel(text, colon ? (size_t)(colon - text) : strlen(text), out)) return refuse_panel(text, err);
    return !colon || parse_format(colon + 1, out, err);
}

bool panel_board_holds(const struct panel_choice *choice, unsigned w_px, unsigned h_px, struct error *err)
{
    const unsigned mem_w_px = choice->pages ? choice->pages->mem_w_px : choice->dcs->mem_w_px;
    const unsigned mem_h_px = choice->pages ? choice->pages->mem_h_px : choice->dcs->mem_h_px;
    if (w_px > mem_w_px || h_px > mem_h_px)
        return error_set(err, "--panel %s: %ux%u pixels do not fit into its memory of %ux%u", panel_choice_name(choice),
                         w_px, h_px, mem_w_px, mem_h_px);
    return !choice->pages || h_px % 8 == 0 ||
           error_set(err, "--panel %s: %ux%u: its pages are eight pixels high", panel_choice_name(choice), w_px, h_px);
}

static int setup_dcs(struct panel_board *board, const struct panel_choice *choice, unsigned w_px, unsigned h_px)
{
    const struct dcs_chip *chip = choice->dcs;
    const struct emulated_module module = {.kind = emulated_kind_find(chip->name),
                                           .w_px = (uint16_t)w_px,
                                           .h_px = (uint16_t)h_px,
                                           .ox_px = (uint16_t)((chip->mem_w_px - w_px) / 2),
                                           .oy_px = (uint16_t)((chip->mem_h_px - h_px) / 2),
                                           .ips = true};
    emulated_dcs_init(&board->chip, &module);
    board->chip.port.deferred = true;
    const struct dcs_config config = {.bus = emulated_port_bus(&board->chip.port),
                                      .dc = emulated_port_dc(&board->chip.port),
                                      .reset = emulated_port_reset(&board->chip.port),
                                      .backlight = emulated_port_backlight(&board->chip.port),
                                      .clock = emulated_port_clock(&board->chip.port),
                                      .w_px = module.w_px,
                                      .h_px = module.h_px,
                                      .ox_px = module.ox_px,
                                      .oy_px = module.oy_px,
                                      .invert = module.ips,
                                      .format = choice->format};
    board->panel = &board->display.panel;
    return dcs_setup(&board->display, chip, &config);
}

static int setup_pages(struct panel_board *board, const struct panel_choice *choice, unsigned w_px, unsigned h_px)
{
    const struct pages_chip *chip = choice->pages;
    const struct emulated_pages_module module = {.kind = emulated_pages_kind_find(chip->name),
                                                 .w_px = (uint16_t)w_px,
                                                 .h_px = (uint16_t)h_px,
                                                 .ox_px = (uint16_t)((chip->mem_w_px - w_px) / 2)};
    emulated_pages_init(&board->pages_chip, &module);
    board->pages_chip.port.deferred = true;
    const struct pages_config config = {.bus = emulated_port_bus(&board->pages_chip.port),
                                        .dc = emulated_port_dc(&board->pages_chip.port),
                                        .reset = emulated_port_reset(&board->pages_chip.port),
                                        .backlight = emulated_port_backlight(&board->pages_chip.port),
                                        .clock = emulated_port_clock(&board->pages_chip.port),
                                        .w_px = module.w_px,
                                        .h_px = module.h_px,
                                        .ox_px = module.ox_px};
    board->panel = &board->pages_display.panel;
    return pages_setup(&board->pages_display, chip, &config);
}

bool panel_board_init(struct panel_board *board, const struct panel_choice *choice, enum lim_method method,
                      unsigned w_px, unsigned h_px, struct error *err)
{
    const size_t lines_b = SCREEN_WIDE_MEM_B(w_px, method == LIM_PAINTER ? h_px : 2) + SCREEN_PAGES_MEM_B(w_px, 0);
    board->name = panel_choice_name(choice);
    board->lines = malloc(lines_b);
    board->seen = malloc((size_t)3 * w_px * h_px);
    if (!board->lines || !board->seen) {
        panel_board_free(board);
        return error_set(err, "emulated %s: out of memory", board->name);
    }
    int code = choice->pages ? setup_pages(board, choice, w_px, h_px) : setup_dcs(board, choice, w_px, h_px);
    if (!code) code = panel_init(board->panel);
    if (!code) code = screen_init(&board->screen, board->panel, method, board->lines, lines_b);
    if (!code) return true;
    panel_board_free(board);
    return error_set(err, "emulated %s: the driver failed with %d", board->name, code);
}

uint64_t panel_board_bus_b(const struct panel_board *board)
{
    return board->chip.port.bus_b + board->pages_chip.port.bus_b;
}

static bool is_quiet(unsigned complaints, const char *last, const char *name, struct error *err)
{
    return complaints == 0 || error_set(err, "emulated %s: %u complaints, the last: %s", name, complaints, last);
}

static void read_pages(const struct panel_board *board, uint16_t *pixels)
{
    for (unsigned i = 0; i < (unsigned)board->panel->w_px * board->panel->h_px; i++)
        pixels[i] =
            emulated_pages_is_bright(&board->pages_chip, i % board->panel->w_px, i / board->panel->w_px) ? 0xFFFF : 0;
}

bool panel_board_read(struct panel_board *board, uint16_t *pixels, struct error *err)
{
    if (!is_quiet(board->chip.complaints, board->chip.complaint, board->name, err) ||
        !is_quiet(board->pages_chip.complaints, board->pages_chip.complaint, board->name, err))
        return false;
    if (board->panel == &board->pages_display.panel) {
        read_pages(board, pixels);
        return true;
    }
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
