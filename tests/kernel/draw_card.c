/* SPDX-License-Identifier: MIT
 *
 * The test card on a panel by spidev and GPIO lines, from start to darkness: what is left of `limner play` where the
 * libraries of the whole program are not at hand, on a foreign processor. */
#include "card.h"
#include "displays/display.h"
#include "linux/linux_port.h"

#include <stdio.h>
#include <stdlib.h>

enum { SPEED_HZ = 1000000, LINES_B = SCREEN_PAGES_MEM_B(320, 2) };

static int draw(struct panel *panel)
{
    static uint32_t lines[LINES_B / 4];
    struct screen screen;

    int err = panel_init(panel);
    if (!err) err = screen_init(&screen, panel, LIM_NEAREST_FIRST, lines, sizeof lines);
    if (!err) err = card_draw(&screen, PANEL_UPRIGHT);
    return err ? err : panel_blank(panel, true);
}

static bool run(const char *spi, const char *name, const char *glass, struct port *port, struct error *err)
{
    const struct linux_port_config config = {
        .spi = spi, .dc = "DC", .reset = "RESET", .backlight = "BACKLIGHT", .speed_hz = SPEED_HZ};
    static struct display display;
    struct panel_choice panel;
    unsigned w_px, h_px, ox_px, oy_px;

    if (sscanf(glass, "%ux%u+%u+%u", &w_px, &h_px, &ox_px, &oy_px) != 4) return error_set(err, "%s: no glass", glass);
    const struct display_module module = {.w_px = (uint16_t)w_px,
                                          .h_px = (uint16_t)h_px,
                                          .ox_px = (uint16_t)ox_px,
                                          .oy_px = (uint16_t)oy_px,
                                          .invert = true};
    if (!panel_choice_parse(name, NULL, &panel, err)) return false;
    if (linux_port_open(port, &config) != 0) return error_set(err, "%s", port->error);
    if (!display_setup(&display, &panel, &module, port, err)) return false;
    const int code = draw(display.panel);
    return code == 0 || error_set(err, "%d: %s", code, port->error);
}

int main(int argc, char **argv)
{
    struct port port = {0};
    struct error err;

    if (argc != 4) {
        fputs("usage: draw_card /dev/spidevB.C PANEL[:FORMAT] WxH+X+Y\n", stderr);
        return EXIT_FAILURE;
    }
    const bool ok = run(argv[1], argv[2], argv[3], &port, &err);
    if (!ok) fprintf(stderr, "draw_card: %s\n", err.text);
    port_close(&port);
    return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
