/* SPDX-License-Identifier: MIT
 *
 * Two languages: that of SSD1306 and its kin, where a byte is a command and some take one more, and the PCD8544's with
 * two sets of commands. What a chip does not know is complained about, and so are addresses beyond memory and what
 * comes in the wrong order. */
#include "emulated_pages.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { HORIZONTAL, PAGE_BY_PAGE = 2 }; /* modes: arguments of 20h */
enum { RESET_PULSE_US = 1, PUMP = 1, POWER_ALL = 7, POWER_RISES_US = 20000 };

struct emulated_pages_kind {
    const char *name;
    uint16_t w_px, h_px;
    uint32_t reset_us; /* after the pulse */
    const char *two;   /* commands that take an argument */
    const char *three; /* commands that take two */
    const char *one;   /* commands without, beside those that all have */
    bool is_pcd;
    bool first_columns, first_lines; /* what the upper left corner of usual glass shows; else the last ones */
    bool rises_alone;                /* its supply comes up in the right order by itself */
    uint8_t needs_power;
};

static const struct emulated_pages_kind ssd1306 = {.name = "ssd1306",
                                                   .w_px = 128,
                                                   .h_px = 64,
                                                   .reset_us = 3,
                                                   .two = "\xD5\xA8\xD3\x8D\x20\xDA\x81\xD9\xDB",
                                                   .three = "\x21\x22",
                                                   .one = "",
                                                   .needs_power = PUMP};
static const struct emulated_pages_kind sh1106 = {.name = "sh1106",
                                                  .w_px = 132,
                                                  .h_px = 64,
                                                  .reset_us = 2,
                                                  .two = "\xD5\xA8\xD3\xAD\xDA\x81\xD9\xDB",
                                                  .one = "\x30\x31\x32\x33",
                                                  .needs_power = PUMP};
static const struct emulated_pages_kind st7567 = {.name = "st7567",
                                                  .w_px = 132,
                                                  .h_px = 64,
                                                  .reset_us = 1000,
                                                  .two = "\x81",
                                                  .one = "\xE2\xA2\xA3\x20\x21\x22\x23\x24\x25\x26\x27"
                                                         "\x28\x29\x2A\x2B\x2C\x2D\x2E\x2F",
                                                  .needs_power = POWER_ALL};
static const struct emulated_pages_kind pcd8544 = {.name = "pcd8544",
                                                   .w_px = 84,
                                                   .h_px = 48,
                                                   .is_pcd = true,
                                                   .first_columns = true,
                                                   .first_lines = true,
                                                   .needs_power = PUMP};
static const struct emulated_pages_kind uc1701 = {.name = "uc1701",
                                                  .w_px = 132,
                                                  .h_px = 64,
                                                  .reset_us = 5000,
                                                  .two = "\x81\xFA",
                                                  .one = "\xE2\xA2\xA3\x20\x21\x22\x23\x24\x25\x26\x27"
                                                         "\x28\x29\x2A\x2B\x2C\x2D\x2E\x2F",
                                                  .first_columns = true,
                                                  .rises_alone = true,
                                                  .needs_power = POWER_ALL};

const struct emulated_pages_kind *const emulated_pages_kinds[] = {&pcd8544, &sh1106, &ssd1306, &st7567, &uc1701, NULL};

const struct emulated_pages_kind *emulated_pages_kind_find(const char *name)
{
    for (size_t i = 0; emulated_pages_kinds[i]; i++)
        if (strcmp(emulated_pages_kinds[i]->name, name) == 0) return emulated_pages_kinds[i];
    return NULL;
}

__attribute__((format(printf, 2, 3))) static void complain(struct emulated_pages *chip, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    vsnprintf(chip->complaint, sizeof chip->complaint, format, args);
    va_end(args);
    chip->complaints++;
}

static void reset_registers(struct emulated_pages *chip)
{
    const struct emulated_pages_kind *kind = chip->module.kind;

    chip->command = chip->n_args = chip->args_due = 0;
    chip->page = chip->column = 0;
    chip->on = chip->inverted = chip->columns_flipped = chip->lines_flipped = chip->extended = false;
    chip->asleep = kind->is_pcd;
    chip->power = 0;
    chip->lines = (uint8_t)kind->h_px;
    chip->mode = PAGE_BY_PAGE; /* SSD1306's default, and all that the others have */
    chip->columns[0] = chip->pages[0] = 0;
    chip->columns[1] = (uint8_t)(kind->w_px - 1);
    chip->pages[1] = (uint8_t)(kind->h_px / 8 - 1);
    chip->window_full = false;
    chip->glass = false;
}

/* What is on needs its supply; an LCD's rises for a while. */
static void switch_on(struct emulated_pages *chip)
{
    const struct emulated_pages_kind *kind = chip->module.kind;

    if ((chip->power & kind->needs_power) != kind->needs_power)
        complain(chip, "display on without its voltage");
    else if (kind->needs_power == POWER_ALL && emulated_port_is_before(&chip->port, chip->power_us + POWER_RISES_US))
        complain(chip, "display on %u us after its voltage", (unsigned)(chip->port.now_us - chip->power_us));
    if (chip->lines != chip->module.h_px && !kind->is_pcd && kind->needs_power == PUMP)
        complain(chip, "%u lines in use, the glass has %u", chip->lines, chip->module.h_px);
    if (kind->needs_power == PUMP && !kind->is_pcd && !chip->glass) complain(chip, "display on, lines wired anyhow");
    chip->on = true;
}

static void set_range(struct emulated_pages *chip, uint8_t range[2], uint8_t *at, unsigned end)
{
    if (chip->mode == PAGE_BY_PAGE) complain(chip, "%02Xh: pages are addressed one by one", chip->command);
    if (chip->args[0] > chip->args[1] || chip->args[1] >= end)
        complain(chip, "%02Xh %u..%u: memory is 0..%u", chip->command, chip->args[0], chip->args[1], end - 1);
    range[0] = (uint8_t)(chip->args[0] % end);
    range[1] = (uint8_t)(chip->args[1] % end);
    *at = range[0];
    chip->window_full = false;
}

static void run_arguments(struct emulated_pages *chip)
{
    const struct emulated_pages_kind *kind = chip->module.kind;
    const uint8_t argument = chip->args[0];

    switch (chip->command) {
    case 0xA8:
        chip->lines = (uint8_t)(argument + 1);
        break;
    case 0x8D:
        chip->power = argument == 0x14 ? PUMP : 0;
        break;
    case 0xAD:
        chip->power = argument == 0x8B ? PUMP : 0;
        break;
    case 0x20:
        chip->mode = argument;
        if (argument != HORIZONTAL && argument != PAGE_BY_PAGE)
            complain(chip, "addressing mode %u is not modelled", argument);
        break;
    case 0x21:
        set_range(chip, chip->columns, &chip->column, kind->w_px);
        break;
    case 0x22:
        set_range(chip, chip->pages, &chip->page, kind->h_px / 8u);
        break;
    case 0xDA:
        chip->glass = true;
        if (argument != (chip->module.h_px > 32 ? 0x12 : 0x02))
            complain(chip, "lines are not wired as %02X says", argument);
        break;
    default:
        break;
    }
}

/* Booster, regulator, follower: 4, 2 and 1, one after the other. */
static void set_power(struct emulated_pages *chip, uint8_t power)
{
    if (power == POWER_ALL && chip->power != 6 && !chip->module.kind->rises_alone)
        complain(chip, "all of the supply at once");
    chip->power = power;
    chip->power_us = chip->port.now_us;
}

/* The address within a page, and the page, where each is addressed for itself. */
static void set_address(struct emulated_pages *chip, uint8_t command)
{
    if (chip->mode != PAGE_BY_PAGE) complain(chip, "%02Xh: pages are not addressed one by one", command);
    if (command >= 0xB0)
        chip->page = command & 7;
    else if (command < 0x10)
        chip->column = (uint8_t)((chip->column & 0xF0) | command);
    else
        chip->column = (uint8_t)((chip->column & 0x0F) | (command & 0x0F) << 4);
}

static uint8_t args_of(const struct emulated_pages_kind *kind, uint8_t command)
{
    if (!command) return 0;
    return kind->three && strchr(kind->three, command) ? 2 : strchr(kind->two, command) ? 1 : 0;
}

static void run_plain(struct emulated_pages *chip, uint8_t command)
{
    const struct emulated_pages_kind *kind = chip->module.kind;

    if (args_of(kind, command)) {
        chip->command = command;
        chip->n_args = 0;
        chip->args_due = args_of(kind, command);
    } else if (command == 0xE2 && strchr(kind->one, 0xE2)) {
        reset_registers(chip);
    } else if ((command & 0xF8) == 0x28 && strchr(kind->one, command)) {
        set_power(chip, command & 7);
    } else if (strchr(kind->one, command) && command) {
        return;
    } else if (command < 0x20 || (command & 0xF8) == 0xB0) {
        set_address(chip, command);
    } else if ((command & 0xFE) == 0xA0) {
        chip->columns_flipped = command & 1;
    } else if ((command & 0xF7) == 0xC0) {
        chip->lines_flipped = command & 8;
    } else if ((command & 0xFE) == 0xA6) {
        chip->inverted = command & 1;
    } else if (command == 0xAF) {
        switch_on(chip);
    } else if (command == 0xAE) {
        chip->on = false;
    } else if (command != 0x40 && command != 0xA4) {
        complain(chip, "command 0x%02X is unknown or not modelled", command);
    }
}

static void run_pcd(struct emulated_pages *chip, uint8_t command)
{
    if ((command & 0xF8) == 0x20) {
        chip->extended = command & 1;
        chip->asleep = command & 4;
        if (command & 2) complain(chip, "vertical addressing is not modelled");
    } else if (chip->extended) {
        if (command & 0x80)
            chip->power = PUMP;
        else if ((command & 0xFC) != 0x04 && (command & 0xF8) != 0x10)
            complain(chip, "extended command 0x%02X is unknown", command);
    } else if (command & 0x80) {
        chip->column = command & 0x7F;
    } else if ((command & 0xF8) == 0x40) {
        chip->page = command & 7;
    } else if (command == 0x0C || command == 0x0D) {
        switch_on(chip);
        chip->inverted = command & 1;
    } else if (command == 0x08) {
        chip->on = false;
    } else {
        complain(chip, "command 0x%02X is unknown or not modelled", command);
    }
}

static void take_command(void *ctx, uint8_t byte)
{
    struct emulated_pages *chip = ctx;

    if (emulated_port_is_before(&chip->port, chip->ready_us)) complain(chip, "0x%02X too soon after reset", byte);
    if (chip->args_due) {
        chip->args[chip->n_args++] = byte;
        if (--chip->args_due == 0) run_arguments(chip);
    } else if (chip->module.kind->is_pcd) {
        run_pcd(chip, byte);
    } else {
        run_plain(chip, byte);
    }
}

/* A PCD8544 and horizontal addressing go on with the next page, and from the end to the start. */
static void advance(struct emulated_pages *chip)
{
    const struct emulated_pages_kind *kind = chip->module.kind;
    const bool ends = chip->column == chip->columns[1];

    if (!kind->is_pcd && chip->mode == PAGE_BY_PAGE) {
        chip->column++;
        return;
    }
    chip->column = ends ? chip->columns[0] : (uint8_t)(chip->column + 1);
    if (!ends) return;
    chip->window_full = chip->page == chip->pages[1] && !kind->is_pcd;
    chip->page = chip->page == chip->pages[1] ? chip->pages[0] : (uint8_t)(chip->page + 1);
}

/* Columns are exchanged as bytes come in, lines as they are shown. */
static void take_data(void *ctx, uint8_t byte)
{
    struct emulated_pages *chip = ctx;
    const struct emulated_pages_kind *kind = chip->module.kind;

    if (chip->args_due) complain(chip, "data after 0x%02X, which lacks %u arguments", chip->command, chip->args_due);
    chip->args_due = 0;
    if (chip->window_full) complain(chip, "more bytes than the window holds");
    chip->window_full = false;
    if (chip->column >= kind->w_px || chip->page >= kind->h_px / 8) {
        complain(chip, "data at page %u, column %u", chip->page, chip->column);
        return;
    }
    const unsigned wire = chip->columns_flipped ? kind->w_px - 1u - chip->column : chip->column;
    chip->memory[chip->page][wire] = byte;
    chip->port.stores++;
    advance(chip);
}

static void take_reset(void *ctx, uint64_t pulse_us)
{
    struct emulated_pages *chip = ctx;
    if (pulse_us < RESET_PULSE_US) complain(chip, "no reset: too short a pulse");
    reset_registers(chip);
    chip->ready_us = chip->port.now_us + chip->module.kind->reset_us;
}

static void lose(void *ctx, size_t n_b)
{
    complain(ctx, "%zu bytes while reset is low", n_b);
}

void emulated_pages_init(struct emulated_pages *chip, const struct emulated_pages_module *module)
{
    assert(module->ox_px + module->w_px <= module->kind->w_px && module->h_px <= module->kind->h_px);
    memset(chip, 0, sizeof *chip);
    chip->port = (struct emulated_port){
        .chip = chip, .command = take_command, .data = take_data, .reset = take_reset, .lost = lose};
    chip->module = *module;
    for (size_t i = 0; i < sizeof chip->memory; i++)
        (&chip->memory[0][0])[i] = (uint8_t)(i * 167 + 13);
    reset_registers(chip);
}

bool emulated_pages_is_bright(const struct emulated_pages *chip, unsigned x, unsigned y)
{
    const struct emulated_pages_module *module = &chip->module;
    const bool first_columns = module->first_columns != module->kind->first_columns;
    const bool first_lines = module->first_lines != module->kind->first_lines;
    const unsigned column = module->ox_px + x, line = first_lines ? y : module->h_px - 1u - y;
    const unsigned wire = first_columns ? column : module->kind->w_px - 1u - column;
    const unsigned row = chip->lines_flipped ? module->h_px - 1u - line : line;
    const bool is_set = chip->memory[row / 8][wire] >> row % 8 & 1;

    if (!chip->on || chip->asleep || chip->port.reset_low || chip->port.backlight_low) return false;
    return (is_set != chip->inverted) != module->negative;
}
