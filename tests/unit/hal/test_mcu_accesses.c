/* SPDX-License-Identifier: MIT
 *
 * Drivers of microcontrollers with registers that notice each access and move as peripherals do: what is read from a
 * FIFO is gone, counters count, bits come after a while. What memory in their place cannot tell: which reads there are,
 * in which order registers are written, and when a wait ends. */
#include "mcu/avr_spi.h"
#include "mcu/avr_timer.h"
#include "mcu/fe310_prci.h"
#include "mcu/fe310_spi.h"
#include "mcu/mtime.h"
#include "mcu/pl022.h"
#include "mcu/rp2040_clocks.h"
#include "mcu/rp2040_dma.h"
#include "mcu/stm32_dma.h"
#include "mcu/stm32_spi.h"
#include "mcu/systick.h"
#include "mcu/wait.h"
#include "rigs/cmocka_ready.h"
#include "rigs/panels/watched_registers.h"

#include <string.h>

#define AT(type, member) offsetof(struct type, member)

static void *page;
static unsigned moves; /* looks that it takes until something moves; what that is, each test says */

static int set_up(void **state)
{
    (void)state;
    page = watched_begin();
    return 0;
}

static void start(void (*before_read)(size_t at_b), void (*after_write)(size_t at_b))
{
    if (!watched_is_possible()) skip();
    watched.before_read = before_read;
    watched.after_write = after_write;
    watched_start();
}

/* -- Waits ------------------------------------------------------------------------------------- */

static void bit_5_comes_at_last(size_t at_b)
{
    if (at_b == 8 && watched.reads[8] == moves) *((uint32_t *)page + 2) |= 32;
}

static void a_wait_takes_as_many_looks_as_it_has(void **state)
{
    (void)state;
    const volatile uint32_t *reg = (const uint32_t *)page + 2;

    for (moves = 1; moves < 9; moves++) {
        watched_begin();
        start(bit_5_comes_at_last, NULL);
        const int err = mcu_wait(reg, 0x30, 0x20, 7);
        watched_stop();
        assert_int_equal(err, moves <= 7 ? 0 : MCU_ERR_TIMEOUT);
        assert_int_equal(watched.reads[8], moves <= 7 ? moves : 7);
    }
    assert_int_equal(mcu_wait(reg, 0x20, 0x20, 0), MCU_ERR_TIMEOUT);
}

/* -- The FE310's SPI --------------------------------------------------------------------------- */

enum { FE310_ROOM_B = 8 };

static unsigned received, lost; /* bytes in the receiver, and those that found no room */

static void fe310_takes(size_t at_b)
{
    struct fe310_spi_registers *spi = page;

    if (at_b != AT(fe310_spi_registers, rxdata)) return;
    const bool is_there = received && (moves < 2 || watched.reads[at_b] % moves == 0);
    spi->rxdata = is_there ? 0xAB : UINT32_C(1) << 31;
    received -= is_there;
}

static void fe310_sends(size_t at_b)
{
    if (at_b != AT(fe310_spi_registers, txdata)) return;
    if (received == FE310_ROOM_B)
        lost++;
    else
        received++;
}

static void what_was_received_before_is_taken_at_the_start(void **state)
{
    (void)state;
    struct fe310_spi spi;

    received = FE310_ROOM_B, moves = 0;
    start(fe310_takes, fe310_sends);
    const int err = fe310_spi_init(&spi, page, 256000000, 32000000, 3);
    watched_stop();
    assert_int_equal(err, 0);
    assert_int_equal(received, 0);
    assert_int_equal(watched.reads[AT(fe310_spi_registers, rxdata)], FE310_ROOM_B);
}

static void of_what_is_sent_no_byte_comes_back_without_room(void **state)
{
    static const uint8_t bytes[20] = {1, 2, 3};
    struct fe310_spi spi;

    (void)state;
    received = lost = 0, moves = 3;
    start(fe310_takes, fe310_sends);
    int err = fe310_spi_init(&spi, page, 256000000, 32000000, 3);
    const struct bus bus = fe310_spi_bus(&spi);
    if (!err) err = bus_write(&bus, bytes, sizeof bytes);
    const unsigned behind = received;
    if (!err) err = bus_flush(&bus);
    watched_stop();
    assert_int_equal(err, 0);
    assert_int_equal(watched.writes[AT(fe310_spi_registers, txdata)], sizeof bytes);
    assert_int_equal(behind, FE310_ROOM_B);
    assert_int_equal(received, 0);
    assert_int_equal(lost, 0);
}

/* -- The FE310's clocks ------------------------------------------------------------------------ */

static void fe310_clocks_come(size_t at_b)
{
    struct fe310_prci *prci = page;

    prci->hfrosccfg |= (prci->hfrosccfg & UINT32_C(1) << 30) << 1;
    prci->hfxosccfg |= (prci->hfxosccfg & UINT32_C(1) << 30) << 1;
    if (at_b == AT(fe310_prci, pllcfg) && !(prci->pllcfg & 1 << 18)) prci->pllcfg |= UINT32_C(1) << 31;
}

static const struct fe310_spi_registers *fe310_flash;
static bool is_flash_too_fast;

/* 256 MHz, of which SiFive's own programs let the flash have an eighteenth. */
static void fe310_is_written(size_t at_b)
{
    const struct fe310_prci *prci = page;

    if (at_b == AT(fe310_prci, pllcfg) && (prci->pllcfg & 0x7FFFF) == 0x305F1)
        is_flash_too_fast |= fe310_flash->sckdiv < 8;
}

static int no_delay(void *ctx, uint32_t delay_us)
{
    *(uint32_t *)ctx += delay_us;
    return 0;
}

/* FE310-G000 Manual, 7: bit 16 of pllcfg chooses the PLL, 17 the crystal, 18 passes it by, 31 says that it has locked;
 * r - 1, f / 2 - 1 and q's power are at 0, 4 and 10. */
static void the_fe310_runs_by_its_ring_while_the_pll_changes(void **state)
{
    (void)state;
    const uint16_t pllcfg_b = AT(fe310_prci, pllcfg);
    const uint32_t pll = 1u << 17 | 1u << 10 | 31u << 4 | 1;
    struct fe310_spi_registers flash = {.sckdiv = 3};
    struct fe310_prci *prci = page;
    uint32_t waited_us = 0, values[8];
    unsigned n = 0;

    prci->pllcfg = 0x70FF7; /* all of it, passed by and chosen */
    fe310_flash = &flash;
    is_flash_too_fast = false;
    start(fe310_clocks_come, fe310_is_written);
    const uint32_t rate_hz = fe310_prci_init(prci, &flash, &(struct clock){&waited_us, no_delay});
    watched_stop();
    assert_int_equal(rate_hz, 256000000);
    assert_int_equal(waited_us, 100);
    assert_false(is_flash_too_fast);
    assert_int_equal(flash.sckdiv, 8);
    assert_int_equal(watched.log[0].at_b, AT(fe310_prci, hfrosccfg));
    for (unsigned i = 0; i < watched.n_log; i++)
        if (watched.log[i].at_b == pllcfg_b && n < 8) values[n++] = watched.log[i].value & 0x7FFFF;
    assert_int_equal(n, 4);
    assert_int_equal(values[0], 0x60FF7);
    assert_int_equal(values[1], 1u << 18 | pll);
    assert_int_equal(values[2], pll);
    assert_int_equal(values[3], 1u << 16 | pll);
    assert_int_equal(prci->plloutdiv, 1u << 8);
}

/* -- The STM32's SPI and DMA ------------------------------------------------------------------- */

/* Where there is no controller, or none that has a clock, nothing that is written stays: RM0090, 7.3.10. */
static void nothing_stays(size_t at_b)
{
    memset((uint8_t *)page + at_b, 0, sizeof(uint32_t));
}

static void a_controller_that_is_not_there_is_told(void **state)
{
    struct stm32_spi_registers spi_registers = {.sr = 2, .cr1 = 0x40};
    struct stm32_spi spi = {&spi_registers};
    struct stm32_dma dma;

    (void)state;
    start(NULL, nothing_stays);
    const int err = stm32_dma_init(&dma, page, 3, 3, &spi);
    watched_stop();
    assert_int_equal(err, MCU_ERR_CONFIG);
    assert_int_equal(spi_registers.cr1, 0x40);
    assert_int_equal(spi_registers.cr2, 0); /* the SPI asks nobody for bytes */
}

static void the_stm32_s_spi_is_set_up_before_it_is_enabled(void **state)
{
    (void)state;
    struct stm32_spi_registers *registers = page;
    struct stm32_spi spi;

    registers->cr1 = 0xFFFF, registers->cr2 = 0xFFFF;
    start(NULL, NULL);
    const int err = stm32_spi_init(&spi, registers, 72000000, 36000000, 3);
    watched_stop();
    assert_int_equal(err, 0);
    assert_true(watched.n_log >= 3);
    assert_int_equal(watched.log[0].at_b, AT(stm32_spi_registers, cr1));
    for (unsigned i = 0; i + 1 < watched.n_log; i++) {
        const struct watched_write *write = &watched.log[i];
        if (write->at_b == AT(stm32_spi_registers, cr1)) assert_int_equal(write->value & 1 << 6, 0);
    }
    assert_int_equal(watched.log[watched.n_log - 1].at_b, AT(stm32_spi_registers, cr1));
    assert_int_equal(registers->cr1, 0xC347);
}

enum { STREAM = 3, STREAM_BIT = 22, PART_MAX_B = 65535 };

static struct stm32_dma_stream *stream_of(void)
{
    return &((struct stm32_dma_registers *)page)->streams[STREAM];
}

static uint32_t stream_step_b; /* bytes that leave at once */

/* Bytes leave each `moves` looks; the last one sets the stream's flag, TCIF3, bit 27 of the lower half. */
static void stm32_dma_moves(size_t at_b)
{
    struct stm32_dma_registers *dma = page;
    struct stm32_dma_stream *stream = stream_of();

    if (at_b != AT(stm32_dma_registers, isr[0]) || !(stream->cr & 1) || watched.reads[at_b] % moves) return;
    stream->ndtr -= stream->ndtr < stream_step_b ? stream->ndtr : stream_step_b;
    if (!stream->ndtr) dma->isr[0] |= UINT32_C(32) << STREAM_BIT;
}

/* A stream that is enabled is looked at, no more. */
static unsigned changed_while_enabled;

static void stm32_dma_is_written(size_t at_b)
{
    struct stm32_dma_registers *dma = page;

    if (at_b == AT(stm32_dma_registers, ifcr[0])) dma->isr[0] &= ~dma->ifcr[0];
    if (at_b != AT(stm32_dma_registers, streams[STREAM].cr) && stream_of()->cr & 1) changed_while_enabled++;
}

static void a_stream_is_set_up_before_and_stopped_behind_each_part(void **state)
{
    static const uint8_t bytes[40];
    struct stm32_spi_registers spi_registers = {.sr = 2};
    struct stm32_spi spi = {&spi_registers};
    struct stm32_dma dma;

    (void)state;
    changed_while_enabled = 0, moves = 50, stream_step_b = 1;
    start(stm32_dma_moves, stm32_dma_is_written);
    int err = stm32_dma_init(&dma, page, STREAM, 3, &spi);
    const struct bus bus = stm32_dma_bus(&dma);
    if (!err) err = bus_write(&bus, bytes, sizeof bytes);
    if (!err) err = bus_write(&bus, bytes, sizeof bytes);
    const size_t left = bus_left_b(&bus);
    if (!err) err = bus_flush(&bus);
    const size_t none = bus_left_b(&bus);
    watched_stop();
    assert_int_equal(err, 0);
    assert_int_equal(left, sizeof bytes);
    assert_int_equal(none, 0);
    assert_int_equal(changed_while_enabled, 0);
    assert_int_equal(watched_times(AT(stm32_dma_registers, streams[STREAM].ndtr), sizeof bytes), 2);
    assert_int_equal(watched_times(AT(stm32_dma_registers, ifcr[0]), UINT32_C(0x3D) << STREAM_BIT), 2);
    assert_int_equal(stream_of()->cr, 3u << 25 | 1u << 10 | 1u << 6);
}

enum { PARTS_MAX = 8 };

/* Where each part is read from, and its length, when the stream is enabled for it. */
static struct {
    uint32_t from, n_b;
} parts[PARTS_MAX];
static unsigned n_parts, bad_part; /* the part in which the bus fails; from 1 on, 0: none */

static void stm32_dma_parts_move(size_t at_b)
{
    stm32_dma_moves(at_b);
    if (n_parts == bad_part && bad_part) ((struct stm32_dma_registers *)page)->isr[0] |= UINT32_C(8) << STREAM_BIT;
}

static void stm32_dma_parts_are_noted(size_t at_b)
{
    stm32_dma_is_written(at_b);
    if (at_b != AT(stm32_dma_registers, streams[STREAM].cr) || !(stream_of()->cr & 1) || n_parts == PARTS_MAX) return;
    parts[n_parts].from = stream_of()->m0ar;
    parts[n_parts++].n_b = stream_of()->ndtr;
}

/* RM0090, 10.5.6: NDTR has 16 bits, and is written while the stream is disabled only. */
static int send_in_parts(size_t n_b, unsigned bad)
{
    static const uint8_t bytes[4 * PART_MAX_B];
    struct stm32_spi_registers spi_registers = {.sr = 2};
    struct stm32_spi spi = {&spi_registers};
    struct stm32_dma dma;

    watched_begin();
    changed_while_enabled = n_parts = 0, moves = 3, stream_step_b = 9999, bad_part = bad;
    start(stm32_dma_parts_move, stm32_dma_parts_are_noted);
    int err = stm32_dma_init(&dma, page, STREAM, 3, &spi);
    const struct bus bus = stm32_dma_bus(&dma);
    if (!err) err = bus_write(&bus, bytes, n_b);
    const int flushed = bus_flush(&bus);
    watched_stop();
    assert_int_equal(changed_while_enabled, 0);
    assert_int_equal(stream_of()->cr & 1, 0);
    for (unsigned i = 0; i < n_parts; i++)
        assert_int_equal(parts[i].from, (uint32_t)(uintptr_t)&bytes[i * (size_t)PART_MAX_B]);
    return err ? err : flushed;
}

static void each_part_is_waited_for_before_the_next(void **state)
{
    static const uint32_t lengths_b[] = {17, 65534, 65535, 65536, 131070, 131071, 200000};

    (void)state;
    for (size_t i = 0; i < sizeof lengths_b / sizeof *lengths_b; i++) {
        uint32_t left_b = lengths_b[i];
        const unsigned wanted = (left_b + PART_MAX_B - 1) / PART_MAX_B;
        assert_int_equal(send_in_parts(left_b, 0), 0);
        assert_int_equal(n_parts, wanted);
        for (unsigned k = 0; k < n_parts; left_b -= parts[k++].n_b)
            assert_int_equal(parts[k].n_b, left_b < PART_MAX_B ? left_b : PART_MAX_B);
        for (unsigned bad = 1; bad <= wanted; bad++) {
            assert_int_equal(send_in_parts(lengths_b[i], bad), MCU_ERR_BUS);
            assert_int_equal(n_parts, bad);
        }
    }
}

/* -- The PL022 --------------------------------------------------------------------------------- */

static unsigned read_from_nothing; /* bytes: what an empty FIFO gives is none */

static void pl022_receives(size_t at_b)
{
    struct pl022_registers *spi = page;

    if (at_b == AT(pl022_registers, dr) && !received) read_from_nothing++;
    if (at_b == AT(pl022_registers, dr) && received) received--;
    if (at_b != AT(pl022_registers, sr)) return;
    spi->sr = PL022_SR_TFE | PL022_SR_TNF | (received ? PL022_SR_RNE : 0u) | (received == 8 ? PL022_SR_RFF : 0u);
}

static void pl022_sends(size_t at_b)
{
    if (at_b != AT(pl022_registers, dr)) return;
    if (received < 8)
        received++;
    else
        lost++;
}

static void the_pl022_is_enabled_last(void **state)
{
    (void)state;
    struct pl022_registers *registers = page;
    const struct pl022_config config = {.clock_hz = 50000000, .spi_hz = 25000000, .mode = 3};
    struct pl022 spi;

    registers->cr1 = 0xF, registers->imsc = 0xF;
    received = 0;
    start(pl022_receives, pl022_sends);
    const int err = pl022_init(&spi, registers, &config);
    watched_stop();
    assert_int_equal(err, 0);
    assert_int_equal(watched.log[0].at_b, AT(pl022_registers, cr1));
    assert_int_equal(watched.log[0].value, 0);
    assert_int_equal(watched.log[watched.n_log - 1].at_b, AT(pl022_registers, cr1));
    assert_int_equal(watched.log[watched.n_log - 1].value, 2);
    assert_int_equal(watched.writes[AT(pl022_registers, cr1)], 2);
    assert_int_equal(registers->imsc, 0);
}

/* Eight bytes at once find an empty receiver; whatever was there before, a flush leaves none. */
static void what_the_pl022_receives_is_taken(void **state)
{
    static const uint8_t bytes[40];
    const struct pl022_config config = {.clock_hz = 50000000, .spi_hz = 25000000, .mode = 3};
    struct pl022 spi;

    (void)state;
    for (unsigned before = 0; before <= 8; before++)
        for (size_t n_b = 0; n_b <= sizeof bytes; n_b += 1 + n_b / 9) {
            received = before, lost = read_from_nothing = 0;
            watched_begin();
            start(pl022_receives, pl022_sends);
            int err = pl022_init(&spi, page, &config);
            const unsigned behind = received;
            if (!err) err = pl022_write(&spi, bytes, n_b);
            const unsigned full = received;
            if (!err) err = pl022_flush(&spi);
            watched_stop();
            assert_int_equal(err, 0);
            assert_int_equal(behind, 0);
            assert_true(full < 8);
            assert_int_equal(received, 0);
            assert_int_equal(lost, 0);
            assert_int_equal(read_from_nothing, 0);
            assert_int_equal(watched.writes[AT(pl022_registers, dr)], n_b);
        }
}

/* Its transmitter: eight bytes wait, and one is on the wire, which leaves each `moves` looks. */
static struct {
    uint8_t waiting[8], sent[64];
    unsigned n_waiting, n_sent;
    bool is_shifting;
    uint8_t shifter;
    uint32_t looks_before[64]; /* each byte was written */
    unsigned n_written;
} transmitter;

static void pl022_shifts(void)
{
    if (transmitter.is_shifting && transmitter.n_sent < 64)
        transmitter.sent[transmitter.n_sent++] = transmitter.shifter;
    transmitter.is_shifting = transmitter.n_waiting > 0;
    if (!transmitter.is_shifting) return;
    transmitter.shifter = transmitter.waiting[0];
    memmove(transmitter.waiting, transmitter.waiting + 1, --transmitter.n_waiting);
}

static void pl022_looks(size_t at_b)
{
    struct pl022_registers *spi = page;

    pl022_receives(at_b);
    if (at_b != AT(pl022_registers, sr)) return;
    if (watched.reads[at_b] % moves == 0) pl022_shifts();
    const bool is_busy = transmitter.n_waiting || transmitter.is_shifting;
    spi->sr &= ~(uint32_t)(PL022_SR_TFE | PL022_SR_TNF | PL022_SR_BSY);
    spi->sr |= (transmitter.n_waiting ? 0u : PL022_SR_TFE) | (transmitter.n_waiting < 8 ? PL022_SR_TNF : 0u) |
               (is_busy ? PL022_SR_BSY : 0u);
}

static void pl022_takes(size_t at_b)
{
    if (at_b != AT(pl022_registers, dr)) return;
    pl022_sends(at_b);
    if (transmitter.n_waiting < 8)
        transmitter.waiting[transmitter.n_waiting++] = (uint8_t)((struct pl022_registers *)page)->dr;
    if (transmitter.n_written < 64)
        transmitter.looks_before[transmitter.n_written++] = watched.reads[AT(pl022_registers, sr)];
    if (!transmitter.is_shifting) pl022_shifts();
}

/* What is written to a full FIFO would be lost. Of whole FIFOs only the first byte is waited for. */
static void what_the_pl022_sends_is_what_was_written(void **state)
{
    const struct pl022_config config = {.clock_hz = 50000000, .spi_hz = 25000000, .mode = 3};
    uint8_t bytes[41];
    struct pl022 spi;

    (void)state;
    for (uint8_t i = 0; i < sizeof bytes; i++)
        bytes[i] = (uint8_t)(i + 1);
    for (moves = 1; moves < 4; moves++)
        for (size_t n_b = 0; n_b <= sizeof bytes; n_b++) {
            memset(&transmitter, 0, sizeof transmitter);
            received = 0;
            watched_begin();
            start(pl022_looks, pl022_takes);
            int err = pl022_init(&spi, page, &config);
            if (!err) err = pl022_write(&spi, bytes, n_b);
            if (!err) err = pl022_flush(&spi);
            watched_stop();
            assert_int_equal(err, 0);
            assert_int_equal(transmitter.n_sent, n_b);
            assert_memory_equal(transmitter.sent, bytes, n_b);
            assert_false(transmitter.n_waiting || transmitter.is_shifting);
            for (size_t i = 1; i < n_b / 8 * 8; i++)
                if (i % 8) assert_int_equal(transmitter.looks_before[i], transmitter.looks_before[i - 1]);
        }
}

/* -- The RP2040's DMA -------------------------------------------------------------------------- */

enum { CHANNEL = 3 };
#define BUSY (UINT32_C(1) << 24)

static unsigned abort_looks; /* until the channel has stopped */

static struct rp2040_dma_channel_registers *channel_of(void)
{
    return &((struct rp2040_dma_registers *)page)->ch[CHANNEL];
}

static void rp2040_dma_moves(size_t at_b)
{
    struct rp2040_dma_registers *dma = page;
    struct rp2040_dma_channel_registers *channel = channel_of();

    if (at_b == AT(rp2040_dma_registers, chan_abort) && watched.reads[at_b] == abort_looks) dma->chan_abort = 0;
    if (at_b != AT(rp2040_dma_registers, ch[CHANNEL].trans_count) || !moves || watched.reads[at_b] % moves) return;
    if (channel->trans_count) channel->trans_count--;
    if (!channel->trans_count) channel->ctrl_trig &= ~BUSY;
}

static int flush_channel(uint32_t left)
{
    static const struct pl022_config config = {.clock_hz = 125000000, .spi_hz = 62500000, .mode = 3};
    static struct pl022_registers spi_registers;
    struct pl022 spi;
    struct rp2040_dma dma;

    spi_registers = (struct pl022_registers){.sr = PL022_SR_TFE | PL022_SR_TNF};
    assert_int_equal(pl022_init(&spi, &spi_registers, &config), 0);
    rp2040_dma_init(&dma, page, CHANNEL, &spi, 16);
    const struct bus bus = rp2040_dma_bus(&dma);
    channel_of()->ctrl_trig = BUSY | 1u;
    channel_of()->trans_count = left;
    start(rp2040_dma_moves, NULL);
    const int err = bus_flush(&bus);
    watched_stop();
    return err;
}

/* A byte at 100 kHz takes 10,000 cycles, and two of them more looks than there are without a byte. */
static void a_slow_channel_is_waited_for(void **state)
{
    (void)state;
    moves = 9000;
    assert_int_equal(flush_channel(2), 0);
    assert_int_equal(watched.writes[AT(rp2040_dma_registers, chan_abort)], 0);
}

/* Disabled first; how long it takes to stop is looked at, and not longer. */
static void a_channel_that_stands_still_is_waited_for_until_it_has_stopped(void **state)
{
    (void)state;
    moves = 0, abort_looks = 3;
    assert_int_equal(flush_channel(2), MCU_ERR_TIMEOUT);
    assert_int_equal(watched.reads[AT(rp2040_dma_registers, chan_abort)], abort_looks);
    assert_int_equal(watched_times(AT(rp2040_dma_registers, chan_abort), 1u << CHANNEL), 1);
    assert_int_equal(watched.log[0].at_b, AT(rp2040_dma_registers, ch[CHANNEL].ctrl_trig));
    assert_int_equal(watched.log[0].value & 1, 0);
    assert_in_range(watched.reads[AT(rp2040_dma_registers, ch[CHANNEL].trans_count)], 10000, 20000);
}

/* -- The RP2040's clocks ----------------------------------------------------------------------- */

struct tree {
    struct rp2040_resets_registers resets;
    struct rp2040_xosc_registers xosc;
    struct rp2040_pll_registers pll_sys;
    struct rp2040_clocks_registers clocks;
};

/* Everything comes when it was asked for: clk_ref has one of four sources, clk_sys one of two. */
static void rp2040_clocks_come(size_t at_b)
{
    struct tree *tree = page;

    (void)at_b;
    tree->resets.reset_done = ~tree->resets.reset;
    if (tree->xosc.ctrl >> 12 == 0xFAB) tree->xosc.status = UINT32_C(1) << 31;
    if (!(tree->pll_sys.pwr & 0x21)) tree->pll_sys.cs |= UINT32_C(1) << 31;
    tree->clocks.ref.selected = 1u << (tree->clocks.ref.ctrl & 3);
    tree->clocks.sys.selected = 1u << (tree->clocks.sys.ctrl & 1);
}

static unsigned changed_in_use;

static void rp2040_clocks_are_written(size_t at_b)
{
    const struct tree *tree = page;
    const bool is_pll = at_b >= offsetof(struct tree, pll_sys) && at_b < offsetof(struct tree, clocks);

    changed_in_use += is_pll && tree->clocks.sys.ctrl & 1;
}

static void the_rp2040_does_not_run_by_a_pll_that_changes(void **state)
{
    (void)state;
    struct tree *tree = page;

    changed_in_use = 0;
    tree->resets.reset = 0x01FFFFFF;
    tree->pll_sys.pwr = 0x2D;
    tree->clocks.sys.ctrl = 1;
    start(rp2040_clocks_come, rp2040_clocks_are_written);
    const int err =
        rp2040_clocks_init(&(struct rp2040_clocks){&tree->resets, &tree->xosc, &tree->pll_sys, &tree->clocks});
    watched_stop();
    assert_int_equal(err, 0);
    assert_int_equal(changed_in_use, 0);
    assert_int_equal(tree->pll_sys.fbdiv_int, 125);
    assert_int_equal(tree->pll_sys.prim, 0x62000);
    assert_int_equal(tree->pll_sys.pwr & 0x29, 0);
    assert_int_equal(tree->clocks.ref.ctrl, 2);
    assert_int_equal(tree->clocks.sys.ctrl, 1);
    assert_int_equal(tree->clocks.sys.div, 0x100);
    assert_int_equal(tree->clocks.peri.ctrl, 1u << 11);
}

/* -- Counters ---------------------------------------------------------------------------------- */

static struct {
    size_t at_b;
    uint32_t mask, step; /* it goes on by so much each `moves` looks, at most once round */
    uint64_t passed;
    uint32_t value;
} counter;

static void counter_counts(size_t at_b)
{
    if (at_b != counter.at_b) return;
    if (moves && watched.reads[at_b] % moves == 0) {
        counter.value += counter.step;
        counter.passed += counter.step < UINT32_C(1) << 31 ? counter.step : 0 - counter.step;
    }
    const uint32_t shown = counter.value & counter.mask;
    if (counter.mask == 0xFFFF)
        *(uint16_t *)((uint8_t *)page + at_b) = (uint16_t)shown;
    else
        *(uint32_t *)((uint8_t *)page + at_b) = shown;
}

/* Returns what the wait does; the counter begins just before it comes round. */
static int waited(const struct clock *clock, uint32_t delay_us)
{
    counter.passed = 0;
    watched.reads[counter.at_b] = 0;
    start(counter_counts, NULL);
    const int err = clock_delay(clock, delay_us);
    watched_stop();
    return err;
}

/* At least as many counts as the time has, and at most one step and two counts more, in steps of all sizes. */
static void assert_waits(const struct clock *clock, uint32_t counts_per_us)
{
    static const uint32_t steps[] = {1, 7, 250};

    for (size_t i = 0; i < 3; i++)
        for (uint32_t delay_us = 0; delay_us < 90; delay_us += 1 + delay_us / 2) {
            const uint32_t step = steps[i];
            counter.step = counter.at_b == 8 ? 0 - step : step;
            counter.value = counter.at_b == 8 ? 11 : 0 - 11u;
            moves = 1;
            assert_int_equal(waited(clock, delay_us), 0);
            /* The first look is where it begins, and has gone on once. */
            const uint64_t least = (uint64_t)delay_us * counts_per_us;
            assert_true(counter.passed >= least + 1 + step);
            assert_true(counter.passed < least + 3 + 2 * (uint64_t)step);
        }
}

/* Looks until a counter that stands still is given up. */
static uint32_t looks_until_given_up(const struct clock *clock)
{
    moves = 0;
    assert_int_equal(waited(clock, 1000), MCU_ERR_TIMEOUT);
    return watched.reads[counter.at_b];
}

/* Moves so seldom that it is given up, or not. */
static int waited_seldom(const struct clock *clock, unsigned looks)
{
    moves = looks;
    counter.step = counter.at_b == 8 ? 0 - 3u : 3;
    return waited(clock, 0);
}

static void systick_waits_as_long_as_it_says(void **state)
{
    (void)state;
    struct systick timer;

    assert_int_equal(systick_init(&timer, page, 5000000), 0);
    const struct clock clock = systick_clock(&timer);
    counter.at_b = AT(systick_registers, cvr);
    counter.mask = 0xFFFFFF;
    assert_waits(&clock, 5);
    assert_int_equal(waited_seldom(&clock, 1000), 0);
    assert_int_equal(looks_until_given_up(&clock), 1 + 4096);
}

static void mtime_waits_as_long_as_it_says(void **state)
{
    (void)state;
    struct mtime timer = {.low = page, .rate_hz = 4000000};
    const struct clock clock = mtime_clock(&timer);

    counter.at_b = 0;
    counter.mask = UINT32_MAX;
    assert_waits(&clock, 4);
    assert_int_equal(waited_seldom(&clock, 6000), 0);
}

static void the_avr_s_timer_waits_as_long_as_it_says(void **state)
{
    (void)state;
    struct avr_timer timer;

    assert_int_equal(avr_timer_init(&timer, page, 16000000), 0);
    const struct clock clock = avr_timer_clock(&timer);
    counter.at_b = AT(avr_timer_registers, tcnt);
    counter.mask = 0xFFFF;
    assert_waits(&clock, 2);
    assert_int_equal(waited_seldom(&clock, 100), 0);
    assert_int_equal(looks_until_given_up(&clock), 1 + 256);
}

/* -- The AVR's SPI ----------------------------------------------------------------------------- */

static void avr_byte_leaves(size_t at_b)
{
    struct avr_spi_registers *spi = page;

    if (at_b != AT(avr_spi_registers, spsr)) return;
    spi->spsr = (uint8_t)(spi->spsr & 1);
    if (moves && watched.reads[at_b] % moves == 0) spi->spsr |= 0x80;
}

/* A byte takes 1024 cycles and, in an emulator, up to 1600 looks. */
static void the_avr_s_spi_waits_for_each_byte(void **state)
{
    static const uint8_t bytes[3] = {1, 2, 3};
    struct avr_spi spi;

    (void)state;
    assert_int_equal(avr_spi_init(&spi, page, 16000000, 8000000, 0), 0);
    const struct bus bus = avr_spi_bus(&spi);
    moves = 1600;
    start(avr_byte_leaves, NULL);
    const int err = bus_write(&bus, bytes, sizeof bytes);
    watched_stop();
    assert_int_equal(err, 0);
    assert_int_equal(watched.reads[AT(avr_spi_registers, spsr)], 3 * 1600);
    assert_int_equal(watched.writes[AT(avr_spi_registers, spdr)], 3);
    watched_begin();
    moves = 0;
    start(avr_byte_leaves, NULL);
    const int late = bus_write(&bus, bytes, sizeof bytes);
    watched_stop();
    assert_int_equal(late, MCU_ERR_TIMEOUT);
    assert_int_equal(watched.reads[AT(avr_spi_registers, spsr)], 2000);
    assert_int_equal(watched.writes[AT(avr_spi_registers, spdr)], 1);
}

#define TEST(name) cmocka_unit_test_setup(name, set_up)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_wait_takes_as_many_looks_as_it_has),
        TEST(what_was_received_before_is_taken_at_the_start),
        TEST(of_what_is_sent_no_byte_comes_back_without_room),
        TEST(the_fe310_runs_by_its_ring_while_the_pll_changes),
        TEST(a_controller_that_is_not_there_is_told),
        TEST(the_stm32_s_spi_is_set_up_before_it_is_enabled),
        TEST(a_stream_is_set_up_before_and_stopped_behind_each_part),
        TEST(each_part_is_waited_for_before_the_next),
        TEST(the_pl022_is_enabled_last),
        TEST(what_the_pl022_receives_is_taken),
        TEST(what_the_pl022_sends_is_what_was_written),
        TEST(a_slow_channel_is_waited_for),
        TEST(a_channel_that_stands_still_is_waited_for_until_it_has_stopped),
        TEST(the_rp2040_does_not_run_by_a_pll_that_changes),
        TEST(systick_waits_as_long_as_it_says),
        TEST(mtime_waits_as_long_as_it_says),
        TEST(the_avr_s_timer_waits_as_long_as_it_says),
        TEST(the_avr_s_spi_waits_for_each_byte),
    };
    return cmocka_run_group_tests_name("mcu_accesses", tests, NULL, NULL);
}
