/* SPDX-License-Identifier: MIT
 *
 * Clocks of the STM32 with memory in the place of the registers, where everything that shall become ready is so from
 * the start, or never: which rate results, and what the registers hold then. */
#include "mcu/stm32_clock.h"
#include "mcu/stm32f1_rcc.h"
#include "mcu/stm32f4_rcc.h"
#include "rigs/cmocka_ready.h"

enum { HSI = 1 << 0, HSI_READY = 1 << 1, BY_PLL = 2 << 2, BY_PLL_ASKED = 2 };
#define HSE (UINT32_C(1) << 16)
#define HSE_READY (UINT32_C(1) << 17)
#define PLL (UINT32_C(1) << 24)
#define PLL_READY (UINT32_C(1) << 25)
#define ALL_READY (HSI_READY | HSE_READY | PLL_READY)

static void assert_f4_runs_by_hsi(struct stm32f4_rcc rcc)
{
    uint32_t flash_acr = 0;
    const struct stm32f4_clocks clocks = stm32f4_rcc_init(&rcc, &flash_acr, 12000000);

    assert_int_equal(clocks.cpu_hz, 16000000);
    assert_int_equal(clocks.apb1_hz, 16000000);
    assert_int_equal(clocks.apb2_hz, 16000000);
    assert_int_equal(rcc.cr & (HSI | HSE | PLL), HSI);
    assert_int_equal(rcc.cfgr & ~(uint32_t)BY_PLL, 0);
}

static void test_f4_stays_on_its_own_oscillator_where_something_is_not_ready(void **state)
{
    (void)state;
    assert_f4_runs_by_hsi((struct stm32f4_rcc){0});
    assert_f4_runs_by_hsi((struct stm32f4_rcc){.cr = PLL_READY, .cfgr = BY_PLL});
    assert_f4_runs_by_hsi((struct stm32f4_rcc){.cr = HSE_READY, .cfgr = BY_PLL});
    assert_f4_runs_by_hsi((struct stm32f4_rcc){.cr = HSE_READY | PLL_READY, .cfgr = 0});
}

static void test_f4_is_left_at_rest_by_whatever_ran_before(void **state)
{
    (void)state;
    assert_f4_runs_by_hsi((struct stm32f4_rcc){.cr = HSI | HSE | PLL, .cfgr = BY_PLL_ASKED | 0xFCF0});
}

static void assert_f4_runs_by(uint32_t hse_hz, uint32_t pllcfgr)
{
    struct stm32f4_rcc rcc = {.cr = ALL_READY, .cfgr = BY_PLL};
    uint32_t flash_acr = 0;
    const struct stm32f4_clocks clocks = stm32f4_rcc_init(&rcc, &flash_acr, hse_hz);

    assert_int_equal(clocks.cpu_hz, 168000000);
    assert_int_equal(clocks.apb1_hz, 42000000);
    assert_int_equal(clocks.apb2_hz, 84000000);
    assert_int_equal(rcc.cr, ALL_READY | HSI | HSE | PLL);
    assert_int_equal(rcc.pllcfgr, pllcfgr);
    assert_int_equal(rcc.cfgr, 0x9400 | BY_PLL | BY_PLL_ASKED); /* APB2 by 2, APB1 by 4 */
    assert_int_equal(flash_acr, 0x705);                         /* caches, prefetch, five wait states */
}

/* RM0090 7.3.2: bits 31 to 28 hold 2 after a reset, and keep it. */
static void test_f4_keeps_reserved_bits(void **state)
{
    struct stm32f4_rcc rcc = {.cr = ALL_READY, .cfgr = BY_PLL, .pllcfgr = 0x24003010};
    uint32_t flash_acr = 0;

    (void)state;
    assert_int_equal(stm32f4_rcc_init(&rcc, &flash_acr, 12000000).cpu_hz, 168000000);
    assert_int_equal(rcc.pllcfgr, 0x2740540C);
}

/* RM0090 7.3.2: PLLQ 7, PLLSRC HSE, PLLP 2, PLLN 336, PLLM. */
static void test_f4_runs_at_168_mhz_by_its_crystal(void **state)
{
    (void)state;
    assert_f4_runs_by(12000000, 0x0740540C);
    assert_f4_runs_by(8000000, 0x07405408);
}

static void test_f4_gives_a_clock_to_peripherals_beside_those_that_have_one(void **state)
{
    (void)state;
    struct stm32f4_rcc rcc = {.ahb1enr = 1 << 20, .apb2enr = 1 << 4};

    stm32f4_rcc_enable(&rcc, STM32F4_GPIOA_ON | STM32F4_DMA2_ON, STM32F4_SPI1_ON);
    assert_int_equal(rcc.ahb1enr, 0x500001);
    assert_int_equal(rcc.apb2enr, 0x1010);
}

static void assert_f1_runs_by_hsi(struct stm32f1_rcc rcc)
{
    uint32_t flash_acr = 0;

    assert_int_equal(stm32f1_rcc_init(&rcc, &flash_acr, 72000000), 8000000);
    assert_int_equal(rcc.cr & (HSI | HSE | PLL), HSI);
    assert_int_equal(rcc.cfgr & ~(uint32_t)BY_PLL, 0);
}

static void test_f1_stays_on_its_own_oscillator_where_something_is_not_ready(void **state)
{
    (void)state;
    assert_f1_runs_by_hsi((struct stm32f1_rcc){0});
    assert_f1_runs_by_hsi((struct stm32f1_rcc){.cr = PLL_READY, .cfgr = BY_PLL});
    assert_f1_runs_by_hsi((struct stm32f1_rcc){.cr = HSE_READY, .cfgr = BY_PLL});
    assert_f1_runs_by_hsi((struct stm32f1_rcc){.cr = HSE_READY | PLL_READY, .cfgr = 0});
    assert_f1_runs_by_hsi((struct stm32f1_rcc){.cr = HSI | HSE | PLL, .cfgr = BY_PLL_ASKED | 0x3F3FF0});
}

static void assert_f1_runs_at(uint32_t cpu_hz, uint32_t cfgr, uint32_t latency)
{
    struct stm32f1_rcc rcc = {.cr = ALL_READY, .cfgr = BY_PLL};
    uint32_t flash_acr = 0;

    assert_int_equal(stm32f1_rcc_init(&rcc, &flash_acr, cpu_hz), cpu_hz);
    assert_int_equal(rcc.cr, ALL_READY | HSI | HSE | PLL);
    assert_int_equal(rcc.cfgr, cfgr | BY_PLL | BY_PLL_ASKED);
    assert_int_equal(flash_acr, 0x10 | latency);
}

/* RM0008 7.3.2: PLLMUL, PLLSRC HSE, and APB1 at 36 MHz or less. */
static void test_f1_runs_by_a_multiple_of_its_crystal(void **state)
{
    (void)state;
    assert_f1_runs_at(72000000, 0x1D0400, 2);
    assert_f1_runs_at(48000000, 0x110400, 1);
    assert_f1_runs_at(24000000, 0x050000, 0);
    assert_f1_runs_at(16000000, 0x010000, 0);
}

static void test_f1_gives_a_clock_to_peripherals_beside_those_that_have_one(void **state)
{
    (void)state;
    struct stm32f1_rcc rcc = {.apb2enr = 1};

    stm32f1_rcc_enable(&rcc, STM32F1_GPIOC_ON | STM32F1_SPI1_ON);
    assert_int_equal(rcc.apb2enr, 0x1011);
}

static void test_peripherals_that_were_reset_are_at_work_again(void **state)
{
    struct stm32f4_rcc four = {.ahb1rstr = 1 << 22, .apb2rstr = 1};
    struct stm32f1_rcc one = {.apb2rstr = 1};

    (void)state;
    stm32f4_rcc_reset(&four, STM32F4_DMA2_ON, STM32F4_SPI1_ON);
    assert_int_equal(four.ahb1rstr, 0);
    assert_int_equal(four.apb2rstr, 1);
    stm32f1_rcc_reset(&one, STM32F1_SPI1_ON);
    assert_int_equal(one.apb2rstr, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_f4_stays_on_its_own_oscillator_where_something_is_not_ready),
        cmocka_unit_test(test_f4_is_left_at_rest_by_whatever_ran_before),
        cmocka_unit_test(test_f4_keeps_reserved_bits),
        cmocka_unit_test(test_f4_runs_at_168_mhz_by_its_crystal),
        cmocka_unit_test(test_peripherals_that_were_reset_are_at_work_again),
        cmocka_unit_test(test_f4_gives_a_clock_to_peripherals_beside_those_that_have_one),
        cmocka_unit_test(test_f1_stays_on_its_own_oscillator_where_something_is_not_ready),
        cmocka_unit_test(test_f1_runs_by_a_multiple_of_its_crystal),
        cmocka_unit_test(test_f1_gives_a_clock_to_peripherals_beside_those_that_have_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
