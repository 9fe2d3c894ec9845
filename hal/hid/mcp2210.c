/* SPDX-License-Identifier: MIT */
#include "hid/mcp2210.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Commands: section 3 of the datasheet. */
enum {
    GET_STATUS = 0x10,
    CANCEL = 0x11,
    GET_CHIP = 0x20,
    SET_CHIP = 0x21,
    SET_LEVELS = 0x30,
    SET_DIRECTIONS = 0x32,
    SET_SPI = 0x40,
    TRANSFER = 0x42
};

/* Byte 1 of an answer, */
enum { STATUS_DONE = 0x00, STATUS_TAKEN = 0xF7, STATUS_BUSY = 0xF8 };
/* of that to TRANSFER byte 3, */
enum { ENGINE_FINISHED = 0x10, ENGINE_STARTED = 0x20, ENGINE_NOT_FINISHED = 0x30 };
/* of that to GET_STATUS byte 3. */
enum { OWNER_OTHER = 2 };

/* Pin functions, and where chip settings have what. */
enum { FUNCTION_GPIO = 0, FUNCTION_SELECT = 1 };
enum { AT_FUNCTIONS = 4, AT_LEVELS = 13, AT_DIRECTIONS = 15, AT_CHIP_END = 18 };

enum { QUIET_MS = 20, STALE_MAX = 64, ALL_PINS = (1 << MCP2210_PINS) - 1, WHY_B = 128 };

struct mcp2210 {
    struct reports reports;
    struct bridge_config config;
    char why[WHY_B];
    uint16_t levels;        /* of all pins, as far as they are outputs */
    uint16_t transaction_b; /* that the bridge is set to; 0: unknown */
    bool begun;             /* pins are set up */
    bool in_doubt;          /* after an error: answers may be on their way, a transaction may be open */
    uint8_t report[MCP2210_REPORT_B], answer[MCP2210_REPORT_B];
};

__attribute__((format(printf, 3, 4))) static int fail(struct mcp2210 *bridge, int err, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    vsnprintf(bridge->why, sizeof bridge->why, format, args);
    va_end(args);
    return err;
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

/* A report of zeros but for the command. */
static uint8_t *command(struct mcp2210 *bridge, uint8_t code)
{
    memset(bridge->report, 0, sizeof bridge->report);
    bridge->report[0] = code;
    return bridge->report;
}

/* -- One report and its answer ----------------------------------------------------------------------------------- */

/* Answers to earlier commands, which an error left on their way, are passed over, and so is what is no whole report. */
static int read_answer(struct mcp2210 *bridge)
{
    const struct reports *reports = &bridge->reports;
    const uint64_t end_ms = reports->now_ms(reports->ctx) + BRIDGE_PATIENCE_MS;
    int other = -1;

    for (;;) {
        const uint64_t now_ms = reports->now_ms(reports->ctx);
        if (now_ms >= end_ms) break;
        const int n_b = reports->read(reports->ctx, bridge->answer, (uint32_t)(end_ms - now_ms));
        if (n_b < 0) return n_b;
        if (n_b < MCP2210_REPORT_B) continue;
        if (bridge->answer[0] == bridge->report[0]) return 0;
        other = bridge->answer[0];
    }
    if (other < 0)
        return fail(bridge, -ETIMEDOUT, "no answer to command 0x%02x in %d ms; unplug it and plug it in again",
                    bridge->report[0], BRIDGE_PATIENCE_MS);
    return fail(bridge, -EPROTO, "it answers command 0x%02x to 0x%02x; is another program using it?", (unsigned)other,
                bridge->report[0]);
}

static int check_status(struct mcp2210 *bridge)
{
    const uint8_t status = bridge->answer[1];

    if (status == STATUS_DONE) return 0;
    if (status == STATUS_TAKEN)
        return fail(bridge, -EBUSY, "another master has the SPI bus (status 0xf7); let it release GP8 or disable that");
    if (status == STATUS_BUSY)
        return fail(bridge, -ETIMEDOUT, "busy for %d ms (status 0xf8); unplug it and plug it in again",
                    BRIDGE_PATIENCE_MS);
    return fail(bridge, -EPROTO, "status 0x%02x to command 0x%02x", status, bridge->report[0]);
}

/* 0xF8 is an ordinary answer: the bridge has no room yet, or is not yet done. */
static int execute(struct mcp2210 *bridge)
{
    const struct reports *reports = &bridge->reports;
    const uint64_t end_ms = reports->now_ms(reports->ctx) + BRIDGE_PATIENCE_MS;

    do {
        int err = reports->write(reports->ctx, bridge->report);
        if (!err) err = read_answer(bridge);
        if (err) return err;
    } while (bridge->answer[1] == STATUS_BUSY && reports->now_ms(reports->ctx) < end_ms);
    return check_status(bridge);
}

static int set_levels(struct mcp2210 *bridge, uint16_t levels)
{
    put_16(&command(bridge, SET_LEVELS)[4], levels);
    const int err = execute(bridge);
    if (!err) bridge->levels = levels;
    return err;
}

/* From any state to one where each answer is to the last command, no transaction is open and, if they ever were, pins
 * are at the levels that they were set to last: an error may have come of a change that took effect. */
static int settle(struct mcp2210 *bridge)
{
    const struct reports *reports = &bridge->reports;
    int n_b = 1;

    for (unsigned i = 0; i < STALE_MAX && n_b > 0; i++)
        n_b = reports->read(reports->ctx, bridge->answer, QUIET_MS);
    if (n_b < 0) return n_b;
    command(bridge, CANCEL);
    int err = execute(bridge);
    if (!err && bridge->begun) err = set_levels(bridge, bridge->levels);
    if (err) return err;
    bridge->transaction_b = 0;
    bridge->in_doubt = false;
    return 0;
}

/* What every function begins and ends with. */
static int enter(struct mcp2210 *bridge)
{
    bridge->why[0] = '\0';
    return bridge->in_doubt ? settle(bridge) : 0;
}

static int leave(struct mcp2210 *bridge, int err)
{
    if (err) bridge->in_doubt = true;
    return err;
}

/* -- Transactions ------------------------------------------------------------------------------------------------ */

static int set_spi(struct mcp2210 *bridge, uint16_t transaction_b)
{
    if (bridge->transaction_b == transaction_b) return 0;
    uint8_t *report = command(bridge, SET_SPI);
    put_16(&report[4], (uint16_t)bridge->config.bit_rate_hz);
    put_16(&report[6], (uint16_t)(bridge->config.bit_rate_hz >> 16));
    put_16(&report[8], ALL_PINS); /* chip selects when idle, and during transactions */
    put_16(&report[10], (uint16_t)(ALL_PINS & ~bridge->config.selects));
    put_16(&report[18], transaction_b); /* bytes 12 to 17 are delays: none */
    report[20] = bridge->config.mode;
    const int err = execute(bridge);
    if (!err) bridge->transaction_b = transaction_b;
    return err;
}

/* n_b = 0: only asks what the engine is at. Returns that, or a negative errno. */
static int transfer(struct mcp2210 *bridge, const uint8_t *data, size_t n_b)
{
    uint8_t *report = command(bridge, TRANSFER);
    report[1] = (uint8_t)n_b;
    if (n_b) memcpy(&report[4], data, n_b);
    const int err = execute(bridge);
    if (err) return err;

    const uint8_t engine = bridge->answer[3];
    if (engine != ENGINE_STARTED && engine != ENGINE_NOT_FINISHED && engine != ENGINE_FINISHED)
        return fail(bridge, -EPROTO, "unknown state 0x%02x of a transfer", engine);
    return engine;
}

static int wait_finished(struct mcp2210 *bridge)
{
    const struct reports *reports = &bridge->reports;
    const uint64_t end_ms = reports->now_ms(reports->ctx) + BRIDGE_PATIENCE_MS;

    while (reports->now_ms(reports->ctx) < end_ms) {
        const int engine = transfer(bridge, NULL, 0);
        if (engine < 0) return engine;
        if (engine == ENGINE_FINISHED) return 0;
    }
    return fail(bridge, -ETIMEDOUT, "a transfer does not end in %d ms", BRIDGE_PATIENCE_MS);
}

static int send_transaction(struct mcp2210 *bridge, const uint8_t *data, size_t n_b)
{
    int engine = ENGINE_STARTED;

    const int err = set_spi(bridge, (uint16_t)n_b);
    if (err) return err;
    for (size_t sent_b = 0; sent_b < n_b;) {
        const size_t part_b = n_b - sent_b < MCP2210_TRANSFER_B ? n_b - sent_b : MCP2210_TRANSFER_B;
        engine = transfer(bridge, &data[sent_b], part_b);
        if (engine < 0) return engine;
        sent_b += part_b;
        if (engine == ENGINE_FINISHED && sent_b < n_b)
            return fail(bridge, -EPROTO, "a transfer ended %zu bytes early", n_b - sent_b);
    }
    return engine == ENGINE_FINISHED ? 0 : wait_finished(bridge);
}

static int send(void *state, const uint8_t *data, size_t n_b)
{
    struct mcp2210 *bridge = state;
    int err = enter(bridge);

    if (!err && n_b) err = send_transaction(bridge, data, n_b);
    return leave(bridge, err);
}

/* -- Pins -------------------------------------------------------------------------------------------------------- */

static int set(void *state, unsigned pin, bool high)
{
    struct mcp2210 *bridge = state;
    const uint16_t bit = (uint16_t)(1u << pin);
    int err = enter(bridge);

    if (!err && (pin >= MCP2210_PINS || !(bridge->config.outputs & bit)))
        err = fail(bridge, -EINVAL, "GP%u is not set up as an output", pin);
    if (!err) err = set_levels(bridge, (uint16_t)(high ? bridge->levels | bit : bridge->levels & ~bit));
    return leave(bridge, err);
}

/* Pins that are none of ours keep what they are. Levels are set before directions, so that no output begins with
 * another's level. */
static int set_pins(struct mcp2210 *bridge)
{
    const struct bridge_config *config = &bridge->config;

    command(bridge, GET_CHIP);
    int err = execute(bridge);
    if (err) return err;
    uint8_t *report = command(bridge, SET_CHIP);
    memcpy(&report[AT_FUNCTIONS], &bridge->answer[AT_FUNCTIONS], AT_CHIP_END - AT_FUNCTIONS);
    for (unsigned i = 0; i < MCP2210_PINS; i++) {
        if (config->outputs >> i & 1) report[AT_FUNCTIONS + i] = FUNCTION_GPIO;
        if (config->selects >> i & 1) report[AT_FUNCTIONS + i] = FUNCTION_SELECT;
    }
    const uint16_t kept = (uint16_t)(get_16(&report[AT_LEVELS]) & ~config->outputs);
    const uint16_t levels = (uint16_t)(kept | (config->levels & config->outputs));
    const uint16_t directions = (uint16_t)(get_16(&report[AT_DIRECTIONS]) & ~config->outputs);
    put_16(&report[AT_LEVELS], levels);
    put_16(&report[AT_DIRECTIONS], directions);
    err = execute(bridge);
    if (!err) err = set_levels(bridge, levels);
    if (err) return err;
    put_16(&command(bridge, SET_DIRECTIONS)[4], directions);
    err = execute(bridge);
    bridge->begun = !err;
    return err;
}

/* -- The beginning ----------------------------------------------------------------------------------------------- */

static int check_owner(struct mcp2210 *bridge)
{
    command(bridge, GET_STATUS);
    const int err = execute(bridge);
    if (err) return err;
    if (bridge->answer[2] > 1 || bridge->answer[3] > OWNER_OTHER)
        return fail(bridge, -EPROTO, "its status is not that of an MCP2210");
    if (bridge->answer[3] == OWNER_OTHER) bridge->answer[1] = STATUS_TAKEN;
    return check_status(bridge);
}

static bool config_fits(const struct bridge_config *config)
{
    if (config->bit_rate_hz < MCP2210_RATE_MIN_HZ || config->mode > 3) return false;
    return !((config->outputs | config->selects) & ~ALL_PINS) && !(config->outputs & config->selects);
}

static int begin(void *state, const struct reports *reports, const struct bridge_config *config)
{
    struct mcp2210 *bridge = state;

    bridge->reports = *reports;
    bridge->config = *config;
    bridge->begun = false;
    bridge->in_doubt = true;
    if (config->bit_rate_hz > MCP2210_RATE_MAX_HZ) bridge->config.bit_rate_hz = MCP2210_RATE_MAX_HZ;
    if (!config_fits(config))
        return fail(bridge, -EINVAL, "it has SPI modes 0 to 3 from %d Hz, and pins GP0 to GP%d, each for one signal",
                    MCP2210_RATE_MIN_HZ, MCP2210_PINS - 1);
    int err = enter(bridge);
    if (!err) err = check_owner(bridge);
    if (!err) err = set_pins(bridge);
    return leave(bridge, err);
}

static const char *why(const void *state)
{
    return ((const struct mcp2210 *)state)->why;
}

const struct bridge_kind mcp2210 = {.name = "MCP2210",
                                    .file = "mcp2210",
                                    .vendor = 0x04D8,
                                    .product = 0x00DE,
                                    .report_b = MCP2210_REPORT_B,
                                    .transfer_b = MCP2210_TRANSFER_B,
                                    .pins = MCP2210_PINS,
                                    .state_b = sizeof(struct mcp2210),
                                    .begin = begin,
                                    .gathered_b = MCP2210_TRANSACTION_B,
                                    .send = send,
                                    .set = set,
                                    .why = why};
