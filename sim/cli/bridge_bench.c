/* SPDX-License-Identifier: MIT */
#include "cli/bridge_bench.h"

#include "linux/code_words.h"

#include <stdlib.h>

static bool open_port(struct bridge_bench *bench, struct error *err)
{
    const struct bridge_link link = emulated_bridge_link(&bench->bridge);
    const struct bridge_options options = emulated_bridge_options(&bench->bridge);
    return bridge_port_open(&bench->port, &link, &options) == 0 || error_set(err, "%s", bench->port.error);
}

struct bridge_bench *bridge_bench_open(const struct panel_choice *choice, const struct display_module *module,
                                       struct error *err)
{
    if (!display_module_check(choice, module, err)) return NULL;
    struct bridge_bench *bench = calloc(1, sizeof *bench);
    if (!bench) {
        error_set(err, "bridge: out of memory");
        return NULL;
    }
    emulated_display_choose(&bench->glass, choice, module);
    emulated_bridge_init(&bench->bridge, bench->glass.port);
    if (open_port(bench, err) && display_setup(&bench->display, choice, module, &bench->port, err)) return bench;
    bridge_bench_close(bench);
    return NULL;
}

void bridge_bench_close(struct bridge_bench *bench)
{
    if (bench) port_close(&bench->port);
    free(bench);
}

struct bridge_cost bridge_bench_cost(const struct bridge_bench *bench)
{
    return (struct bridge_cost){.spi_b = (unsigned long)bench->bridge.chip.bus_b,
                                .reports = (unsigned long)bench->bridge.cable.reports};
}

bool bridge_bench_check(const struct bridge_bench *bench, const struct panel_choice *choice, int code,
                        struct error *err)
{
    if (code) return error_set(err, "emulated %s: %s (%d)", choice->name, code_words(code), code);
    if (bench->bridge.chip.complaints) return error_set(err, "emulated MCP2210: %s", bench->bridge.chip.complaint);
    return emulated_display_is_quiet(&bench->glass, err);
}
