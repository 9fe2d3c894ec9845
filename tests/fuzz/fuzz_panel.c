/* SPDX-License-Identifier: MIT */
#include "fuzz_panel.h"

#include <stdlib.h>
#include <string.h>

enum { BESIDE = 0x5AA5, PAGE_PX = 8 };

static void breaks(struct fuzz_panel *panel, const char *promise)
{
    if (!panel->broken) panel->broken = promise;
}

static bool fails(struct fuzz_panel *panel)
{
    panel->failed |= ++panel->calls == panel->fails_at;
    return panel->calls == panel->fails_at;
}

static void *lend(void *ctx, uint16_t y_px)
{
    struct fuzz_panel *panel = ctx;

    if (y_px >= panel->target.h_px) {
        breaks(panel, "a line was asked for that is not there");
        return NULL;
    }
    if (panel->target.fill && !panel->target.show) breaks(panel, "a line was asked for of a target that keeps it");
    return fails(panel) ? NULL : panel->lines[y_px];
}

static void show(struct fuzz_panel *panel, uint16_t y_px, const uint16_t *line, uint16_t x_px, uint16_t n_px)
{
    memcpy(&panel->shown[y_px][x_px], &line[x_px], n_px * sizeof *line);
    for (uint16_t x = x_px; x < x_px + n_px; x++)
        if (panel->done[y_px][x] < UINT8_MAX) panel->done[y_px][x]++;
}

/* The last line of a page sends it as far as that line reaches. */
static void take_page(struct fuzz_panel *panel, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    memcpy(&panel->page[y_px % PAGE_PX][x_px], &panel->lines[y_px][x_px], n_px * sizeof(uint16_t));
    for (uint16_t k = 0; k < PAGE_PX && y_px % PAGE_PX == PAGE_PX - 1; k++)
        show(panel, (uint16_t)(y_px - (PAGE_PX - 1) + k), panel->page[k], x_px, n_px);
}

/* A window is filled row by row. */
static void go_on(struct fuzz_panel *panel, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    if (y_px != panel->y || x_px != panel->x || x_px + n_px > panel->window.x1 || y_px >= panel->window.y1)
        breaks(panel, "pixels came in another order than the window's");
    panel->x = (uint16_t)(panel->x + n_px);
    if (panel->x < panel->window.x1) return;
    panel->x = panel->window.x0;
    panel->y++;
}

static int done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct fuzz_panel *panel = ctx;

    if (fails(panel)) return FUZZ_PANEL_ERROR;
    if (y_px >= panel->target.h_px || x_px + n_px > panel->target.w_px) {
        breaks(panel, "pixels beside the picture are said to be final");
        return 0;
    }
    if (panel->target.costs.page_px == PAGE_PX) {
        take_page(panel, y_px, x_px, n_px);
        return 0;
    }
    if (panel->in_window) go_on(panel, y_px, x_px, n_px);
    show(panel, y_px, panel->lines[y_px], x_px, n_px);
    return 0;
}

static int window(void *ctx, const struct lim_rect *opened)
{
    struct fuzz_panel *panel = ctx;

    if (fails(panel)) return FUZZ_PANEL_ERROR;
    panel->in_window = opened != NULL;
    if (!opened) return 0;
    if (opened->x0 >= opened->x1 || opened->y0 >= opened->y1 || opened->x1 > panel->target.w_px ||
        opened->y1 > panel->target.h_px || panel->target.costs.page_px != 1)
        breaks(panel, "a window beside the picture, or of nothing, or of a display that has pages");
    panel->window = *opened;
    panel->x = opened->x0;
    panel->y = opened->y0;
    return 0;
}

static void fill_line(void *of_look, uint16_t x0_px, uint16_t x1_px)
{
    const struct lim_piece_look *look = of_look;
    struct fuzz_panel *panel = look->ctx;

    if (look->y_px >= panel->target.h_px || x1_px > panel->target.w_px) {
        breaks(panel, "a piece beside the picture");
        return;
    }
    for (uint16_t x = x0_px; x < x1_px; x++)
        panel->lines[look->y_px][x] = look->colour;
}

static void fill(void *of_look, uint16_t x0_px, uint16_t x1_px)
{
    const struct lim_piece_look *look = of_look;
    struct fuzz_panel *panel = look->ctx;
    uint16_t x0, x1;

    if (look->y_px >= panel->target.h_px) {
        breaks(panel, "a piece beside the picture");
        return;
    }
    fuzz_panel_visible(panel, look->y_px, &x0, &x1);
    if (x0_px < x0 || x1_px > x1) {
        breaks(panel, "a piece that cannot be seen");
        return;
    }
    for (uint16_t x = x0_px; x < x1_px; x++)
        panel->kept[(size_t)look->y_px * panel->target.w_px + x] = look->colour;
}

static int show_kept(void *ctx)
{
    struct fuzz_panel *panel = ctx;

    if (fails(panel)) return FUZZ_PANEL_ERROR;
    for (uint16_t y = 0; y < panel->target.h_px; y++)
        show(panel, y, &panel->kept[(size_t)y * panel->target.w_px], 0, panel->target.w_px);
    return 0;
}

static void visible(void *ctx, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px)
{
    struct fuzz_panel *panel = ctx;

    if (y_px >= panel->target.h_px) breaks(panel, "it was asked what of a line is seen that is not there");
    fuzz_panel_visible(panel, y_px, x0_px, x1_px);
}

void fuzz_panel_visible(const struct fuzz_panel *panel, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px)
{
    const uint16_t w_px = panel->target.w_px, cut = (uint16_t)abs((int)y_px - panel->target.h_px / 2);

    *x0_px = 0;
    *x1_px = w_px;
    if (!panel->is_round) return;
    *x0_px = cut < w_px ? cut : w_px;
    *x1_px = (uint16_t)(w_px - cut / 2) > *x0_px && cut / 2 < w_px ? (uint16_t)(w_px - cut / 2) : *x0_px;
}

static void take_memory(struct fuzz_panel *panel, enum fuzz_sink sink)
{
    const uint16_t w_px = panel->target.w_px, h_px = panel->target.h_px, stride_px = (uint16_t)((w_px + 3) & ~1);

    panel->kept = malloc((size_t)w_px * h_px * sizeof *panel->kept);
    if (sink != FUZZ_SINK_FRAMEBUFFER) {
        for (uint16_t y = 0; y < h_px; y++)
            panel->lines[y] = malloc(w_px * sizeof *panel->lines[y]);
        return;
    }
    panel->lines[0] = malloc((size_t)stride_px * h_px * sizeof *panel->lines[0]);
    for (uint16_t y = 1; y < h_px; y++)
        panel->lines[y] = panel->lines[y - 1] + stride_px;
    panel->target.framebuffer = (struct lim_framebuffer){panel->lines[0], stride_px};
}

void fuzz_panel_init(struct fuzz_panel *panel, uint16_t w_px, uint16_t h_px, enum fuzz_sink sink, bool is_round,
                     uint8_t page_px)
{
    memset(panel, 0, sizeof *panel);
    panel->is_round = is_round;
    panel->target =
        (struct lim_target){.w_px = w_px,
                            .h_px = h_px,
                            .format = LIM_RGB565,
                            .ctx = panel,
                            .lend = lend,
                            .done = done,
                            .visible = is_round ? visible : NULL,
                            .fill = sink == FUZZ_SINK_PIECES ? fill
                                    : sink == FUZZ_SINK_RUNS ? fill_line
                                                             : NULL,
                            .show = sink == FUZZ_SINK_PIECES ? show_kept : NULL,
                            .window = page_px ? window : NULL,
                            .costs = {.window_b = 11, .pixel_bits = 16, .page_px = page_px, .x_align_px = 1}};
    take_memory(panel, sink);
}

void fuzz_panel_begin(struct fuzz_panel *panel, uint16_t unpainted, uint32_t fails_at)
{
    const uint16_t w_px = panel->target.w_px, stride_px = panel->target.framebuffer.stride_px;

    memset(panel->done, 0, sizeof panel->done);
    panel->unpainted = unpainted;
    panel->in_window = panel->failed = false;
    panel->calls = 0;
    panel->fails_at = fails_at;
    for (uint16_t y = 0; y < panel->target.h_px; y++) {
        for (uint16_t x = 0; x < w_px; x++)
            panel->lines[y][x] = panel->kept[(size_t)y * w_px + x] = unpainted;
        for (uint16_t x = w_px; x < stride_px; x++)
            panel->lines[y][x] = BESIDE;
    }
}

static const char *check_line(const struct fuzz_panel *panel, uint16_t y, bool is_painted)
{
    uint16_t x0, x1;

    fuzz_panel_visible(panel, y, &x0, &x1);
    for (uint16_t x = x0; x < x1; x++) {
        if (!panel->target.window && panel->done[y][x] != 1) return "a pixel was not final once";
        if (is_painted && panel->shown[y][x] == panel->unpainted) return "a pixel was not painted";
    }
    for (uint16_t x = panel->target.w_px; x < panel->target.framebuffer.stride_px; x++)
        if (panel->lines[y][x] != BESIDE) return "something was painted beside the framebuffer's lines";
    return NULL;
}

const char *fuzz_panel_check(const struct fuzz_panel *panel, bool is_painted)
{
    const char *broken = panel->broken;

    for (uint16_t y = 0; !broken && y < panel->target.h_px; y++)
        broken = check_line(panel, y, is_painted);
    return broken;
}

bool fuzz_panel_is_same(const struct fuzz_panel *a, const struct fuzz_panel *b)
{
    for (uint16_t y = 0; y < a->target.h_px; y++) {
        uint16_t x0, x1;
        fuzz_panel_visible(a->is_round ? a : b, y, &x0, &x1);
        if (memcmp(&a->shown[y][x0], &b->shown[y][x0], (size_t)(x1 - x0) * sizeof a->shown[0][0]) != 0) return false;
    }
    return true;
}

void fuzz_panel_free(struct fuzz_panel *panel)
{
    free(panel->kept);
    for (uint16_t y = 0; y < panel->target.h_px && (y == 0 || !panel->target.framebuffer.pixels); y++)
        free(panel->lines[y]);
}
