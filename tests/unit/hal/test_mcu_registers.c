/* SPDX-License-Identifier: MIT
 *
 * The bits that drivers and their tests share by name, against the numbers of the makers' manuals. */
#include "mcu/avr_spi.h"
#include "mcu/pl022.h"
#include "mcu/rp2040_dma.h"
#include "mcu/sio_gpio.h"
#include "mcu/stm32_clock.h"
#include "mcu/stm32f1_rcc.h"
#include "mcu/stm32f4_rcc.h"
#include "rigs/cmocka_ready.h"

/* ATmega32U4, 17.2: SPCR has SPIE SPE DORD MSTR CPOL CPHA SPR1 SPR0, SPSR has SPIF first and SPI2X last. */
static void avr_spi_is_as_the_manual_has_it(void **state)
{
    (void)state;
    assert_int_equal(AVR_SPCR_SPE, 0x40);
    assert_int_equal(AVR_SPCR_MSTR, 0x10);
    assert_int_equal(AVR_SPSR_SPIF, 0x80);
    assert_int_equal(AVR_SPSR_SPI2X, 0x01);
}

/* PrimeCell SSP (PL022), 3.3: SSPSR, SSPCR1, SSPDMACR; FIFOs of eight words. */
static void pl022_is_as_the_manual_has_it(void **state)
{
    (void)state;
    assert_int_equal(PL022_SR_TFE, 0x01);
    assert_int_equal(PL022_SR_TNF, 0x02);
    assert_int_equal(PL022_SR_RNE, 0x04);
    assert_int_equal(PL022_SR_RFF, 0x08);
    assert_int_equal(PL022_SR_BSY, 0x10);
    assert_int_equal(PL022_CR1_SSE, 0x02);
    assert_int_equal(PL022_DMACR_TXDMAE, 0x02);
    assert_int_equal(PL022_FIFO_B, 8);
}

/* RP2040: 2.5.3.1 requests of DMA, 2.19.2 functions, 2.19.6.3 pads: SLEWFAST, SCHMITT, PDE, PUE, DRIVE, IE, OD from
 * bit 0 on; drive 1 is 4 mA. */
static void rp2040_is_as_the_manual_has_it(void **state)
{
    const int schmitt = 2, pull_up = 8, ma_4 = 16, input = 64;

    (void)state;
    assert_int_equal(RP2040_DREQ_SPI0_TX, 16);
    assert_int_equal(RP2040_DMA_MIN_B, 16);
    assert_int_equal(SIO_GPIO_PINS, 30);
    assert_int_equal(SIO_GPIO_SPI, 1);
    assert_int_equal(SIO_GPIO_SIO, 5);
    assert_int_equal(SIO_GPIO_SLOW, input + ma_4 + schmitt);
    assert_int_equal(SIO_GPIO_FAST, input + ma_4 + schmitt + 1);
    assert_int_equal(SIO_GPIO_BUTTON, input + pull_up + schmitt);
}

/* RM0008, 7.3.1, 7.3.2 and 7.3.7; RM0090, 7.3.1, 7.3.3, 7.3.10 and 7.3.14. */
static void stm32_clocks_are_as_the_manuals_have_them(void **state)
{
    (void)state;
    assert_int_equal(STM32_HSI_ON, 0x1);
    assert_int_equal(STM32_HSE_ON, 0x10000);
    assert_int_equal(STM32_PLL_ON, 0x1000000);
    assert_int_equal(STM32_BY_HSI, 0);
    assert_int_equal(STM32_BY_PLL, 2);
    assert_int_equal(STM32F1_GPIOA_ON, 0x4);
    assert_int_equal(STM32F1_GPIOB_ON, 0x8);
    assert_int_equal(STM32F1_GPIOC_ON, 0x10);
    assert_int_equal(STM32F1_SPI1_ON, 0x1000);
    assert_int_equal(STM32F4_GPIOA_ON, 0x1);
    assert_int_equal(STM32F4_GPIOC_ON, 0x4);
    assert_int_equal(STM32F4_DMA2_ON, 0x400000);
    assert_int_equal(STM32F4_SPI1_ON, 0x1000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(avr_spi_is_as_the_manual_has_it),
        cmocka_unit_test(pl022_is_as_the_manual_has_it),
        cmocka_unit_test(rp2040_is_as_the_manual_has_it),
        cmocka_unit_test(stm32_clocks_are_as_the_manuals_have_them),
    };
    return cmocka_run_group_tests_name("mcu_registers", tests, NULL, NULL);
}
