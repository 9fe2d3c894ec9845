/* SPDX-License-Identifier: MIT
 *
 * Prints the record of a display's wires (standard input) as a wire log, which `limner decode` reads. The line SELECT
 * is the lamp's, which changes after each frame; ends after so many of them. */
#include "wire_tap.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

static const char *const line_names[WIRE_LINES] = {
    [WIRE_DC] = "dc", [WIRE_RESET] = "reset", [WIRE_BACKLIGHT] = "backlight", [WIRE_SELECT] = "led"};

struct wires {
    uint64_t start_ns;
    unsigned long frames; /* that have ended */
    int lamp;             /* its level; -1: it has none yet */
};

static int print_bytes(uint32_t n_b)
{
    putchar('b');
    for (uint32_t i = 0; i < n_b; i++) {
        const int byte = getchar();
        if (byte == EOF) return -1;
        printf(" %02X", (unsigned)byte);
    }
    putchar('\n');
    return 0;
}

static void print_level(struct wires *wires, unsigned line, int level)
{
    printf("p %s %d\n", line_names[line], level);
    if (line != WIRE_SELECT) return;
    wires->frames += wires->lamp >= 0 && wires->lamp != level;
    wires->lamp = level;
}

/* Of one chip on the bus, that of chip select 0. -1: the record ends within the event. */
static int print_event(struct wires *wires, const struct wire_tap_event *event)
{
    printf("t %" PRIu64 "\n", event->time_ns - wires->start_ns);
    if (event->kind == WIRE_TAP_LEVEL) print_level(wires, event->which % WIRE_LINES, event->value != 0);
    if (event->kind == WIRE_TAP_SELECT && event->which == 0) printf("p cs %d\n", event->value != 0);
    return event->n_b ? print_bytes(event->n_b) : 0;
}

int main(int argc, char **argv)
{
    const unsigned long frames = argc == 2 ? strtoul(argv[1], NULL, 10) : 0;
    struct wires wires = {.lamp = -1};
    struct wire_tap_event event;

    if (frames == 0) {
        fputs("usage: wires FRAMES <RECORD >LOG\n", stderr);
        return EXIT_FAILURE;
    }
    while (wires.frames < frames) {
        if (fread(&event, sizeof event, 1, stdin) != 1) return EXIT_FAILURE;
        if (wires.start_ns == 0) wires.start_ns = event.time_ns;
        if (print_event(&wires, &event)) return EXIT_FAILURE;
    }
    return fflush(stdout) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
