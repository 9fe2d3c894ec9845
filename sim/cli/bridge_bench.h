/* SPDX-License-Identifier: MIT
 *
 * A display behind an emulated MCP2210, driven by the real port and the real driver: what predictions are counted on.
 */
#ifndef SIM_BRIDGE_BENCH_H
#define SIM_BRIDGE_BENCH_H

#include "displays/display.h"
#include "glass/emulated_bridge.h"
#include "glass/emulated_display.h"

struct bridge_bench {
    struct emulated_display glass;
    struct emulated_bridge bridge;
    struct port port;
    struct display display;
};

/* Large: on the heap. NULL: an error, and nothing to close. */
struct bridge_bench *bridge_bench_open(const struct panel_choice *choice, const struct display_module *module,
                                       struct error *err);
void bridge_bench_close(struct bridge_bench *bench);

struct bridge_cost {
    unsigned long spi_b; /* commands and pixels */
    unsigned long reports;
};

/* What has gone through it so far. */
struct bridge_cost bridge_bench_cost(const struct bridge_bench *bench);

/* An error of the driver (code), or the first complaint of bridge or glass. */
bool bridge_bench_check(const struct bridge_bench *bench, const struct panel_choice *choice, int code,
                        struct error *err);

#endif
