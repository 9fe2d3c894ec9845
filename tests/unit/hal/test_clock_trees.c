/* SPDX-License-Identifier: MIT
 *
 * Clocks of microcontrollers that live: what is switched on becomes ready after a while, what is selected runs the
 * processor, and at every access it is looked whether it may run so, by the limits of the makers' manuals. From
 * whatever a boot loader may have left. */
#include "mcu/lm3s_clocks.h"
#include "mcu/mcu.h"
#include "mcu/stm32f1_rcc.h"
#include "mcu/stm32f4_rcc.h"
#include "rigs/cmocka_ready.h"
#include "rigs/panels/watched_registers.h"

#include <string.h>

static uint8_t *page;
static unsigned moves, looks; /* what was asked for is there after so many looks; those so far */
static unsigned complaints;
static const char *complaint; /* the first */

static uint32_t *word(size_t at_b)
{
    return (uint32_t *)(void *)(page + at_b);
}

static void check(bool is_right, const char *text)
{
    if (is_right) return;
    if (!complaints++) complaint = text;
}

/* As memory is: all zeros. */
static void prepare(unsigned new_moves)
{
    if (!watched_is_possible()) skip();
    page = watched_begin();
    moves = new_moves, looks = complaints = 0;
}

static void start(void (*before_read)(size_t at_b), void (*after_write)(size_t at_b))
{
    watched.before_read = before_read;
    watched.after_write = after_write;
    watched_start();
}

static void assert_quiet(void)
{
    if (complaints) fail_msg("%u complaints, the first: %s", complaints, complaint);
}

/* -- STM32: RM0008 and RM0090, 7.3 --------------------------------------------------------------- */

enum { ACR_B = 0x400, PLLCFGR_B = 4 };
enum { BY_HSI, BY_HSE, BY_PLL };

/* In RCC_CR; the bit above says that it is ready. */
static const uint32_t oscillators[] = {
    [BY_HSI] = UINT32_C(1) << 0, [BY_HSE] = UINT32_C(1) << 16, [BY_PLL] = UINT32_C(1) << 24};
#define ON_ALL (oscillators[BY_HSI] | oscillators[BY_HSE] | oscillators[BY_PLL])
#define READY_ALL (ON_ALL << 1)

static const struct stm32 {
    size_t cfgr_b;
    uint32_t hsi_hz, wait_state_hz, most_hz, apb1_most_hz, apb2_most_hz;
    unsigned ppre1_bit, ppre2_bit;
} f1 = {4, 8000000, 24000000, 72000000, 36000000, 72000000, 8, 11},
  f4 = {8, 16000000, 30000000, 168000000, 42000000, 84000000, 10, 13};

static const struct stm32 *stm32;
static uint32_t hse_hz;
static bool has_wait_states;
static uint32_t seen_cr, seen_cfgr, seen_pllcfgr; /* what the chip shows */

static uint32_t cr_before;

static unsigned source(void)
{
    return seen_cfgr >> 2 & 3;
}

static uint32_t f1_pll_hz(void)
{
    const uint32_t from_hz = seen_cfgr >> 16 & 1 ? hse_hz >> (seen_cfgr >> 17 & 1) : f1.hsi_hz / 2;
    const uint32_t multiplier = (seen_cfgr >> 18 & 15) + 2;

    return from_hz * (multiplier < 16 ? multiplier : 16);
}

static uint32_t f4_pll_hz(void)
{
    const uint32_t from_hz = seen_pllcfgr >> 22 & 1 ? hse_hz : f4.hsi_hz;
    const uint32_t m = seen_pllcfgr & 63, n = seen_pllcfgr >> 6 & 511, p = 2 * ((seen_pllcfgr >> 16 & 3) + 1);

    check(m >= 2 && n >= 50 && n <= 432, "PLLM and PLLN are beyond their ranges");
    if (m < 2) return 0;
    const uint32_t in_hz = from_hz / m, vco_hz = in_hz * n;
    check(in_hz >= 950000 && in_hz <= 2100000, "the PLL's input is not 1 to 2 MHz");
    check(vco_hz >= 100000000 && vco_hz <= 432000000, "the PLL's oscillator is not at 100 to 432 MHz");
    check(vco_hz / (seen_pllcfgr >> 24 & 15) == 48000000, "USB would not have its 48 MHz");
    return vco_hz / p;
}

static uint32_t cpu_hz(void)
{
    const uint32_t hz[] = {stm32->hsi_hz, hse_hz, 0, 0};

    if (source() == BY_PLL) return stm32 == &f1 ? f1_pll_hz() : f4_pll_hz();
    return hz[source()] >> (seen_cfgr >> 7 & 1 ? (seen_cfgr >> 4 & 7) + 1 : 0); /* HPRE, below its gap */
}

static uint32_t apb_hz(unsigned bit)
{
    const uint32_t ppre = seen_cfgr >> bit & 7;

    return cpu_hz() >> (ppre & 4 ? (ppre & 3) + 1 : 0);
}

static void check_stm32(void)
{
    const uint32_t hz = cpu_hz(), ready = oscillators[source()] << 1;

    check(source() <= BY_PLL && seen_cr & ready, "the processor runs by what is not ready");
    check(hz <= stm32->most_hz, "the processor is too fast");
    check(apb_hz(stm32->ppre1_bit) <= stm32->apb1_most_hz, "APB1 is too fast");
    check(apb_hz(stm32->ppre2_bit) <= stm32->apb2_most_hz, "APB2 is too fast");
    check((*word(ACR_B) & 7) >= (hz - 1) / stm32->wait_state_hz, "flash has too few wait states");
}

static void show_stm32(void)
{
    *word(0) = seen_cr;
    *word(stm32->cfgr_b) = seen_cfgr;
    if (stm32 == &f4) *word(PLLCFGR_B) = seen_pllcfgr;
}

/* What is on becomes ready, and what is off ceases to be; the PLL needs its source. */
static void stm32_goes_on(size_t at_b)
{
    (void)at_b;
    if (++looks % moves) return;
    seen_cr = (seen_cr & ~READY_ALL) | (seen_cr & ON_ALL) << 1;
    if (!(seen_cr & oscillators[BY_HSE])) seen_cr &= ~(oscillators[BY_PLL] << 1);
    const uint32_t wanted = seen_cfgr & 3;
    if (wanted <= BY_PLL && seen_cr & oscillators[wanted] << 1) seen_cfgr = (seen_cfgr & ~UINT32_C(12)) | wanted << 2;
    check_stm32();
    show_stm32();
}

static void cr_is_written(uint32_t value)
{
    const uint32_t begun = value & ~cr_before & ON_ALL;

    check(!(begun << 1 & seen_cr), "what is started is called ready from the last time");
    check(value & oscillators[source()], "what the processor runs by is stopped");
    seen_cr = (value & ~READY_ALL) | (seen_cr & READY_ALL);
    cr_before = value;
}

static void cfgr_is_written(uint32_t value)
{
    const uint32_t changed = value ^ seen_cfgr, pll = oscillators[BY_PLL];

    check(stm32 != &f1 || !(changed & 0x3F0000) || !(seen_cr & (pll | pll << 1)), "a PLL that is on is changed");
    seen_cfgr = (value & ~UINT32_C(12)) | (seen_cfgr & 12);
}

static void stm32_is_written(size_t at_b)
{
    const uint32_t value = *word(at_b), pll = oscillators[BY_PLL];

    if (at_b == 0) cr_is_written(value);
    if (at_b == stm32->cfgr_b) cfgr_is_written(value);
    if (stm32 == &f4 && at_b == PLLCFGR_B) {
        check(!(seen_cr & (pll | pll << 1)), "a PLL that is on is changed");
        seen_pllcfgr = value;
    }
    if (at_b == ACR_B && !has_wait_states) *word(ACR_B) = 0;
    check_stm32();
    show_stm32();
}

struct left {
    uint32_t cr, pllcfgr, cfgr, acr;
};

static void start_stm32(const struct stm32 *kind, const struct left *left, uint32_t crystal_hz, unsigned new_moves)
{
    prepare(new_moves);
    stm32 = kind;
    hse_hz = crystal_hz;
    has_wait_states = true;
    seen_cr = left->cr | (left->cr & ON_ALL) << 1;
    cr_before = seen_cr;
    seen_cfgr = left->cfgr | (left->cfgr & 3) << 2;
    seen_pllcfgr = left->pllcfgr;
    *word(ACR_B) = left->acr;
    show_stm32();
    check_stm32();
    start(stm32_goes_on, stm32_is_written);
}

/* After a reset; by the PLL with all else off that can be; by the crystal with the PLL on; by the internal oscillator
 * with slow buses and everything on. */
static const struct left f1_left[] = {{0x83, 0, 0, 0x30},
                                      {0x01010080, 0, 0x1D0402, 0x12},
                                      {0x01010080, 0, 0x010001, 0x10},
                                      {0x01010081, 0, 0x193FF0, 0x30}};

static void the_stm32f1_runs_by_its_pll_from_wherever_it_was(void **state)
{
    struct stm32f1_rcc *rcc;

    (void)state;
    for (size_t i = 0; i < sizeof f1_left / sizeof *f1_left; i++)
        for (uint32_t wanted_hz = 16000000; wanted_hz <= 72000000; wanted_hz += 8000000)
            for (unsigned late = 1; late < 8; late += 3) {
                start_stm32(&f1, &f1_left[i], 8000000, late);
                rcc = (struct stm32f1_rcc *)(void *)page;
                const uint32_t hz = stm32f1_rcc_init(rcc, word(ACR_B), wanted_hz);
                watched_stop();
                assert_quiet();
                assert_int_equal(hz, wanted_hz);
                assert_int_equal(source(), BY_PLL);
                assert_int_equal(cpu_hz(), wanted_hz);
                assert_int_equal(apb_hz(f1.ppre2_bit), wanted_hz);
                assert_int_equal(apb_hz(f1.ppre1_bit), wanted_hz > 36000000 ? wanted_hz / 2 : wanted_hz);
            }
}

/* PM0075 has wait states from 24 MHz on; an F100 goes up to these, and has none. */
static void an_stm32f100_without_wait_states_stays_slow(void **state)
{
    (void)state;
    for (uint32_t wanted_hz = 16000000; wanted_hz <= 48000000; wanted_hz += 8000000) {
        const bool fits = wanted_hz <= 24000000;
        start_stm32(&f1, &f1_left[0], 8000000, 2);
        has_wait_states = false;
        const uint32_t hz = stm32f1_rcc_init((struct stm32f1_rcc *)(void *)page, word(ACR_B), wanted_hz);
        watched_stop();
        assert_quiet();
        assert_int_equal(hz, fits ? wanted_hz : 8000000);
        assert_int_equal(cpu_hz(), hz);
        assert_int_equal(source(), fits ? BY_PLL : BY_HSI);
        if (!fits) assert_int_equal(seen_cr & (oscillators[BY_HSE] | oscillators[BY_PLL]), 0);
    }
}

static const struct left f4_left[] = {{0x83, 0x24003010, 0, 0},
                                      {0x01010080, 0x07405408, 0x9402, 0x705},
                                      {0x01010080, 0x07405408, 0x0001, 0x705},
                                      {0x01010081, 0x07405408, 0xFCF0, 0}};

static void the_stm32f4_runs_by_its_pll_from_wherever_it_was(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof f4_left / sizeof *f4_left; i++)
        for (uint32_t mhz = i ? 8 : 4; mhz <= (i ? 8 : 26); mhz++)
            for (unsigned late = 1; late < 8; late += 3) {
                start_stm32(&f4, &f4_left[i], mhz * 1000000, late);
                struct stm32f4_rcc *rcc = (struct stm32f4_rcc *)(void *)page;
                const struct stm32f4_clocks clocks = stm32f4_rcc_init(rcc, word(ACR_B), hse_hz);
                watched_stop();
                assert_quiet();
                assert_int_equal(source(), BY_PLL);
                assert_int_equal(cpu_hz(), 168000000);
                assert_int_equal(clocks.cpu_hz, 168000000);
                assert_int_equal(clocks.apb1_hz, apb_hz(f4.ppre1_bit));
                assert_int_equal(clocks.apb2_hz, apb_hz(f4.ppre2_bit));
                assert_int_equal(*word(ACR_B) & 0x700, 0x700); /* caches and prefetch */
            }
}

/* RM0090, 3.5.1: who raises the clock reads the wait states back first. */
static void an_stm32f4_whose_flash_takes_no_wait_states_stays_slow(void **state)
{
    (void)state;
    start_stm32(&f4, &f4_left[0], 8000000, 2);
    has_wait_states = false;
    const struct stm32f4_clocks clocks = stm32f4_rcc_init((struct stm32f4_rcc *)(void *)page, word(ACR_B), hse_hz);
    watched_stop();
    assert_quiet();
    assert_int_equal(clocks.cpu_hz, 16000000);
    assert_int_equal(clocks.apb1_hz, 16000000);
    assert_int_equal(clocks.apb2_hz, 16000000);
    assert_int_equal(cpu_hz(), 16000000);
    assert_int_equal(seen_cr & (oscillators[BY_HSE] | oscillators[BY_PLL]), 0);
}

static uint32_t reads_since; /* of a register, since it was written */

static void one_is_read(size_t at_b)
{
    reads_since |= UINT32_C(1) << at_b / 4 % 32;
}

static void one_is_written(size_t at_b)
{
    reads_since &= ~(UINT32_C(1) << at_b / 4 % 32);
}

/* ES0182: a peripheral may be touched two cycles after its clock was switched on, which reading it back takes. */
static void clocks_of_peripherals_are_read_back(void **state)
{
    (void)state;
    prepare(1);
    reads_since = 0;
    start(one_is_read, one_is_written);
    stm32f4_rcc_enable((struct stm32f4_rcc *)(void *)page, 1, 2);
    watched_stop();
    assert_true(reads_since >> offsetof(struct stm32f4_rcc, ahb1enr) / 4 & 1);
    assert_true(reads_since >> offsetof(struct stm32f4_rcc, apb2enr) / 4 & 1);
    prepare(1);
    reads_since = 0;
    start(one_is_read, one_is_written);
    stm32f1_rcc_enable((struct stm32f1_rcc *)(void *)page, 2);
    watched_stop();
    assert_true(reads_since >> offsetof(struct stm32f1_rcc, apb2enr) / 4 & 1);
}

/* -- LM3S: data sheet of the LM3S6965, 5.3 and 5.5 ------------------------------------------------ */

enum { DID0_B = 0, LDOPCTL_B = 0x34, RIS_B = 0x50, MISC_B = 0x58, RCC_B = 0x60, RCC2_B = 0x70 };
enum { RCC_BYPASS = 1 << 11, RCC_PWRDN = 1 << 13, RCC_USESYSDIV = 1 << 22, RCC_SOURCE = 0x3F0, LOCKED = 1 << 6 };

/* Of DID0: format 1, class 1 (Fury), revision. Of LDOPCTL: StellarisWare's inc/hw_sysctl.h has it. */
static const uint32_t LM3S6965_A2 = 0x10010002;
enum { V_2_50 = 0, V_2_75 = 0x1B };

static uint32_t lm3s_did0 = 0x10010002;
static unsigned locked_after;      /* looks; 0: it does not */
static bool is_locked, is_noticed; /* the PLL; in RIS */
static uint32_t rcc_before;

static void check_lm3s(void)
{
    const uint32_t rcc = *word(RCC_B);

    if (rcc & RCC_BYPASS || *word(RCC2_B) >> 31) return;
    check(is_locked, "the processor runs by a PLL that has not locked");
    check(rcc & RCC_USESYSDIV && (rcc >> 23 & 15) >= 3, "the processor is faster than 50 MHz");
    check((rcc >> 6 & 15) == 0xE, "the PLL takes the crystal for another one than 8 MHz");
}

static void lm3s_goes_on(size_t at_b)
{
    if (at_b == RIS_B && !(*word(RCC_B) & RCC_PWRDN) && ++looks == locked_after) is_locked = is_noticed = true;
    *word(RIS_B) = is_noticed ? LOCKED : 0;
    check_lm3s();
}

/* Switched off, or from another source, it locks anew. */
static void lm3s_is_written(size_t at_b)
{
    const uint32_t rcc = *word(RCC_B);

    if (at_b == MISC_B && *word(MISC_B) & LOCKED) is_noticed = false;
    if (at_b == RCC_B && !(rcc & RCC_BYPASS) && *word(DID0_B) == LM3S6965_A2)
        check(*word(LDOPCTL_B) == V_2_75, "the PLL of revision A2 is taken at 2.5 V");
    if (at_b == RCC_B && (rcc & RCC_PWRDN || (rcc ^ rcc_before) & RCC_SOURCE)) is_locked = false, looks = 0;
    rcc_before = rcc;
    check_lm3s();
}

static int start_lm3s(uint32_t rcc, uint32_t rcc2, unsigned after)
{
    prepare(1);
    *word(DID0_B) = lm3s_did0;
    *word(RCC_B) = rcc_before = rcc;
    *word(RCC2_B) = rcc2;
    locked_after = after;
    is_locked = !(rcc & RCC_PWRDN);
    is_noticed = true; /* from the last time */
    start(lm3s_goes_on, lm3s_is_written);
    const int err = lm3s_clocks_init((volatile struct lm3s_system_registers *)(void *)page);
    watched_stop();
    assert_quiet();
    return err;
}

/* After a reset, which leaves the internal oscillator; by the PLL at 50 MHz; by the registers that Fury has besides. */
static void the_lm3s_runs_by_its_pll_from_wherever_it_was(void **state)
{
    static const uint32_t rccs[] = {0x078E3AD1, 0x01C00380, 0x01C00B80, 0x078E3AF0};

    (void)state;
    for (size_t i = 0; i < 4; i++)
        for (uint32_t rcc2 = 0; rcc2 < 2; rcc2++)
            for (unsigned after = 1; after < 9; after++) {
                assert_int_equal(start_lm3s(rccs[i], rcc2 ? 0xC1802800 : 0x07802810, after), 0);
                const uint32_t rcc = *word(RCC_B);
                assert_true(is_locked && looks == after);
                assert_int_equal(*word(RCC2_B) >> 31, 0); /* USERCC2 */
                assert_int_equal(rcc & (RCC_BYPASS | RCC_PWRDN | RCC_USESYSDIV), RCC_USESYSDIV);
                assert_int_equal(200000000 / ((rcc >> 23 & 15) + 1), LM3S_SYSTEM_HZ);
                assert_int_equal(rcc & 0x31, 0); /* MOSCDIS, and OSCSRC is the main oscillator */
            }
}

/* A crystal starts in 10 ms at most, the PLL's counter has 1200h of its periods, and the internal oscillator has up to
 * a third more than 12 MHz. A look takes four cycles. */
static void the_lm3s_s_pll_is_given_its_time(void **state)
{
    const uint32_t us = 10000 + 0x1200 / 8;

    (void)state;
    assert_int_equal(start_lm3s(0x078E3AD1, 0x07802810, 0), MCU_ERR_TIMEOUT);
    assert_int_equal(watched.reads[RIS_B], us * (12 + 12 / 3) / 4);
    assert_true(*word(RCC_B) & RCC_BYPASS);
}

/* The erratum is revision A2's; others run at the 2.5 V that they are specified for. */
static void the_lm3s_has_a_higher_core_voltage_on_revision_a2_alone(void **state)
{
    static const struct {
        uint32_t did0, ldopctl;
    } parts[] = {
        {0x10010002, V_2_75}, {0x10010000, V_2_50}, {0x10010100, V_2_50}, {0x10010102, V_2_50},
        {0x10010202, V_2_50}, {0x00000002, V_2_50}, {0x10000002, V_2_50}, {0x10030002, V_2_50},
    };

    (void)state;
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        lm3s_did0 = parts[i].did0;
        assert_int_equal(start_lm3s(0x078E3AD1, 0x07802810, 3), 0);
        assert_int_equal(*word(LDOPCTL_B), parts[i].ldopctl);
        assert_int_equal(watched.writes[LDOPCTL_B], parts[i].ldopctl != V_2_50);
        assert_int_equal(*word(DID0_B), parts[i].did0);
    }
    lm3s_did0 = LM3S6965_A2;
}

static unsigned steps;

static void lm3s_peripheral_is_read(size_t at_b)
{
    const size_t reset_b = offsetof(struct lm3s_system_registers, srcr[1]);

    if (at_b == reset_b && (steps == 2 || steps == 4)) steps++;
}

static void lm3s_peripheral_is_written(size_t at_b)
{
    const size_t reset_b = offsetof(struct lm3s_system_registers, srcr[1]);
    const bool is_held = *word(reset_b) == 0x35;

    if (steps == 0 && at_b == offsetof(struct lm3s_system_registers, rcgc[1])) steps++;
    if (steps == 1 && at_b == reset_b && is_held) steps++;
    if (steps == 3 && at_b == reset_b && !is_held) steps++;
}

/* Clocked, held in reset, and let go, with a read behind each: the cycles that it takes. */
static void an_lm3s_s_peripheral_is_clocked_and_then_reset(void **state)
{
    (void)state;
    prepare(1);
    *word(offsetof(struct lm3s_system_registers, rcgc[1])) = 0x102;
    *word(offsetof(struct lm3s_system_registers, srcr[1])) = 0x21;
    steps = 0;
    start(lm3s_peripheral_is_read, lm3s_peripheral_is_written);
    lm3s_peripherals_start((volatile struct lm3s_system_registers *)(void *)page, 1, 0x14);
    watched_stop();
    assert_int_equal(steps, 5);
    assert_int_equal(*word(offsetof(struct lm3s_system_registers, rcgc[1])), 0x116);
    assert_int_equal(*word(offsetof(struct lm3s_system_registers, srcr[1])), 0x21);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_stm32f1_runs_by_its_pll_from_wherever_it_was),
        cmocka_unit_test(an_stm32f100_without_wait_states_stays_slow),
        cmocka_unit_test(the_stm32f4_runs_by_its_pll_from_wherever_it_was),
        cmocka_unit_test(an_stm32f4_whose_flash_takes_no_wait_states_stays_slow),
        cmocka_unit_test(clocks_of_peripherals_are_read_back),
        cmocka_unit_test(the_lm3s_runs_by_its_pll_from_wherever_it_was),
        cmocka_unit_test(the_lm3s_s_pll_is_given_its_time),
        cmocka_unit_test(the_lm3s_has_a_higher_core_voltage_on_revision_a2_alone),
        cmocka_unit_test(an_lm3s_s_peripheral_is_clocked_and_then_reset),
    };
    return cmocka_run_group_tests_name("clock_trees", tests, NULL, NULL);
}
