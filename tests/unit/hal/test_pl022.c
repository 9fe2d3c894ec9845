/* SPDX-License-Identifier: MIT
 *
 * The PL022's driver on registers in memory: rates are the fastest that do not exceed what was asked, modes get the
 * manual's bits, and a peripheral that stands still is told from one that moves. What arrives on the wire, and in which
 * order, boards' images show in emulators. */
#include "mcu/pl022.h"
#include "rigs/cmocka_ready.h"

#include <string.h>

enum { IDLE = PL022_SR_TFE | PL022_SR_TNF, CR0_8_BITS = 7, CR0_SPO = 1 << 6, CR0_SPH = 1 << 7 };

static struct pl022_registers registers;
static struct pl022 pl022;

static int init(uint32_t clock_hz, uint32_t spi_hz, uint8_t mode)
{
    const struct pl022_config config = {.clock_hz = clock_hz, .spi_hz = spi_hz, .mode = mode};

    memset(&registers, 0xff, sizeof registers);
    registers.sr = IDLE;
    return pl022_init(&pl022, &registers, &config);
}

static void registers_lie_where_the_manual_says(void **state)
{
    (void)state;
    assert_int_equal(offsetof(struct pl022_registers, sr), 0x0c);
    assert_int_equal(offsetof(struct pl022_registers, cpsr), 0x10);
    assert_int_equal(offsetof(struct pl022_registers, dmacr), 0x24);
}

/* Of all divisors the least that is slow enough. */
static uint32_t least_divisor(uint32_t clock_hz, uint32_t spi_hz)
{
    uint32_t least = 0;

    for (uint32_t prescaler = 2; prescaler <= 254; prescaler += 2)
        for (uint32_t rate = 1; rate <= 256; rate++) {
            const uint32_t divisor = prescaler * rate;
            if ((uint64_t)divisor * spi_hz >= clock_hz && (!least || divisor < least)) least = divisor;
        }
    return least;
}

static void the_rate_is_the_next_slower_one(void **state)
{
    (void)state;
    static const uint32_t CLOCK_HZ[] = {50000000, 125000000, 12000000, 6000001};
    static const uint32_t SPI_HZ[] = {62500000, 25000000, 24999999, 4000000, 1000000,
                                      96899,    30011,    3001,     1931,    200000000};

    for (size_t c = 0; c < sizeof CLOCK_HZ / sizeof CLOCK_HZ[0]; c++)
        for (size_t s = 0; s < sizeof SPI_HZ / sizeof SPI_HZ[0]; s++) {
            const uint32_t divisor = least_divisor(CLOCK_HZ[c], SPI_HZ[s]);
            assert_int_equal(init(CLOCK_HZ[c], SPI_HZ[s], 0), divisor ? 0 : MCU_ERR_CONFIG);
            if (!divisor) continue;
            assert_int_equal(registers.cpsr * ((registers.cr0 >> 8) + 1), divisor);
            assert_int_equal(registers.cpsr % 2, 0);
            assert_int_equal(pl022.spi_hz, CLOCK_HZ[c] / divisor);
        }
}

static void a_rate_that_no_divisor_reaches_is_refused(void **state)
{
    (void)state;
    assert_int_equal(init(50000000, 0, 0), MCU_ERR_CONFIG);
    assert_int_equal(init(50000000, 50000000 / 65024, 0), MCU_ERR_CONFIG);
    assert_int_equal(init(50000000, 50000000 / 65024 + 1, 0), 0);
}

static void modes_are_polarity_and_phase(void **state)
{
    (void)state;
    static const uint32_t BITS[] = {0, CR0_SPH, CR0_SPO, CR0_SPO | CR0_SPH};

    for (uint8_t mode = 0; mode < 4; mode++) {
        assert_int_equal(init(50000000, 25000000, mode), 0);
        assert_int_equal(registers.cr0, CR0_8_BITS | BITS[mode]);
        assert_int_equal(registers.cr1, PL022_CR1_SSE);
        assert_int_equal(registers.imsc, 0);
    }
}

static void every_length_ends_with_its_last_byte(void **state)
{
    (void)state;
    uint8_t data[40];
    for (uint8_t i = 0; i < sizeof data; i++)
        data[i] = (uint8_t)(0xa0 + i);
    assert_int_equal(init(50000000, 4000000, 0), 0);
    const struct bus bus = pl022_bus(&pl022);

    for (size_t n_b = 1; n_b <= sizeof data; n_b++) {
        assert_int_equal(bus_write(&bus, data, n_b), 0);
        assert_int_equal(registers.dr, data[n_b - 1]);
        assert_int_equal(bus_flush(&bus), 0);
    }
    registers.dr = 0x55;
    assert_int_equal(bus_write(&bus, data, 0), 0);
    assert_int_equal(registers.dr, 0x55);
}

static void a_fifo_that_stays_full_is_an_error(void **state)
{
    (void)state;
    static const uint8_t data[9];
    assert_int_equal(init(50000000, 4000000, 0), 0);
    const struct bus bus = pl022_bus(&pl022);

    registers.sr = PL022_SR_BSY;
    registers.dr = 0x55;
    assert_int_equal(bus_write(&bus, data, 1), MCU_ERR_TIMEOUT);
    assert_int_equal(bus_write(&bus, data, sizeof data), MCU_ERR_TIMEOUT);
    assert_int_equal(registers.dr, 0x55);
    registers.sr = PL022_SR_BSY | PL022_SR_TNF; /* a slot, but never eight */
    assert_int_equal(bus_write(&bus, data, sizeof data), MCU_ERR_TIMEOUT);
}

static void a_byte_that_never_leaves_is_an_error(void **state)
{
    (void)state;
    static const uint8_t data[3];
    assert_int_equal(init(50000000, 4000000, 0), 0);
    const struct bus bus = pl022_bus(&pl022);

    registers.sr = IDLE | PL022_SR_BSY;
    assert_int_equal(bus_write(&bus, data, sizeof data), 0);
    assert_int_equal(bus_flush(&bus), MCU_ERR_TIMEOUT);
    registers.sr = PL022_SR_TNF; /* idle with something to send: stopped */
    assert_int_equal(bus_flush(&bus), MCU_ERR_TIMEOUT);
}

/* Bytes received without end neither hold up a write nor a flush. */
static void what_is_received_holds_nothing_up(void **state)
{
    (void)state;
    static const uint8_t data[20];
    assert_int_equal(init(50000000, 4000000, 0), 0);
    const struct bus bus = pl022_bus(&pl022);

    registers.sr = IDLE | PL022_SR_RNE | PL022_SR_RFF;
    assert_int_equal(bus_write(&bus, data, sizeof data), 0);
    assert_int_equal(bus_flush(&bus), 0);
}

static void a_start_that_never_gets_idle_is_an_error(void **state)
{
    (void)state;
    const struct pl022_config config = {.clock_hz = 50000000, .spi_hz = 4000000};

    registers = (struct pl022_registers){.sr = PL022_SR_BSY};
    assert_int_equal(pl022_init(&pl022, &registers, &config), MCU_ERR_TIMEOUT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(registers_lie_where_the_manual_says),
        cmocka_unit_test(the_rate_is_the_next_slower_one),
        cmocka_unit_test(a_rate_that_no_divisor_reaches_is_refused),
        cmocka_unit_test(modes_are_polarity_and_phase),
        cmocka_unit_test(every_length_ends_with_its_last_byte),
        cmocka_unit_test(a_fifo_that_stays_full_is_an_error),
        cmocka_unit_test(a_byte_that_never_leaves_is_an_error),
        cmocka_unit_test(what_is_received_holds_nothing_up),
        cmocka_unit_test(a_start_that_never_gets_idle_is_an_error),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
