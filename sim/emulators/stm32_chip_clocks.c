/* SPDX-License-Identifier: MIT
 *
 * RCC, flash's wait states and the regulator. RM0090 3.9, 5.4, 7.3; RM0008 3.3.3, 7.3. */
#include "stm32_parts.h"

enum { HSI_ON = 1 << 0, HSE_ON = 1 << 16, PLL_ON = 1 << 24 };
enum { SW = 3, SWS_SHIFT = 2, HPRE_SHIFT = 4 };
enum source { SOURCE_HSI, SOURCE_HSE, SOURCE_PLL };
enum { ACR_LATENCY = 7, ACR_PRFTBE = 1 << 4, PWR_VOS = 1 << 14 };

#define PS_PER_S UINT64_C(1000000000000)
#define HSE_START_PS (2 * PS_PER_S / 1000) /* DS8626 5.3.8 and DS5319 5.3.6: 2 ms, typically */
#define PLL_LOCK_PS (200 * PS_PER_S / 1000000)
enum { STOP_CYCLES = 6, SWITCH_CYCLES = 8 };

/* Where the two differ. */
static const struct clock_part {
    uint8_t cfgr, ppre1_shift, ppre2_shift;
    uint8_t enables[3], resets[3];
    uint32_t hsi_hz, hse_min_hz, hse_max_hz;
    uint32_t hclk_max_hz, apb1_max_hz, apb2_max_hz;
    uint32_t wait_state_hz; /* one more for each of these begun beyond the first */
} parts[CHIP_KINDS] = {
    [CHIP_F405] = {0x08,
                   10,
                   13,
                   {0x30, 0x40, 0x44},
                   {0x10, 0x20, 0x24},
                   16000000,
                   4000000,
                   26000000,
                   168000000,
                   42000000,
                   84000000,
                   30000000},
    [CHIP_F103] = {0x04,
                   8,
                   11,
                   {0x14, 0x1C, 0x18},
                   {0, 0x10, 0x0C},
                   8000000,
                   4000000,
                   16000000,
                   72000000,
                   36000000,
                   72000000,
                   24000000},
};

static struct chip_block *rcc(struct chip *chip)
{
    return &chip->blocks[0];
}

static const struct clock_part *part(const struct chip *chip)
{
    return &parts[chip->kind];
}

static uint32_t cr(struct chip *chip)
{
    return chip_value(rcc(chip), 0);
}

static uint32_t cfgr(struct chip *chip)
{
    return chip_value(rcc(chip), part(chip)->cfgr);
}

static uint32_t acr(struct chip *chip)
{
    return chip_value(chip_find(chip, "FLASH"), 0);
}

/* -- The PLL -- */

/* Whether the PLL is fed by the crystal. */
static bool is_by_hse(struct chip *chip)
{
    return chip->kind == CHIP_F405 ? chip_value(rcc(chip), 4) >> 22 & 1 : cfgr(chip) >> 16 & 1;
}

static void check_range(struct chip *chip, const char *what, uint64_t value, uint64_t least, uint64_t most)
{
    if (value < least || value > most)
        chip_complain(chip, RULE_PLL_RANGE, "%s is %llu, not %llu to %llu", what, (unsigned long long)value,
                      (unsigned long long)least, (unsigned long long)most);
}

/* RM0090 7.3.2: M 2..63 gives 1 to 2 MHz, N 50..432 gives 100 to 432; Q gives 48 at most. */
static uint32_t f405_pll_hz(struct chip *chip, uint32_t input_hz)
{
    const uint32_t bits = chip_value(rcc(chip), 4);
    const uint32_t m = bits & 63, n = bits >> 6 & 511, p = 2 * ((bits >> 16 & 3) + 1), q = bits >> 24 & 15;

    check_range(chip, "PLLM", m, 2, 63);
    check_range(chip, "PLLN", n, 50, 432);
    check_range(chip, "PLLQ", q, 2, 15);
    if (!m || !q) return 0;
    const uint64_t vco_hz = (uint64_t)input_hz * n / m;
    check_range(chip, "the PLL's input", input_hz / m, 1000000, 2000000);
    check_range(chip, "the VCO's rate", vco_hz, 100000000, 432000000);
    check_range(chip, "the rate for USB and SDIO", vco_hz / q, 0, 48000000);
    return (uint32_t)(vco_hz / p);
}

/* RM0008 7.3.2: 1110 and 1111 are both 16 times; 7.2.3: the output is 16 to 72 MHz, DS5319 5.3.8: the input 1 to 25. */
static uint32_t f103_pll_hz(struct chip *chip, uint32_t input_hz)
{
    const uint32_t bits = cfgr(chip), code = bits >> 18 & 15;
    const uint32_t fed_hz = is_by_hse(chip) && !(bits >> 17 & 1) ? input_hz : input_hz / 2;
    const uint32_t hz = fed_hz * (code < 14 ? code + 2 : 16);

    check_range(chip, "the PLL's input", fed_hz, 1000000, 25000000);
    check_range(chip, "the PLL's output", hz, 16000000, 72000000);
    return hz;
}

static bool is_ready(struct chip *chip, enum source source)
{
    const struct chip_clocks *clocks = &chip->clocks;

    switch (source) {
    case SOURCE_HSI:
        return cr(chip) & HSI_ON || chip->now_ps < clocks->hsi_stops_ps;
    case SOURCE_HSE:
        return cr(chip) & HSE_ON ? chip->now_ps >= clocks->hse_ready_ps : chip->now_ps < clocks->hse_stops_ps;
    default:
        return cr(chip) & PLL_ON ? chip->now_ps >= clocks->pll_ready_ps : chip->now_ps < clocks->pll_stops_ps;
    }
}

static void start_pll(struct chip *chip)
{
    struct chip_clocks *clocks = &chip->clocks;
    const bool by_hse = is_by_hse(chip), is_fed = is_ready(chip, by_hse ? SOURCE_HSE : SOURCE_HSI);
    const uint32_t input_hz = by_hse ? chip->setting.hse_hz : part(chip)->hsi_hz;

    if (!is_fed) chip_complain(chip, RULE_PLL_SOURCE, "%s is not ready", by_hse ? "HSE" : "HSI");
    clocks->pll_hz = chip->kind == CHIP_F405 ? f405_pll_hz(chip, input_hz) : f103_pll_hz(chip, input_hz);
    clocks->pll_ready_ps =
        is_fed && clocks->pll_hz && !chip->setting.pll_fails ? chip->now_ps + PLL_LOCK_PS : CHIP_NEVER;
}

static void start_hse(struct chip *chip)
{
    const uint32_t hz = chip->setting.hse_hz;

    if (hz && (hz < part(chip)->hse_min_hz || hz > part(chip)->hse_max_hz))
        chip_complain(chip, RULE_CRYSTAL, "a crystal of %u Hz", (unsigned)hz);
    chip->clocks.hse_ready_ps = hz ? chip->now_ps + HSE_START_PS : CHIP_NEVER;
}

/* What runs by what: RM0090 figure 21, RM0008 figure 8. */
static bool is_used(struct chip *chip, enum source source)
{
    const unsigned now = chip->clocks.source, next = cfgr(chip) & SW;

    if (now == source || next == source) return true;
    return (now == SOURCE_PLL || next == SOURCE_PLL) && source == (is_by_hse(chip) ? SOURCE_HSE : SOURCE_HSI);
}

static void stop_source(struct chip *chip, enum source source, const char *name, uint64_t *stops_ps)
{
    if (is_used(chip, source))
        chip_complain(chip, RULE_STOP_UNUSED, "%s is stopped, by which the processor runs", name);
    *stops_ps = chip->now_ps + STOP_CYCLES * chip->clocks.cycle_ps;
}

static void control(struct chip *chip, uint32_t before, uint32_t now)
{
    const uint32_t rising = now & ~before, falling = before & ~now;

    if (rising & HSE_ON) start_hse(chip);
    if (rising & PLL_ON) start_pll(chip);
    if (falling & PLL_ON) stop_source(chip, SOURCE_PLL, "the PLL", &chip->clocks.pll_stops_ps);
    if (falling & HSE_ON) stop_source(chip, SOURCE_HSE, "HSE", &chip->clocks.hse_stops_ps);
    if (falling & HSI_ON) stop_source(chip, SOURCE_HSI, "HSI", &chip->clocks.hsi_stops_ps);
}

/* -- Rates -- */

static uint32_t source_hz(struct chip *chip, unsigned source)
{
    if (source == SOURCE_HSE) return chip->setting.hse_hz;
    return source == SOURCE_PLL ? chip->clocks.pll_hz : part(chip)->hsi_hz;
}

/* 0xxx: 1; 1000 .. 1011: 2 .. 16; 1100 .. 1111: 64 .. 512. */
static uint32_t ahb_divider(uint32_t bits)
{
    const uint32_t code = bits >> HPRE_SHIFT & 15;
    return code < 8 ? 1 : code < 12 ? 2u << (code - 8) : 64u << (code - 12);
}

/* 0xx: 1; 100 .. 111: 2 .. 16. */
static uint32_t apb_divider(uint32_t bits, unsigned shift)
{
    const uint32_t code = bits >> shift & 7;
    return code < 4 ? 1 : 2u << (code - 4);
}

static void check_most(struct chip *chip, const char *bus, uint32_t hz, uint32_t most_hz)
{
    if (hz > most_hz)
        chip_complain(chip, RULE_BUS_RATE, "%s has %u Hz, %u at most", bus, (unsigned)hz, (unsigned)most_hz);
}

static void check_wait_states(struct chip *chip)
{
    const uint32_t hz = chip->clocks.hclk_hz, needed = (hz - 1) / part(chip)->wait_state_hz;

    if ((acr(chip) & ACR_LATENCY) < needed)
        chip_complain(chip, RULE_WAIT_STATES, "%u wait states at %u Hz, which wants %u",
                      (unsigned)acr(chip) & ACR_LATENCY, (unsigned)hz, (unsigned)needed);
}

static void check_voltage(struct chip *chip)
{
    struct chip_block *pwr = chip_find(chip, "PWR");

    if (pwr && chip->clocks.hclk_hz > 144000000 && !(chip_value(pwr, 0) & PWR_VOS))
        chip_complain(chip, RULE_VOLTAGE, "%u Hz at scale 2", (unsigned)chip->clocks.hclk_hz);
}

static void set_rates(struct chip *chip)
{
    struct chip_clocks *clocks = &chip->clocks;
    const uint32_t bits = cfgr(chip), before_hz = clocks->hclk_hz;

    clocks->sysclk_hz = source_hz(chip, clocks->source);
    clocks->hclk_hz = clocks->sysclk_hz / ahb_divider(bits);
    clocks->apb1_hz = clocks->hclk_hz / apb_divider(bits, part(chip)->ppre1_shift);
    clocks->apb2_hz = clocks->hclk_hz / apb_divider(bits, part(chip)->ppre2_shift);
    clocks->cycle_ps = PS_PER_S / clocks->hclk_hz;
    check_most(chip, "the processor", clocks->hclk_hz, part(chip)->hclk_max_hz);
    check_most(chip, "APB1", clocks->apb1_hz, part(chip)->apb1_max_hz);
    check_most(chip, "APB2", clocks->apb2_hz, part(chip)->apb2_max_hz);
    if (clocks->hclk_hz > before_hz && !clocks->wait_states_are_read)
        chip_complain(chip, RULE_WAIT_STATES_READ, "FLASH_ACR was written, and not read");
    check_wait_states(chip);
    check_voltage(chip);
}

/* The processor goes on by what it had, until the selected clock is ready. */
static void select_source(struct chip *chip, unsigned source)
{
    struct chip_clocks *clocks = &chip->clocks;

    clocks->switch_is_read = false;
    clocks->switch_ps = chip->now_ps + SWITCH_CYCLES * clocks->cycle_ps;
    if (source > SOURCE_PLL || !is_ready(chip, source)) {
        chip_complain(chip, RULE_SWITCH_READY, "SW is %u", source);
        const uint64_t ready_ps = source == SOURCE_HSE   ? clocks->hse_ready_ps
                                  : source == SOURCE_PLL ? clocks->pll_ready_ps
                                                         : CHIP_NEVER;
        clocks->switch_ps = ready_ps > clocks->switch_ps ? ready_ps : clocks->switch_ps;
    }
    chip_wake(chip, clocks->switch_ps);
}

static void configure(struct chip *chip, uint32_t before, uint32_t now)
{
    const uint32_t dividers = 0xFu << HPRE_SHIFT | 7u << part(chip)->ppre1_shift | 7u << part(chip)->ppre2_shift;

    if ((before ^ now) & dividers) set_rates(chip);
    if ((before ^ now) & SW) select_source(chip, now & SW);
}

void clocks_run(struct chip *chip)
{
    struct chip_clocks *clocks = &chip->clocks;

    if (clocks->switch_ps > chip->now_ps) {
        chip_wake(chip, clocks->switch_ps);
        return;
    }
    clocks->switch_ps = CHIP_NEVER;
    clocks->source = cfgr(chip) & SW;
    set_rates(chip);
}

void clocks_check_settled(struct chip *chip)
{
    if (!chip->clocks.switch_is_read) chip_complain(chip, RULE_SWITCH_READ, "SW was written");
}

void clocks_start(struct chip *chip)
{
    struct chip_clocks *clocks = &chip->clocks;

    clocks->hse_ready_ps = clocks->pll_ready_ps = clocks->switch_ps = CHIP_NEVER;
    clocks->switch_is_read = clocks->wait_states_are_read = true;
    set_rates(chip);
}

/* -- Registers -- */

static void rcc_before_write(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t value)
{
    const uint32_t changed = chip_value(block, offset) ^ value;
    const uint32_t pll_bits = chip->kind == CHIP_F405 ? (offset == 4 ? UINT32_MAX : 0) : offset == 4 ? 0x3Fu << 16 : 0;

    if (changed & pll_bits && cr(chip) & PLL_ON) chip_complain(chip, RULE_PLL_STOPPED, "the PLL is on");
}

static void rcc_after_write(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t before,
                            uint32_t value)
{
    const uint32_t now = chip_value(block, offset);

    if (offset == 0) control(chip, before, now);
    if (offset == part(chip)->cfgr) configure(chip, before, now);
    for (unsigned i = 0; i < 3; i++) {
        if (offset == part(chip)->enables[i]) chip_switch_clocks(chip, offset, now);
        if (offset && offset == part(chip)->resets[i]) chip_reset_blocks(chip, offset, value);
    }
}

static uint32_t rcc_read(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t stored)
{
    struct chip_clocks *clocks = &chip->clocks;

    (void)block;
    if (offset == 0)
        return stored | (uint32_t)is_ready(chip, SOURCE_HSI) << 1 | (uint32_t)is_ready(chip, SOURCE_HSE) << 17 |
               (uint32_t)is_ready(chip, SOURCE_PLL) << 25;
    if (offset == part(chip)->cfgr) {
        if (clocks->source == (stored & SW)) clocks->switch_is_read = true;
        return stored | clocks->source << SWS_SHIFT;
    }
    chip_read_clocks(chip, offset);
    return stored;
}

static void flash_before_write(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t value)
{
    const uint32_t changed = chip_value(block, offset) ^ value;

    if (offset == 0 && chip->kind == CHIP_F103 && changed & ACR_PRFTBE &&
        (chip->clocks.sysclk_hz > 24000000 || chip->clocks.sysclk_hz != chip->clocks.hclk_hz))
        chip_complain(chip, RULE_PREFETCH, "at %u Hz", (unsigned)chip->clocks.sysclk_hz);
}

static void flash_after_write(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t before,
                              uint32_t value)
{
    (void)block;
    if ((before ^ value) & ACR_LATENCY) chip->clocks.wait_states_are_read = false;
    if (offset == 0) check_wait_states(chip);
}

static uint32_t flash_read(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t stored)
{
    (void)block, (void)offset;
    chip->clocks.wait_states_are_read = true;
    return chip->kind == CHIP_F103 ? stored | (stored & ACR_PRFTBE) << 1 : stored;
}

static void pwr_after_write(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t before,
                            uint32_t value)
{
    (void)block, (void)offset, (void)before, (void)value;
    check_voltage(chip);
}

#define COUNT(table) (sizeof(table) / sizeof(table)[0])

static const struct chip_register f405_rcc_registers[] = {
    {0x00, 0x00000081, 0x0F0FFFFB, 0x050D00F9}, /* CR */
    {0x04, 0x24003010, 0x0F437FFF, 0x0F437FFF}, /* PLLCFGR */
    {0x08, 0x00000000, 0xFFFFFCFF, 0xFFFFFCF3}, /* CFGR */
    {0x10, 0x00000000, 0x226011FF, 0x226011FF}, /* AHB1RSTR */
    {0x20, 0x00000000, 0x36FEC9FF, 0x36FEC9FF}, /* APB1RSTR */
    {0x24, 0x00000000, 0x00075933, 0x00075933}, /* APB2RSTR */
    {0x30, 0x00100000, 0x7E7411FF, 0x7E7411FF}, /* AHB1ENR */
    {0x40, 0x00000000, 0x36FEC9FF, 0x36FEC9FF}, /* APB1ENR */
    {0x44, 0x00000000, 0x00075F33, 0x00075F33}, /* APB2ENR */
};

static const struct chip_register f103_rcc_registers[] = {
    {0x00, 0x00000081, 0x030FFFFB, 0x010D00F9}, /* CR */
    {0x04, 0x00000000, 0x077FFFFF, 0x077FFFF3}, /* CFGR */
    {0x0C, 0x00000000, 0x00005E7D, 0x00005E7D}, /* APB2RSTR */
    {0x10, 0x00000000, 0x1AE64807, 0x1AE64807}, /* APB1RSTR */
    {0x14, 0x00000014, 0x00000055, 0x00000055}, /* AHBENR */
    {0x18, 0x00000000, 0x00005E7D, 0x00005E7D}, /* APB2ENR */
    {0x1C, 0x00000000, 0x1AE64807, 0x1AE64807}, /* APB1ENR */
};

static const struct chip_register f405_flash_registers[] = {{0x00, 0, 0x00001F07, 0x00001F07}};
static const struct chip_register f103_flash_registers[] = {{0x00, 0x30, 0x0000003F, 0x0000001F}};
static const struct chip_register f405_pwr_registers[] = {{0x00, 0x4000, 0x000043FF, 0x000043F3}};

#define RCC_LAYOUT(at, table)                                                                                          \
    {                                                                                                                  \
        .name = "RCC", .base = (at), .registers = (table), .n_registers = COUNT(table),                                \
        .before_write = rcc_before_write, .after_write = rcc_after_write, .read = rcc_read                             \
    }
#define FLASH_LAYOUT(at, table)                                                                                        \
    {                                                                                                                  \
        .name = "FLASH", .base = (at), .registers = (table), .n_registers = COUNT(table),                              \
        .before_write = flash_before_write, .after_write = flash_after_write, .read = flash_read                       \
    }

static const struct chip_layout f405_rcc = RCC_LAYOUT(0x40023800, f405_rcc_registers);
static const struct chip_layout f103_rcc = RCC_LAYOUT(0x40021000, f103_rcc_registers);
static const struct chip_layout f405_flash = FLASH_LAYOUT(0x40023C00, f405_flash_registers);
static const struct chip_layout f103_flash = FLASH_LAYOUT(0x40022000, f103_flash_registers);
static const struct chip_layout f405_pwr = {
    .name = "PWR",
    .base = 0x40007000,
    .enable_word = 0x40,
    .reset_word = 0x20,
    .enable_bit = 28,
    .registers = f405_pwr_registers,
    .n_registers = COUNT(f405_pwr_registers),
    .after_write = pwr_after_write,
};

const struct chip_layout *const chip_clock_layouts[CHIP_KINDS][4] = {
    [CHIP_F405] = {&f405_rcc, &f405_flash, &f405_pwr},
    [CHIP_F103] = {&f103_rcc, &f103_flash},
};
