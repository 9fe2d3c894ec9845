/* SPDX-License-Identifier: MIT
 *
 * DMA2 of the F405, as far as it feeds SPI1: streams read memory as late as the manual lets them, one item ahead in
 * direct mode, so that a buffer which is painted while it is on its way shows. RM0090 10.3 and 10.5. */
#include "stm32_parts.h"

enum { CR = 0x00, NDTR = 0x04, PAR = 0x08, M0AR = 0x0C, M1AR = 0x10, FCR = 0x14, STREAM_B = 0x18, FIRST = 0x10 };
enum { LISR = 0x00, LIFCR = 0x08 };
enum { EN = 1 << 0, MINC = 1 << 10, MODES = 0x01EC813E, DMDIS = 1 << 2, FTH = 3 };
enum { FEIF = 1 << 0, TEIF = 1 << 3, HTIF = 1 << 4, TCIF = 1 << 5, FLAGS = 0x3D };
enum { SERVE_CYCLES = 6, END_CYCLES = 12 };
#define SPI1_DR UINT32_C(0x4001300C)

static struct chip_block *dma_block(struct chip *chip)
{
    return chip_find(chip, "DMA2");
}

static uint32_t *stream_register(struct chip *chip, unsigned stream, unsigned which)
{
    return &dma_block(chip)->values[(FIRST + stream * STREAM_B + which) / 4];
}

static uint32_t control(struct chip *chip, unsigned stream)
{
    return *stream_register(chip, stream, CR);
}

static unsigned flags_shift(unsigned stream)
{
    static const unsigned shifts[4] = {0, 6, 16, 22}; /* RM0090 10.5.1 */
    return shifts[stream % 4];
}

static uint32_t *flags_of(struct chip *chip, unsigned stream)
{
    return &dma_block(chip)->values[LISR / 4 + stream / 4];
}

static void set_flag(struct chip *chip, unsigned stream, uint32_t flag)
{
    *flags_of(chip, stream) |= flag << flags_shift(stream);
}

/* RM0090 table 44. */
static bool is_spi1_tx(struct chip *chip, unsigned stream)
{
    return (stream == 3 || stream == 5) && (control(chip, stream) >> 25 & 7) == 3;
}

static void switch_off(struct chip *chip, unsigned stream)
{
    *stream_register(chip, stream, CR) &= ~(uint32_t)EN;
    chip->streams[stream].ending = false;
    chip->streams[stream].serve_ps = chip->streams[stream].off_ps = CHIP_NEVER;
}

/* -- Items -- */

/* RM0090 2.1.4 and 2.3: what is behind the bus matrix. */
static bool is_reached(uint32_t address)
{
    return (address >= 0x08000000 && address < 0x08100000) || (address >= 0x20000000 && address < 0x20020000);
}

static bool fetch(struct chip *chip, unsigned stream)
{
    struct chip_stream *s = &chip->streams[stream];
    uint8_t value;

    if (!is_reached(s->from) || !chip->world.memory(chip->world.ctx, s->from, &value)) {
        chip_complain(chip, RULE_DMA_MEMORY, "stream %u reads 0x%08X", stream, (unsigned)s->from);
        set_flag(chip, stream, TEIF);
        switch_off(chip, stream);
        return false;
    }
    s->fifo[(s->fifo_first + s->fifo_n++) % CHIP_FIFO] = value;
    if (control(chip, stream) & MINC) s->from++;
    s->left--;
    return true;
}

static void fill(struct chip *chip, unsigned stream)
{
    struct chip_stream *s = &chip->streams[stream];

    while (s->fifo_n < s->fifo_depth && s->left)
        if (!fetch(chip, stream)) return;
}

/* A FIFO is filled again when it is at its threshold or below: 4, 8, 12 or 16 bytes. */
static void serve(struct chip *chip, unsigned stream)
{
    struct chip_stream *s = &chip->streams[stream];
    uint32_t *ndtr = stream_register(chip, stream, NDTR);
    const unsigned threshold = (*stream_register(chip, stream, FCR) & FTH) * 4 + 4;
    const uint8_t value = s->fifo[s->fifo_first];

    s->serve_ps = CHIP_NEVER;
    s->fifo_first = (uint8_t)((s->fifo_first + 1) % CHIP_FIFO);
    s->fifo_n--;
    chip->spi.request = false;
    --*ndtr;
    if (*ndtr == s->count / 2) set_flag(chip, stream, HTIF);
    spi_take(chip, value);
    if (!*ndtr) {
        switch_off(chip, stream);
        set_flag(chip, stream, TCIF);
    } else if (s->fifo_depth == 1 || s->fifo_n <= threshold) {
        fill(chip, stream);
    }
}

/* RM0090 10.3.14: a stream that is stopped says so by TCIF. */
static void run_stream(struct chip *chip, unsigned stream)
{
    struct chip_stream *s = &chip->streams[stream];

    if (s->serve_ps <= chip->now_ps) serve(chip, stream);
    if (s->off_ps <= chip->now_ps) {
        switch_off(chip, stream);
        set_flag(chip, stream, TCIF);
    }
    chip_wake(chip, s->serve_ps);
    chip_wake(chip, s->off_ps);
}

void dma_run(struct chip *chip)
{
    if (chip->kind != CHIP_F405) return;
    for (unsigned i = 0; i < CHIP_STREAMS; i++)
        run_stream(chip, i);
}

void dma_asked(struct chip *chip)
{
    if (chip->kind != CHIP_F405) return;
    for (unsigned i = 0; i < CHIP_STREAMS; i++) {
        struct chip_stream *s = &chip->streams[i];
        if (!(control(chip, i) & EN) || s->ending || !is_spi1_tx(chip, i) || !s->fifo_n) continue;
        s->serve_ps = chip->now_ps + SERVE_CYCLES * chip->clocks.cycle_ps;
        chip_wake(chip, s->serve_ps);
        return;
    }
}

bool dma_is_idle(const struct chip *chip)
{
    for (unsigned i = 0; i < CHIP_STREAMS; i++)
        if (chip->streams[i].serve_ps != CHIP_NEVER) return false;
    return true;
}

void dma_peripheral_stops(struct chip *chip, const char *why)
{
    if (chip->kind != CHIP_F405) return;
    for (unsigned i = 0; i < CHIP_STREAMS; i++)
        if (is_spi1_tx(chip, i) && (control(chip, i) & EN || !chip->streams[i].off_is_read))
            chip_complain(chip, RULE_DMA_FIRST, "%s: stream %u has EN %u", why, i, (unsigned)control(chip, i) & EN);
}

/* -- On -- */

static void check_way(struct chip *chip, unsigned stream, uint32_t bits)
{
    const uint32_t par = *stream_register(chip, stream, PAR);
    const bool wide = chip_value(chip_find(chip, "SPI1"), 0) >> 11 & 1;

    if (par != SPI1_DR || (bits >> 6 & 3) != 1 || bits & 1 << 9)
        chip_complain(chip, RULE_DMA_TARGET, "stream %u: PAR 0x%08X, CR 0x%08X", stream, (unsigned)par, (unsigned)bits);
    if ((bits >> 11 & 3) != wide) chip_complain(chip, RULE_DMA_WIDTH, "stream %u: PSIZE %u", stream, bits >> 11 & 3);
    if (wide || bits & MODES || bits >> 13 & 3)
        chip_complain(chip, RULE_MODELLED, "stream %u: CR 0x%08X", stream, (unsigned)bits);
    if (!is_spi1_tx(chip, stream))
        chip_complain(chip, RULE_DMA_REQUEST, "stream %u, channel %u", stream, bits >> 25 & 7);
}

static void switch_on(struct chip *chip, unsigned stream)
{
    struct chip_stream *s = &chip->streams[stream];
    const uint32_t flags = *flags_of(chip, stream) >> flags_shift(stream) & FLAGS;

    if (flags) chip_complain(chip, RULE_DMA_FLAGS, "stream %u has flags 0x%02X", stream, (unsigned)flags);
    check_way(chip, stream, control(chip, stream));
    s->off_is_read = false;
    s->count = s->left = *stream_register(chip, stream, NDTR);
    s->from = *stream_register(chip, stream, M0AR);
    s->fifo_first = s->fifo_n = 0;
    s->fifo_depth = *stream_register(chip, stream, FCR) & DMDIS ? CHIP_FIFO : 1;
    if (!s->count) {
        chip_complain(chip, RULE_DMA_COUNT, "stream %u has none", stream);
        switch_off(chip, stream);
        return;
    }
    fill(chip, stream);
    if (!spi_asks(chip)) return;
    set_flag(chip, stream,
             FEIF); /* asked before memory was read, which RM0090 10.3.18 says may happen: no data are lost */
    dma_asked(chip);
}

void dma_start(struct chip *chip)
{
    for (unsigned i = 0; i < CHIP_STREAMS; i++)
        chip->streams[i] = (struct chip_stream){.off_is_read = true, .off_ps = CHIP_NEVER, .serve_ps = CHIP_NEVER};
}

/* -- Registers -- */

static void before_write(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t value)
{
    const unsigned stream = (offset - FIRST) / STREAM_B, which = (offset - FIRST) % STREAM_B;

    if (offset < FIRST) return;
    const uint32_t changed = chip_value(block, offset) ^ value;
    const bool on = control(chip, stream) & EN;
    if (on && changed && (which != CR || value & EN))
        chip_complain(chip, RULE_DMA_STOPPED, "stream %u: 0x%02X is written", stream, (unsigned)offset);
    if (!on && changed && !chip->streams[stream].off_is_read)
        chip_complain(chip, RULE_DMA_READ, "stream %u: 0x%02X is written", stream, (unsigned)offset);
}

/* What an enabled stream is told does not count, but that it is to stop. */
static void write_stream(struct chip *chip, unsigned stream, uint32_t *stored, bool is_control, uint32_t before)
{
    struct chip_stream *s = &chip->streams[stream];
    const bool on = is_control ? before & EN : control(chip, stream) & EN;
    const bool stays = *stored & EN;

    if (!on) {
        if (is_control && stays) switch_on(chip, stream);
        return;
    }
    *stored = before;
    if (!is_control || stays || s->ending) return;
    s->ending = true;
    s->serve_ps = CHIP_NEVER;
    s->off_ps = chip->now_ps + END_CYCLES * chip->clocks.cycle_ps;
    chip_wake(chip, s->off_ps);
}

static void after_write(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t before, uint32_t value)
{
    if (offset >= FIRST)
        write_stream(chip, (offset - FIRST) / STREAM_B, &block->values[offset / 4], (offset - FIRST) % STREAM_B == CR,
                     before);
    else if (offset >= LIFCR)
        block->values[(offset - LIFCR) / 4] &= ~value;
}

static uint32_t read(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t stored)
{
    (void)block;
    if (offset >= FIRST && (offset - FIRST) % STREAM_B == CR && !(stored & EN))
        chip->streams[(offset - FIRST) / STREAM_B].off_is_read = true;
    return stored;
}

#define STREAM(n)                                                                                                      \
    {FIRST + (n)*STREAM_B + CR, 0, 0x0FEFFFFF, 0x0FEFFFFF}, {FIRST + (n)*STREAM_B + NDTR, 0, 0xFFFF, 0xFFFF},          \
        {FIRST + (n)*STREAM_B + PAR, 0, UINT32_MAX, UINT32_MAX},                                                       \
        {FIRST + (n)*STREAM_B + M0AR, 0, UINT32_MAX, UINT32_MAX},                                                      \
        {FIRST + (n)*STREAM_B + M1AR, 0, UINT32_MAX, UINT32_MAX},                                                      \
    {                                                                                                                  \
        FIRST + (n)*STREAM_B + FCR, 0x21, 0xBF, 0x87                                                                   \
    }

static const struct chip_register registers[] = {
    {0x00, 0, 0x0F7D0F7D, 0},
    {0x04, 0, 0x0F7D0F7D, 0},
    {0x08, 0, 0x0F7D0F7D, 0},
    {0x0C, 0, 0x0F7D0F7D, 0},
    STREAM(0),
    STREAM(1),
    STREAM(2),
    STREAM(3),
    STREAM(4),
    STREAM(5),
    STREAM(6),
    STREAM(7),
};

const struct chip_layout chip_dma_layout = {
    .name = "DMA2",
    .base = 0x40026400,
    .enable_word = 0x30,
    .reset_word = 0x10,
    .enable_bit = 22,
    .registers = registers,
    .n_registers = sizeof registers / sizeof registers[0],
    .before_write = before_write,
    .after_write = after_write,
    .read = read,
    .restart = dma_start,
};
