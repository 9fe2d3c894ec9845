/* SPDX-License-Identifier: MIT */
#include "bridge_cost.h"

#include "emulated_bridge.h"
#include "emulated_display.h"

#include <stdlib.h>

enum { PIECE_PX = 960 }; /* whole bytes in every format */

struct bench {
    struct emulated_display glass;
    struct emulated_bridge bridge;
    struct port port;
    struct display display;
    uint8_t pixels[PIECE_PX * 3]; /* whose values cost nothing */
};

static int send_window(struct bench *bench, const struct bridge_window *window)
{
    struct panel *panel = bench->display.panel;
    size_t left_px = (size_t)window->w_px * window->h_px;
    int err = panel_window(panel, window->x_px, window->y_px, window->w_px, window->h_px);

    while (left_px && !err) {
        const size_t n_px = left_px < PIECE_PX ? left_px : PIECE_PX;
        err = panel_pixels(panel, bench->pixels, n_px);
        left_px -= n_px;
    }
    return err;
}

static int send_frame(struct bench *bench, const struct bridge_window *windows, size_t n_windows)
{
    int err = 0;

    for (size_t i = 0; i < n_windows && !err; i++)
        err = send_window(bench, &windows[i]);
    return err ? err : panel_flush(bench->display.panel);
}

/* The first frame leaves D/C and the transaction's length as frames do; the second one counts. */
static int measure(struct bench *bench, const struct bridge_window *windows, size_t n_windows, struct bridge_cost *out)
{
    int err = panel_init(bench->display.panel);

    if (!err) err = send_frame(bench, windows, n_windows);
    const uint64_t before_b = bench->bridge.chip.bus_b;
    const long before = bench->bridge.cable.reports;
    if (!err) err = send_frame(bench, windows, n_windows);
    out->spi_b = (unsigned long)(bench->bridge.chip.bus_b - before_b);
    out->reports = (unsigned long)(bench->bridge.cable.reports - before);
    return err;
}

static bool run(struct bench *bench, const struct panel_choice *choice, const struct display_module *module,
                const struct bridge_window *windows, size_t n_windows, struct bridge_cost *out, struct error *err)
{
    emulated_display_init(&bench->glass, choice, module);
    emulated_bridge_init(&bench->bridge, bench->glass.port);
    const struct bridge_link link = emulated_bridge_link(&bench->bridge);
    const struct bridge_options options = emulated_bridge_options(&bench->bridge);
    if (bridge_port_open(&bench->port, &link, &options) != 0) return error_set(err, "%s", bench->port.error);
    bool ok = display_setup(&bench->display, choice, module, &bench->port, err);
    const struct panel *panel = bench->display.panel;
    const struct bridge_window whole = {.w_px = ok ? panel->w_px : 0, .h_px = ok ? panel->h_px : 0};
    const int code = ok ? measure(bench, n_windows ? windows : &whole, n_windows ? n_windows : 1, out) : 0;
    port_close(&bench->port);
    if (code) ok = error_set(err, "emulated %s: the driver failed with %d", choice->name, code);
    if (ok && bench->bridge.chip.complaints) ok = error_set(err, "emulated MCP2210: %s", bench->bridge.chip.complaint);
    return ok && emulated_display_is_quiet(&bench->glass, err);
}

bool bridge_cost_of(const struct panel_choice *choice, const struct display_module *module,
                    const struct bridge_window *windows, size_t n_windows, struct bridge_cost *out, struct error *err)
{
    struct bench *bench = calloc(1, sizeof *bench);

    if (!bench) return error_set(err, "bridge: out of memory");
    const bool ok =
        display_module_check(choice, module, err) && run(bench, choice, module, windows, n_windows, out, err);
    free(bench);
    return ok;
}

double bridge_cost_fps(const struct bridge_cost *cost, double reports_per_s)
{
    return reports_per_s / (double)cost->reports;
}
