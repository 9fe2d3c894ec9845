/* SPDX-License-Identifier: MIT */
#include "emulators/esp32c3_chip.h"

#include <stdio.h>
#include <string.h>

#define SYSTEM UINT32_C(0x600C0000)
#define RTC UINT32_C(0x60008000)
#define TIMER_GROUP UINT32_C(0x6001F000)
#define GPIO UINT32_C(0x60004000)
#define IO_MUX UINT32_C(0x60009000)
#define SYSTIMER UINT32_C(0x60023000)
#define SPI2 UINT32_C(0x60024000)
#define BIT(n) (UINT32_C(1) << (n))
#define KEY UINT32_C(0x50D83AA1)
#define SUPER_KEY UINT32_C(0x8F1D312A)
#define PS_PER_S UINT64_C(1000000000000)
#define CRYSTAL_HZ UINT32_C(40000000)
#define PLL_SPI_HZ UINT32_C(80000000)
#define BITE_PS (PS_PER_S * 3 / 10) /* sooner than any of them, by their defaults */

enum { SPI2_BIT = 6, SYSTIMER_BIT = 29 };
/* Registers of SPI2, by their number. */
enum { CMD, CTRL = 2, CLOCK, USER, MS_DLEN = 7, MISC, DMA_CONF = 12, W0 = 38, SLAVE = 56, CLK_GATE = 58 };
enum { USR = 24, UPDATE = 23, EQU_SYSCLK = 31, BUF_AFIFO_RST = 30, CK_IDLE_EDGE = 29, CK_OUT_EDGE = 9 };
enum { SCK_PIN = 6, MOSI_PIN = 7, DIRECT = 2, MATRIX = 1, OUT_REGISTER = 128 };

static void complain(struct c3 *chip, enum c3_rule rule, const char *what, uint32_t value)
{
    char text[80];

    (void)snprintf(text, sizeof text, "%s 0x%08X", what, (unsigned)value);
    chip->world.complaint(chip->world.ctx, rule, text);
}

/* Clocks and time ------------------------------------------------------------------------------------------------- */

uint32_t c3_cpu_hz(const struct c3 *chip)
{
    return CRYSTAL_HZ / ((chip->sysclk & 0x3FF) + 1);
}

uint32_t c3_spi_hz(const struct c3 *chip)
{
    const uint32_t clock = chip->spi.config[CLOCK];
    const uint32_t source_hz = chip->spi.clk_gate & BIT(2) ? PLL_SPI_HZ : CRYSTAL_HZ;

    return clock & BIT(EQU_SYSCLK) ? source_hz : source_hz / ((clock >> 18 & 15) + 1) / ((clock >> 12 & 63) + 1);
}

unsigned c3_spi_mode(const struct c3 *chip)
{
    const bool high = chip->spi.config[MISC] & BIT(CK_IDLE_EDGE), late = chip->spi.config[USER] & BIT(CK_OUT_EDGE);
    return high ? (late ? 2 : 3) : late ? 1 : 0;
}

/* As late as can be: what was written meanwhile goes out. */
static void end_transfer(struct c3 *chip)
{
    struct c3_spi *spi = &chip->spi;

    for (unsigned i = 0; i < spi->bits / 8; i++)
        chip->world.byte(chip->world.ctx, (uint8_t)(spi->data[i / 4] >> 8 * (i % 4)));
    spi->sent_b += spi->bits / 8;
    spi->bits = 0;
}

static bool is_stopped(const struct c3 *chip)
{
    const struct c3_setting *setting = &chip->setting;
    return setting->stop_after && chip->spi.sent_b >= setting->stop_after && chip->spi.resets <= setting->stop_for;
}

static void check_watchdogs(struct c3 *chip)
{
    if (chip->bitten || chip->now_ps < BITE_PS) return;
    const bool rtc = chip->rtc.config0 & (BIT(31) | BIT(12));
    const bool group = chip->timer_group.taken & (BIT(31) | BIT(14));
    const bool super = !(chip->swd_conf & (BIT(31) | BIT(30)));
    chip->bitten = rtc || group || super;
    if (chip->bitten) complain(chip, C3_WATCHDOG_BITES, rtc ? "RTC's" : group ? "timer group's" : "super", 0);
}

void c3_run(struct c3 *chip, uint32_t cycles)
{
    chip->now_ps += PS_PER_S / c3_cpu_hz(chip) * cycles;
    if (chip->spi.bits && chip->now_ps >= chip->spi.until_ps && !is_stopped(chip)) end_transfer(chip);
    check_watchdogs(chip);
}

/* Pins ------------------------------------------------------------------------------------------------------------ */

static bool is_output(const struct c3 *chip, unsigned pin)
{
    return (chip->mux[pin] >> 12 & 7) == MATRIX && (chip->out_sel[pin] & 255) == OUT_REGISTER &&
           (chip->enable & BIT(pin));
}

static void show_levels(struct c3 *chip, uint32_t before_enabled)
{
    for (unsigned pin = 0; pin < C3_PINS; pin++) {
        if (!is_output(chip, pin)) continue;
        const bool high = (chip->out >> pin & 1) != (chip->out_sel[pin] >> 8 & 1);
        const bool changes = high != (chip->level >> pin & 1);
        if (changes && chip->spi.bits && chip->setting.wired >> pin & 1) complain(chip, C3_PIN_IDLE, "pin", pin);
        if (changes || !(before_enabled >> pin & 1)) chip->world.level(chip->world.ctx, pin, high);
        chip->level = high ? chip->level | BIT(pin) : chip->level & ~BIT(pin);
    }
}

static uint32_t outputs(const struct c3 *chip)
{
    uint32_t pins = 0;

    for (unsigned pin = 0; pin < C3_PINS; pin++)
        if (is_output(chip, pin)) pins |= BIT(pin);
    return pins;
}

/* The first level is set before a pin is an output, and no other. */
static void set_out(struct c3 *chip, uint32_t out, uint32_t before)
{
    const uint32_t changed = (out ^ chip->out) & ~before & chip->enable;

    if (changed) complain(chip, C3_PIN_DRIVEN, "pins", changed);
    chip->out = out;
}

static void write_gpio(struct c3 *chip, uint32_t offset, uint32_t value)
{
    const uint32_t before = outputs(chip);

    if (offset == 0x8)
        set_out(chip, chip->out | value, before);
    else if (offset == 0xC)
        set_out(chip, chip->out & ~value, before);
    else if (offset == 0x24)
        chip->enable |= value;
    else if (offset == 0x28)
        chip->enable &= ~value;
    else if (offset >= 0x554 && offset < 0x554 + 4 * C3_PINS)
        chip->out_sel[(offset - 0x554) / 4] = value;
    else
        complain(chip, C3_MODELLED, "write to", GPIO + offset);
    show_levels(chip, before);
}

static void write_mux(struct c3 *chip, uint32_t offset, uint32_t value)
{
    const uint32_t before = outputs(chip);

    if (offset < 4 || offset >= 4 + 4 * C3_PINS)
        complain(chip, C3_MODELLED, "write to", IO_MUX + offset);
    else
        chip->mux[offset / 4 - 1] = value;
    show_levels(chip, before);
}

/* SPI2 ------------------------------------------------------------------------------------------------------------ */

static bool is_clocked(struct c3 *chip, unsigned bit, uint32_t address)
{
    const bool is = (chip->clk_en0 >> bit & 1) && !(chip->rst_en0 >> bit & 1);

    if (!is) complain(chip, C3_CLOCK_ON, "register", address);
    return is;
}

static void reset_spi(struct c3 *chip)
{
    const uint64_t sent_b = chip->spi.sent_b;
    const uint32_t resets = chip->spi.resets + 1;

    chip->spi = (struct c3_spi){.sent_b = sent_b, .resets = resets};
    chip->spi.config[CLOCK] = BIT(EQU_SYSCLK) | 3 << 12 | 1 << 6 | 3;
    chip->spi.config[USER] = BIT(31) | 0xC0;
    chip->spi.config[CTRL] = 0x3C0000;
    chip->spi.config[MISC] = 0x3E;
}

static void check_clock(struct c3 *chip)
{
    const uint32_t clock = chip->spi.config[CLOCK], n = clock >> 12 & 63;

    if (!(clock & BIT(EQU_SYSCLK)) && ((clock & 63) != n || (clock >> 6 & 63) != (n + 1) / 2 - 1))
        complain(chip, C3_SPI_CLOCK, "clock", clock);
    if (chip->setting.panel_hz && c3_spi_hz(chip) > chip->setting.panel_hz) complain(chip, C3_SPI_RATE, "clock", clock);
}

static void check_transfer(struct c3 *chip)
{
    const struct c3_spi *spi = &chip->spi;
    const uint32_t user = spi->config[USER], bits = spi->config[MS_DLEN] + 1;

    if (!spi->is_updated) complain(chip, C3_SPI_UPDATED, "cmd", BIT(USR));
    if (!spi->is_emptied) complain(chip, C3_SPI_EMPTIED, "dma_conf", spi->config[DMA_CONF]);
    if ((user & ~(BIT(27) | BIT(CK_OUT_EDGE) | 0xC0)) || !(user & BIT(27))) complain(chip, C3_SPI_PHASES, "user", user);
    if (spi->config[CTRL] & 0x0600C3C8) complain(chip, C3_SPI_PHASES, "ctrl", spi->config[CTRL]);
    if (bits % 8 || bits > 32 * C3_SPI_WORDS) complain(chip, C3_SPI_LENGTH, "bits", bits);
    if ((spi->clk_gate & 3) != 3) complain(chip, C3_CLOCK_ON, "clk_gate", spi->clk_gate);
    if ((chip->mux[SCK_PIN] >> 12 & 7) != DIRECT) complain(chip, C3_SPI_PINS, "mux of GPIO6", chip->mux[SCK_PIN]);
    if ((chip->mux[MOSI_PIN] >> 12 & 7) != DIRECT) complain(chip, C3_SPI_PINS, "mux of GPIO7", chip->mux[MOSI_PIN]);
    check_clock(chip);
}

static void start_transfer(struct c3 *chip)
{
    struct c3_spi *spi = &chip->spi;

    check_transfer(chip);
    spi->bits = spi->config[MS_DLEN] % (32 * C3_SPI_WORDS) + 1;
    spi->until_ps = chip->now_ps + PS_PER_S / c3_spi_hz(chip) * spi->bits;
    spi->is_emptied = false;
}

/* It takes as long as either clock. */
static void write_cmd(struct c3 *chip, uint32_t value)
{
    if (value & ~(BIT(USR) | BIT(UPDATE))) complain(chip, C3_MODELLED, "cmd", value);
    if (value & BIT(UPDATE)) {
        chip->spi.update_until_ps = chip->now_ps + PS_PER_S / CRYSTAL_HZ * 4;
        chip->spi.is_updated = true;
    }
    if (!(value & BIT(USR))) return;
    if (chip->now_ps < chip->spi.update_until_ps) complain(chip, C3_SPI_UPDATED, "cmd", value);
    start_transfer(chip);
}

static void write_spi(struct c3 *chip, uint32_t offset, uint32_t value)
{
    const uint32_t number = offset / 4;
    struct c3_spi *spi = &chip->spi;

    if (!is_clocked(chip, SPI2_BIT, SPI2 + offset)) return;
    if (spi->bits) complain(chip, C3_SPI_BUSY, "register", SPI2 + offset);
    if (number >= W0 && number < W0 + C3_SPI_WORDS) {
        spi->data[number - W0] = value;
        return;
    }
    if (number == CMD) {
        write_cmd(chip, value);
        return;
    }
    spi->is_updated = false;
    if (number == CLK_GATE)
        spi->clk_gate = value;
    else if (number == SLAVE)
        spi->slave = value;
    else if (number < C3_SPI_CONFIGS && number != 1 && number != 5 && number != 6)
        spi->config[number] = value;
    else
        complain(chip, C3_MODELLED, "write to", SPI2 + offset);
    if (number == SLAVE && value) complain(chip, C3_MODELLED, "slave", value);
    if (number == DMA_CONF && value & BIT(BUF_AFIFO_RST)) spi->is_emptied = true;
}

static uint32_t read_spi(struct c3 *chip, uint32_t offset)
{
    if (!is_clocked(chip, SPI2_BIT, SPI2 + offset)) return 0;
    if (offset != 4 * CMD) {
        complain(chip, C3_MODELLED, "read of", SPI2 + offset);
        return 0;
    }
    return (chip->spi.bits ? BIT(USR) : 0) | (chip->now_ps < chip->spi.update_until_ps ? BIT(UPDATE) : 0);
}

/* Timer, clocks, watchdogs ---------------------------------------------------------------------------------------- */

static void write_systimer(struct c3 *chip, uint32_t offset, uint32_t value)
{
    if (!is_clocked(chip, SYSTIMER_BIT, SYSTIMER + offset)) return;
    if (offset == 0)
        chip->systimer_conf = value;
    else if (offset == 4 && value == BIT(30))
        chip->systimer_valid_ps = chip->now_ps + PS_PER_S / 16000000;
    else
        complain(chip, C3_MODELLED, "write to", SYSTIMER + offset);
}

static uint32_t read_systimer(struct c3 *chip, uint32_t offset)
{
    const bool is_valid = chip->systimer_valid_ps && chip->now_ps >= chip->systimer_valid_ps;

    if (!is_clocked(chip, SYSTIMER_BIT, SYSTIMER + offset)) return 0;
    if (offset == 4) return is_valid ? BIT(29) : 0;
    if (offset != 0x44) complain(chip, C3_MODELLED, "read of", SYSTIMER + offset);
    if (!is_valid) complain(chip, C3_TIMER_ASKED, "read of", SYSTIMER + offset);
    if (is_valid && chip->systimer_conf & BIT(30))
        chip->systimer_value = (uint32_t)(chip->systimer_valid_ps / (PS_PER_S / 16000000));
    return chip->systimer_value;
}

static void write_system(struct c3 *chip, uint32_t offset, uint32_t value)
{
    if (offset == 0x10) {
        chip->clk_en0 = value;
    } else if (offset == 0x18) {
        if (value & ~chip->rst_en0 & BIT(SPI2_BIT)) reset_spi(chip);
        chip->rst_en0 = value;
    } else if (offset == 0x58 && !(value >> 10 & 3)) {
        chip->sysclk = value;
    } else {
        complain(chip, C3_MODELLED, "write to", SYSTEM + offset);
    }
}

static uint32_t read_system(struct c3 *chip, uint32_t offset)
{
    if (offset == 0x10) return chip->clk_en0;
    if (offset == 0x18) return chip->rst_en0;
    if (offset == 0x58) return chip->sysclk;
    complain(chip, C3_MODELLED, "read of", SYSTEM + offset);
    return 0;
}

static void write_protected(struct c3 *chip, uint32_t *reg, uint32_t value, bool is_open)
{
    if (is_open)
        *reg = value;
    else
        complain(chip, C3_WATCHDOG_KEY, "value", value);
}

static void write_rtc(struct c3 *chip, uint32_t offset, uint32_t value)
{
    if (offset == 0x90)
        write_protected(chip, &chip->rtc.config0, value, chip->rtc.wprotect == KEY);
    else if (offset == 0xA8)
        chip->rtc.wprotect = value;
    else if (offset == 0xAC)
        write_protected(chip, &chip->swd_conf, value, chip->swd_wprotect == SUPER_KEY);
    else if (offset == 0xB0)
        chip->swd_wprotect = value;
    else
        complain(chip, C3_MODELLED, "write to", RTC + offset);
}

static uint32_t read_rtc(struct c3 *chip, uint32_t offset)
{
    if (offset == 0x90) return chip->rtc.config0;
    if (offset == 0xAC) return chip->swd_conf;
    complain(chip, C3_MODELLED, "read of", RTC + offset);
    return 0;
}

/* What is written counts when bit 22 is, too. */
static void write_timer_group(struct c3 *chip, uint32_t offset, uint32_t value)
{
    static const uint32_t takes = BIT(22);
    struct c3_watchdog *dog = &chip->timer_group;

    if (offset == 0x48) {
        write_protected(chip, &dog->config0, value & ~takes, dog->wprotect == KEY);
        if (value & takes) dog->taken = dog->config0;
    } else if (offset == 0x64) {
        dog->wprotect = value;
    } else {
        complain(chip, C3_MODELLED, "write to", TIMER_GROUP + offset);
    }
}

static uint32_t read_timer_group(struct c3 *chip, uint32_t offset)
{
    if (offset == 0x48) return chip->timer_group.config0;
    complain(chip, C3_MODELLED, "read of", TIMER_GROUP + offset);
    return 0;
}

/* All -------------------------------------------------------------------------------------------------------------- */

static bool is_word(struct c3 *chip, uint32_t address, unsigned size_b)
{
    if (size_b == 4 && address % 4 == 0) return true;
    complain(chip, C3_WORDS, "register", address);
    return false;
}

uint32_t c3_read(struct c3 *chip, uint32_t address, unsigned size_b)
{
    const uint32_t offset = address & 0xFFF;

    if (!is_word(chip, address, size_b)) return 0;
    switch (address - offset) {
    case SYSTEM:
        return read_system(chip, offset);
    case RTC:
        return read_rtc(chip, offset);
    case TIMER_GROUP:
        return read_timer_group(chip, offset);
    case SYSTIMER:
        return read_systimer(chip, offset);
    case SPI2:
        return read_spi(chip, offset);
    default:
        complain(chip, C3_MODELLED, "read of", address);
        return 0;
    }
}

void c3_write(struct c3 *chip, uint32_t address, uint32_t value, unsigned size_b)
{
    const uint32_t offset = address & 0xFFF;

    if (!is_word(chip, address, size_b)) return;
    switch (address - offset) {
    case SYSTEM:
        write_system(chip, offset, value);
        break;
    case RTC:
        write_rtc(chip, offset, value);
        break;
    case TIMER_GROUP:
        write_timer_group(chip, offset, value);
        break;
    case GPIO:
        write_gpio(chip, offset, value);
        break;
    case IO_MUX:
        write_mux(chip, offset, value);
        break;
    case SYSTIMER:
        write_systimer(chip, offset, value);
        break;
    case SPI2:
        write_spi(chip, offset, value);
        break;
    default:
        complain(chip, C3_MODELLED, "write to", address);
    }
}

/* The ROM runs by half of the crystal, both watchdogs of booting from flash run, and SPI2 has no clock: a reset gives
 * it one, but who relies on that is told. */
void c3_init(struct c3 *chip, const struct c3_setting *setting, const struct c3_world *world)
{
    *chip = (struct c3){.world = *world, .setting = *setting, .sysclk = 1};
    chip->clk_en0 = UINT32_C(0xF9C1E02F) & ~(BIT(SPI2_BIT) | BIT(SYSTIMER_BIT));
    chip->rtc.config0 = BIT(31) | BIT(12) | 0x13214;
    chip->timer_group.config0 = chip->timer_group.taken = BIT(14) | 0x4C000;
    for (unsigned pin = 0; pin < C3_PINS; pin++)
        chip->out_sel[pin] = OUT_REGISTER;
    reset_spi(chip);
    chip->spi.resets = 0;
}
