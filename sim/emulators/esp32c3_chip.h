/* SPDX-License-Identifier: MIT
 *
 * An ESP32-C3 without its processor: clocks, watchdogs, pins, SPI2 and system timer as a program's registers reach
 * them, in the state that the ROM leaves them in. It takes its time, and tells each rule that a program breaks. Written
 * from Espressif's register descriptions (espressif/esp-idf components/soc/esp32c3/register/soc) and its ESP32-C3
 * Technical Reference Manual (TRM); it shares nothing with hal/mcu. What is not here, it tells as well. */
#ifndef SIM_EMULATORS_ESP32C3_CHIP_H
#define SIM_EMULATORS_ESP32C3_CHIP_H

#include <stdbool.h>
#include <stdint.h>

enum c3_rule {
    C3_MODELLED,
    C3_WORDS,
    C3_WATCHDOG_KEY,
    C3_WATCHDOG_BITES,
    C3_CLOCK_ON,
    C3_SPI_BUSY,
    C3_SPI_UPDATED,
    C3_SPI_EMPTIED,
    C3_SPI_PHASES,
    C3_SPI_LENGTH,
    C3_SPI_CLOCK,
    C3_SPI_RATE,
    C3_SPI_PINS,
    C3_PIN_DRIVEN,
    C3_PIN_IDLE,
    C3_TIMER_ASKED,
    C3_RULES
};

struct c3_rule_text {
    const char *source, *text;
};

extern const struct c3_rule_text c3_rules[C3_RULES];

struct c3_world {
    void *ctx;
    void (*complaint)(void *ctx, enum c3_rule rule, const char *what);
    void (*byte)(void *ctx, uint8_t byte);
    void (*level)(void *ctx, unsigned pin, bool high); /* of the pad, when it changes */
};

struct c3_setting {
    uint32_t panel_hz;   /* the fastest clock that the display takes; 0: any */
    uint64_t stop_after; /* bytes, after which SPI2 stops; 0: it does not */
    uint32_t stop_for;   /* resets of it that do not mend that */
    uint32_t wired;      /* pins whose level must stand while bytes leave: a bit each */
};

enum { C3_PINS = 22, C3_SPI_WORDS = 16, C3_SPI_CONFIGS = 0x34 / 4 };

struct c3_watchdog {
    uint32_t config0, wprotect;
    uint32_t taken; /* of what was written, what counts */
};

struct c3_spi {
    uint32_t config[C3_SPI_CONFIGS]; /* registers by their number */
    uint32_t clk_gate, slave, data[C3_SPI_WORDS];
    bool is_updated, is_emptied; /* what was written counts; the queue was emptied since the last transfer */
    unsigned bits;               /* under way; 0: none */
    uint64_t until_ps, update_until_ps, sent_b;
    uint32_t resets;
};

/* Read, but for what is to be set. */
struct c3 {
    struct c3_world world;
    struct c3_setting setting;
    uint64_t now_ps;
    uint32_t clk_en0, rst_en0, sysclk;
    struct c3_watchdog rtc, timer_group;
    uint32_t swd_conf, swd_wprotect;
    bool bitten;
    uint32_t out, enable, out_sel[C3_PINS], mux[C3_PINS], level; /* level: of pads that are outputs */
    struct c3_spi spi;
    uint32_t systimer_conf, systimer_value;
    uint64_t systimer_valid_ps; /* 0: nobody asked */
};

void c3_init(struct c3 *chip, const struct c3_setting *setting, const struct c3_world *world);

/* So many cycles of the processor pass. */
void c3_run(struct c3 *chip, uint32_t cycles);
uint32_t c3_cpu_hz(const struct c3 *chip);
uint32_t c3_spi_hz(const struct c3 *chip);
unsigned c3_spi_mode(const struct c3 *chip);

uint32_t c3_read(struct c3 *chip, uint32_t address, unsigned size_b);
void c3_write(struct c3 *chip, uint32_t address, uint32_t value, unsigned size_b);

#endif
