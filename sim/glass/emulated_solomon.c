/* SPDX-License-Identifier: MIT
 *
 * Bytes are commands, arguments or pixels: by D/C and, where the chip takes arguments with D/C low, by how many the
 * command before is due. Columns are exchanged as pixels come in, lines as they are shown. */
#include "glass/emulated_solomon.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { RESET_PULSE_US = 2 };

struct command {
    uint8_t code, n_args;
    bool is_locked; /* until FDh B1h */
};

struct emulated_solomon_kind {
    const char *name;
    uint16_t w_px, h_px;
    bool args_low;        /* arguments come with D/C low, and pixels need no command */
    bool has_colours;     /* else two pixels of grey a byte */
    uint8_t lines, write; /* commands: lines in use; pixels follow */
    uint8_t as_is, negative, all_off;
    uint8_t columns_bit, exchange_bit, grey_bit; /* of A0h; the last: which pixel of a byte comes first */
    const struct command *commands;              /* ends with code 0 */
};

enum { ROWS_BIT = 0x10, EXCHANGE_COLOURS_BIT = 0x04 };

/* Beside these: 15h, 75h, A0h, A1h, A2h, AEh, AFh, FDh, which are modelled, and those that the kinds name. */
static const struct command ssd1351_commands[] = {
    {0x9E, 0, false}, {0xAB, 1, false}, {0xB1, 1, true},   {0xB2, 3, false}, {0xB3, 1, true}, {0xB4, 3, false},
    {0xB5, 1, false}, {0xB6, 1, false}, {0xB8, 63, false}, {0xB9, 0, false}, {0xBB, 1, true}, {0xBE, 1, true},
    {0xC1, 3, true},  {0xC7, 1, false}, {0xE3, 0, false},  {0, 0, false},
};
static const struct command ssd1327_commands[] = {
    {0x2E, 0, false}, {0x81, 1, false}, {0xAB, 1, false},  {0xB1, 1, false}, {0xB3, 1, false},
    {0xB5, 1, false}, {0xB6, 1, false}, {0xB8, 15, false}, {0xB9, 0, false}, {0xBC, 1, false},
    {0xBE, 1, false}, {0xD5, 1, false}, {0xE3, 0, false},  {0, 0, false},
};
static const struct command ssd0323_commands[] = {
    {0x81, 1, false}, {0x84, 0, false}, {0x85, 0, false}, {0x86, 0, false}, {0xAD, 1, false},
    {0xB1, 1, false}, {0xB2, 1, false}, {0xB3, 1, false}, {0xB8, 8, false}, {0xBC, 1, false},
    {0xBE, 1, false}, {0xBF, 1, false}, {0xE3, 0, false}, {0x23, 1, false}, {0x2E, 0, false},
    {0xB0, 1, false}, {0xB4, 1, false}, {0xCF, 1, false}, {0, 0, false},
};

static const struct emulated_solomon_kind ssd1351 = {.name = "ssd1351",
                                                     .w_px = 128,
                                                     .h_px = 128,
                                                     .has_colours = true,
                                                     .lines = 0xCA,
                                                     .write = 0x5C,
                                                     .as_is = 0xA6,
                                                     .negative = 0xA7,
                                                     .all_off = 0xA4,
                                                     .columns_bit = 0x02,
                                                     .exchange_bit = 0x01,
                                                     .commands = ssd1351_commands};
static const struct emulated_solomon_kind ssd1327 = {.name = "ssd1327",
                                                     .w_px = 128,
                                                     .h_px = 128,
                                                     .args_low = true,
                                                     .lines = 0xA8,
                                                     .as_is = 0xA4,
                                                     .negative = 0xA7,
                                                     .all_off = 0xA6,
                                                     .columns_bit = 0x01,
                                                     .exchange_bit = 0x04,
                                                     .grey_bit = 0x02,
                                                     .commands = ssd1327_commands};
static const struct emulated_solomon_kind ssd0323 = {.name = "ssd0323",
                                                     .w_px = 128,
                                                     .h_px = 80,
                                                     .args_low = true,
                                                     .lines = 0xA8,
                                                     .as_is = 0xA4,
                                                     .negative = 0xA7,
                                                     .all_off = 0xA6,
                                                     .columns_bit = 0x01,
                                                     .exchange_bit = 0x04,
                                                     .grey_bit = 0x02,
                                                     .commands = ssd0323_commands};

const struct emulated_solomon_kind *const emulated_solomon_kinds[] = {&ssd0323, &ssd1327, &ssd1351, NULL};

const struct emulated_solomon_kind *emulated_solomon_kind_find(const char *name)
{
    for (size_t i = 0; emulated_solomon_kinds[i]; i++)
        if (strcmp(emulated_solomon_kinds[i]->name, name) == 0) return emulated_solomon_kinds[i];
    return NULL;
}

__attribute__((format(printf, 2, 0))) static void keep(struct emulated_solomon *chip, const char *format, va_list args)
{
    vsnprintf(chip->complaint, sizeof chip->complaint, format, args);
    chip->complaints++;
}

__attribute__((format(printf, 2, 3))) static void complain(struct emulated_solomon *chip, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    keep(chip, format, args);
    va_end(args);
}

/* Of what glass would bear. */
__attribute__((format(printf, 2, 3))) static void note(struct emulated_solomon *chip, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    if (!emulated_port_notes(&chip->port, format, args)) keep(chip, format, args);
    va_end(args);
}

static unsigned column_px(const struct emulated_solomon_kind *kind)
{
    return kind->has_colours ? 1 : 2;
}

static void reset_registers(struct emulated_solomon *chip)
{
    const struct emulated_solomon_kind *kind = chip->kind;

    chip->n_args = chip->args_due = 0;
    chip->unlocked = chip->awake = chip->window_full = false;
    chip->writing = kind->args_low;
    chip->remap = kind->has_colours ? 0x40 : 0;
    chip->first_line = chip->shift = 0;
    chip->contrast = 0x40;
    chip->range = 0x84;
    chip->lines = (uint8_t)(kind->h_px - 1);
    chip->shown = kind->as_is;
    chip->columns[0] = chip->rows[0] = chip->column = chip->row = 0;
    chip->columns[1] = (uint8_t)(kind->w_px / column_px(kind) - 1);
    chip->rows[1] = (uint8_t)(kind->h_px - 1);
    chip->n_bits = 0;
}

/* Commands --------------------------------------------------------------------------------- */

/* Addresses beyond memory come round; a range that ends before it begins changes nothing. */
static void set_range(struct emulated_solomon *chip, uint8_t range[2], uint8_t *at, unsigned end)
{
    const uint8_t first = (uint8_t)(chip->args[0] % end), last = (uint8_t)(chip->args[1] % end);

    if (chip->args[0] > chip->args[1] || chip->args[1] >= end)
        note(chip, "%02Xh %u..%u: memory is 0..%u", chip->command, chip->args[0], chip->args[1], end - 1);
    if (first > last) return;
    range[0] = *at = first;
    range[1] = last;
    chip->window_full = false;
}

static void set_remap(struct emulated_solomon *chip, uint8_t remap)
{
    const struct emulated_solomon_kind *kind = chip->kind;
    const unsigned depth = remap >> 6;

    if (kind->has_colours ? remap & 0x08 || depth == 0 || depth == 3 : remap & 0xA8)
        complain(chip, "A0h %02Xh is not defined, or not modelled", remap);
    if (!(remap & (kind->has_colours ? 0x20 : 0x40))) complain(chip, "odd and even lines are not apart");
    chip->remap = remap;
}

static void lock(struct emulated_solomon *chip, uint8_t how)
{
    if (how != 0x12 && (how != 0xB1 || !chip->kind->has_colours)) note(chip, "FDh %02Xh", how);
    if (how == 0xB1) chip->unlocked = true;
}

/* More lines in use than there are do no harm, fewer are seen as well. */
static void wake(struct emulated_solomon *chip)
{
    if (chip->lines + 1 < chip->glass.h_px)
        note(chip, "%u lines in use, the glass has %u", chip->lines + 1, chip->glass.h_px);
    chip->awake = true;
}

static void run(struct emulated_solomon *chip)
{
    const struct emulated_solomon_kind *kind = chip->kind;
    const uint8_t command = chip->command, argument = chip->args[0];

    if (command == 0x15)
        set_range(chip, chip->columns, &chip->column, kind->w_px / column_px(kind));
    else if (command == 0x75)
        set_range(chip, chip->rows, &chip->row, kind->h_px);
    else if (command == 0xA0)
        set_remap(chip, argument);
    else if (command == 0xA1)
        chip->first_line = argument;
    else if (command == 0xA2)
        chip->shift = argument;
    else if (command == 0x81)
        chip->contrast = argument;
    else if (command >= 0x84 && command <= 0x86)
        chip->range = command;
    else if (command == 0xAE)
        chip->awake = false;
    else if (command == 0xAF)
        wake(chip);
    else if (command == 0xFD)
        lock(chip, argument);
    else if (command == kind->lines)
        chip->lines = argument;
    else if (command == kind->as_is || command == kind->negative || command == kind->all_off)
        chip->shown = command;
}

/* How many arguments a command takes; -1: the chip has none of that code. */
static int args_of(struct emulated_solomon *chip, uint8_t code)
{
    const struct emulated_solomon_kind *kind = chip->kind;

    if (code == 0x15 || code == 0x75) return 2;
    if (code == 0xA0 || code == 0xA1 || code == 0xA2 || code == 0xFD || code == kind->lines) return 1;
    if (code == 0xAE || code == 0xAF || code == kind->as_is || code == kind->negative || code == kind->all_off)
        return 0;
    if (kind->write && code == kind->write) return 0;
    for (const struct command *at = kind->commands; at->code; at++) {
        if (at->code != code) continue;
        if (at->is_locked && !chip->unlocked) note(chip, "%02Xh is locked", code);
        return at->n_args;
    }
    return -1;
}

static void begin(struct emulated_solomon *chip, uint8_t code)
{
    const struct emulated_solomon_kind *kind = chip->kind;
    const int n_args = args_of(chip, code);

    if (chip->n_bits) complain(chip, "a pixel was cut after %u bits", chip->n_bits);
    chip->n_bits = 0;
    chip->writing = kind->args_low || code == kind->write;
    chip->command = code;
    chip->n_args = 0;
    chip->args_due = n_args > 0 ? (uint8_t)n_args : 0;
    if (n_args < 0) note(chip, "command %02Xh is unknown or not modelled", code);
    if (n_args == 0) run(chip);
}

static void take_argument(struct emulated_solomon *chip, uint8_t byte)
{
    chip->args[chip->n_args++] = byte;
    if (--chip->args_due == 0) run(chip);
}

static void take_command(void *ctx, uint8_t byte)
{
    struct emulated_solomon *chip = ctx;

    if (chip->args_due && chip->kind->args_low) {
        take_argument(chip, byte);
        return;
    }
    if (chip->args_due) complain(chip, "%02Xh lacks %u arguments", chip->command, chip->args_due);
    begin(chip, byte);
}

/* Pixels ------------------------------------------------------------------------------------- */

static bool step(uint8_t *at, const uint8_t range[2])
{
    const bool ends = *at == range[1];

    *at = ends ? range[0] : (uint8_t)(*at + 1);
    return ends;
}

static void advance(struct emulated_solomon *chip)
{
    if (chip->remap & chip->kind->exchange_bit)
        chip->window_full = step(&chip->row, chip->rows) && step(&chip->column, chip->columns);
    else
        chip->window_full = step(&chip->column, chip->columns) && step(&chip->row, chip->rows);
}

static void store_greys(struct emulated_solomon *chip, uint8_t byte)
{
    const struct emulated_solomon_kind *kind = chip->kind;
    const unsigned pair = chip->remap & kind->columns_bit ? kind->w_px / 2u - 1 - chip->column : chip->column;
    const bool upper_first = chip->remap & kind->grey_bit;

    chip->memory[chip->row][2 * pair] = upper_first ? byte >> 4 : byte & 15;
    chip->memory[chip->row][2 * pair + 1] = upper_first ? byte & 15 : byte >> 4;
    emulated_port_store(&chip->port, (struct emulated_place){(uint16_t)(2 * pair), chip->row, 2, 1});
    advance(chip);
}

static void store_colour(struct emulated_solomon *chip, uint8_t byte)
{
    const struct emulated_solomon_kind *kind = chip->kind;
    const unsigned wire = chip->remap & kind->columns_bit ? kind->w_px - 1u - chip->column : chip->column;
    const bool is_wide = chip->remap >> 6 == 2;

    chip->bits = chip->bits << 8 | byte;
    chip->n_bits = (uint8_t)(chip->n_bits + 8);
    if (chip->n_bits < (is_wide ? 24 : 16)) return;
    chip->memory[chip->row][wire] = chip->bits;
    chip->wide[chip->row][wire] = is_wide;
    emulated_port_store(&chip->port, (struct emulated_place){(uint16_t)wire, chip->row, 1, 1});
    chip->bits = chip->n_bits = 0;
    advance(chip);
}

static void take_data(void *ctx, uint8_t byte)
{
    struct emulated_solomon *chip = ctx;
    const bool args_low = chip->kind->args_low;

    if (chip->args_due && !args_low) {
        take_argument(chip, byte);
        return;
    }
    if (chip->args_due || !chip->writing) {
        complain(chip, "data %02Xh after command %02Xh", byte, chip->command);
        return;
    }
    if (chip->window_full && chip->n_bits == 0) note(chip, "more pixels than the window holds");
    if (chip->kind->has_colours)
        store_colour(chip, byte);
    else
        store_greys(chip, byte);
}

static void take_reset(void *ctx, uint64_t pulse_us)
{
    struct emulated_solomon *chip = ctx;

    if (pulse_us < RESET_PULSE_US) complain(chip, "no reset: too short a pulse");
    reset_registers(chip);
}

static void lose(void *ctx, size_t n_b)
{
    complain(ctx, "%zu bytes while reset is low", n_b);
}

void emulated_solomon_init(struct emulated_solomon *chip, const struct glass *glass)
{
    memset(chip, 0, sizeof *chip);
    chip->kind = emulated_solomon_kind_find(glass->chip);
    chip->glass = *glass;
    assert(chip->kind && glass->mem_w_px == chip->kind->w_px && glass->mem_h_px == chip->kind->h_px);
    assert(glass_fits(glass));
    chip->port = (struct emulated_port){
        .chip = chip, .command = take_command, .data = take_data, .reset = take_reset, .lost = lose};
    for (unsigned i = 0; i < EMULATED_SOLOMON_MAX_PX * EMULATED_SOLOMON_MAX_PX; i++)
        chip->memory[i / EMULATED_SOLOMON_MAX_PX][i % EMULATED_SOLOMON_MAX_PX] = i * 167u & 15u;
    reset_registers(chip);
}

/* What the eye sees -------------------------------------------------------------------------- */

/* Lines in use are scanned from output 0 on, or down to it; the shift moves all outputs by so many lines. Memory begins
 * where A1h says. Outputs beyond the lines in use show nothing. */
static bool memory_row(const struct emulated_solomon *chip, unsigned y, unsigned *row)
{
    const unsigned outputs = chip->kind->h_px, output = glass_line(&chip->glass, y);
    const unsigned last = chip->glass.told_lines ? chip->lines : outputs - 1u;
    const unsigned scanned =
        (chip->remap & ROWS_BIT ? outputs + last + chip->shift - output : output + chip->shift) % outputs;

    *row = (scanned + chip->first_line) % outputs;
    return scanned <= chip->lines;
}

static void decode(const struct emulated_solomon *chip, unsigned row, unsigned wire, uint8_t rgb[3])
{
    const uint32_t raw = chip->memory[row][wire];
    const bool is_wide = chip->wide[row][wire];
    const unsigned first = is_wide ? raw >> 16 & 63 : raw >> 11 & 31;
    const unsigned second = is_wide ? raw >> 8 & 63 : raw >> 5 & 63;
    const unsigned third = is_wide ? raw & 63 : raw & 31;
    const uint8_t outer[] = {(uint8_t)(is_wide ? first << 2 | first >> 4 : first << 3 | first >> 2),
                             (uint8_t)(is_wide ? third << 2 | third >> 4 : third << 3 | third >> 2)};
    const bool red_first = (bool)(chip->remap & EXCHANGE_COLOURS_BIT) == chip->glass.blue_first;

    if (!chip->kind->has_colours) {
        memset(rgb, (int)(raw * 17), 3);
        return;
    }
    rgb[0] = outer[!red_first];
    rgb[1] = (uint8_t)(second << 2 | second >> 4);
    rgb[2] = outer[red_first];
}

void emulated_solomon_see(const struct emulated_solomon *chip, unsigned x, unsigned y, uint8_t rgb[3])
{
    const struct emulated_solomon_kind *kind = chip->kind;
    const bool lit = chip->awake && !chip->port.reset_low && !chip->port.backlight_low;
    unsigned row;

    memset(rgb, 0, 3);
    if (!lit || chip->shown == kind->all_off || !memory_row(chip, y, &row)) return;
    decode(chip, row, glass_column(&chip->glass, x), rgb);
    for (unsigned i = 0; i < 3 && (chip->shown == kind->negative) != chip->glass.negative; i++)
        rgb[i] = (uint8_t)(255 - rgb[i]);
}

unsigned emulated_solomon_current_permille(const struct emulated_solomon *chip)
{
    const unsigned quarters = chip->range == 0x86 ? 4 : chip->range == 0x85 ? 2 : 1;

    return strcmp(chip->kind->name, "ssd0323") == 0 ? 1000u * quarters * (chip->contrast & 127u) / (4 * 127u) : 0;
}
