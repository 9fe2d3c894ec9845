/* SPDX-License-Identifier: MIT
 *
 * What comes while select is high is one message: a command and eight bits that do nothing; or a command, lines of
 * number, pixels and eight bits, and eight bits more, for a line is stored by the sixteen bits behind it. Buses send
 * the highest bit first, the glass takes a number's lowest first. */
#include "glass/emulated_sharp.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { WRITE = 0x80, POSITIVE = 0x40, CLEAR = 0x20, SIGN_US = 1000000 };

/* The datasheets' tsSCS, thSCS, twSCSL and the width of EXTCOMIN, as drivers quote them: 6, 2, 6 for glass of 128x128
 * and LS013B7DH05, and 2 for twSCSL of LS013B4DN04 alone; 3, 1, 1, 1 for LS027B7DH01 and LS027B4DH01. No driver was
 * found to quote EXTCOMIN's of the first; Zephyr's drivers/display/ls0xx.c has 3 us for all. */
static const struct emulated_sharp_kind ls013b7dh03 = {
    .name = "ls013b7dh03", .w_px = 128, .h_px = 128, .setup_us = 6, .hold_us = 2, .low_us = 6, .pulse_us = 2};
static const struct emulated_sharp_kind ls027b7dh01 = {
    .name = "ls027b7dh01", .w_px = 400, .h_px = 240, .setup_us = 3, .hold_us = 1, .low_us = 1, .pulse_us = 1};

const struct emulated_sharp_kind *const emulated_sharp_kinds[] = {&ls013b7dh03, &ls027b7dh01, NULL};

const struct emulated_sharp_kind *emulated_sharp_kind_find(const char *name)
{
    for (size_t i = 0; emulated_sharp_kinds[i]; i++)
        if (strcmp(emulated_sharp_kinds[i]->name, name) == 0) return emulated_sharp_kinds[i];
    return NULL;
}

__attribute__((format(printf, 2, 0))) static void keep(struct emulated_sharp *chip, const char *format, va_list args)
{
    vsnprintf(chip->complaint, sizeof chip->complaint, format, args);
    chip->complaints++;
}

__attribute__((format(printf, 2, 3))) static void complain(struct emulated_sharp *chip, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    keep(chip, format, args);
    va_end(args);
}

/* Of what glass would bear. */
__attribute__((format(printf, 2, 3))) static void note(struct emulated_sharp *chip, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    if (!emulated_port_notes(&chip->port, format, args)) keep(chip, format, args);
    va_end(args);
}

/* The same sign for longer than a second spoils the glass; said once for each time. */
static void check_sign(struct emulated_sharp *chip)
{
    const uint64_t now_us = chip->port.now_us;

    if (now_us - chip->sign_us <= SIGN_US) return;
    complain(chip, "the voltage had one sign for %u ms", (unsigned)((now_us - chip->sign_us) / 1000));
    chip->sign_us = now_us;
}

static void set_sign(struct emulated_sharp *chip, bool positive)
{
    check_sign(chip);
    if (positive == chip->positive) return;
    chip->positive = positive;
    chip->sign_us = chip->port.now_us;
    chip->signs++;
}

static void take_mode(struct emulated_sharp *chip, uint8_t command)
{
    if (emulated_port_is_before(&chip->port, chip->select_us + chip->kind->setup_us))
        note(chip, "bits too soon after select");
    if (command & WRITE && command & CLEAR) complain(chip, "command %02Xh", command);
    chip->command = command;
    if (!chip->by_pin) set_sign(chip, command & POSITIVE);
    if (command & CLEAR) memset(chip->memory, 0xFF, sizeof chip->memory);
}

static uint8_t lowest_first(uint8_t byte)
{
    unsigned number = 0;

    for (unsigned i = 0; i < 8; i++)
        number |= ((unsigned)byte >> (7 - i) & 1u) << i;
    return (uint8_t)number;
}

static void store_line(struct emulated_sharp *chip)
{
    if (chip->number < 1 || chip->number > chip->kind->h_px)
        note(chip, "line %u: there are 1..%u", chip->number, chip->kind->h_px);
    else
        memcpy(chip->memory[chip->number - 1], chip->line, sizeof chip->line);
    emulated_port_store(&chip->port, (struct emulated_place){0, chip->number, chip->kind->w_px, 1});
}

static void take_byte(void *ctx, uint8_t byte)
{
    struct emulated_sharp *chip = ctx;
    const unsigned line_b = chip->kind->w_px / 8u, at = chip->n_b ? (chip->n_b - 1) % (line_b + 2) : 0;

    if (!chip->selected) {
        complain(chip, "a byte without select");
        return;
    }
    if (chip->n_b == 0) {
        take_mode(chip, byte);
    } else if (chip->command & WRITE) {
        if (at == 0 && chip->n_b > 1) store_line(chip);
        if (at == 0) chip->number = lowest_first(byte);
        if (at >= 1 && at <= line_b) chip->line[at - 1] = byte;
    }
    chip->n_b++;
    chip->byte_us = chip->port.now_us;
}

static void check_end(struct emulated_sharp *chip)
{
    const unsigned line_b = chip->kind->w_px / 8u, lines_b = chip->n_b - 2;

    if (chip->n_b && emulated_port_is_before(&chip->port, chip->byte_us + chip->kind->hold_us))
        note(chip, "select ended too soon after the last bit");
    if (chip->n_b == 0) return;
    if (chip->n_b < 2 || (chip->command & WRITE ? lines_b == 0 || lines_b % (line_b + 2) : lines_b))
        complain(chip, "%u bytes after %02Xh: not whole lines and the bits behind them", chip->n_b, chip->command);
}

static void take_select(void *ctx, bool high)
{
    struct emulated_sharp *chip = ctx;

    if (chip->port.pending_b) complain(chip, "select changed while bytes were on their way");
    check_sign(chip);
    if (chip->selected && !high) {
        check_end(chip);
        chip->rise_us = chip->port.now_us + chip->kind->low_us;
    }
    if (!chip->selected && high) {
        if (emulated_port_is_before(&chip->port, chip->rise_us)) note(chip, "select was low for too short a time");
        chip->select_us = chip->port.now_us;
        chip->n_b = 0;
    }
    chip->selected = high;
}

static int set_alternate(void *ctx, bool high)
{
    struct emulated_sharp *chip = ctx;

    if (high && !chip->pin_high) {
        if (chip->by_pin) set_sign(chip, !chip->positive);
        chip->fall_us = chip->port.now_us + chip->kind->pulse_us;
    }
    if (!high && chip->pin_high && emulated_port_is_before(&chip->port, chip->fall_us))
        note(chip, "EXTCOMIN was high for too short a time");
    chip->pin_high = high;
    return 0;
}

void emulated_sharp_init(struct emulated_sharp *chip, const struct emulated_sharp_kind *kind, bool by_pin)
{
    assert(kind->w_px <= EMULATED_SHARP_MAX_W_PX && kind->h_px <= EMULATED_SHARP_MAX_H_PX);
    memset(chip, 0, sizeof *chip);
    chip->port = (struct emulated_port){.chip = chip, .command = take_byte, .data = take_byte, .select = take_select};
    chip->kind = kind;
    chip->by_pin = by_pin;
    for (size_t i = 0; i < sizeof chip->memory; i++)
        (&chip->memory[0][0])[i] = (uint8_t)(i * 167 + 13);
}

struct pin emulated_sharp_alternate(struct emulated_sharp *chip)
{
    return (struct pin){chip, set_alternate};
}

bool emulated_sharp_is_white(const struct emulated_sharp *chip, unsigned x, unsigned y)
{
    return chip->port.backlight_low || chip->memory[y][x / 8] >> (7 - x % 8) & 1;
}
