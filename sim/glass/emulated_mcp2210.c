/* SPDX-License-Identifier: MIT */
#include "glass/emulated_mcp2210.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Section 3 of the datasheet. */
enum {
    STATUS = 0x10,
    CANCEL = 0x11,
    GET_CHIP = 0x20,
    SET_CHIP = 0x21,
    SET_LEVELS = 0x30,
    GET_LEVELS = 0x31,
    SET_DIRECTIONS = 0x32,
    GET_DIRECTIONS = 0x33,
    SET_SPI = 0x40,
    GET_SPI = 0x41,
    TRANSFER = 0x42,
    WRITE_EEPROM = 0x51,
    SET_NVRAM = 0x60
};
enum { DONE = 0x00, TAKEN = 0xF7, BUSY = 0xF8, UNKNOWN = 0xF9, BLOCKED = 0xFB };
enum { FINISHED = 0x10, STARTED = 0x20, NOT_FINISHED = 0x30 };
enum { GPIO = 0, SELECT = 1, DEDICATED = 2 };
enum { TRANSFER_B = 60, MIN_RATE_HZ = 1500, MAX_RATE_HZ = 12000000, SPI_SETTINGS_B = 17, ALL_PINS = 0x1FF };

__attribute__((format(printf, 3, 4))) static void
complain(struct emulated_mcp2210 *chip, enum emulated_mcp2210_complaint kind, const char *format, ...)
{
    va_list args;

    chip->complaints++;
    chip->complaints_of[kind]++;
    va_start(args, format);
    vsnprintf(chip->complaint, sizeof chip->complaint, format, args);
    va_end(args);
}

static uint16_t get_16(const uint8_t *bytes)
{
    return (uint16_t)(bytes[0] | bytes[1] << 8);
}

static void put_16(uint8_t *bytes, uint16_t value)
{
    bytes[0] = (uint8_t)value;
    bytes[1] = (uint8_t)(value >> 8);
}

static void check_reserved(struct emulated_mcp2210 *chip, const uint8_t *report, size_t first, size_t end)
{
    for (size_t i = first; i < end; i++)
        if (report[i]) {
            complain(chip, BRIDGE_RESERVED, "command %02x: reserved byte %zu is %02x", report[0], i, report[i]);
            return;
        }
}

/* Levels and functions reach the wires. Nobody sees a fault of the display's: it has none. */
static void drive(struct emulated_mcp2210 *chip)
{
    for (unsigned i = 0; i < EMULATED_MCP2210_PINS; i++) {
        const uint16_t bit = (uint16_t)(1u << i);
        const bool drives = chip->functions[i] == GPIO && !(chip->inputs & bit);
        const bool low = drives && !(chip->levels & bit);
        const bool changed = drives && (!(chip->driven & bit) || low != !!(chip->driven_low & bit));
        chip->driven = (uint16_t)(drives ? chip->driven | bit : chip->driven & ~bit);
        chip->driven_low = (uint16_t)(low ? chip->driven_low | bit : chip->driven_low & ~bit);
        if (changed && pin_is_wired(&chip->pins[i]) && pin_set(&chip->pins[i], !low) != 0)
            complain(chip, BRIDGE_VALUE, "GP%u: the display's pin failed", i);
    }
}

static uint8_t status(struct emulated_mcp2210 *chip, const uint8_t *report, uint8_t *answer)
{
    check_reserved(chip, report, 1, EMULATED_MCP2210_REPORT_B);
    if (report[0] == CANCEL) chip->running = false;
    answer[2] = !chip->bus_taken;
    answer[3] = chip->bus_taken ? 2 : chip->running;
    return DONE;
}

static uint8_t get_chip(struct emulated_mcp2210 *chip, const uint8_t *report, uint8_t *answer)
{
    check_reserved(chip, report, 1, EMULATED_MCP2210_REPORT_B);
    memcpy(&answer[4], chip->functions, sizeof chip->functions);
    put_16(&answer[13], chip->levels);
    put_16(&answer[15], chip->inputs);
    answer[17] = chip->other_settings;
    return DONE;
}

static uint8_t set_chip(struct emulated_mcp2210 *chip, const uint8_t *report)
{
    check_reserved(chip, report, 1, 4);
    check_reserved(chip, report, 18, EMULATED_MCP2210_REPORT_B);
    if (chip->running) {
        complain(chip, BRIDGE_BUSY, "chip settings while a transaction is under way");
        return BUSY;
    }
    for (unsigned i = 0; i < EMULATED_MCP2210_PINS; i++)
        if (report[4 + i] > DEDICATED) complain(chip, BRIDGE_VALUE, "GP%u: there is no function %u", i, report[4 + i]);
    memcpy(chip->functions, &report[4], sizeof chip->functions);
    chip->levels = get_16(&report[13]) & ALL_PINS;
    chip->inputs = get_16(&report[15]) & ALL_PINS;
    chip->other_settings = report[17];
    drive(chip);
    return DONE;
}

static uint8_t set_levels(struct emulated_mcp2210 *chip, const uint8_t *report, uint8_t *answer)
{
    const uint16_t levels = get_16(&report[4]) & ALL_PINS;

    check_reserved(chip, report, 1, 4);
    check_reserved(chip, report, 6, EMULATED_MCP2210_REPORT_B);
    if (chip->running) complain(chip, BRIDGE_BUSY, "levels of pins while a transaction is under way");
    for (unsigned i = 0; i < EMULATED_MCP2210_PINS; i++) {
        if (!((levels ^ chip->levels) >> i & 1)) continue;
        if (chip->functions[i] != GPIO)
            complain(chip, BRIDGE_NOT_GPIO, "GP%u has another function than GPIO", i);
        else if (chip->inputs >> i & 1)
            complain(chip, BRIDGE_NOT_OUTPUT, "GP%u is an input", i);
    }
    chip->levels = levels;
    drive(chip);
    put_16(&answer[4], levels);
    return DONE;
}

static uint8_t set_directions(struct emulated_mcp2210 *chip, const uint8_t *report)
{
    check_reserved(chip, report, 1, 4);
    check_reserved(chip, report, 6, EMULATED_MCP2210_REPORT_B);
    if (chip->running) complain(chip, BRIDGE_BUSY, "directions of pins while a transaction is under way");
    chip->inputs = get_16(&report[4]) & ALL_PINS;
    drive(chip);
    return DONE;
}

static uint8_t get_pins(struct emulated_mcp2210 *chip, const uint8_t *report, uint8_t *answer)
{
    check_reserved(chip, report, 1, EMULATED_MCP2210_REPORT_B);
    put_16(&answer[4], report[0] == GET_LEVELS ? chip->levels : chip->inputs);
    return DONE;
}

static uint8_t get_spi(const struct emulated_mcp2210 *chip, uint8_t *answer)
{
    answer[2] = SPI_SETTINGS_B;
    put_16(&answer[4], (uint16_t)chip->bit_rate_hz);
    put_16(&answer[6], (uint16_t)(chip->bit_rate_hz >> 16));
    put_16(&answer[8], chip->idle_selects);
    put_16(&answer[10], chip->active_selects);
    for (unsigned i = 0; i < 3; i++)
        put_16(&answer[12 + 2 * i], chip->delays[i]);
    put_16(&answer[18], chip->transaction_b);
    answer[20] = chip->mode;
    return DONE;
}

static uint8_t set_spi(struct emulated_mcp2210 *chip, const uint8_t *report, uint8_t *answer)
{
    const uint32_t bit_rate_hz = get_16(&report[4]) | (uint32_t)get_16(&report[6]) << 16;

    check_reserved(chip, report, 1, 4);
    if (chip->running) {
        complain(chip, BRIDGE_BUSY, "SPI settings while a transaction is under way");
        return BUSY;
    }
    if (bit_rate_hz < MIN_RATE_HZ || bit_rate_hz > MAX_RATE_HZ)
        complain(chip, BRIDGE_VALUE, "bit rate %lu Hz", (unsigned long)bit_rate_hz);
    if (report[20] > 3) complain(chip, BRIDGE_VALUE, "SPI mode %u", report[20]);
    if (get_16(&report[18]) == 0) complain(chip, BRIDGE_VALUE, "transactions of no bytes");
    if ((get_16(&report[8]) | get_16(&report[10])) & ~ALL_PINS) complain(chip, BRIDGE_VALUE, "more than 9 selects");
    chip->bit_rate_hz = bit_rate_hz;
    chip->idle_selects = get_16(&report[8]);
    chip->active_selects = get_16(&report[10]);
    for (unsigned i = 0; i < 3; i++)
        chip->delays[i] = get_16(&report[12 + 2 * i]);
    chip->transaction_b = get_16(&report[18]);
    chip->mode = report[20];
    return get_spi(chip, answer);
}

static bool is_selected(const struct emulated_mcp2210 *chip)
{
    if (chip->select >= EMULATED_MCP2210_PINS) return true;
    if (chip->functions[chip->select] == SELECT) return !(chip->active_selects >> chip->select & 1);
    return chip->driven_low >> chip->select & 1;
}

static void send(struct emulated_mcp2210 *chip, const uint8_t *data, uint8_t n_b)
{
    chip->left_b = (uint16_t)(chip->left_b - n_b);
    chip->received_b = n_b;
    chip->bus_b += n_b;
    if (n_b && !is_selected(chip)) {
        complain(chip, BRIDGE_NOT_SELECTED, "%u bytes without chip select", n_b);
        return;
    }
    if (n_b && chip->spi.write && (bus_write(&chip->spi, data, n_b) != 0 || bus_flush(&chip->spi) != 0))
        complain(chip, BRIDGE_VALUE, "the display's bus failed");
}

/* Figure 3-23. The first bytes start a transaction, further ones continue it, and the first answer after its last bytes
 * ends it. What is sent comes back one report later. */
static uint8_t transfer(struct emulated_mcp2210 *chip, const uint8_t *report, uint8_t *answer)
{
    const uint8_t n_b = report[1];

    check_reserved(chip, report, 2, 4);
    if (chip->bus_taken) return TAKEN;
    if (chip->busy_every && ++chip->transfers % chip->busy_every == 0) return BUSY;
    if (n_b > TRANSFER_B) {
        complain(chip, BRIDGE_TOO_LONG, "%u bytes in a report", n_b);
        return UNKNOWN;
    }
    const bool starts = !chip->running;
    if (starts) {
        chip->left_b = chip->transaction_b;
        chip->transactions++;
        chip->received_b = 0;
    }
    if (n_b > chip->left_b || (starts && n_b == 0)) {
        complain(chip, BRIDGE_TRANSACTION, "%u bytes for a transaction with %u left", n_b, chip->left_b);
        return BUSY;
    }
    const bool ends = !starts && chip->left_b == 0;
    chip->running = !ends;
    answer[2] = chip->received_b;
    answer[3] = ends ? FINISHED : starts ? STARTED : NOT_FINISHED;
    send(chip, &report[4], n_b);
    return DONE;
}

static uint8_t refuse(struct emulated_mcp2210 *chip, uint8_t command)
{
    if (command == SET_NVRAM || command == WRITE_EEPROM) {
        complain(chip, BRIDGE_NVRAM, "command %02x writes what outlives a power-down", command);
        return BLOCKED;
    }
    complain(chip, BRIDGE_UNKNOWN_COMMAND, "command %02x is unknown", command);
    return UNKNOWN;
}

static uint8_t execute(struct emulated_mcp2210 *chip, const uint8_t *report, uint8_t *answer)
{
    switch (report[0]) {
    case STATUS:
    case CANCEL:
        return status(chip, report, answer);
    case GET_CHIP:
        return get_chip(chip, report, answer);
    case SET_CHIP:
        return set_chip(chip, report);
    case SET_LEVELS:
        return set_levels(chip, report, answer);
    case SET_DIRECTIONS:
        return set_directions(chip, report);
    case GET_LEVELS:
    case GET_DIRECTIONS:
        return get_pins(chip, report, answer);
    case SET_SPI:
        return set_spi(chip, report, answer);
    case GET_SPI:
        check_reserved(chip, report, 1, EMULATED_MCP2210_REPORT_B);
        return get_spi(chip, answer);
    case TRANSFER:
        return transfer(chip, report, answer);
    default:
        return refuse(chip, report[0]);
    }
}

bool emulated_mcp2210_answer(void *ctx, const uint8_t *report, uint8_t *answer)
{
    struct emulated_mcp2210 *chip = ctx;

    memset(answer, 0, EMULATED_MCP2210_REPORT_B);
    chip->commands[report[0]]++;
    answer[0] = report[0];
    answer[1] = execute(chip, report, answer);
    return true;
}

void emulated_mcp2210_power_up(struct emulated_mcp2210 *chip)
{
    memset(chip->functions, DEDICATED, sizeof chip->functions);
    chip->levels = chip->inputs = chip->idle_selects = ALL_PINS;
    chip->active_selects = 0;
    chip->other_settings = 0;
    chip->bit_rate_hz = 1000000;
    memset(chip->delays, 0, sizeof chip->delays);
    chip->transaction_b = 4;
    chip->mode = 0;
    chip->running = false;
    chip->driven = chip->driven_low = 0;
}

void emulated_mcp2210_init(struct emulated_mcp2210 *chip)
{
    *chip = (struct emulated_mcp2210){.select = EMULATED_MCP2210_UNWIRED};
    emulated_mcp2210_power_up(chip);
}
