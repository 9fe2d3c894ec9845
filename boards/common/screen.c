/* SPDX-License-Identifier: MIT
 *
 * A panel as the renderer's target.
 * In: pieces of lines, from the renderer. Out: windows and pixels, to the panel. Memory: the
 * caller's lines. A line whose pixels may still be on their way is never lent: with two lines, a
 * panel that accepts the second has finished with the first; with one, done() waits. */
#include "screen.h"

enum { BYTES_A_PIXEL = 2 };

/* The painter finds every line at its own place; nearest first takes turns. */
static uint8_t *screen_line(const struct screen *screen, uint16_t y_px)
{
    uint16_t index = screen->target.method == LIM_PAINTER ? y_px : screen->lent_line;
    return screen->mem + (size_t)index * screen->line_b;
}

static void *screen_lend(void *ctx, uint16_t y_px)
{
    struct screen *screen = ctx;
    if (y_px >= screen->target.h_px) return NULL;
    if (screen->lent_line_sent) {
        screen->lent_line = (uint16_t)((screen->lent_line + 1u) % screen->n_lines);
        screen->lent_line_sent = false;
    }
    return screen_line(screen, y_px);
}

/* From a line's start the window takes all the lines below as well, from its middle only the rest
 * of the line: what follows usually fits, and a window need not be filled. */
static int screen_open_window(struct screen *screen, uint16_t x_px, uint16_t y_px)
{
    uint16_t w_px = (uint16_t)(screen->target.w_px - x_px);
    uint16_t h_px = x_px == 0 ? (uint16_t)(screen->target.h_px - y_px) : 1;
    int err = panel_window(screen->panel, x_px, y_px, w_px, h_px);
    if (err) return err;
    screen->window_open = true;
    screen->window_end_y_px = (uint16_t)(y_px + h_px);
    screen->next_x_px = x_px;
    screen->next_y_px = y_px;
    return 0;
}

static void screen_advance(struct screen *screen, uint16_t n_px)
{
    screen->next_x_px = (uint16_t)(screen->next_x_px + n_px);
    if (screen->next_x_px < screen->target.w_px) return;
    screen->next_x_px = 0;
    screen->next_y_px++;
    if (screen->next_y_px == screen->window_end_y_px) screen->window_open = false;
}

static int screen_send(struct screen *screen, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    bool continues = screen->window_open && screen->next_x_px == x_px && screen->next_y_px == y_px;
    if (!continues) {
        int err = screen_open_window(screen, x_px, y_px);
        if (err) return err;
    }
    screen->lent_line_sent = true;
    int err = panel_pixels(screen->panel, screen_line(screen, y_px) + (size_t)x_px * BYTES_A_PIXEL, n_px);
    if (err) return err;
    screen_advance(screen, n_px);
    return screen->n_lines == 1 ? panel_flush(screen->panel) : 0;
}

static int screen_done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct screen *screen = ctx;
    LIM_ASSERT(y_px < screen->target.h_px && x_px <= screen->target.w_px && n_px <= screen->target.w_px - x_px);
    if (n_px == 0) return 0;
    int err = screen_send(screen, y_px, x_px, n_px);
    if (err) screen->window_open = false;
    return err;
}

int screen_init(struct screen *screen, struct panel *panel, enum lim_method method, void *mem, size_t mem_b)
{
    uint16_t line_b = (uint16_t)SCREEN_LINE_B(panel->w_px);
    uint16_t most_lines = method == LIM_PAINTER ? panel->h_px : 2;
    size_t n_lines = mem_b / line_b;
    if (n_lines == 0 || (method == LIM_PAINTER && n_lines < panel->h_px)) return LIM_ERR_MEMORY;

    *screen = (struct screen){.panel = panel, .mem = mem, .line_b = line_b};
    screen->n_lines = n_lines < most_lines ? (uint16_t)n_lines : most_lines;
    screen->target = (struct lim_target){
        .w_px = panel->w_px,
        .h_px = panel->h_px,
        .format = panel->format,
        .method = method,
        .ctx = screen,
        .lend = screen_lend,
        .done = screen_done,
    };
    return 0;
}

void screen_begin_frame(struct screen *screen)
{
    screen->window_open = false;
}

int screen_end_frame(struct screen *screen)
{
    return panel_flush(screen->panel);
}
