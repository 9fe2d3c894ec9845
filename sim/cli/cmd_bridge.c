/* SPDX-License-Identifier: MIT
 *
 * `limner bridge`: how many frames a second a display behind a USB-HID bridge shows at the ceiling of reports, as
 * the table in sim/MEASURED.md: whole frames, and what changes on flights through scenes. */
#include "base/arguments.h"
#include "base/grow.h"
#include "base/parse.h"
#include "cli/bridge_flight.h"
#include "cli/commands.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct row {
    const char *panel;
    unsigned w_px, h_px;
};

static const struct row USUAL[] = {{"ssd1306", 128, 64}, {"st7735", 128, 160}, {"st7789", 240, 240}};

/* What comes in pairs: a scene, and a file of cameras. */
struct flights {
    char **paths;
    int count;
};

/* The camera file's, without folder and suffix. */
static void print_name(const char *path)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    printf(" %.*s: reports | frames/s |", (int)strcspn(name, "."), name);
}

static void print_heading(const struct flights *flights)
{
    printf("| panel | pixels | whole: bytes | reports | frames/s, answered at once | a millisecond later |");
    for (int i = 0; i < flights->count; i++)
        print_name(flights->paths[2 * i + 1]);
    printf("\n|---|---|---|---|---|---|");
    for (int i = 0; i < flights->count; i++)
        printf("---|---|");
    puts("");
}

static bool find_costs(const struct row *row, const struct flights *flights, struct bridge_cost *whole,
                       struct bridge_cost *changes, struct error *err)
{
    const struct display_module module = {.w_px = (uint16_t)row->w_px, .h_px = (uint16_t)row->h_px};
    struct panel_choice choice;
    if (!panel_choice_parse(row->panel, NULL, &choice, err) || !bridge_cost_of(&choice, &module, NULL, 0, whole, err))
        return false;
    for (int i = 0; i < flights->count; i++)
        if (!bridge_flight_cost(&choice, &module, flights->paths[2 * i], flights->paths[2 * i + 1], &changes[i], err))
            return false;
    return true;
}

static bool print_row(const struct row *row, bool first, const struct flights *flights, struct error *err)
{
    struct bridge_cost whole, *changes = grow_zeroed((size_t)flights->count + 1, sizeof *changes);
    const bool ok = find_costs(row, flights, &whole, changes, err);
    if (ok && first) print_heading(flights);
    if (ok)
        printf("| %s | %ux%u | %lu | %lu | %.2f | %.2f |", row->panel, row->w_px, row->h_px, whole.spi_b, whole.reports,
               bridge_cost_fps(&whole, BRIDGE_REPORTS_PER_S), bridge_cost_fps(&whole, BRIDGE_REPORTS_PER_S / 2));
    for (int i = 0; i < flights->count && ok; i++)
        printf(" %lu | %.2f |", changes[i].reports, bridge_cost_fps(&changes[i], BRIDGE_REPORTS_PER_S));
    if (ok) puts("");
    fflush(stdout); /* compiling the next row's scenes forks */
    free(changes);
    return ok;
}

static bool print_table(struct arguments *arguments, struct error *err)
{
    struct row row = {0};
    const char *size = NULL;
    if (!arguments_value(arguments, "--panel", &row.panel, err) || !arguments_value(arguments, "--size", &size, err))
        return false;
    const struct flights flights = {arguments->items + 1, (arguments->count - 1) / 2};
    if (arguments->count % 2 == 0)
        return error_set(err, "bridge: %s: a scene and its camera file come together",
                         arguments->items[arguments->count - 1]);
    if (!row.panel != !size) return error_set(err, "bridge: --panel and --size come together");
    if (size && !parse_size(size, &row.w_px, &row.h_px, err)) return false;
    if (row.panel) return print_row(&row, true, &flights, err);
    for (size_t i = 0; i < sizeof USUAL / sizeof USUAL[0]; i++)
        if (!print_row(&USUAL[i], i == 0, &flights, err)) return false;
    return true;
}

int cmd_bridge(int argc, char **argv)
{
    struct arguments arguments = {argv, argc};
    struct error err;
    const bool ok = print_table(&arguments, &err);
    if (!ok) fprintf(stderr, "limner: %s\n", err.text);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
