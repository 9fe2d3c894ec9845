/* SPDX-License-Identifier: MIT */
#include "glass/emulated_ch347.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { SET_SPI = 0xC0, SET_SELECTS = 0xC1, SEND = 0xC4, SET_PINS = 0xCC };
enum { HEADER_B = 3, DATA_AT = 5, SEND_MOST_B = 504, SELECT_0 = 2, SELECT_1 = 5 };

__attribute__((format(printf, 2, 3))) static void complain(struct emulated_ch347 *chip, const char *format, ...)
{
    va_list args;

    chip->complaints++;
    va_start(args, format);
    vsnprintf(chip->complaint, sizeof chip->complaint, format, args);
    va_end(args);
}

static size_t get_16(const uint8_t *bytes)
{
    return bytes[0] | (size_t)bytes[1] << 8;
}

/* As in the programs: but for clock (12), polarity (6) and phase (8) the bytes are always the same. */
static size_t set_spi(struct emulated_ch347 *chip, const uint8_t *data, uint8_t *answer)
{
    static const uint8_t usual[26] = {0, 0, 4, 1, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 7, 0, 0, 0, 0xFF};

    for (size_t i = 0; i < sizeof usual; i++)
        if (i != 6 && i != 8 && i != 12 && data[i] != usual[i]) complain(chip, "byte %zu of C0 is %02x", i, data[i]);
    if ((data[6] & ~2) || (data[8] & ~1) || (data[12] & ~0x38)) complain(chip, "mode or clock that C0 does not have");
    chip->mode = (uint8_t)(data[6] | data[8]);
    chip->clock = data[12] >> 3;
    chip->is_set_up = true;
    answer[DATA_AT] = 0;
    return 1;
}

static void set_select(struct emulated_ch347 *chip, unsigned index, uint8_t state)
{
    if (state != 0 && state != 0x80 && state != 0xC0) complain(chip, "select %u: there is no %02x", index, state);
    if (state) chip->selected[index] = state == 0x80;
}

static size_t set_pins(struct emulated_ch347 *chip, const uint8_t *data, uint8_t *answer)
{
    for (unsigned i = 0; i < EMULATED_CH347_PINS; i++) {
        const uint8_t bit = (uint8_t)(1u << i);
        const bool high = data[i] & 0x08;
        if ((data[i] & 0xC0) == 0xC0) {
            if (i <= SELECT_0) complain(chip, "GP%u is one of SPI's", i);
            chip->outputs = (uint8_t)(data[i] & 0x30 ? chip->outputs | bit : chip->outputs & ~bit);
            chip->levels = (uint8_t)(high ? chip->levels | bit : chip->levels & ~bit);
            if (chip->outputs & bit && pin_is_wired(&chip->pins[i]) && pin_set(&chip->pins[i], high) != 0)
                complain(chip, "GP%u: the display's pin failed", i);
        }
        answer[DATA_AT + i] = (uint8_t)((chip->outputs & bit ? 0x80 : 0) | (chip->levels & bit ? 0x40 : 0));
    }
    return EMULATED_CH347_PINS;
}

static size_t send(struct emulated_ch347 *chip, const uint8_t *data, size_t n_b, uint8_t *answer)
{
    answer[DATA_AT] = 0;
    chip->bus_b += n_b;
    if (n_b == 0 || n_b > SEND_MOST_B) complain(chip, "%zu bytes in a report", n_b);
    if (!chip->is_set_up) complain(chip, "bytes before SPI is set up");
    if (!chip->selected[chip->select == SELECT_1]) complain(chip, "bytes without chip select");
    if (chip->spi.write && (bus_write(&chip->spi, data, n_b) != 0 || bus_flush(&chip->spi) != 0))
        complain(chip, "the display's bus failed");
    return 1;
}

/* The number of bytes of the answer's data; chip selects are set without an answer. */
static size_t execute(struct emulated_ch347 *chip, const uint8_t *report, uint8_t *answer)
{
    const uint8_t *data = &report[DATA_AT];

    switch (report[2]) {
    case SET_SPI:
        return set_spi(chip, data, answer);
    case SET_SELECTS:
        set_select(chip, 0, data[0]);
        set_select(chip, 1, data[5]);
        return 0;
    case SEND:
        return send(chip, data, get_16(&report[3]), answer);
    case SET_PINS:
        return set_pins(chip, data, answer);
    default:
        complain(chip, "command %02x is unknown", report[2]);
        return 0;
    }
}

bool emulated_ch347_answer(void *ctx, const uint8_t *report, uint8_t *answer)
{
    struct emulated_ch347 *chip = ctx;

    memset(answer, 0, EMULATED_CH347_REPORT_B);
    if (get_16(report) != HEADER_B + get_16(&report[3]))
        complain(chip, "lengths %zu and %zu", get_16(report), get_16(&report[3]));
    const size_t data_b = execute(chip, report, answer);
    answer[0] = (uint8_t)(HEADER_B + data_b);
    answer[2] = report[2];
    answer[3] = (uint8_t)data_b;
    return data_b > 0;
}

void emulated_ch347_power_up(struct emulated_ch347 *chip)
{
    chip->is_set_up = chip->selected[0] = chip->selected[1] = false;
    chip->outputs = chip->levels = 0;
}

void emulated_ch347_init(struct emulated_ch347 *chip)
{
    *chip = (struct emulated_ch347){.select = SELECT_0};
}
