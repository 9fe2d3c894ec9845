/* SPDX-License-Identifier: MIT
 *
 * An emulated chip: bytes, D/C and reset in; memory, a picture and complaints out.
 * A byte goes down one of three ways: as a command (D/C low), as an argument of the last command,
 * or as part of a pixel while RAMWR or RAMWRC is in force. Times are checked against the
 * datasheet's, on a clock that only the driver's own waits advance. */
#include "glass/emulated_dcs.h"

#include <assert.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { ROW_ORDER = 0x80, COLUMN_ORDER = 0x40, EXCHANGE = 0x20, MADCTL_RESERVED = 0x03 };

/* The keys of a register that locks others, and what takes each back; others are locked from B0h on. */
enum { KEY_1 = 0xC3, KEY_2 = 0x96, ALL_KEYS = 3, FIRST_LOCKED = 0xB0 };

enum { RESET_PULSE_US = 10, LISTEN_US = 5000, SLEEP_CHANGE_US = 120000 };

/* `is_borne`: glass would bear it. */
__attribute__((format(printf, 4, 0))) static void keep(bool is_borne, struct emulated_dcs *chip,
                                                       enum emulated_complaint kind, const char *format, va_list args)
{
    if (is_borne && emulated_port_notes(&chip->port, format, args)) return;
    vsnprintf(chip->complaint, sizeof chip->complaint, format, args);
    chip->complaints++;
    chip->complaints_of[kind]++;
    if (chip->on_complaint) chip->on_complaint(chip->on_complaint_ctx, chip->complaint);
}

__attribute__((format(printf, 4, 5))) static void note_if(bool is_borne, struct emulated_dcs *chip,
                                                          enum emulated_complaint kind, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    keep(is_borne, chip, kind, format, args);
    va_end(args);
}

__attribute__((format(printf, 3, 4))) static void note(struct emulated_dcs *chip, enum emulated_complaint kind,
                                                       const char *format, ...)
{
    va_list args;
    va_start(args, format);
    keep(true, chip, kind, format, args);
    va_end(args);
}

__attribute__((format(printf, 3, 4))) static void complain(struct emulated_dcs *chip, enum emulated_complaint kind,
                                                           const char *format, ...)
{
    va_list args;
    va_start(args, format);
    keep(false, chip, kind, format, args);
    va_end(args);
}

static uint16_t columns_end(const struct emulated_dcs *chip)
{
    return chip->madctl & EXCHANGE ? chip->glass.mem_h_px : chip->glass.mem_w_px;
}

static uint16_t rows_end(const struct emulated_dcs *chip)
{
    return chip->madctl & EXCHANGE ? chip->glass.mem_w_px : chip->glass.mem_h_px;
}

/* What both kinds of reset do; memory keeps its contents. */
static void reset_registers(struct emulated_dcs *chip)
{
    chip->asleep = true;
    chip->display_on = false;
    chip->inverted = false;
    chip->tells_refresh = false;
    chip->scan = 0;
    chip->keys = 0;
    chip->columns[0] = 0;
    chip->columns[1] = (uint16_t)(columns_end(chip) - 1);
    chip->rows[0] = 0;
    chip->rows[1] = (uint16_t)(rows_end(chip) - 1);
    chip->address_valid = false;
    chip->ready_us = chip->port.now_us + LISTEN_US;
    chip->sleep_out_from_us = chip->port.now_us + SLEEP_CHANGE_US;
    chip->sleep_in_from_us = chip->port.now_us;
}

static void reset_hardware(struct emulated_dcs *chip)
{
    chip->madctl = 0;
    chip->bits_a_pixel = 24;
    chip->command = NULL;
    chip->writing = false;
    chip->n_bits = 0;
    reset_registers(chip);
}

static bool too_soon(struct emulated_dcs *chip, uint64_t from_us)
{
    if (!emulated_port_is_before(&chip->port, from_us)) return false;
    note(chip, EMULATED_TOO_SOON, "%s came %u us too soon", chip->command->name,
         (unsigned)(from_us - chip->port.now_us));
    return !chip->port.foreign;
}

static void run_swreset(struct emulated_dcs *chip)
{
    too_soon(chip, chip->sleep_in_from_us); /* not allowed while sleep is being left */
    reset_registers(chip);
}

static void run_slpin(struct emulated_dcs *chip)
{
    if (chip->asleep || too_soon(chip, chip->sleep_in_from_us)) return;
    chip->asleep = true;
    chip->ready_us = chip->port.now_us + LISTEN_US;
    chip->sleep_out_from_us = chip->port.now_us + SLEEP_CHANGE_US;
}

static void run_slpout(struct emulated_dcs *chip)
{
    if (!chip->asleep || too_soon(chip, chip->sleep_out_from_us)) return;
    chip->asleep = false;
    chip->ready_us = chip->port.now_us + LISTEN_US;
    chip->sleep_in_from_us = chip->port.now_us + SLEEP_CHANGE_US;
}

static void run_invoff(struct emulated_dcs *chip)
{
    chip->inverted = false;
}

static void run_invon(struct emulated_dcs *chip)
{
    chip->inverted = true;
}

static void run_dispoff(struct emulated_dcs *chip)
{
    chip->display_on = false;
}

static void run_dispon(struct emulated_dcs *chip)
{
    if (chip->asleep) note(chip, EMULATED_ASLEEP, "DISPON while asleep");
    chip->display_on = true;
}

static void run_teoff(struct emulated_dcs *chip)
{
    chip->tells_refresh = false;
}

/* Mode 1 tells each line as well. */
static void run_teon(struct emulated_dcs *chip)
{
    if (chip->args[0] != 0) note(chip, EMULATED_ARGS_VALUE, "TEON 0x%02X", chip->args[0]);
    chip->tells_refresh = true;
}

static bool next_refresh(void *ctx, uint64_t *at_us)
{
    struct emulated_dcs *chip = ctx;
    if (!chip->tells_refresh) complain(chip, EMULATED_TEARING, "waited for the refresh without TEON");
    *at_us = (chip->port.now_us / chip->refresh_us + 1) * chip->refresh_us;
    return chip->tells_refresh && !chip->asleep;
}

static void set_range(struct emulated_dcs *chip, uint16_t range[2], uint16_t end)
{
    unsigned first = chip->args[0] * 256u + chip->args[1];
    unsigned last = chip->args[2] * 256u + chip->args[3];
    chip->address_valid = false;
    if (first > last || last >= end) {
        note(chip, EMULATED_RANGE, "%s %u..%u: memory is 0..%u here", chip->command->name, first, last, end - 1u);
        return;
    }
    range[0] = (uint16_t)first;
    range[1] = (uint16_t)last;
}

static void run_caset(struct emulated_dcs *chip)
{
    set_range(chip, chip->columns, columns_end(chip));
}

static void run_raset(struct emulated_dcs *chip)
{
    set_range(chip, chip->rows, rows_end(chip));
}

static void run_madctl(struct emulated_dcs *chip)
{
    if (chip->args[0] & MADCTL_RESERVED) note(chip, EMULATED_ARGS_VALUE, "MADCTL 0x%02X", chip->args[0]);
    chip->madctl = chip->args[0];
    chip->address_valid = false;
}

static void run_colmod(struct emulated_dcs *chip)
{
    const unsigned format = chip->args[0] & 0x07;

    if (format == 3 && chip->kind->takes_12)
        chip->bits_a_pixel = 12;
    else if (format == 5 && chip->kind->takes_16)
        chip->bits_a_pixel = 16;
    else if (format == 6) /* six bits in each of three bytes */
        chip->bits_a_pixel = 24;
    else
        complain(chip, EMULATED_ARGS_VALUE, "COLMOD 0x%02X", chip->args[0]);
}

/* Which way the outputs for columns and for rows are scanned, whatever MADCTL says of memory. */
static void run_scan(struct emulated_dcs *chip)
{
    chip->scan = chip->args[1];
}

/* A key's bits, inverted, take it back. */
static void run_lock(struct emulated_dcs *chip)
{
    const uint8_t key = chip->args[0], taken = (uint8_t)~key;

    if (key == KEY_1 || key == KEY_2)
        chip->keys |= key == KEY_1 ? 1 : 2;
    else if (taken == KEY_1 || taken == KEY_2)
        chip->keys &= taken == KEY_1 ? 2 : 1;
    else
        note(chip, EMULATED_ARGS_VALUE, "%s 0x%02X is no key", chip->command->name, key);
}

static void start_writing(struct emulated_dcs *chip)
{
    chip->writing = true;
    chip->n_bits = 0;
    if (chip->asleep) note(chip, EMULATED_ASLEEP, "%s while asleep", chip->command->name);
    if (chip->address_valid) return;
    note(chip, EMULATED_PIXELS_OUTSIDE, "%s without a valid window", chip->command->name);
    chip->ignore_data = true;
}

/* A window that fitted may not fit any more once columns and rows were exchanged. */
static void run_ramwr(struct emulated_dcs *chip)
{
    chip->frame_writes++;
    chip->x = chip->columns[0];
    chip->y = chip->rows[0];
    chip->window_full = false;
    chip->address_valid = chip->columns[1] < columns_end(chip) && chip->rows[1] < rows_end(chip);
    start_writing(chip);
}

static bool is_locked(const struct emulated_dcs *chip, uint8_t code)
{
    const uint8_t lock = chip->kind->lock_register;
    return lock && code != lock && code >= FIRST_LOCKED && chip->keys != ALL_KEYS;
}

static const struct emulated_command *find_vendor(struct emulated_dcs *chip, uint8_t code)
{
    if (is_locked(chip, code)) return NULL;
    for (const struct emulated_register *at = chip->kind->registers; at && at->code; at++) {
        if (at->code != code) continue;
        snprintf(chip->vendor_name, sizeof chip->vendor_name, "command 0x%02X", code);
        chip->vendor = (struct emulated_command){code, at->n_args, chip->vendor_name, NULL};
        if (code == chip->kind->scan_register) chip->vendor.run = run_scan;
        if (code == chip->kind->lock_register) chip->vendor.run = run_lock;
        return &chip->vendor;
    }
    return NULL;
}

static const struct emulated_command *find_command(struct emulated_dcs *chip, uint8_t code)
{
    static const struct emulated_command commands[] = {
        {0x00, 0, "NOP", NULL},          {0x01, 0, "SWRESET", run_swreset},  {0x10, 0, "SLPIN", run_slpin},
        {0x11, 0, "SLPOUT", run_slpout}, {0x13, 0, "NORON", NULL},           {0x20, 0, "INVOFF", run_invoff},
        {0x21, 0, "INVON", run_invon},   {0x28, 0, "DISPOFF", run_dispoff},  {0x29, 0, "DISPON", run_dispon},
        {0x2A, 4, "CASET", run_caset},   {0x2B, 4, "RASET", run_raset},      {0x2C, 0, "RAMWR", run_ramwr},
        {0x34, 0, "TEOFF", run_teoff},   {0x35, 1, "TEON", run_teon},        {0x36, 1, "MADCTL", run_madctl},
        {0x3A, 1, "COLMOD", run_colmod}, {0x3C, 0, "RAMWRC", start_writing},
    };
    for (size_t i = 0; i < sizeof commands / sizeof commands[0]; i++) {
        if (commands[i].code == code) return &commands[i];
    }
    return find_vendor(chip, code);
}

/* Whether nothing is seen of a command that has too few arguments, or too many. */
static bool is_borne(const struct emulated_command *command)
{
    return !command->run || command->run == run_teon || command->run == run_scan;
}

static void end_command(struct emulated_dcs *chip)
{
    const struct emulated_command *command = chip->command;
    if (chip->writing && chip->n_bits >= 8) { /* 4 bits over are the filling after an odd 12-bit pixel */
        complain(chip, EMULATED_PIXEL_SPLIT, "pixel cut after %u of %u bits", chip->n_bits, chip->bits_a_pixel);
    }
    if (command && chip->n_args < command->n_args)
        note_if(is_borne(command), chip, EMULATED_ARGS_SHORT, "%s ended after %u of %u arguments", command->name,
                chip->n_args, command->n_args);
    chip->command = NULL;
    chip->writing = false;
    chip->ignore_data = false;
    chip->n_args = 0;
    chip->n_bits = 0;
}

static void run_if_complete(struct emulated_dcs *chip)
{
    if (chip->n_args == chip->command->n_args && chip->command->run) chip->command->run(chip);
}

static void receive_command(struct emulated_dcs *chip, uint8_t code)
{
    end_command(chip);
    chip->command = find_command(chip, code);
    if (!chip->command) {
        note(chip, EMULATED_UNKNOWN_COMMAND, "command 0x%02X is %s", code,
             is_locked(chip, code) ? "locked" : "unknown or not modelled");
        chip->ignore_data = true;
        return;
    }
    too_soon(chip, chip->ready_us);
    run_if_complete(chip);
}

static void receive_argument(struct emulated_dcs *chip, uint8_t byte)
{
    if (!chip->command || chip->n_args == chip->command->n_args) {
        note_if(chip->command && is_borne(chip->command), chip, EMULATED_ARGS_EXTRA,
                "data 0x%02X after %s, which takes %u bytes: too many, or no RAMWR", byte,
                chip->command ? chip->command->name : "no command", chip->command ? chip->command->n_args : 0);
        chip->ignore_data = true;
        return;
    }
    chip->args[chip->n_args++] = byte;
    run_if_complete(chip);
}

static struct emulated_pixel decode(uint32_t raw, unsigned bits)
{
    struct emulated_pixel pixel = {.raw = raw};
    for (unsigned i = 0; i < 3; i++) {
        unsigned c;
        if (bits == 12) {
            c = (raw >> (8 - 4 * i) & 15) * 17;
        } else if (bits == 24) {
            c = raw >> (18 - 8 * i) & 63;
            c = c << 2 | c >> 4;
        } else if (i == 1) {
            c = raw >> 5 & 63;
            c = c << 2 | c >> 4;
        } else {
            c = raw >> (i == 0 ? 11 : 0) & 31;
            c = c << 3 | c >> 2;
        }
        pixel.rgb[i] = (uint8_t)c;
    }
    return pixel;
}

/* The address counter runs along columns, then rows, and from the window's end to its start. */
static void advance_address(struct emulated_dcs *chip)
{
    if (chip->x++ < chip->columns[1]) return;
    chip->x = chip->columns[0];
    if (chip->y++ < chip->rows[1]) return;
    chip->y = chip->rows[0];
    chip->window_full = true;
}

static void store_pixel(struct emulated_dcs *chip, uint32_t raw)
{
    if (chip->window_full) {
        note(chip, EMULATED_PIXELS_OUTSIDE, "more pixels than the window %u..%u, %u..%u holds", chip->columns[0],
             chip->columns[1], chip->rows[0], chip->rows[1]);
        chip->window_full = false;
    }
    unsigned column = chip->madctl & EXCHANGE ? chip->y : chip->x;
    unsigned row = chip->madctl & EXCHANGE ? chip->x : chip->y;
    if (chip->madctl & COLUMN_ORDER) column = chip->glass.mem_w_px - 1u - column;
    if (chip->madctl & ROW_ORDER) row = chip->glass.mem_h_px - 1u - row;
    if (chip->x == chip->columns[0] && chip->y == chip->rows[0]) chip->first_row = (uint16_t)row;
    chip->memory[row][column] = decode(raw, chip->bits_a_pixel);
    emulated_port_store(&chip->port, (struct emulated_place){(uint16_t)column, (uint16_t)row, 1, 1});
    advance_address(chip);
}

static void receive_pixel_byte(struct emulated_dcs *chip, uint8_t byte)
{
    chip->bits = chip->bits << 8 | byte;
    chip->n_bits = (uint8_t)(chip->n_bits + 8);
    if (chip->n_bits < chip->bits_a_pixel) return;
    chip->n_bits = (uint8_t)(chip->n_bits - chip->bits_a_pixel);
    store_pixel(chip, chip->bits >> chip->n_bits & ((UINT32_C(1) << chip->bits_a_pixel) - 1));
}

static void take_command(void *ctx, uint8_t byte)
{
    receive_command(ctx, byte);
}

static void take_data(void *ctx, uint8_t byte)
{
    struct emulated_dcs *chip = ctx;
    if (chip->ignore_data) return;
    if (chip->writing)
        receive_pixel_byte(chip, byte);
    else
        receive_argument(chip, byte);
}

static void take_reset(void *ctx, uint64_t pulse_us)
{
    struct emulated_dcs *chip = ctx;
    if (pulse_us < RESET_PULSE_US)
        complain(chip, EMULATED_RESET, "reset low for %u us only", (unsigned)pulse_us);
    else
        reset_hardware(chip);
}

static void lose(void *ctx, size_t n_b)
{
    complain(ctx, EMULATED_RESET, "%zu bytes while reset is low", n_b);
}

static void fill_with_noise(struct emulated_dcs *chip)
{
    uint32_t noise = 1;
    for (unsigned row = 0; row < EMULATED_MAX_H_PX; row++) {
        for (unsigned column = 0; column < EMULATED_MAX_W_PX; column++) {
            noise = noise * 1664525u + 1013904223u;
            chip->memory[row][column] = decode(noise >> 16, 16);
        }
    }
}

void emulated_dcs_init(struct emulated_dcs *chip, const struct glass *glass)
{
    const struct emulated_kind *kind = emulated_kind_find(glass->chip);

    assert(kind && glass->mem_w_px <= kind->w_px && glass->mem_h_px <= kind->h_px && glass_fits(glass));
    memset(chip, 0, sizeof *chip);
    chip->port = (struct emulated_port){.chip = chip,
                                        .command = take_command,
                                        .data = take_data,
                                        .reset = take_reset,
                                        .lost = lose,
                                        .edge = next_refresh};
    chip->refresh_us = 16667;
    chip->glass = *glass;
    chip->kind = kind;
    fill_with_noise(chip);
    reset_hardware(chip);
}
