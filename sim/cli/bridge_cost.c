/* SPDX-License-Identifier: MIT */
#include "cli/bridge_cost.h"

enum { PIECE_PX = 960 }; /* whole bytes in every format */

static int send_window(struct panel *panel, const struct bridge_window *window)
{
    static const uint8_t pixels[PIECE_PX * 3]; /* whose values cost nothing */
    const size_t piece_px =
        (size_t)PIECE_PX / panel->step_x_px * panel->step_x_px; /* whole lines where a panel takes no less */
    size_t left_px = (size_t)window->w_px * window->h_px;
    int err = panel_window(panel, window->x_px, window->y_px, window->w_px, window->h_px);

    while (left_px && !err) {
        const size_t n_px = left_px < piece_px ? left_px : piece_px;
        err = panel_pixels(panel, pixels, n_px);
        left_px -= n_px;
    }
    return err;
}

static int send_frame(struct panel *panel, const struct bridge_window *windows, size_t n_windows)
{
    int err = 0;

    for (size_t i = 0; i < n_windows && !err; i++)
        err = send_window(panel, &windows[i]);
    return err ? err : panel_flush(panel);
}

/* The first frame leaves D/C and the transaction's length as frames do; the second one counts. */
static int measure(struct bridge_bench *bench, const struct bridge_window *windows, size_t n_windows,
                   struct bridge_cost *out)
{
    struct panel *panel = bench->display.panel;
    int err = panel_init(panel);

    if (!err) err = send_frame(panel, windows, n_windows);
    const struct bridge_cost before = bridge_bench_cost(bench);
    if (!err) err = send_frame(panel, windows, n_windows);
    const struct bridge_cost after = bridge_bench_cost(bench);
    *out = (struct bridge_cost){after.spi_b - before.spi_b, after.reports - before.reports};
    return err;
}

bool bridge_cost_of(const struct panel_choice *choice, const struct display_module *module,
                    const struct bridge_window *windows, size_t n_windows, struct bridge_cost *out, struct error *err)
{
    struct bridge_bench *bench = bridge_bench_open(choice, module, err);
    if (!bench) return false;
    const struct panel *panel = bench->display.panel;
    const struct bridge_window whole = {.w_px = panel->w_px, .h_px = panel->h_px};
    const int code = measure(bench, n_windows ? windows : &whole, n_windows ? n_windows : 1, out);
    const bool ok = bridge_bench_check(bench, choice, code, err);
    bridge_bench_close(bench);
    return ok;
}

double bridge_cost_fps(const struct bridge_cost *cost, double reports_per_s)
{
    return reports_per_s / (double)cost->reports;
}
