/* SPDX-License-Identifier: MIT
 *
 * What a frame costs over a USB-HID bridge: the reports that the real port sends for it to an emulated MCP2210,
 * counted, and from them the frames a second. Full-speed USB asks an interrupt endpoint once a millisecond at most, so
 * a bridge takes 1000 reports a second and not one more; each has to be answered before the next, and a host whose
 * answer arrives only a millisecond later gets half of that. The time that SPI itself takes is hidden behind both: 60
 * bytes at 12 MHz are 40 us. Not tried on hardware. */
#ifndef SIM_BRIDGE_COST_H
#define SIM_BRIDGE_COST_H

#include "cli/bridge_bench.h"

enum { BRIDGE_REPORTS_PER_S = 1000 };

/* A rectangle of the picture; on panels of pages it begins and ends at whole ones. */
struct bridge_window {
    uint16_t x_px, y_px, w_px, h_px;
};

/* Of a frame that sends these windows, one after the other, to a panel that was sent such a frame before. n_windows 0:
 * the whole picture. */
bool bridge_cost_of(const struct panel_choice *choice, const struct display_module *module,
                    const struct bridge_window *windows, size_t n_windows, struct bridge_cost *out, struct error *err);

/* At so many reports a second. */
double bridge_cost_fps(const struct bridge_cost *cost, double reports_per_s);

#endif
