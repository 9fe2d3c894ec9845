/* SPDX-License-Identifier: MIT
 *
 * What drivers of microcontrollers leave in registers that held anything before: zeros, ones, noise; at rates, pins and
 * modes of all kinds, those that are refused among them. It is as in tests/golden/golden_registers.expected. The
 * drivers' own tests say what is right; this tells that a bit that was left alone, or none, has changed.
 * GOLDEN_FRAMES=write writes the file anew. */
#include "golden_stage.h"
#include "mcu/avr_gpio.h"
#include "mcu/avr_spi.h"
#include "mcu/avr_timer.h"
#include "mcu/fe310_gpio.h"
#include "mcu/fe310_prci.h"
#include "mcu/fe310_spi.h"
#include "mcu/lm3s_clocks.h"
#include "mcu/lm3s_gpio.h"
#include "mcu/pl022.h"
#include "mcu/rp2040_clocks.h"
#include "mcu/rp2040_dma.h"
#include "mcu/sio_gpio.h"
#include "mcu/stm32_dma.h"
#include "mcu/stm32_spi.h"
#include "mcu/stm32f1_gpio.h"
#include "mcu/stm32f1_rcc.h"
#include "mcu/stm32f4_gpio.h"
#include "mcu/stm32f4_rcc.h"
#include "mcu/systick.h"
#include "rigs/cmocka_ready.h"
#include "rigs/random.h"

enum { PATTERNS = 10 };

static const uint32_t rates_hz[] = {0,        1,        32768,    125000,    1000000,   4000000,   7999999,   8000000,
                                    8000001,  12000000, 16000000, 24000000,  25000000,  31250000,  48000000,  62500000,
                                    72000000, 84000000, 90000000, 125000000, 168000000, 256000000, UINT32_MAX};
enum { RATES = sizeof rates_hz / sizeof *rates_hz };

static const uint8_t data[40] = {1, 2, 4, 8, 16, 32, 64, 128, 255};
static struct random noise;
static uint32_t hash;

/* Zeros, ones, then noise. */
static void fill(unsigned pattern, void *registers, size_t size_b)
{
    uint8_t *at = registers;

    for (size_t i = 0; i < size_b; i++)
        at[i] = pattern == 0 ? 0 : pattern == 1 ? 0xFF : (uint8_t)random_u64(&noise);
}

static void note(const void *registers, size_t size_b, int64_t result)
{
    hash = golden_hash(golden_hash(hash, &result, sizeof result), registers, size_b);
}

/* Everything that a bus does, with what it leaves. */
static void note_bus(const struct bus *bus, void *registers, size_t size_b)
{
    note(registers, size_b, bus_write(bus, data, 1));
    note(registers, size_b, bus_write(bus, data, 9));
    note(registers, size_b, bus_flush(bus));
    note(registers, size_b, bus->message_b);
}

static void note_pin(const struct pin *pin, void *registers, size_t size_b)
{
    note(registers, size_b, pin_set(pin, true));
    note(registers, size_b, pin_set(pin, false));
}

static void avr(unsigned pattern)
{
    struct avr_spi_registers spi_at;
    struct avr_timer_registers timer_at;
    struct avr_gpio_registers gpio_at;
    struct avr_spi spi;
    struct avr_timer timer;
    struct avr_output output;

    for (int i = 0; i < RATES; i++) {
        for (int k = 0; k < RATES; k++) {
            fill(pattern, &spi_at, sizeof spi_at);
            note(&spi_at, sizeof spi_at, avr_spi_init(&spi, &spi_at, rates_hz[i], rates_hz[k], 0));
        }
        fill(pattern, &timer_at, sizeof timer_at);
        const int err = avr_timer_init(&timer, &timer_at, rates_hz[i]);
        note(&timer_at, sizeof timer_at, err ? err : timer.ticks_per_us);
    }
    for (uint8_t bit = 0; bit < 8; bit++) {
        fill(pattern, &gpio_at, sizeof gpio_at);
        struct pin pin = avr_gpio_output(&output, &gpio_at, bit, pattern & 1);
        note_pin(&pin, &gpio_at, sizeof gpio_at);
        pin = avr_gpio_sink(&output, &gpio_at, bit);
        note_pin(&pin, &gpio_at, sizeof gpio_at);
        avr_gpio_inputs(&gpio_at, (uint8_t)(0x15u << bit));
        note(&gpio_at, sizeof gpio_at, 0);
    }
}

static int no_delay(void *ctx, uint32_t delay_us)
{
    hash = golden_hash(hash, &delay_us, sizeof delay_us);
    return *(const int *)ctx;
}

static void fe310(unsigned pattern)
{
    struct fe310_gpio gpio_at;
    struct fe310_prci prci_at;
    struct fe310_spi_registers spi_at;
    struct fe310_spi spi;

    for (uint8_t bit = 0; bit < 32; bit++) {
        const struct fe310_pin to = {&gpio_at, bit, bit & 1};
        fill(pattern, &gpio_at, sizeof gpio_at);
        const struct pin pin = fe310_gpio_output(&to, bit & 2);
        note_pin(&pin, &gpio_at, sizeof gpio_at);
        fe310_gpio_lend(&to);
        note(&gpio_at, sizeof gpio_at, 0);
    }
    for (int err = 0; err > -2; err--) {
        const struct clock clock = {&err, no_delay};
        fill(pattern, &prci_at, sizeof prci_at);
        fill(pattern, &spi_at, sizeof spi_at);
        note(&prci_at, sizeof prci_at, fe310_prci_init(&prci_at, &spi_at, &clock));
        note(&spi_at, sizeof spi_at, 0);
    }
    for (int i = 0; i < RATES; i++)
        for (int k = 0; k<RATES; k += pattern> 2 ? 7 : 1) {
            fill(pattern, &spi_at, sizeof spi_at);
            spi_at.rxdata |= pattern % 3 ? UINT32_C(1) << 31 : 0;
            note(&spi_at, sizeof spi_at, fe310_spi_init(&spi, &spi_at, rates_hz[i], rates_hz[k], 3));
        }
    fill(pattern, &spi_at, sizeof spi_at);
    if (fe310_spi_init(&spi, &spi_at, 16000000, 4000000, 3)) return;
    const struct bus bus = fe310_spi_bus(&spi);
    for (int ready = 0; ready < 2; ready++) {
        spi_at.rxdata = ready ? 0 : UINT32_C(1) << 31;
        note_bus(&bus, &spi_at, sizeof spi_at);
    }
}

static void lm3s(unsigned pattern)
{
    static struct lm3s_system_registers system_at;
    static struct lm3s_gpio_registers gpio_at;
    struct lm3s_output output;

    fill(pattern, &system_at, sizeof system_at);
    note(&system_at, sizeof system_at, lm3s_clocks_init(&system_at));
    for (uint8_t group = 0; group < 3; group++) {
        lm3s_peripherals_start(&system_at, group, UINT32_C(0x11) << pattern);
        note(&system_at, sizeof system_at, group);
    }
    for (uint8_t bit = 0; bit < 8; bit++) {
        fill(pattern, &gpio_at, sizeof gpio_at);
        const struct pin pin = lm3s_gpio_output(&output, &gpio_at, bit, pattern & 1);
        note_pin(&pin, &gpio_at, sizeof gpio_at);
        lm3s_gpio_inputs(&gpio_at, (uint8_t)(0x15u << bit));
        lm3s_gpio_alternate(&gpio_at, (uint8_t)(0x23u << bit));
        note(&gpio_at, sizeof gpio_at, lm3s_gpio_read(&gpio_at, (uint8_t)(1u << bit)));
    }
}

static void rp2040(unsigned pattern)
{
    static struct rp2040_dma_registers dma_at;
    struct rp2040_resets_registers resets_at;
    struct rp2040_xosc_registers xosc_at;
    struct rp2040_pll_registers pll_at;
    struct rp2040_clocks_registers clocks_at;
    const struct rp2040_clocks clocks = {&resets_at, &xosc_at, &pll_at, &clocks_at};
    struct pl022_registers spi_at;
    struct pl022 spi;
    struct rp2040_dma dma;

    for (int ready = 0; ready < 5; ready++) { /* one more each time */
        fill(pattern, &resets_at, sizeof resets_at);
        fill(pattern, &xosc_at, sizeof xosc_at);
        fill(pattern, &pll_at, sizeof pll_at);
        fill(pattern, &clocks_at, sizeof clocks_at);
        if (ready > 0) xosc_at.status |= UINT32_C(1) << 31;
        if (ready > 1) clocks_at.sys.selected = ready == 4 ? 3 : 1;
        if (ready > 2) clocks_at.ref.selected = 4, resets_at.reset_done = UINT32_MAX;
        note(&clocks_at, sizeof clocks_at, rp2040_clocks_init(&clocks));
        note(&resets_at, sizeof resets_at, rp2040_reset(&resets_at, UINT32_C(0x1020) << pattern));
        note(&resets_at, sizeof resets_at, rp2040_release(&resets_at, UINT32_C(1) << ready));
        note(&xosc_at, sizeof xosc_at, 0);
        note(&pll_at, sizeof pll_at, 0);
    }
    for (int i = 0; i < RATES; i++)
        for (int k = 0; k < RATES; k++)
            for (uint8_t mode = 0; mode < 5; mode++) {
                const struct pl022_config config = {rates_hz[i], rates_hz[k], mode};
                fill(pattern, &spi_at, sizeof spi_at);
                if (mode || i % 5) spi_at.sr = PL022_SR_TFE | PL022_SR_TNF; /* else what it is at is noise */
                const int err = pl022_init(&spi, &spi_at, &config);
                note(&spi_at, sizeof spi_at, err ? err : (int64_t)spi.spi_hz << 32 | spi.limit_polls);
            }
    const struct pl022_config config = {125000000, 31250000, (uint8_t)(pattern & 3)};
    spi_at.sr = PL022_SR_TFE | PL022_SR_TNF;
    assert_int_equal(pl022_init(&spi, &spi_at, &config), 0);
    for (unsigned status = 0; status < 32; status++) {
        const struct bus bus = pl022_bus(&spi);
        spi_at.sr = status;
        note_bus(&bus, &spi_at, sizeof spi_at);
    }
    for (uint8_t channel = 0; channel < 12; channel++) {
        fill(pattern, &dma_at, sizeof dma_at);
        rp2040_dma_init(&dma, &dma_at, channel, &spi, (uint8_t)(16 + channel));
        const struct bus bus = rp2040_dma_bus(&dma);
        dma_at.chan_abort = 0;
        spi_at.sr = PL022_SR_TFE | PL022_SR_TNF;
        for (unsigned busy = 0; busy < 4; busy++) {
            dma_at.ch[channel].ctrl_trig = (busy & 1 ? UINT32_C(1) << 24 : 0) | (busy & 2 ? UINT32_C(5) << 29 : 0);
            for (size_t n_b = 14; n_b < 19; n_b++)
                hash = golden_hash(hash, &(int){bus_write(&bus, data, n_b)}, sizeof(int));
            hash = golden_hash(hash, &(size_t){bus.left_b(bus.ctx)}, sizeof(size_t));
            hash = golden_hash(hash, &(int){bus_flush(&bus)}, sizeof(int));
            dma_at.ch[channel].read_addr = dma_at.ch[channel].write_addr = 0; /* of this run */
            note(&dma_at, sizeof dma_at, busy);
        }
    }
}

static void sio(unsigned pattern)
{
    struct sio_registers sio_at;
    struct io_bank0_registers io_at;
    struct pads_bank0_registers pads_at;
    const struct sio_gpio gpio = {&sio_at, &io_at, &pads_at};
    struct sio_output output;

    for (uint8_t number = 0; number < SIO_GPIO_PINS; number++) {
        fill(pattern, &sio_at, sizeof sio_at);
        fill(pattern, &io_at, sizeof io_at);
        fill(pattern, &pads_at, sizeof pads_at);
        sio_gpio_select(&gpio, number, number & 1 ? SIO_GPIO_SPI : SIO_GPIO_SIO,
                        number & 2 ? SIO_GPIO_SLOW : SIO_GPIO_FAST);
        note(&io_at, sizeof io_at, 0);
        const struct pin pin = sio_gpio_output(&output, &gpio, number, pattern & 1);
        note_pin(&pin, &sio_at, sizeof sio_at);
        note(&io_at, sizeof io_at, 0);
        note(&pads_at, sizeof pads_at, 0);
    }
}

static void stm32(unsigned pattern)
{
    struct stm32f1_gpio f1_at;
    struct stm32f4_gpio f4_at;
    struct stm32f1_rcc rcc1_at;
    struct stm32f4_rcc rcc4_at;
    struct stm32_spi_registers spi_at;
    struct stm32_dma_registers dma_at;
    struct stm32_spi spi;
    struct stm32_dma dma;
    uint32_t acr;

    for (uint8_t bit = 0; bit < 16; bit++) {
        const struct stm32f1_pin one = {&f1_at, bit, bit & 1};
        const struct stm32f4_pin four = {&f4_at, bit, bit & 1};
        fill(pattern, &f1_at, sizeof f1_at);
        fill(pattern, &f4_at, sizeof f4_at);
        struct pin pin = stm32f1_gpio_output(&one, bit & 2);
        note_pin(&pin, &f1_at, sizeof f1_at);
        stm32f1_gpio_lend(&one);
        note(&f1_at, sizeof f1_at, 0);
        pin = stm32f4_gpio_output(&four, bit & 2);
        note_pin(&pin, &f4_at, sizeof f4_at);
        stm32f4_gpio_lend(&four, (uint8_t)(bit ^ 5));
        note(&f4_at, sizeof f4_at, 0);
    }
    for (int i = 0; i < RATES; i++)
        for (int ready = 0; ready < (pattern < 4 ? 2 : 1); ready++) {
            fill(pattern, &rcc1_at, sizeof rcc1_at);
            fill(pattern, &rcc4_at, sizeof rcc4_at);
            fill(pattern, &acr, sizeof acr);
            if (ready) rcc1_at.cr = rcc4_at.cr = UINT32_C(0x02020002), rcc1_at.cfgr = rcc4_at.cfgr = 8;
            note(&rcc1_at, sizeof rcc1_at, stm32f1_rcc_init(&rcc1_at, &acr, rates_hz[i]));
            note(&acr, sizeof acr, 0);
            const struct stm32f4_clocks clocks = stm32f4_rcc_init(&rcc4_at, &acr, rates_hz[i]);
            note(&rcc4_at, sizeof rcc4_at, (int64_t)clocks.cpu_hz << 32 | clocks.apb2_hz);
            note(&acr, sizeof acr, clocks.apb1_hz);
            stm32f1_rcc_enable(&rcc1_at, UINT32_C(0x14) << pattern);
            stm32f4_rcc_enable(&rcc4_at, UINT32_C(0x12) << pattern, UINT32_C(0x21) << pattern);
            note(&rcc1_at, sizeof rcc1_at, 0);
            note(&rcc4_at, sizeof rcc4_at, 0);
        }
    for (int i = 0; i < RATES; i++)
        for (int k = 0; k < RATES; k++) {
            fill(pattern, &spi_at, sizeof spi_at);
            note(&spi_at, sizeof spi_at, stm32_spi_init(&spi, &spi_at, rates_hz[i], rates_hz[k], 3));
        }
    assert_int_equal(stm32_spi_init(&spi, &spi_at, 84000000, 21000000, 3), 0);
    const struct bus bus = stm32_spi_bus(&spi);
    for (spi_at.sr = 0; spi_at.sr < 512; spi_at.sr += spi_at.sr ? spi_at.sr : 1)
        note_bus(&bus, &spi_at, sizeof spi_at);
    for (uint8_t stream = 0; stream < 8; stream++)
        for (uint8_t flags = 0; flags < 4; flags++) {
            fill(pattern, &dma_at, sizeof dma_at);
            spi_at.sr = 2;
            const int err = stm32_dma_init(&dma, &dma_at, stream, (uint8_t)(stream ^ 3), &spi);
            const struct bus by = stm32_dma_bus(&dma);
            for (int i = 0; i < 2; i++)
                dma_at.isr[i] = flags == 3   ? UINT32_MAX
                                : flags == 2 ? UINT32_C(0x08208208)
                                : flags      ? UINT32_C(0x0C30C30C)
                                             : 0;
            dma_at.streams[stream].ndtr = 0;
            for (size_t n_b = 1; n_b < 40; n_b += 6)
                hash = golden_hash(hash, &(int){bus_write(&by, data, n_b)}, sizeof(int));
            hash = golden_hash(hash, &(size_t){by.left_b(by.ctx)}, sizeof(size_t));
            hash = golden_hash(hash, &(int){bus_flush(&by)}, sizeof(int));
            dma_at.streams[stream].par = dma_at.streams[stream].m0ar = 0; /* of this run */
            note(&dma_at, sizeof dma_at, err);
            note(&spi_at, sizeof spi_at, 0);
        }
}

static void systick(unsigned pattern)
{
    struct systick_registers at;
    struct systick timer;

    for (int i = 0; i < RATES; i++) {
        fill(pattern, &at, sizeof at);
        const int err = systick_init(&timer, &at, rates_hz[i]);
        note(&at, sizeof at, err ? err : (int64_t)timer.cycles_per_us);
    }
}

static void registers_become_what_they_did(void **state)
{
    static const struct {
        const char *name;
        void (*run)(unsigned pattern);
    } families[] = {{"avr", avr}, {"fe310", fe310}, {"lm3s", lm3s},      {"rp2040", rp2040},
                    {"sio", sio}, {"stm32", stm32}, {"systick", systick}};

    (void)state;
    for (size_t i = 0; i < sizeof families / sizeof *families; i++) {
        golden_put("%s:", families[i].name);
        noise = (struct random){300 + i};
        for (unsigned pattern = 0; pattern < PATTERNS; pattern++) {
            hash = GOLDEN_HASH;
            families[i].run(pattern);
            golden_put(" %08x", hash);
        }
        golden_put("\n");
    }
    golden_compare("tests/golden/golden_registers.expected");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(registers_become_what_they_did)};

    return cmocka_run_group_tests_name("golden_registers", tests, NULL, NULL);
}
