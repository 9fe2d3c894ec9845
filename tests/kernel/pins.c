/* SPDX-License-Identifier: MIT
 *
 * From the trace that QEMU writes of a PL061's outputs, on standard input, to a record as the kernel's tap makes it, on
 * standard output: SPI in mode 0 is read off the pins, as a display would. */
#include "wire_tap.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The lines of tests/kernel/arm64.dts; those of D/C, reset and backlight are the record's own. */
enum { PIN_CLOCK = 4, PIN_DATA = 5, PIN_SELECT = 7, PINS };

struct pins {
    bool high[PINS];
    uint64_t time_ns;
    uint8_t byte;
    unsigned bits; /* of the byte under way */
};

static void put(const struct pins *pins, struct wire_tap_event event)
{
    event.time_ns = pins->time_ns;
    fwrite(&event, sizeof event, 1, stdout);
}

static void put_byte(struct pins *pins)
{
    put(pins, (struct wire_tap_event){.kind = WIRE_TAP_BYTES, .word_bits = 8, .n_b = 1});
    putchar(pins->byte);
    pins->bits = 0;
}

/* Selected, a rise of the clock takes a bit. A byte cut off by chip select is one of too few bits: dropped, as chips
 * do. */
static void follow(struct pins *pins, unsigned pin, bool high)
{
    if (pins->high[pin] == high) return;
    pins->high[pin] = high;
    if (pin < WIRE_LINES)
        put(pins, (struct wire_tap_event){.kind = WIRE_TAP_LEVEL, .which = (uint8_t)pin, .value = high});
    if (pin == PIN_SELECT) {
        pins->bits = 0;
        put(pins, (struct wire_tap_event){.kind = WIRE_TAP_SELECT, .value = high});
    }
    if (pin != PIN_CLOCK || !high || pins->high[PIN_SELECT]) return;
    pins->byte = (uint8_t)(pins->byte << 1 | pins->high[PIN_DATA]);
    if (++pins->bits == 8) put_byte(pins);
}

/* "PROCESS@SECONDS.MICROSECONDS:pl061_set_output ... setting output PIN to LEVEL" */
static bool parse(const char *line, struct pins *pins, unsigned *pin, unsigned *level)
{
    unsigned long long s, us;
    const char *at = strchr(line, '@'), *what = strstr(line, "setting output ");

    if (!at || !what || sscanf(at, "@%llu.%llu", &s, &us) != 2) return false;
    pins->time_ns = (s * 1000000 + us) * 1000;
    return sscanf(what, "setting output %u to %u", pin, level) == 2 && *pin < PINS;
}

int main(void)
{
    struct pins pins = {.high = {[PIN_SELECT] = true}};
    unsigned pin, level, events = 0;
    char line[256];

    for (; fgets(line, sizeof line, stdin); events++)
        if (parse(line, &pins, &pin, &level)) follow(&pins, pin, level);
    return events && fflush(stdout) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
