/* SPDX-License-Identifier: MIT */
#include "mcu/pl022.h"

#include "mcu/wait.h"

#define CR0_SCR(scr) ((scr) << 8)
#define CR0_SPH (UINT32_C(1) << 7)
#define CR0_SPO (UINT32_C(1) << 6)
#define CR0_DSS_8_BITS UINT32_C(7) /* and FRF = 0: Motorola's frame format */

enum { CPSDVSR_MIN = 2, CPSDVSR_MAX = 254, SCR_MAX = 255, FRAME_BITS = 8 };

/* The full FIFO and the byte in the shifter take 9 frames of SSPCLK, and a poll at least a cycle of the processor,
 * whose clock is at most 8 times SSPCLK. */
enum { LIMIT_CYCLES_BIT = (PL022_FIFO_B + 1) * FRAME_BITS * 8 };

struct division {
    uint32_t prescaler; /* CPSDVSR */
    uint32_t rate;      /* SCR + 1 */
};

static uint32_t divide_up(uint32_t a, uint32_t b)
{
    return a / b + (a % b != 0);
}

/* SSPCLK / (prescaler * rate) is the fastest that is not above spi_hz. False: none is slow enough. */
static bool choose_division(struct division *best, const struct pl022_config *config)
{
    if (!config->spi_hz) return false;
    const uint32_t least = divide_up(config->clock_hz, config->spi_hz);

    *best = (struct division){0, 0};
    for (uint32_t prescaler = CPSDVSR_MIN; prescaler <= CPSDVSR_MAX; prescaler += 2) {
        const uint32_t rate = least > prescaler ? divide_up(least, prescaler) : 1;
        if (rate > SCR_MAX + 1) continue;
        if (!best->rate || prescaler * rate < best->prescaler * best->rate) *best = (struct division){prescaler, rate};
    }
    return best->rate != 0;
}

int pl022_init(struct pl022 *pl022, volatile struct pl022_registers *registers, const struct pl022_config *config)
{
    struct division division;

    if (!choose_division(&division, config)) return MCU_ERR_CONFIG;
    const uint32_t divisor = division.prescaler * division.rate;
    pl022->registers = registers;
    pl022->spi_hz = config->clock_hz / divisor;
    pl022->limit_polls = divisor * LIMIT_CYCLES_BIT;

    registers->cr1 = 0;
    registers->cpsr = division.prescaler;
    registers->cr0 = CR0_SCR(division.rate - 1) | (config->mode & 1 ? CR0_SPH : 0) | (config->mode & 2 ? CR0_SPO : 0) |
                     CR0_DSS_8_BITS;
    registers->imsc = 0;
    registers->cr1 = PL022_CR1_SSE;
    return pl022_flush(pl022);
}

/* Until the bits of the status that mask has are `value`. */
static inline int wait_status(const struct pl022 *pl022, uint32_t mask, uint32_t value)
{
    return mcu_wait(&pl022->registers->sr, mask, value, pl022->limit_polls);
}

/* A full receive FIFO loses what follows, which nobody minds, but emulators may wait until it has room. Written out, as
 * put_eight() is: a loop would cost as much as what it does. */
static inline void take_received(volatile struct pl022_registers *registers)
{
    if (!(registers->sr & PL022_SR_RFF)) return;
    (void)registers->dr;
    (void)registers->dr;
    (void)registers->dr;
    (void)registers->dr;
    (void)registers->dr;
    (void)registers->dr;
    (void)registers->dr;
    (void)registers->dr;
}

static inline void put_eight(volatile struct pl022_registers *registers, const uint8_t *data)
{
    registers->dr = data[0];
    registers->dr = data[1];
    registers->dr = data[2];
    registers->dr = data[3];
    registers->dr = data[4];
    registers->dr = data[5];
    registers->dr = data[6];
    registers->dr = data[7];
}

/* By whole FIFOs: one wait serves eight bytes, and the shifter still has a byte's time of work when it ends. */
int pl022_write(struct pl022 *pl022, const uint8_t *data, size_t n_b)
{
    volatile struct pl022_registers *const registers = pl022->registers;

    for (; n_b >= PL022_FIFO_B; n_b -= PL022_FIFO_B, data += PL022_FIFO_B) {
        int err = wait_status(pl022, PL022_SR_TFE, PL022_SR_TFE);
        if (err) return err;
        put_eight(registers, data);
        take_received(registers);
    }
    for (; n_b; n_b--) {
        int err = wait_status(pl022, PL022_SR_TNF, PL022_SR_TNF);
        if (err) return err;
        registers->dr = *data++;
        take_received(registers);
    }
    return 0;
}

int pl022_flush(struct pl022 *pl022)
{
    volatile struct pl022_registers *const registers = pl022->registers;

    take_received(registers);
    int err = wait_status(pl022, PL022_SR_TFE | PL022_SR_BSY, PL022_SR_TFE);
    for (unsigned i = 0; i < PL022_FIFO_B && registers->sr & PL022_SR_RNE; i++)
        (void)registers->dr;
    return err;
}

static int bus_write_ctx(void *ctx, const uint8_t *data, size_t n_b)
{
    return pl022_write((struct pl022 *)ctx, data, n_b);
}

static int bus_flush_ctx(void *ctx)
{
    return pl022_flush((struct pl022 *)ctx);
}

struct bus pl022_bus(struct pl022 *pl022)
{
    return (struct bus){.ctx = pl022, .write = bus_write_ctx, .flush = bus_flush_ctx};
}
