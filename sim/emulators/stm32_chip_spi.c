/* SPDX-License-Identifier: MIT
 *
 * SPI1 as it sends: a data register, which DMA or the processor fills, and a shift register behind it. RM0090 28.3 and
 * 28.5, RM0008 25.3 and 25.5. */
#include "stm32_parts.h"

enum { CR1 = 0x00, CR2 = 0x04, SR = 0x08, DR = 0x0C };
enum {
    CPHA = 1 << 0,
    MSTR = 1 << 2,
    BR_SHIFT = 3,
    SPE = 1 << 6,
    LSBFIRST = 1 << 7,
    SSI = 1 << 8,
    SSM = 1 << 9,
    RXONLY = 1 << 10,
    DFF = 1 << 11,
    CRCNEXT = 1 << 12,
    CRCEN = 1 << 13,
    BIDIOE = 1 << 14,
    BIDIMODE = 1 << 15,
};
enum { TXDMAEN = 1 << 1, SSOE = 1 << 2, CR2_OTHER = 0xF1 }; /* interrupts, the receiver's DMA, TI's frames */
enum { RXNE = 1 << 0, TXE = 1 << 1, MODF = 1 << 5, OVR = 1 << 6, BSY = 1 << 7 };

/* RM0090 28.3.9: BSY is set two clocks of the bus after a write. */
enum { LOAD_CLOCKS = 2 };
#define PS_PER_S UINT64_C(1000000000000)

static struct chip_block *spi_block(struct chip *chip)
{
    return chip_find(chip, "SPI1");
}

static uint32_t cr1(struct chip *chip)
{
    return chip_value(spi_block(chip), CR1);
}

bool spi_is_idle(const struct chip *chip)
{
    return !chip->spi.full && !chip->spi.busy;
}

bool spi_end_is_read(const struct chip *chip)
{
    return chip->spi.end_is_read;
}

bool spi_asks(const struct chip *chip)
{
    return chip->spi.request;
}

/* A request stays until it is acknowledged (RM0090 10.3.2), even if the processor writes the data meanwhile. */
static void ask(struct chip *chip)
{
    if (!(chip_value(spi_block(chip), CR2) & TXDMAEN)) return;
    chip->spi.request = true;
    dma_asked(chip);
}

/* -- What leaves -- */

static uint8_t reversed(uint8_t byte)
{
    uint8_t result = 0;
    for (unsigned i = 0; i < 8; i++)
        result = (uint8_t)(result | (byte >> i & 1) << (7 - i));
    return result;
}

static void tell(struct chip *chip)
{
    const uint16_t value = chip->spi.shifting;
    const bool wide = cr1(chip) & DFF, lsb_first = cr1(chip) & LSBFIRST;
    const uint8_t high = (uint8_t)(value >> 8), low = (uint8_t)value;
    const uint8_t bytes[2] = {lsb_first ? reversed(low) : wide ? high : low, lsb_first ? reversed(high) : low};

    for (unsigned i = 0; i < (wide ? 2 : 1); i++) {
        chip->spi.bytes++;
        chip->world.byte(chip->world.ctx, bytes[i]);
    }
}

static void load(struct chip *chip)
{
    struct chip_spi *spi = &chip->spi;

    spi->load_ps = CHIP_NEVER;
    if (chip->setting.stop_after && spi->bytes >= chip->setting.stop_after) spi->stopped = true;
    if (spi->stopped) {
        spi->busy = false;
        return;
    }
    pins_before_byte(chip);
    spi->shifting = spi->data;
    spi->full = false;
    spi->busy = true;
    spi->end_ps = chip->now_ps + (cr1(chip) & DFF ? 16 : 8) * PS_PER_S / spi->hz;
    chip_wake(chip, spi->end_ps);
    ask(chip);
}

static void end(struct chip *chip)
{
    struct chip_spi *spi = &chip->spi;

    spi->end_ps = CHIP_NEVER;
    tell(chip);
    if (!(cr1(chip) & BIDIMODE)) {
        spi->ovr = spi->ovr || spi->rxne;
        spi->rxne = true;
    }
    if (spi->full)
        load(chip);
    else
        spi->busy = false;
}

void spi_run(struct chip *chip)
{
    struct chip_spi *spi = &chip->spi;

    if (spi->end_ps <= chip->now_ps) end(chip);
    if (spi->load_ps <= chip->now_ps) load(chip);
    chip_wake(chip, spi->end_ps);
    chip_wake(chip, spi->load_ps);
}

void spi_take(struct chip *chip, uint16_t value)
{
    struct chip_spi *spi = &chip->spi;
    const uint32_t control = cr1(chip);

    if (!(control & SPE)) {
        chip_complain(chip, RULE_SPI_ENABLED, "0x%02X is written", value);
        return;
    }
    if (!(control & MSTR) || (control & BIDIMODE ? !(control & BIDIOE) : control & RXONLY)) {
        chip_complain(chip, RULE_SPI_DIRECTION, "CR1 is 0x%04X", (unsigned)control);
        return;
    }
    if (spi->full) chip_complain(chip, RULE_SPI_EMPTY, "0x%02X takes the place of 0x%02X", value, spi->data);
    spi->full = true;
    spi->data = value;
    spi->empty_is_read = spi->end_is_read = false;
    if (spi->busy || spi->load_ps != CHIP_NEVER || spi->stopped) return;
    spi->load_ps = chip->now_ps + LOAD_CLOCKS * PS_PER_S / chip->clocks.apb2_hz;
    chip_wake(chip, spi->load_ps);
}

/* -- On and off -- */

static void check_rate(struct chip *chip)
{
    static const uint32_t most_hz[CHIP_KINDS] = {[CHIP_F405] = 42000000, [CHIP_F103] = 18000000};
    const uint32_t hz = chip->spi.hz, panel_hz = chip->setting.panel_hz;

    if (hz > most_hz[chip->kind])
        chip_complain(chip, RULE_SPI_RATE, "%u Hz, of %u", (unsigned)hz, (unsigned)most_hz[chip->kind]);
    if (panel_hz && hz > panel_hz)
        chip_complain(chip, RULE_SPI_RATE, "%u Hz, where the display takes %u", (unsigned)hz, (unsigned)panel_hz);
}

/* RM0090 28.3.10: a master whose NSS is low, or whose SSI is, is none any more. */
static bool loses_itself(struct chip *chip, struct chip_block *block)
{
    const uint32_t control = chip_value(block, CR1);
    const bool selected = control & SSM ? control & SSI : chip_value(block, CR2) & SSOE;

    if (!(control & MSTR) || selected) return false;
    chip_complain(chip, RULE_SPI_SELECTED, "CR1 is 0x%04X", (unsigned)control);
    block->values[CR1 / 4] &= ~(uint32_t)(MSTR | SPE);
    block->values[SR / 4] |= MODF;
    return true;
}

static void enable(struct chip *chip, struct chip_block *block)
{
    struct chip_spi *spi = &chip->spi;

    if (loses_itself(chip, block)) return;
    clocks_check_settled(chip);
    spi->hz = chip->clocks.apb2_hz >> ((chip_value(block, CR1) >> BR_SHIFT & 7) + 1);
    check_rate(chip);
    pins_for_spi(chip);
    if (spi->stopped && spi->restarts++ == chip->setting.stop_for) {
        spi->stopped = false;
        chip->setting.stop_after = 0;
    }
    ask(chip);
}

static void disable(struct chip *chip)
{
    struct chip_spi *spi = &chip->spi;

    spi->busy = spi->full = spi->request = false;
    spi->load_ps = spi->end_ps = CHIP_NEVER;
}

void spi_check_off(struct chip *chip, const char *why)
{
    if (!spi_is_idle(chip))
        chip_complain(chip, RULE_SPI_IDLE, "%s: TXE is %d, BSY %d", why, !chip->spi.full, chip->spi.busy);
    else if (!spi_end_is_read(chip))
        chip_complain(chip, RULE_END_READ, "%s", why);
    dma_peripheral_stops(chip, why);
}

void spi_start(struct chip *chip)
{
    struct chip_spi *spi = &chip->spi;

    disable(chip);
    spi->rxne = spi->ovr = false;
    spi->end_is_read = true;
}

static void note_end(struct chip_spi *spi)
{
    if (!spi->full) spi->empty_is_read = true;
    if (spi->empty_is_read && !spi->busy) spi->end_is_read = true;
}

/* -- Registers -- */

static void before_write(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t value)
{
    const uint32_t before = chip_value(block, CR1);
    const uint32_t changed = (before ^ value) & ~(uint32_t)(SPE | CRCNEXT | SSI);

    if (offset != CR1) return;
    if (changed && value & SPE)
        chip_complain(chip, RULE_SPI_ORDER, "CR1 0x%04X becomes 0x%04X", (unsigned)before, (unsigned)value);
    if (before & ~value & SPE) spi_check_off(chip, "SPE is cleared");
}

static void after_write(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t before, uint32_t value)
{
    const uint32_t now = chip_value(block, offset);

    if (offset == DR) spi_take(chip, (uint16_t)(chip_value(block, CR1) & DFF ? value : value & 0xFF));
    if (offset == CR1 && now & CRCEN) chip_complain(chip, RULE_MODELLED, "SPI1: checksums");
    if (offset == CR1 && now & ~before & SPE) enable(chip, block);
    if (offset == CR1 && before & ~now & SPE) disable(chip);
    if (offset != CR2) return;
    if (now & CR2_OTHER) chip_complain(chip, RULE_MODELLED, "SPI1: CR2 is 0x%02X", (unsigned)now);
    if (before & ~now & TXDMAEN) chip->spi.request = false;
    if (now & ~before & TXDMAEN && chip_value(block, CR1) & SPE && !chip->spi.full) ask(chip);
}

static uint32_t read(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t stored)
{
    struct chip_spi *spi = &chip->spi;

    (void)block;
    if (offset == DR) spi->rxne = spi->ovr = false;
    if (offset != SR) return stored;
    note_end(spi);
    return stored | (spi->rxne ? RXNE : 0) | (spi->full ? 0 : TXE) | (spi->ovr ? OVR : 0) | (spi->busy ? BSY : 0);
}

static const struct chip_register f405_registers[] = {
    {CR1, 0, 0xFFFF, 0xFFFF},
    {CR2, 0, 0xF7, 0xF7},
    {SR, 0, 0x1FF, 0},
    {DR, 0, 0xFFFF, 0},
};
static const struct chip_register f103_registers[] = {
    {CR1, 0, 0xFFFF, 0xFFFF},
    {CR2, 0, 0xE7, 0xE7},
    {SR, 0, 0xFF, 0},
    {DR, 0, 0xFFFF, 0},
};

#define LAYOUT(enable, reset, table)                                                                                   \
    {                                                                                                                  \
        .name = "SPI1", .base = 0x40013000, .enable_word = (enable), .reset_word = (reset), .enable_bit = 12,          \
        .registers = (table), .n_registers = sizeof(table) / sizeof(table)[0], .before_write = before_write,           \
        .after_write = after_write, .read = read, .restart = spi_start                                                 \
    }

static const struct chip_layout f405_layout = LAYOUT(0x44, 0x24, f405_registers);
static const struct chip_layout f103_layout = LAYOUT(0x18, 0x0C, f103_registers);
const struct chip_layout *const chip_spi_layouts[CHIP_KINDS] = {[CHIP_F405] = &f405_layout, [CHIP_F103] = &f103_layout};
