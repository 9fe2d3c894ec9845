/* SPDX-License-Identifier: MIT
 *
 * The rules that the emulated STM32 holds programs to: a program that keeps them all is not told on, and each way to
 * break one is, by the name of that rule and no other. Numbers are those of RM0090 and RM0008. */
#include "emulators/stm32_chip.h"
#include "rigs/cmocka_ready.h"

#include <stdio.h>
#include <string.h>

enum { RCC4 = 0x40023800, RCC1 = 0x40021000, ACR4 = 0x40023C00, ACR1 = 0x40022000, PWR = 0x40007000 };
enum { GPIOA4 = 0x40020000, GPIOB4 = 0x40020400, GPIOA1 = 0x40010800, SPI = 0x40013000, DMA = 0x40026400 };
enum { CR1 = SPI, CR2 = SPI + 4, SR = SPI + 8, DR = SPI + 12 };
enum { TXE = 2, BSY = 128, SPE = 0x40, CONFIGURED = 0xC307 }; /* transmits by two of the clock, mode 3, SSM and SSI */
enum { STREAM3 = DMA + 0x10 + 3 * 0x18, NDTR = 4, PAR = 8, M0AR = 12, FCR = 20 };
enum { LISR = DMA, LIFCR = DMA + 8, LONG_B = 600 };
#define HSE_ON UINT32_C(0x00010000)
#define HSE_READY UINT32_C(0x00020000)
#define PLL_ON UINT32_C(0x01000000)
#define PLL_READY UINT32_C(0x02000000)
#define TO_SPI UINT32_C(0x06000440) /* channel 3, memory counts up, to the peripheral */
#define FLAGS3 (UINT32_C(0x3D) << 22)
#define TC3 (UINT32_C(0x20) << 22)
#define RAM UINT32_C(0x20000000)

static struct {
    struct chip chip;
    unsigned told[RULES];
    unsigned ever[CHIP_KINDS][RULES];
    uint8_t sent[4 * LONG_B];
    unsigned n_sent, levels;
    uint8_t ram[4 * LONG_B];
} rig;

static void on_complaint(void *ctx, enum chip_rule rule, const char *what)
{
    (void)ctx, (void)what;
    rig.told[rule]++;
    rig.ever[rig.chip.kind][rule]++;
}

static void on_byte(void *ctx, uint8_t byte)
{
    (void)ctx;
    assert_true(rig.n_sent < sizeof rig.sent);
    rig.sent[rig.n_sent++] = byte;
}

static void on_level(void *ctx, unsigned wire, bool high)
{
    (void)ctx, (void)wire, (void)high;
    rig.levels++;
}

static bool on_memory(void *ctx, uint32_t address, uint8_t *value)
{
    (void)ctx;
    if (address >= RAM + sizeof rig.ram) return false;
    *value = address < RAM ? 0xFF : rig.ram[address - RAM];
    return true;
}

/* Every access takes some instructions, as in a program. */
static void put(uint32_t address, uint32_t value)
{
    chip_run(&rig.chip, 4);
    chip_write(&rig.chip, address, value, 4);
}

static uint32_t get(uint32_t address)
{
    chip_run(&rig.chip, 4);
    return chip_read(&rig.chip, address, 4);
}

static void set(uint32_t address, uint32_t bits)
{
    put(address, get(address) | bits);
}

static void await(uint32_t address, uint32_t mask, uint32_t value)
{
    for (uint32_t i = 0; i < 2000000; i++)
        if ((get(address) & mask) == value) return;
    fail_msg("0x%08X does not become 0x%08X", (unsigned)address, (unsigned)value);
}

static void assert_told(enum chip_rule rule)
{
    for (unsigned i = 0; i < RULES; i++)
        if (i != rule && rig.told[i]) fail_msg("instead of rule %d, %u is told: %s", rule, i, chip_rules[i].text);
    if (rule < RULES && !rig.told[rule]) fail_msg("rule %d is not told: %s", rule, chip_rules[rule].text);
    memset(rig.told, 0, sizeof rig.told);
}

static void assert_nothing_told(void)
{
    assert_told(RULES);
}

/* -- How it is done right, and where a test does otherwise -- */

struct recipe {
    enum chip_kind kind;
    uint32_t hse_hz, pll_bits, acr, bus_bits, port, port_bits[3], cr1;
    bool pll_early, pll_alone, switch_early, latency_late, latency_unread, switch_unread, together, no_pins;
    uint32_t panel_hz;
};

static const struct recipe right[CHIP_KINDS] = {
    [CHIP_F405] = {.kind = CHIP_F405,
                   .hse_hz = 12000000,
                   .pll_bits = 0x2740540C,
                   .acr = 0x705,
                   .bus_bits = 0x9400,
                   .port = GPIOA4,
                   .port_bits = {0xA8009900, 0x0C00CC00, 0x50500000}, /* PA4, PA6: outputs; PA5, PA7: AF5 */
                   .cr1 = CONFIGURED},
    [CHIP_F103] = {.kind = CHIP_F103,
                   .hse_hz = 8000000,
                   .pll_bits = 0x001D0000,
                   .acr = 0x12,
                   .bus_bits = 0x400,
                   .port = GPIOA1,
                   .port_bits = {0xB2B24444, 0, 0},
                   .cr1 = CONFIGURED | 1 << 3},
};

static void power_on(const struct recipe *recipe)
{
    const struct chip_setting setting = {.hse_hz = recipe->hse_hz, .panel_hz = recipe->panel_hz};
    const struct chip_world world = {NULL, on_complaint, on_byte, on_level, on_memory};

    memset(rig.told, 0, sizeof rig.told);
    rig.n_sent = rig.levels = 0;
    chip_init(&rig.chip, recipe->kind, &setting, &world);
    for (uint8_t bit = 4; bit <= 6; bit += 2)
        assert_true(chip_add_wire(&rig.chip, &(struct chip_wire){recipe->port, bit, true, true, false, false}));
}

static void clocks(const struct recipe *recipe)
{
    const bool f4 = recipe->kind == CHIP_F405;
    const uint32_t rcc = f4 ? RCC4 : RCC1, cfgr = rcc + (f4 ? 8 : 4), acr = f4 ? ACR4 : ACR1;

    set(rcc, HSE_ON);
    if (!recipe->pll_early && rig.chip.setting.hse_hz) await(rcc, HSE_READY, HSE_READY);
    put(rcc + 4, recipe->pll_bits);
    set(rcc, PLL_ON);
    if (recipe->pll_early || recipe->pll_alone) return;
    if (!recipe->switch_early) await(rcc, PLL_READY, PLL_READY);
    if (!recipe->latency_late) put(acr, recipe->acr);
    if (!recipe->latency_unread) get(acr);
    set(cfgr, recipe->bus_bits);
    set(cfgr, 2);
    if (!recipe->switch_unread) await(cfgr, 12, 8);
    chip_run(&rig.chip, 100000);
    if (recipe->latency_late) put(acr, recipe->acr);
    get(acr);
}

static void peripherals(const struct recipe *recipe)
{
    if (recipe->kind == CHIP_F405) {
        set(RCC4 + 0x30, 1 << 22 | 1);
        set(RCC4 + 0x44, 1 << 12);
        get(RCC4 + 0x30);
        get(RCC4 + 0x44);
        if (recipe->no_pins) return;
        put(GPIOA4 + 8, recipe->port_bits[1]);
        put(GPIOA4 + 0x20, recipe->port_bits[2]);
    } else {
        set(RCC1 + 0x18, 1 << 12 | 4);
    }
    if (!recipe->no_pins) put(recipe->port, recipe->port_bits[0]);
}

static void start(const struct recipe *recipe)
{
    power_on(recipe);
    clocks(recipe);
    peripherals(recipe);
    if (!recipe->together) put(CR1, recipe->cr1);
    put(CR1, recipe->cr1 | SPE);
}

static void start_right(enum chip_kind kind)
{
    start(&right[kind]);
    assert_nothing_told();
}

static void send(uint8_t byte)
{
    await(SR, TXE, TXE);
    put(DR, byte);
}

static void finish(void)
{
    await(SR, TXE, TXE);
    await(SR, BSY, 0);
}

static void stream(uint32_t from, uint32_t count)
{
    for (unsigned i = 0; i < sizeof rig.ram; i++)
        rig.ram[i] = (uint8_t)(i * 7 + 1);
    put(STREAM3 + PAR, DR);
    put(STREAM3 + FCR, 0);
    put(STREAM3, TO_SPI);
    put(LIFCR, FLAGS3);
    put(STREAM3 + M0AR, from);
    put(STREAM3 + NDTR, count);
}

static void stream_on(void)
{
    set(STREAM3, 1);
    set(CR2, 2);
}

/* As RM0090 28.3.9 has it. */
static void finish_stream(void)
{
    await(LISR, TC3, TC3);
    put(CR2, 0);
    finish();
}

/* -- What is right -- */

static void test_a_program_that_keeps_the_rules_is_not_told_on(void **state)
{
    (void)state;
    for (unsigned kind = 0; kind < CHIP_KINDS; kind++) {
        start_right(kind);
        for (uint8_t i = 0; i < 5; i++)
            send(i);
        finish();
        put(right[kind].port + (kind == CHIP_F405 ? 0x18 : 0x10), 1 << 6);
        assert_nothing_told();
        assert_int_equal(rig.n_sent, 5);
        assert_int_equal(rig.sent[4], 4);
        assert_int_equal(rig.levels, 3); /* two that are driven, one that rises */
    }
}

static void test_clocks_become_what_their_dividers_say(void **state)
{
    (void)state;
    start_right(CHIP_F405);
    assert_int_equal(rig.chip.clocks.hclk_hz, 168000000);
    assert_int_equal(rig.chip.clocks.apb1_hz, 42000000);
    assert_int_equal(rig.chip.clocks.apb2_hz, 84000000);
    assert_int_equal(rig.chip.spi.hz, 42000000);
    start_right(CHIP_F103);
    assert_int_equal(rig.chip.clocks.hclk_hz, 72000000);
    assert_int_equal(rig.chip.clocks.apb1_hz, 36000000);
    assert_int_equal(rig.chip.spi.hz, 18000000);
}

static void test_a_stream_sends_in_the_time_of_its_bytes(void **state)
{
    (void)state;
    start_right(CHIP_F405);
    stream(RAM, LONG_B);
    const uint64_t from_ps = rig.chip.now_ps;
    stream_on();
    finish_stream();
    const uint64_t took_ps = rig.chip.now_ps - from_ps, bus_ps = LONG_B * UINT64_C(8000000000000) / 42000000;
    assert_nothing_told();
    assert_int_equal(rig.n_sent, LONG_B);
    assert_memory_equal(rig.sent, rig.ram, LONG_B);
    assert_true(took_ps >= bus_ps && took_ps < bus_ps + bus_ps / 20);
    assert_int_equal(get(STREAM3) & 1, 0);
    assert_int_equal(get(STREAM3 + NDTR), 0);
}

static void test_what_is_painted_too_early_is_sent(void **state)
{
    (void)state;
    start_right(CHIP_F405);
    stream(RAM, 100);
    stream_on();
    while (rig.n_sent < 50)
        chip_run(&rig.chip, 1);
    memset(rig.ram, 0, sizeof rig.ram);
    finish_stream();
    assert_int_equal(rig.sent[49], 49 * 7 + 1 - 256);
    assert_int_equal(rig.sent[55], 0);
}

static void test_a_fifo_reads_ahead(void **state)
{
    (void)state;
    start_right(CHIP_F405);
    stream(RAM, 100);
    put(STREAM3 + FCR, 4);
    stream_on();
    while (rig.n_sent < 1)
        chip_run(&rig.chip, 1);
    memset(rig.ram, 0, sizeof rig.ram);
    finish_stream();
    assert_nothing_told();
    assert_int_equal(rig.sent[10], 71);
    assert_int_equal(rig.sent[40], 0);
}

/* RM0090 10.3.18: an underrun at the start costs no data, and its flag is one more to clear. */
static void test_a_stream_that_is_asked_at_once_flags_an_underrun(void **state)
{
    (void)state;
    start_right(CHIP_F405);
    stream(RAM, 100);
    put(CR2, 2);
    set(STREAM3, 1);
    finish_stream();
    assert_nothing_told();
    assert_int_equal(rig.n_sent, 100);
    assert_memory_equal(rig.sent, rig.ram, 100);
    assert_true(get(LISR) >> 22 & 1);
}

static void test_a_stream_that_is_stopped_takes_its_time(void **state)
{
    (void)state;
    start_right(CHIP_F405);
    stream(RAM, 100);
    stream_on();
    chip_run(&rig.chip, 500);
    const uint32_t control = get(STREAM3);
    put(STREAM3, control & ~UINT32_C(1));
    assert_int_equal(chip_read(&rig.chip, STREAM3, 4) & 1, 1);
    await(STREAM3, 1, 0);
    assert_true(get(STREAM3 + NDTR) > 50);
    assert_true(get(LISR) & TC3); /* RM0090 10.3.14 */
    assert_nothing_told();
}

static void test_a_crystal_or_pll_that_fails_is_never_ready(void **state)
{
    (void)state;
    struct recipe recipe = right[CHIP_F405];
    recipe.hse_hz = 0;
    power_on(&recipe);
    set(RCC4, HSE_ON);
    chip_run(&rig.chip, 100000000);
    assert_int_equal(get(RCC4) & HSE_READY, 0);
    power_on(&right[CHIP_F103]);
    rig.chip.setting.pll_fails = true;
    set(RCC1, HSE_ON);
    await(RCC1, HSE_READY, HSE_READY);
    put(RCC1 + 4, right[CHIP_F103].pll_bits);
    set(RCC1, PLL_ON);
    chip_run(&rig.chip, 100000000);
    assert_int_equal(get(RCC1) & PLL_READY, 0);
    assert_nothing_told();
}

/* -- Registers and clocks -- */

static void test_registers_are_used_as_they_are(void **state)
{
    (void)state;
    start_right(CHIP_F405);
    get(0x40000000);
    assert_told(RULE_MODELLED);
    chip_write(&rig.chip, DR, 1, 1);
    assert_told(RULE_WIDTH);
    chip_write(&rig.chip, STREAM3 + NDTR, 1, 2);
    assert_told(RULE_WIDTH);
    put(RCC4 + 0x30, 0x80400001);
    assert_told(RULE_RESERVED);
    put(CR2, 8);
    assert_told(RULE_RESERVED);
    start_right(CHIP_F103);
    get(0x40010000);
    assert_told(RULE_MODELLED);
    chip_write(&rig.chip, DR, 1, 1);
    assert_told(RULE_WIDTH);
    put(CR2, 16);
    assert_told(RULE_RESERVED);
}

static void test_a_peripheral_wants_its_clock(void **state)
{
    (void)state;
    for (unsigned kind = 0; kind < CHIP_KINDS; kind++) {
        power_on(&right[kind]);
        put(CR1, CONFIGURED);
        assert_told(RULE_CLOCK_ON);
        put(right[kind].port, 0x44444444);
        assert_told(RULE_CLOCK_ON);
    }
    power_on(&right[CHIP_F405]);
    get(STREAM3);
    assert_told(RULE_CLOCK_ON);
}

static void test_a_peripheral_wants_two_cycles(void **state)
{
    (void)state;
    power_on(&right[CHIP_F405]);
    put(RCC4 + 0x30, 0x00100001);
    chip_run(&rig.chip, 1);
    chip_write(&rig.chip, GPIOA4, 0xA8000100, 4);
    assert_told(RULE_CLOCK_DELAY);
    power_on(&right[CHIP_F405]);
    put(RCC4 + 0x30, 0x00100001);
    chip_read(&rig.chip, RCC4 + 0x30, 4);
    chip_write(&rig.chip, GPIOA4, 0xA8000100, 4);
    assert_nothing_told();
}

static void assert_clocks_tell(struct recipe recipe, enum chip_rule rule)
{
    power_on(&recipe);
    clocks(&recipe);
    assert_told(rule);
}

#define BUT(kind, ...) with(right[kind], (struct recipe){__VA_ARGS__})

/* What is not 0 there takes the place of what is right. */
static struct recipe with(struct recipe recipe, struct recipe other)
{
    if (other.hse_hz) recipe.hse_hz = other.hse_hz;
    if (other.pll_bits) recipe.pll_bits = other.pll_bits;
    if (other.acr) recipe.acr = other.acr;
    if (other.bus_bits) recipe.bus_bits = other.bus_bits;
    if (other.cr1) recipe.cr1 = other.cr1;
    for (int i = 0; i < 3; i++)
        if (other.port_bits[i]) recipe.port_bits[i] = other.port_bits[i];
    recipe.pll_early = other.pll_early;
    recipe.pll_alone = other.pll_alone;
    recipe.switch_early = other.switch_early;
    recipe.latency_late = other.latency_late;
    recipe.latency_unread = other.latency_unread;
    recipe.switch_unread = other.switch_unread;
    recipe.together = other.together;
    recipe.no_pins = other.no_pins;
    recipe.panel_hz = other.panel_hz;
    return recipe;
}

static void test_oscillators_and_pll(void **state)
{
    (void)state;
    assert_clocks_tell(BUT(CHIP_F103, .hse_hz = 25000000, .pll_bits = 0x00030000, .pll_alone = true), RULE_CRYSTAL);
    assert_clocks_tell(BUT(CHIP_F405, .hse_hz = 30000000, .pll_bits = 0x2740541E, .pll_alone = true), RULE_CRYSTAL);
    for (unsigned kind = 0; kind < CHIP_KINDS; kind++) {
        assert_clocks_tell(BUT(kind, .pll_early = true), RULE_PLL_SOURCE);
        assert_clocks_tell(BUT(kind, .switch_early = true), RULE_SWITCH_READY);
    }
    assert_clocks_tell(BUT(CHIP_F405, .pll_bits = 0x27405406, .pll_alone = true), RULE_PLL_RANGE); /* M 6: 2 MHz, 672 */
    assert_clocks_tell(BUT(CHIP_F405, .pll_bits = 0x2640540C, .pll_alone = true), RULE_PLL_RANGE); /* Q 6: 56 MHz */
    assert_clocks_tell(BUT(CHIP_F405, .pll_bits = 0x27400B0C, .pll_alone = true), RULE_PLL_RANGE); /* N 44 */
    assert_clocks_tell(BUT(CHIP_F103, .pll_bits = 0x00010000, .hse_hz = 4000000, .pll_alone = true), RULE_PLL_RANGE);
    assert_clocks_tell(BUT(CHIP_F103, .pll_bits = 0x00210000, .pll_alone = true), RULE_PLL_RANGE); /* 80 MHz */
}

static void test_the_pll_is_configured_while_it_is_off(void **state)
{
    (void)state;
    start_right(CHIP_F405);
    put(RCC4 + 4, 0x2740540D);
    assert_told(RULE_PLL_STOPPED);
    start_right(CHIP_F103);
    put(RCC1 + 4, 0x0019040A);
    assert_told(RULE_PLL_STOPPED);
}

static void test_wait_states_come_first_and_are_read(void **state)
{
    (void)state;
    for (unsigned kind = 0; kind < CHIP_KINDS; kind++) {
        assert_clocks_tell(BUT(kind, .latency_late = true), RULE_WAIT_STATES);
        assert_clocks_tell(BUT(kind, .latency_unread = true), RULE_WAIT_STATES_READ);
    }
    assert_clocks_tell(BUT(CHIP_F405, .acr = 0x704), RULE_WAIT_STATES);
    assert_clocks_tell(BUT(CHIP_F103, .acr = 0x11), RULE_WAIT_STATES);
    start_right(CHIP_F405);
    put(ACR4, 0x700);
    assert_told(RULE_WAIT_STATES);
    start_right(CHIP_F103);
    put(ACR1, 0x02);
    assert_told(RULE_PREFETCH);
}

static void test_buses_have_limits(void **state)
{
    (void)state;
    assert_clocks_tell(BUT(CHIP_F405, .bus_bits = 0x8400), RULE_BUS_RATE); /* APB1 has 84 MHz */
    assert_clocks_tell(BUT(CHIP_F405, .bus_bits = 0x1400), RULE_BUS_RATE); /* APB2 has 168 */
    assert_clocks_tell(BUT(CHIP_F103, .bus_bits = 0x3000), RULE_BUS_RATE); /* APB1 has 72 */
    power_on(&right[CHIP_F405]);
    set(RCC4 + 0x40, 1 << 28);
    put(PWR, 0);
    clocks(&right[CHIP_F405]);
    assert_told(RULE_VOLTAGE);
}

static void test_what_is_in_use_is_not_stopped(void **state)
{
    (void)state;
    static const uint32_t used[3] = {HSE_ON, PLL_ON, HSE_ON | PLL_ON};
    for (unsigned kind = 0; kind < CHIP_KINDS; kind++)
        for (unsigned i = 0; i < 3; i++) {
            start_right(kind);
            const uint32_t rcc = kind == CHIP_F405 ? RCC4 : RCC1, now = get(rcc);
            put(rcc, now & ~used[i]);
            assert_told(RULE_STOP_UNUSED);
        }
    power_on(&right[CHIP_F405]);
    put(RCC4, 0x80);
    assert_told(RULE_STOP_UNUSED);
}

static void test_the_switch_is_waited_for(void **state)
{
    (void)state;
    for (unsigned kind = 0; kind < CHIP_KINDS; kind++) {
        const struct recipe recipe = BUT(kind, .switch_unread = true);
        start(&recipe);
        assert_told(RULE_SWITCH_READ);
    }
}

/* -- Pins -- */

static void assert_start_tells(struct recipe recipe, enum chip_rule rule)
{
    start(&recipe);
    assert_told(rule);
}

static void test_the_spi_wants_its_pins(void **state)
{
    (void)state;
    assert_start_tells(BUT(CHIP_F405, .no_pins = true), RULE_SPI_PINS);
    assert_start_tells(BUT(CHIP_F405, .port_bits = {0, 0, 0x50600000}), RULE_SPI_PINS);   /* AF6 */
    assert_start_tells(BUT(CHIP_F405, .port_bits = {0xA8005900, 0, 0}), RULE_SPI_PINS);   /* PA7 is an output */
    assert_start_tells(BUT(CHIP_F405, .port_bits = {0, 0x0C00C400, 0}), RULE_SPI_EDGES);  /* 25 MHz at SCK */
    assert_start_tells(BUT(CHIP_F103, .port_bits = {0x32B24444, 0, 0}), RULE_SPI_PINS);   /* PA7 is an output */
    assert_start_tells(BUT(CHIP_F103, .port_bits = {0xB2A24444, 0, 0}), RULE_SPI_EDGES);  /* 2 MHz at SCK */
    assert_start_tells(BUT(CHIP_F405, .port_bits = {0xA4009900, 0, 0}), RULE_DEBUG_PINS); /* PA13 is an output */
}

static void test_wires_move_when_the_bus_rests(void **state)
{
    (void)state;
    for (unsigned kind = 0; kind < CHIP_KINDS; kind++) {
        const uint32_t bsrr = right[kind].port + (kind == CHIP_F405 ? 0x18 : 0x10);
        start_right(kind);
        put(bsrr, 1 << 6);
        send(1);
        chip_write(&rig.chip, bsrr, UINT32_C(1) << 22, 4); /* TXE is 0 */
        assert_told(RULE_PIN_IDLE);
        await(SR, TXE, TXE);
        put(bsrr, 1 << 6); /* BSY is 1 */
        assert_told(RULE_PIN_IDLE);
        finish();
        put(bsrr, UINT32_C(1) << 22);
        assert_nothing_told();
    }
    start_right(CHIP_F405);
    stream(RAM, 1);
    set(STREAM3, 1);
    chip_write(&rig.chip, CR2, 2, 4);
    chip_write(&rig.chip, GPIOA4 + 0x18, 1 << 4, 4); /* asked for, not yet there: TXE is 1, BSY 0 */
    assert_told(RULE_PIN_IDLE);
}

/* It rests in time, but by luck: RM0090 28.3.9, note. */
static void test_the_end_is_waited_for(void **state)
{
    (void)state;
    for (unsigned kind = 0; kind < CHIP_KINDS; kind++) {
        const uint32_t bsrr = right[kind].port + (kind == CHIP_F405 ? 0x18 : 0x10);
        start_right(kind);
        send(1);
        chip_run(&rig.chip, 10000);
        put(bsrr, 1 << 6);
        assert_told(RULE_END_READ);
        start_right(kind);
        chip_write(&rig.chip, DR, 1, 4);
        assert_int_equal(chip_read(&rig.chip, SR, 4) & (BSY | TXE), 0); /* BSY is 0 not yet, not already */
        chip_run(&rig.chip, 10000);
        put(bsrr, 1 << 6);
        assert_told(RULE_END_READ);
        start_right(kind);
        send(1);
        await(SR, TXE, TXE);
        chip_run(&rig.chip, 10000);
        put(CR1, right[kind].cr1);
        assert_told(RULE_END_READ);
    }
}

static void test_wires_are_driven(void **state)
{
    (void)state;
    struct recipe recipe = BUT(CHIP_F405, .port_bits = {0xA8008900, 0, 0}); /* PA6 is an input */
    start(&recipe);
    assert_nothing_told();
    send(1);
    finish();
    assert_told(RULE_PIN_DRIVEN);
    recipe = BUT(CHIP_F103, .port_bits = {0xB4B24444, 0, 0});
    start(&recipe);
    send(1);
    finish();
    assert_told(RULE_PIN_DRIVEN);
}

/* -- SPI -- */

static void test_the_spi_has_a_most_rate(void **state)
{
    (void)state;
    assert_start_tells(BUT(CHIP_F103, .cr1 = CONFIGURED), RULE_SPI_RATE); /* 36 MHz */
    assert_start_tells(BUT(CHIP_F405, .panel_hz = 41999999), RULE_SPI_RATE);
    assert_start_tells(BUT(CHIP_F405, .panel_hz = 42000000), RULES);
}

static void test_the_spi_is_configured_then_enabled(void **state)
{
    (void)state;
    for (unsigned kind = 0; kind < CHIP_KINDS; kind++) {
        assert_start_tells(BUT(kind, .together = true), RULE_SPI_ORDER);
        start_right(kind);
        put(CR1, (right[kind].cr1 | SPE) ^ 3); /* another mode */
        assert_told(RULE_SPI_ORDER);
        assert_start_tells(BUT(kind, .cr1 = right[kind].cr1 & ~UINT32_C(0x100)), RULE_SPI_SELECTED); /* SSI is 0 */
        assert_int_equal(get(SR) >> 5 & 1, 1);
    }
}

static void assert_byte_tells(struct recipe recipe, enum chip_rule rule)
{
    start(&recipe);
    assert_nothing_told();
    put(DR, 1);
    chip_run(&rig.chip, 10000);
    assert_told(rule);
    assert_int_equal(rig.n_sent, 0);
}

static void test_data_are_written_when_they_can_leave(void **state)
{
    (void)state;
    for (unsigned kind = 0; kind < CHIP_KINDS; kind++) {
        assert_byte_tells(BUT(kind, .cr1 = right[kind].cr1 & ~UINT32_C(0x4000)), RULE_SPI_DIRECTION); /* BIDIOE is 0 */
        start_right(kind);
        put(CR1, right[kind].cr1);
        put(DR, 1);
        assert_told(RULE_SPI_ENABLED);
        start_right(kind);
        for (uint8_t i = 1; i < 4; i++)
            chip_write(&rig.chip, DR, i, 4);
        assert_told(RULE_SPI_EMPTY);
        finish();
        assert_int_equal(rig.n_sent, 1);
        assert_int_equal(rig.sent[0], 3);
    }
}

static void test_the_spi_is_disabled_when_it_rests(void **state)
{
    (void)state;
    for (unsigned kind = 0; kind < CHIP_KINDS; kind++) {
        start_right(kind);
        send(1);
        await(SR, TXE, TXE);
        put(CR1, right[kind].cr1);
        assert_told(RULE_SPI_IDLE);
        start_right(kind);
        send(1);
        put(kind == CHIP_F405 ? RCC4 + 0x44 : RCC1 + 0x18, kind == CHIP_F405 ? 0 : 4);
        assert_told(RULE_SPI_IDLE);
    }
}

/* RM0090 28.3.9: two clocks of the bus lie between a write and BSY; TXE is what is looked at first. */
static void test_busy_alone_tells_too_little(void **state)
{
    (void)state;
    start_right(CHIP_F405);
    chip_write(&rig.chip, DR, 1, 4);
    chip_run(&rig.chip, 1);
    assert_int_equal(chip_read(&rig.chip, SR, 4) & (BSY | TXE), 0);
}

static void test_modes_of_the_spi_change_what_leaves(void **state)
{
    (void)state;
    struct recipe recipe = BUT(CHIP_F405, .cr1 = CONFIGURED | 0x80); /* least significant bit first */
    start(&recipe);
    send(0x53);
    finish();
    assert_int_equal(rig.sent[0], 0xCA);
    recipe.cr1 = CONFIGURED | 0x800; /* 16 bits */
    start(&recipe);
    await(SR, TXE, TXE);
    put(DR, 0x1234);
    finish();
    assert_nothing_told();
    assert_memory_equal(rig.sent, "\x12\x34", 2);
}

/* RM0090 28.3.7, 28.3.10: what nobody reads is received all the same, unless the one data line is an output. */
static void test_two_lines_receive_what_nobody_reads(void **state)
{
    (void)state;
    start_right(CHIP_F405);
    send(1);
    send(2);
    finish();
    assert_int_equal(get(SR) & 0x41, 0);
    struct recipe recipe = right[CHIP_F405];
    recipe.cr1 &= ~UINT32_C(0xC000);
    start(&recipe);
    send(1);
    finish();
    assert_int_equal(get(SR) & 0x41, 1);
    send(2);
    finish();
    assert_int_equal(get(SR) & 0x41, 0x41);
    get(DR);
    assert_int_equal(get(SR) & 0x41, 0);
    assert_nothing_told();
}

/* -- DMA -- */

static void assert_stream_tells(uint32_t at, uint32_t value, enum chip_rule rule)
{
    start_right(CHIP_F405);
    stream(RAM, 100);
    put(at, value);
    stream_on();
    chip_run(&rig.chip, 100);
    assert_told(rule);
}

static void test_a_stream_is_told_where_from_and_where_to(void **state)
{
    (void)state;
    assert_stream_tells(STREAM3 + PAR, DR + 1, RULE_DMA_TARGET);
    assert_stream_tells(STREAM3, TO_SPI & ~UINT32_C(0x40), RULE_DMA_TARGET); /* to memory */
    assert_stream_tells(STREAM3, TO_SPI | 0x200, RULE_DMA_TARGET);           /* the peripheral's address counts up */
    assert_stream_tells(STREAM3, TO_SPI ^ UINT32_C(0x02000000), RULE_DMA_REQUEST); /* channel 2 */
    assert_stream_tells(STREAM3, TO_SPI | 0x800, RULE_DMA_WIDTH);
    assert_stream_tells(STREAM3 + NDTR, 0, RULE_DMA_COUNT);
    assert_stream_tells(STREAM3 + M0AR, 0x10000000, RULE_DMA_MEMORY); /* CCM */
    assert_true(get(LISR) >> 22 & 8);
    assert_stream_tells(STREAM3 + M0AR, 0x2001FFFF - 50, RULE_DMA_MEMORY);
    assert_stream_tells(STREAM3, TO_SPI | 0x100, RULE_MODELLED); /* for ever */
}

static void test_other_streams_do_not_serve_the_spi(void **state)
{
    (void)state;
    enum { STREAM2 = STREAM3 - 0x18 };
    start_right(CHIP_F405);
    put(STREAM2 + PAR, DR);
    put(STREAM2 + M0AR, RAM);
    put(STREAM2 + NDTR, 10);
    put(STREAM2, TO_SPI);
    set(STREAM2, 1);
    set(CR2, 2);
    chip_run(&rig.chip, 10000);
    assert_told(RULE_DMA_REQUEST);
    assert_int_equal(rig.n_sent, 0);
}

static void test_a_stream_is_off_when_it_is_configured(void **state)
{
    (void)state;
    static const uint32_t at[4] = {STREAM3 + M0AR, STREAM3 + NDTR, STREAM3 + PAR, STREAM3 + FCR};
    for (unsigned i = 0; i < 4; i++) {
        start_right(CHIP_F405);
        stream(RAM, 100);
        stream_on();
        put(at[i], 7);
        assert_told(RULE_DMA_STOPPED);
        assert_int_not_equal(get(at[i]), 7);
    }
    start_right(CHIP_F405);
    stream(RAM, 100);
    stream_on();
    put(STREAM3, TO_SPI | 1 | 1 << 16);
    assert_told(RULE_DMA_STOPPED);
}

static void test_a_stream_is_read_as_off(void **state)
{
    (void)state;
    start_right(CHIP_F405);
    stream(RAM, 100);
    stream_on();
    finish_stream();
    put(LIFCR, FLAGS3);
    put(STREAM3 + M0AR, RAM + 4);
    assert_told(RULE_DMA_READ);
    start_right(CHIP_F405);
    stream(RAM, 100);
    stream_on();
    finish_stream();
    get(STREAM3);
    put(LIFCR, FLAGS3);
    put(STREAM3 + M0AR, RAM + 4);
    put(STREAM3 + NDTR, 20);
    stream_on();
    finish_stream();
    assert_nothing_told();
    assert_int_equal(rig.n_sent, 120);
}

static void test_flags_are_cleared(void **state)
{
    (void)state;
    start_right(CHIP_F405);
    stream(RAM, 100);
    stream_on();
    finish_stream();
    get(STREAM3);
    put(STREAM3 + NDTR, 20);
    put(LIFCR, TC3); /* HTIF stays */
    stream_on();
    assert_told(RULE_DMA_FLAGS);
}

static void test_a_stream_is_off_before_its_peripheral(void **state)
{
    (void)state;
    start_right(CHIP_F405);
    stream(RAM, 2);
    set(STREAM3, 1); /* and nothing asks */
    put(CR1, CONFIGURED);
    assert_told(RULE_DMA_FIRST);
    start_right(CHIP_F405);
    stream(RAM, 100);
    stream_on();
    finish_stream();
    put(CR1, CONFIGURED); /* EN was not read */
    assert_told(RULE_DMA_FIRST);
    start_right(CHIP_F405);
    stream(RAM, 100);
    stream_on();
    set(RCC4 + 0x24, 1 << 12); /* reset */
    assert_told(RULE_DMA_FIRST);
    start_right(CHIP_F405);
    stream(RAM, 100);
    stream_on();
    set(RCC4 + 0x10, 1 << 22); /* the controller first */
    set(RCC4 + 0x24, 1 << 12);
    assert_nothing_told();
    assert_int_equal(get(STREAM3), 0);
    assert_int_equal(get(CR1), 0);
}

/* RM0090 10.3.2: a request stays until it is acknowledged. */
static void test_a_request_that_nobody_took_comes_at_the_wrong_time(void **state)
{
    (void)state;
    start_right(CHIP_F405);
    stream(RAM, 100);
    put(CR2, 2);
    send(0xAA);
    send(0xBB);
    set(STREAM3, 1);
    chip_run(&rig.chip, 1000);
    assert_told(RULE_SPI_EMPTY);
}

/* -- All of them -- */

static void test_each_rule_was_broken_on_each_chip_that_has_it(void **state)
{
    (void)state;
    for (unsigned kind = 0; kind < CHIP_KINDS; kind++)
        for (unsigned rule = 0; rule < RULES; rule++)
            if (!chip_rules[rule].source[kind] != !rig.ever[kind][rule])
                fail_msg("chip %u: '%s' was broken %u times", kind, chip_rules[rule].text, rig.ever[kind][rule]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_program_that_keeps_the_rules_is_not_told_on),
        cmocka_unit_test(test_clocks_become_what_their_dividers_say),
        cmocka_unit_test(test_a_stream_sends_in_the_time_of_its_bytes),
        cmocka_unit_test(test_what_is_painted_too_early_is_sent),
        cmocka_unit_test(test_a_fifo_reads_ahead),
        cmocka_unit_test(test_a_stream_that_is_asked_at_once_flags_an_underrun),
        cmocka_unit_test(test_a_stream_that_is_stopped_takes_its_time),
        cmocka_unit_test(test_a_crystal_or_pll_that_fails_is_never_ready),
        cmocka_unit_test(test_registers_are_used_as_they_are),
        cmocka_unit_test(test_a_peripheral_wants_its_clock),
        cmocka_unit_test(test_a_peripheral_wants_two_cycles),
        cmocka_unit_test(test_oscillators_and_pll),
        cmocka_unit_test(test_the_pll_is_configured_while_it_is_off),
        cmocka_unit_test(test_wait_states_come_first_and_are_read),
        cmocka_unit_test(test_buses_have_limits),
        cmocka_unit_test(test_what_is_in_use_is_not_stopped),
        cmocka_unit_test(test_the_switch_is_waited_for),
        cmocka_unit_test(test_the_spi_wants_its_pins),
        cmocka_unit_test(test_wires_move_when_the_bus_rests),
        cmocka_unit_test(test_the_end_is_waited_for),
        cmocka_unit_test(test_wires_are_driven),
        cmocka_unit_test(test_the_spi_has_a_most_rate),
        cmocka_unit_test(test_the_spi_is_configured_then_enabled),
        cmocka_unit_test(test_data_are_written_when_they_can_leave),
        cmocka_unit_test(test_the_spi_is_disabled_when_it_rests),
        cmocka_unit_test(test_busy_alone_tells_too_little),
        cmocka_unit_test(test_modes_of_the_spi_change_what_leaves),
        cmocka_unit_test(test_two_lines_receive_what_nobody_reads),
        cmocka_unit_test(test_a_stream_is_told_where_from_and_where_to),
        cmocka_unit_test(test_other_streams_do_not_serve_the_spi),
        cmocka_unit_test(test_a_stream_is_off_when_it_is_configured),
        cmocka_unit_test(test_a_stream_is_read_as_off),
        cmocka_unit_test(test_flags_are_cleared),
        cmocka_unit_test(test_a_stream_is_off_before_its_peripheral),
        cmocka_unit_test(test_a_request_that_nobody_took_comes_at_the_wrong_time),
        cmocka_unit_test(test_each_rule_was_broken_on_each_chip_that_has_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
