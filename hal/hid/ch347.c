/* SPDX-License-Identifier: MIT */
#include "hid/ch347.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { SET_SPI = 0xC0, SET_SELECTS = 0xC1, SEND = 0xC4, SET_PINS = 0xCC };

/* Where reports have what. */
enum { AT_LENGTH = 0, AT_COMMAND = 2, AT_DATA_LENGTH = 3, AT_DATA = 5, ANSWER_MIN_B = 6 };

/* Of a pin, in a command and in an answer. */
enum { PIN_CHANGE = 0xC0, PIN_OUTPUT = 0x30, PIN_HIGH = 0x08, PIN_IS_OUTPUT = 0x80, PIN_IS_HIGH = 0x40 };
enum { SELECT_0_PIN = 2, SELECT_1_PIN = 5, SELECT_ON = 0x80, SELECT_OFF = 0xC0, SELECTS_B = 10, SELECT_1_AT = 5 };

enum { QUIET_MS = 20, STALE_MAX = 64, WHY_B = 128, ALL_PINS = (1 << CH347_PINS) - 1 };

struct ch347 {
    struct reports reports;
    struct bridge_config config; /* with the levels that pins were set to last */
    char why[WHY_B];
    bool in_doubt; /* from the start, and after an error */
    uint8_t report[CH347_REPORT_B], answer[CH347_REPORT_B];
};

__attribute__((format(printf, 3, 4))) static int fail(struct ch347 *bridge, int err, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    vsnprintf(bridge->why, sizeof bridge->why, format, args);
    va_end(args);
    return err;
}

static void put_16(uint8_t *bytes, size_t value)
{
    bytes[0] = (uint8_t)value;
    bytes[1] = (uint8_t)(value >> 8);
}

/* A report of zeros but for the header; returns where the data go. */
static uint8_t *command(struct ch347 *bridge, uint8_t code, size_t data_b)
{
    memset(bridge->report, 0, sizeof bridge->report);
    put_16(&bridge->report[AT_LENGTH], AT_DATA - AT_COMMAND + data_b);
    bridge->report[AT_COMMAND] = code;
    put_16(&bridge->report[AT_DATA_LENGTH], data_b);
    return &bridge->report[AT_DATA];
}

static int send_report(struct ch347 *bridge)
{
    return bridge->reports.write(bridge->reports.ctx, bridge->report);
}

/* Answers to other commands are what an error left on their way. */
static int execute(struct ch347 *bridge)
{
    const struct reports *reports = &bridge->reports;
    const uint64_t end_ms = reports->now_ms(reports->ctx) + BRIDGE_PATIENCE_MS;
    const int err = send_report(bridge);

    if (err) return err;
    for (;;) {
        const uint64_t now_ms = reports->now_ms(reports->ctx);
        if (now_ms >= end_ms) break;
        const int n_b = reports->read(reports->ctx, bridge->answer, (uint32_t)(end_ms - now_ms));
        if (n_b < 0) return n_b;
        if (n_b >= ANSWER_MIN_B && bridge->answer[AT_COMMAND] == bridge->report[AT_COMMAND]) return 0;
    }
    return fail(bridge, -ETIMEDOUT, "no answer to command 0x%02x in %d ms; unplug it and plug it in again",
                bridge->report[AT_COMMAND], BRIDGE_PATIENCE_MS);
}

/* Divisors are powers of two: the fastest that the display takes. */
static uint8_t divisor_code(uint32_t bit_rate_hz)
{
    uint8_t code = 0;

    while ((uint32_t)CH347_RATE_MAX_HZ >> code > bit_rate_hz)
        code++;
    return code;
}

/* Bytes that are not explained are those that the programs send. */
static int set_spi(struct ch347 *bridge)
{
    static const uint8_t usual[26] = {[2] = 0x04, 0x01, [11] = 0x02, [16] = 0x07, [20] = 0xFF};
    uint8_t *data = command(bridge, SET_SPI, sizeof usual);

    memcpy(data, usual, sizeof usual);
    if (bridge->config.mode & 2) data[6] = 0x02; /* polarity */
    if (bridge->config.mode & 1) data[8] = 0x01; /* phase */
    data[12] = (uint8_t)(divisor_code(bridge->config.bit_rate_hz) << 3);
    const int err = execute(bridge);
    if (err || bridge->answer[AT_DATA] == 0) return err;
    return fail(bridge, -EPROTO, "it refuses its SPI settings with 0x%02x", bridge->answer[AT_DATA]);
}

static int set_pins(struct ch347 *bridge, uint16_t pins, uint16_t levels)
{
    uint8_t *data = command(bridge, SET_PINS, CH347_PINS);

    if (!pins) return 0;
    for (unsigned i = 0; i < CH347_PINS; i++)
        if (pins >> i & 1) data[i] = (uint8_t)(PIN_CHANGE | PIN_OUTPUT | (levels >> i & 1 ? PIN_HIGH : 0));
    const int err = execute(bridge);
    if (err) return err;
    for (unsigned i = 0; i < CH347_PINS; i++) {
        const unsigned wanted = PIN_IS_OUTPUT | (levels >> i & 1 ? PIN_IS_HIGH : 0);
        const unsigned is = bridge->answer[AT_DATA + i] & (PIN_IS_OUTPUT | PIN_IS_HIGH);
        if ((pins >> i & 1) && is != wanted)
            return fail(bridge, -EPROTO, "GP%u does not follow (0x%02x)", i, bridge->answer[AT_DATA + i]);
    }
    bridge->config.levels = (uint16_t)((bridge->config.levels & ~pins) | (levels & pins));
    return 0;
}

/* Chip select stays low while the port is open, but for a moment whenever the display is to begin afresh. */
static int set_selects(struct ch347 *bridge, uint8_t state)
{
    uint8_t *data = command(bridge, SET_SELECTS, SELECTS_B);

    if (bridge->config.selects >> SELECT_0_PIN & 1) data[0] = state;
    if (bridge->config.selects >> SELECT_1_PIN & 1) data[SELECT_1_AT] = state;
    return bridge->config.selects ? send_report(bridge) : 0;
}

/* No way is known to cancel anything: everything is set up anew. */
static int settle(struct ch347 *bridge)
{
    const struct reports *reports = &bridge->reports;
    int n_b = 1;

    for (unsigned i = 0; i < STALE_MAX && n_b > 0; i++)
        n_b = reports->read(reports->ctx, bridge->answer, QUIET_MS);
    int err = n_b < 0 ? n_b : set_spi(bridge);
    if (!err) err = set_pins(bridge, bridge->config.outputs, bridge->config.levels);
    if (!err) err = set_selects(bridge, SELECT_OFF);
    if (!err) err = set_selects(bridge, SELECT_ON);
    if (!err) bridge->in_doubt = false;
    return err;
}

static int enter(struct ch347 *bridge)
{
    bridge->why[0] = '\0';
    return bridge->in_doubt ? settle(bridge) : 0;
}

static int leave(struct ch347 *bridge, int err)
{
    if (err) bridge->in_doubt = true;
    return err;
}

static int send(void *state, const uint8_t *data, size_t n_b)
{
    struct ch347 *bridge = state;
    int err = enter(bridge);

    if (!err && n_b) {
        memcpy(command(bridge, SEND, n_b), data, n_b);
        err = execute(bridge);
    }
    return leave(bridge, err);
}

static int set(void *state, unsigned pin, bool high)
{
    struct ch347 *bridge = state;
    const uint16_t bit = (uint16_t)(1u << pin);
    int err = enter(bridge);

    if (!err && (pin >= CH347_PINS || !(bridge->config.outputs & bit)))
        err = fail(bridge, -EINVAL, "GP%u is not set up as an output", pin);
    if (!err) err = set_pins(bridge, bit, high ? bit : 0);
    return leave(bridge, err);
}

/* GP0 to GP2 are SPI's own. */
static bool config_fits(const struct bridge_config *config)
{
    const uint16_t selects = 1 << SELECT_0_PIN | 1 << SELECT_1_PIN;
    if (config->bit_rate_hz < CH347_RATE_MIN_HZ || config->mode > 3 || config->selects & ~selects) return false;
    return !(config->outputs & (7 | ~ALL_PINS)) && !(config->outputs & config->selects);
}

static int begin(void *state, const struct reports *reports, const struct bridge_config *config)
{
    struct ch347 *bridge = state;

    bridge->reports = *reports;
    bridge->config = *config;
    bridge->in_doubt = true;
    if (!config_fits(config))
        return fail(bridge, -EINVAL, "it has SPI modes 0 to 3 from %d Hz, outputs GP3 to GP7, and GP2 or GP5 for --cs",
                    CH347_RATE_MIN_HZ);
    return leave(bridge, enter(bridge));
}

static const char *why(const void *state)
{
    return ((const struct ch347 *)state)->why;
}

const struct bridge_kind ch347 = {.name = "CH347T",
                                  .file = "ch347",
                                  .experimental = "; experimental, not tried on hardware",
                                  .vendor = 0x1A86,
                                  .product = 0x55DC,
                                  .interface = 1,
                                  .report_b = CH347_REPORT_B,
                                  .transfer_b = CH347_TRANSFER_B,
                                  .pins = CH347_PINS,
                                  .state_b = sizeof(struct ch347),
                                  .begin = begin,
                                  .gathered_b = CH347_TRANSFER_B,
                                  .send = send,
                                  .set = set,
                                  .why = why};
