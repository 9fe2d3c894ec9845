/* SPDX-License-Identifier: MIT
 *
 * Two languages: that of SSD1306 and its kin, where a byte is a command and some take one more, and the PCD8544's with
 * two sets of commands. What a chip does not know is complained about, and so are addresses beyond memory and what
 * comes in the wrong order. */
#include "glass/emulated_pages.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { HORIZONTAL, VERTICAL, PAGE_BY_PAGE }; /* modes: arguments of 20h */
enum { RESET_PULSE_US = 1, PUMP = 1, POWER_ALL = 7, POWER_RISES_US = 20000 };
enum { WIRING_ALTERNATES = 0x10, WIRING_EXCHANGES = 0x20, WIRING_AT_RESET = 0x12, REFERENCE = 0x10 };

/* A command with arguments, beside those that are modelled: nothing is seen of it, or nobody needs it. */
struct command {
    uint8_t code, n_args;
};

struct emulated_pages_kind {
    const char *name;
    uint16_t w_px, h_px;          /* columns, and outputs for lines */
    uint32_t reset_us;            /* after the pulse */
    const struct command *longer; /* commands with arguments; ends with code 0 */
    const char *one;              /* commands without, beside those that all have */
    bool is_pcd;
    bool rises_alone; /* its supply comes up in the right order by itself */
    uint8_t needs_power, power;
    uint8_t ratio, level; /* of the glass's voltage, after a reset */
};

/* Scrolling is told of, and not shown. */
static const struct command ssd1306_longer[] = {
    {0xD5, 1}, {0xA8, 1}, {0xD3, 1}, {0x8D, 1}, {0x20, 1}, {0xDA, 1}, {0x81, 1}, {0xD9, 1}, {0xDB, 1},
    {0xAD, 1}, {0x21, 2}, {0x22, 2}, {0x26, 6}, {0x27, 6}, {0x29, 5}, {0x2A, 5}, {0xA3, 2}, {0, 0},
};
static const struct command sh1106_longer[] = {
    {0xD5, 1}, {0xA8, 1}, {0xD3, 1}, {0xAD, 1}, {0xDA, 1}, {0x81, 1}, {0xD9, 1}, {0xDB, 1}, {0, 0},
};
static const struct command st7567_longer[] = {{0x81, 1}, {0, 0}};
static const struct command uc1701_longer[] = {{0x81, 1}, {0xFA, 1}, {0xF8, 1}, {0, 0}};

static const char st7567_one[] = "\xE2\xA2\xA3\xE3\x20\x21\x22\x23\x24\x25\x26\x27"
                                 "\x28\x29\x2A\x2B\x2C\x2D\x2E\x2F";
static const char uc1701_one[] = "\xE2\xA2\xA3\xE3\xAC\x20\x21\x22\x23\x24\x25\x26\x27"
                                 "\x28\x29\x2A\x2B\x2C\x2D\x2E\x2F";

static const struct emulated_pages_kind ssd1306 = {.name = "ssd1306",
                                                   .w_px = 128,
                                                   .h_px = 64,
                                                   .reset_us = 3,
                                                   .longer = ssd1306_longer,
                                                   .one = "\x2E\xE3",
                                                   .needs_power = PUMP};
static const struct emulated_pages_kind sh1106 = {.name = "sh1106",
                                                  .w_px = 132,
                                                  .h_px = 64,
                                                  .reset_us = 2,
                                                  .longer = sh1106_longer,
                                                  .one = "\x30\x31\x32\x33\xE3",
                                                  .needs_power = PUMP,
                                                  .power = PUMP,
                                                  .ratio = 2,
                                                  .level = 0x80};
static const struct emulated_pages_kind st7567 = {.name = "st7567",
                                                  .w_px = 132,
                                                  .h_px = 64,
                                                  .reset_us = 1000,
                                                  .longer = st7567_longer,
                                                  .one = st7567_one,
                                                  .needs_power = POWER_ALL,
                                                  .ratio = 4,
                                                  .level = 0x20};
static const struct emulated_pages_kind pcd8544 = {
    .name = "pcd8544", .w_px = 84, .h_px = 48, .is_pcd = true, .needs_power = PUMP};
static const struct emulated_pages_kind uc1701 = {.name = "uc1701",
                                                  .w_px = 132,
                                                  .h_px = 64,
                                                  .reset_us = 5000,
                                                  .longer = uc1701_longer,
                                                  .one = uc1701_one,
                                                  .rises_alone = true,
                                                  .needs_power = POWER_ALL};

const struct emulated_pages_kind *const emulated_pages_kinds[] = {&pcd8544, &sh1106, &ssd1306, &st7567, &uc1701, NULL};

const struct emulated_pages_kind *emulated_pages_kind_find(const char *name)
{
    for (size_t i = 0; emulated_pages_kinds[i]; i++)
        if (strcmp(emulated_pages_kinds[i]->name, name) == 0) return emulated_pages_kinds[i];
    return NULL;
}

__attribute__((format(printf, 2, 0))) static void keep(struct emulated_pages *chip, const char *format, va_list args)
{
    vsnprintf(chip->complaint, sizeof chip->complaint, format, args);
    chip->complaints++;
}

__attribute__((format(printf, 2, 3))) static void complain(struct emulated_pages *chip, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    keep(chip, format, args);
    va_end(args);
}

/* Of what glass would bear. */
__attribute__((format(printf, 2, 3))) static void note(struct emulated_pages *chip, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    if (!emulated_port_notes(&chip->port, format, args)) keep(chip, format, args);
    va_end(args);
}

static void reset_registers(struct emulated_pages *chip)
{
    const struct emulated_pages_kind *kind = chip->kind;

    chip->command = chip->n_args = chip->args_due = 0;
    chip->page = chip->column = 0;
    chip->on = chip->inverted = chip->all_on = chip->columns_flipped = chip->lines_flipped = chip->extended = false;
    chip->asleep = kind->is_pcd;
    chip->power = kind->power;
    chip->lines = (uint8_t)kind->h_px;
    chip->shift = chip->start_line = 0;
    chip->wiring = WIRING_AT_RESET;
    chip->ratio = kind->ratio;
    chip->level = kind->level;
    chip->mode = kind->is_pcd ? HORIZONTAL : PAGE_BY_PAGE; /* SSD1306's default, and all that the others have */
    chip->columns[0] = chip->pages[0] = 0;
    chip->columns[1] = (uint8_t)(kind->w_px - 1);
    chip->pages[1] = (uint8_t)(kind->h_px / 8 - 1);
    chip->window_full = false;
    chip->told_wiring = chip->has_reference = false;
}

/* What is on needs its supply; an LCD's rises for a while. Lines too few or too many, or wired otherwise, are seen as
 * well. */
static void switch_on(struct emulated_pages *chip)
{
    const struct emulated_pages_kind *kind = chip->kind;
    const bool is_oled = kind->needs_power == PUMP && !kind->is_pcd;

    if ((chip->power & kind->needs_power) != kind->needs_power)
        note(chip, "display on without its voltage");
    else if (kind->needs_power == POWER_ALL && emulated_port_is_before(&chip->port, chip->power_us + POWER_RISES_US))
        note(chip, "display on %u us after its voltage", (unsigned)(chip->port.now_us - chip->power_us));
    if (is_oled && chip->lines != chip->glass.h_px)
        note(chip, "%u lines in use, the glass has %u", chip->lines, chip->glass.h_px);
    if (is_oled && !chip->told_wiring) note(chip, "display on, lines wired anyhow");
    chip->on = true;
}

static void set_range(struct emulated_pages *chip, uint8_t range[2], uint8_t *at, unsigned end)
{
    if (chip->mode == PAGE_BY_PAGE) note(chip, "%02Xh: pages are addressed one by one", chip->command);
    if (chip->args[0] > chip->args[1] || chip->args[1] >= end)
        note(chip, "%02Xh %u..%u: memory is 0..%u", chip->command, chip->args[0], chip->args[1], end - 1);
    range[0] = (uint8_t)(chip->args[0] % end);
    range[1] = (uint8_t)(chip->args[1] % end);
    *at = range[0];
    chip->window_full = false;
}

static void set_mode(struct emulated_pages *chip, uint8_t mode)
{
    chip->mode = mode > PAGE_BY_PAGE ? PAGE_BY_PAGE : mode;
    if (mode > PAGE_BY_PAGE) complain(chip, "there is no addressing mode %u", mode);
}

static void set_wiring(struct emulated_pages *chip, uint8_t wiring)
{
    const unsigned alternates = chip->glass.wiring == GLASS_ALTERNATING ? WIRING_ALTERNATES : 0;

    chip->wiring = wiring;
    chip->told_wiring = true;
    if ((wiring & (WIRING_ALTERNATES | WIRING_EXCHANGES)) != alternates)
        note(chip, "lines are not wired as %02X says", wiring);
}

static void run_arguments(struct emulated_pages *chip)
{
    const struct emulated_pages_kind *kind = chip->kind;
    const uint8_t argument = chip->args[0];

    switch (chip->command) {
    case 0xA8:
        chip->lines = (uint8_t)((argument & 63) + 1);
        break;
    case 0xD3:
        chip->shift = argument & 63;
        break;
    case 0x81:
        chip->level = argument;
        break;
    case 0x8D:
        chip->power = argument & 4 ? PUMP : 0;
        break;
    case 0xAD:
        if (kind->power)
            chip->power = argument & 1 ? PUMP : 0;
        else
            chip->has_reference = argument & REFERENCE;
        break;
    case 0x20:
        set_mode(chip, argument);
        break;
    case 0x21:
        set_range(chip, chip->columns, &chip->column, kind->w_px);
        break;
    case 0x22:
        set_range(chip, chip->pages, &chip->page, kind->h_px / 8u);
        break;
    case 0xDA:
        set_wiring(chip, argument);
        break;
    case 0x26:
    case 0x27:
    case 0x29:
    case 0x2A:
        note(chip, "%02Xh: scrolling is not modelled", chip->command);
        break;
    default:
        break;
    }
}

/* Booster, regulator, follower: 4, 2 and 1, one after the other. */
static void set_power(struct emulated_pages *chip, uint8_t power)
{
    if (power == POWER_ALL && chip->power != 6 && !chip->kind->rises_alone) note(chip, "all of the supply at once");
    chip->power = power;
    chip->power_us = chip->port.now_us;
}

/* The address within a page, and the page. The SSD1306's datasheet has these commands for addressing pages one by one;
 * modules take them in its other modes too: u8g2 places all that it draws so, with 20h 00h. */
static void set_address(struct emulated_pages *chip, uint8_t command)
{
    if (chip->mode != PAGE_BY_PAGE) note(chip, "%02Xh: pages are not addressed one by one", command);
    if (command >= 0xB0)
        chip->page = command & 7;
    else if (command < 0x10)
        chip->column = (uint8_t)((chip->column & 0xF0) | command);
    else
        chip->column = (uint8_t)((chip->column & 0x0F) | (command & 0x0F) << 4);
    chip->window_full = false;
}

static uint8_t args_of(const struct emulated_pages_kind *kind, uint8_t command)
{
    for (const struct command *at = kind->longer; at->code; at++)
        if (at->code == command) return at->n_args;
    return 0;
}

/* Commands that all have. */
static void run_common(struct emulated_pages *chip, uint8_t command)
{
    if (command < 0x20 || (command & 0xF8) == 0xB0)
        set_address(chip, command);
    else if ((command & 0xFE) == 0xA0)
        chip->columns_flipped = command & 1;
    else if ((command & 0xF7) == 0xC0)
        chip->lines_flipped = command & 8;
    else if ((command & 0xFE) == 0xA6)
        chip->inverted = command & 1;
    else if ((command & 0xFE) == 0xA4)
        chip->all_on = command & 1;
    else if ((command & 0xC0) == 0x40)
        chip->start_line = command & 63;
    else if (command == 0xAF)
        switch_on(chip);
    else if (command == 0xAE)
        chip->on = false;
    else
        note(chip, "command 0x%02X is unknown or not modelled", command);
}

static void run_plain(struct emulated_pages *chip, uint8_t command)
{
    const struct emulated_pages_kind *kind = chip->kind;

    if (args_of(kind, command)) {
        chip->command = command;
        chip->n_args = 0;
        chip->args_due = args_of(kind, command);
    } else if (!command || !strchr(kind->one, command)) {
        run_common(chip, command);
    } else if (command == 0xE2) {
        reset_registers(chip);
    } else if ((command & 0xF8) == 0x28 && kind->needs_power == POWER_ALL) {
        set_power(chip, command & 7);
    } else if ((command & 0xE0) == 0x20) {
        chip->ratio = command & 7; /* a charge pump has half as many */
    }
}

static void run_pcd(struct emulated_pages *chip, uint8_t command)
{
    if ((command & 0xF8) == 0x20) {
        chip->extended = command & 1;
        chip->asleep = command & 4;
        chip->mode = command & 2 ? VERTICAL : HORIZONTAL;
    } else if (chip->extended) {
        if (command & 0x80) {
            chip->power = PUMP;
            chip->level = command & 0x7F;
        } else if ((command & 0xFC) != 0x04 && (command & 0xF8) != 0x10) {
            note(chip, "extended command 0x%02X is unknown", command);
        }
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
        note(chip, "command 0x%02X is unknown or not modelled", command);
    }
}

static void take_command(void *ctx, uint8_t byte)
{
    struct emulated_pages *chip = ctx;

    if (emulated_port_is_before(&chip->port, chip->ready_us)) note(chip, "0x%02X too soon after reset", byte);
    if (chip->args_due) {
        chip->args[chip->n_args++] = byte;
        if (--chip->args_due == 0) run_arguments(chip);
    } else if (chip->kind->is_pcd) {
        run_pcd(chip, byte);
    } else {
        run_plain(chip, byte);
    }
}

static bool step(uint8_t *at, const uint8_t range[2])
{
    const bool ends = *at == range[1];

    *at = ends ? range[0] : (uint8_t)(*at + 1);
    return ends;
}

/* A window, and all of a PCD8544's memory, go on with the next page or column, and from the end to the start. */
static void advance(struct emulated_pages *chip)
{
    if (chip->mode == PAGE_BY_PAGE)
        chip->column++;
    else if (chip->mode == VERTICAL)
        chip->window_full = step(&chip->page, chip->pages) && step(&chip->column, chip->columns);
    else
        chip->window_full = step(&chip->column, chip->columns) && step(&chip->page, chip->pages);
    if (chip->kind->is_pcd) chip->window_full = false;
}

/* Columns are exchanged as bytes come in, lines as they are shown. */
static void take_data(void *ctx, uint8_t byte)
{
    struct emulated_pages *chip = ctx;
    const struct emulated_pages_kind *kind = chip->kind;

    if (chip->args_due) complain(chip, "data after 0x%02X, which lacks %u arguments", chip->command, chip->args_due);
    chip->args_due = 0;
    if (chip->window_full) note(chip, "more bytes than the window holds");
    chip->window_full = false;
    if (chip->column >= kind->w_px || chip->page >= kind->h_px / 8) {
        complain(chip, "data at page %u, column %u", chip->page, chip->column);
        return;
    }
    const unsigned wire = chip->columns_flipped ? kind->w_px - 1u - chip->column : chip->column;
    chip->memory[chip->page][wire] = byte;
    emulated_port_store(&chip->port, (struct emulated_place){(uint16_t)wire, (uint16_t)(8 * chip->page), 1, 8});
    advance(chip);
}

static void take_reset(void *ctx, uint64_t pulse_us)
{
    struct emulated_pages *chip = ctx;
    if (pulse_us < RESET_PULSE_US) complain(chip, "no reset: too short a pulse");
    reset_registers(chip);
    chip->ready_us = chip->port.now_us + chip->kind->reset_us;
}

static void lose(void *ctx, size_t n_b)
{
    complain(ctx, "%zu bytes while reset is low", n_b);
}

void emulated_pages_init(struct emulated_pages *chip, const struct glass *glass)
{
    memset(chip, 0, sizeof *chip);
    chip->kind = emulated_pages_kind_find(glass->chip);
    chip->glass = *glass;
    assert(chip->kind && glass->mem_w_px == chip->kind->w_px && glass->mem_h_px == chip->kind->h_px);
    assert(glass_fits(glass));
    chip->port = (struct emulated_port){
        .chip = chip, .command = take_command, .data = take_data, .reset = take_reset, .lost = lose};
    for (size_t i = 0; i < sizeof chip->memory; i++)
        (&chip->memory[0][0])[i] = (uint8_t)(i * 167 + 13);
    reset_registers(chip);
}

/* What the eye sees -------------------------------------------------------------------------- */

/* Outputs leave the chip on two sides, each a half of them. Alternating, even lines come from the first side and odd
 * ones from the second. */
static unsigned pad_of(unsigned output, bool alternates, unsigned outputs)
{
    if (!alternates) return output;
    return output / 2 + (output % 2 ? outputs / 2 : 0);
}

static unsigned output_at(unsigned pad, bool alternates, unsigned outputs)
{
    if (!alternates) return pad;
    return pad < outputs / 2 ? 2 * pad : 2 * (pad - outputs / 2) + 1;
}

/* The output that drives a line of the glass, as the chip numbers them. */
static unsigned output_of(const struct emulated_pages *chip, unsigned y)
{
    const unsigned outputs = chip->kind->h_px, meant = glass_line(&chip->glass, y);

    if (!chip->glass.told_lines) return meant;
    unsigned pad = pad_of(meant, chip->glass.wiring == GLASS_ALTERNATING, outputs);
    if (chip->wiring & WIRING_EXCHANGES) pad = (pad + outputs / 2) % outputs;
    return output_at(pad, chip->wiring & WIRING_ALTERNATES, outputs);
}

/* Lines in use are scanned from output 0 on or, flipped, down to it; the shift moves all outputs by so many lines.
 * Those that are not in use show nothing. */
static bool memory_line(const struct emulated_pages *chip, unsigned y, unsigned *line)
{
    const unsigned outputs = chip->kind->h_px, output = output_of(chip, y);
    const unsigned scanned =
        chip->lines_flipped ? outputs + chip->lines - 1u + chip->shift - output : output + chip->shift;

    *line = (scanned % outputs + chip->start_line) % outputs;
    return scanned % outputs < chip->lines;
}

bool emulated_pages_is_bright(const struct emulated_pages *chip, unsigned x, unsigned y)
{
    unsigned line;

    if (!chip->on || chip->asleep || chip->port.reset_low || chip->port.backlight_low) return false;
    if (chip->glass.needs_reference && !chip->has_reference) return false;
    if (!memory_line(chip, y, &line)) return false;
    const bool is_set = chip->memory[line / 8][glass_column(&chip->glass, x)] >> line % 8 & 1;
    return (chip->all_on || is_set != chip->inverted) != chip->glass.negative;
}
