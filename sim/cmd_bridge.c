/* SPDX-License-Identifier: MIT
 *
 * `limner bridge`: how many frames a second a display behind a USB-HID bridge shows at the ceiling of reports, as
 * README's table. */
#include "arguments.h"
#include "bridge_cost.h"
#include "commands.h"
#include "parse.h"

#include <stdio.h>
#include <stdlib.h>

struct row {
    const char *panel;
    unsigned w_px, h_px;
};

static const struct row USUAL[] = {{"ssd1306", 128, 64}, {"st7735", 128, 160}, {"st7789", 240, 240}};

static void print_heading(void)
{
    puts("| panel | pixels | bytes a frame | reports a frame | frames/s, answered at once | a millisecond later |");
    puts("|---|---|---|---|---|---|");
}

static bool print_row(const struct row *row, bool first, struct error *err)
{
    const struct display_module module = {.w_px = (uint16_t)row->w_px, .h_px = (uint16_t)row->h_px};
    struct panel_choice choice;
    struct bridge_cost cost;
    if (!panel_choice_parse(row->panel, NULL, &choice, err) || !bridge_cost_of(&choice, &module, NULL, 0, &cost, err))
        return false;
    if (first) print_heading();
    printf("| %s | %ux%u | %lu | %lu | %.2f | %.2f |\n", row->panel, row->w_px, row->h_px, cost.spi_b, cost.reports,
           bridge_cost_fps(&cost, BRIDGE_REPORTS_PER_S), bridge_cost_fps(&cost, BRIDGE_REPORTS_PER_S / 2));
    return true;
}

static bool print_table(struct arguments *arguments, struct error *err)
{
    struct row row = {0};
    const char *size = NULL;
    if (!arguments_value(arguments, "--panel", &row.panel, err) || !arguments_value(arguments, "--size", &size, err))
        return false;
    if (arguments->count > 1) return error_set(err, "bridge: what is '%s'?", arguments->items[1]);
    if (!row.panel != !size) return error_set(err, "bridge: --panel and --size come together");
    if (size && !parse_size(size, &row.w_px, &row.h_px, err)) return false;
    if (row.panel) return print_row(&row, true, err);
    for (size_t i = 0; i < sizeof USUAL / sizeof USUAL[0]; i++)
        if (!print_row(&USUAL[i], i == 0, err)) return false;
    return true;
}

int cmd_bridge(int argc, char **argv)
{
    struct arguments arguments = {argv, argc};
    struct error err;
    const bool ok = print_table(&arguments, &err);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok && fflush(stdout) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
