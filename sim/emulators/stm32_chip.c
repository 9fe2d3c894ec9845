/* SPDX-License-Identifier: MIT
 *
 * Addresses and time: finds the register, asks whether it may be used as it is, and has its part do what it does. */
#include "stm32_parts.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { TICK_CSR = 0x10, TICK_RVR = 0x14, TICK_CVR = 0x18, TICK_MASK = 0xFFFFFF };
enum { WHAT_B = 160 };

void chip_complain(struct chip *chip, enum chip_rule rule, const char *what, ...)
{
    char text[WHAT_B];
    va_list arguments;

    va_start(arguments, what);
    (void)vsnprintf(text, sizeof text, what, arguments);
    va_end(arguments);
    chip->world.complain(chip->world.ctx, rule, text);
}

struct chip_block *chip_find(struct chip *chip, const char *name)
{
    for (unsigned i = 0; i < chip->n_blocks; i++)
        if (!strcmp(chip->blocks[i].layout->name, name)) return &chip->blocks[i];
    return NULL;
}

/* -- The processor's own: SysTick, and where the vectors are. Armv7-M Architecture Reference Manual, B3.2 and B3.3. --
 */

static const struct chip_register core_registers[] = {
    {TICK_CSR, 0, 0x10007, 0x7},
    {TICK_RVR, 0, TICK_MASK, TICK_MASK},
    {TICK_CVR, 0, TICK_MASK, 0},
};

static const struct chip_register control_registers[] = {
    {0x08, 0, 0xFFFFFF80, 0xFFFFFF80}, /* VTOR */
    {0x88, 0, 0x00F00000, 0x00F00000}, /* CPACR */
};

static void core_after_write(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t before,
                             uint32_t value)
{
    (void)block, (void)before;
    if (offset == TICK_CVR) chip->tick_from_ps = chip->now_ps;
    if (offset == TICK_CSR && (value & 5) == 1)
        chip_complain(chip, RULE_MODELLED, "SysTick by the eighth of the processor's clock");
    if (offset == TICK_CSR && (value & 2)) chip_complain(chip, RULE_MODELLED, "SysTick's interrupt");
}

/* A cycle's length may have changed since it was 0; programs do not count across that. */
static uint32_t core_read(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t stored)
{
    if (offset != TICK_CVR || !(chip_value(block, TICK_CSR) & 1)) return stored;
    const uint64_t cycles = (chip->now_ps - chip->tick_from_ps) / chip->clocks.cycle_ps;
    const uint64_t period = (uint64_t)chip_value(block, TICK_RVR) + 1;
    return (uint32_t)((period - cycles % period) % period);
}

static const struct chip_layout core_layout = {
    .name = "SysTick",
    .base = 0xE000E000,
    .registers = core_registers,
    .n_registers = sizeof core_registers / sizeof core_registers[0],
    .after_write = core_after_write,
    .read = core_read,
};

static const struct chip_layout control_layout = {
    .name = "SCB",
    .base = 0xE000ED00,
    .registers = control_registers,
    .n_registers = sizeof control_registers / sizeof control_registers[0],
};

/* -- Blocks -- */

static void reset_block(struct chip_block *block)
{
    for (unsigned i = 0; i < block->layout->n_registers; i++)
        block->values[block->layout->registers[i].offset / 4] = block->layout->registers[i].reset;
}

static void add_block(struct chip *chip, const struct chip_layout *layout)
{
    struct chip_block *block = &chip->blocks[chip->n_blocks++];

    *block = (struct chip_block){.layout = layout, .on_since_ps = layout->enable_word ? CHIP_NEVER : 0};
    block->on_is_read = !layout->enable_word;
    reset_block(block);
}

void chip_init(struct chip *chip, enum chip_kind kind, const struct chip_setting *setting,
               const struct chip_world *world)
{
    *chip = (struct chip){.kind = kind, .setting = *setting, .world = *world, .next_ps = CHIP_NEVER};
    for (unsigned i = 0; i < 4 && chip_clock_layouts[kind][i]; i++)
        add_block(chip, chip_clock_layouts[kind][i]);
    for (unsigned i = 0; i < 8 && chip_pin_layouts[kind][i]; i++)
        add_block(chip, chip_pin_layouts[kind][i]);
    add_block(chip, chip_spi_layouts[kind]);
    if (kind == CHIP_F405) add_block(chip, &chip_dma_layout);
    add_block(chip, &core_layout);
    add_block(chip, &control_layout);
    spi_start(chip);
    dma_start(chip);
    clocks_start(chip);
}

bool chip_add_wire(struct chip *chip, const struct chip_wire *wire)
{
    if (chip->n_wires == CHIP_WIRES) return false;
    chip->wires[chip->n_wires++] = *wire;
    return true;
}

/* -- Time -- */

/* Parts wake the chip anew for what comes next. */
static void happen(struct chip *chip)
{
    const uint64_t until_ps = chip->now_ps;

    while (chip->next_ps <= until_ps) {
        chip->now_ps = chip->next_ps;
        chip->next_ps = CHIP_NEVER;
        clocks_run(chip);
        spi_run(chip);
        dma_run(chip);
    }
    chip->now_ps = until_ps;
}

void chip_run(struct chip *chip, uint32_t cycles)
{
    chip->now_ps += cycles * chip->clocks.cycle_ps;
    if (chip->now_ps >= chip->next_ps) happen(chip);
}

/* -- Access -- */

static const struct chip_register *find_register(const struct chip_layout *layout, uint32_t offset)
{
    for (unsigned i = 0; i < layout->n_registers; i++)
        if (layout->registers[i].offset == (offset & ~UINT32_C(3))) return &layout->registers[i];
    return NULL;
}

static struct chip_block *find_block(struct chip *chip, uint32_t address, const struct chip_register **found)
{
    for (unsigned i = 0; i < chip->n_blocks; i++) {
        const struct chip_layout *layout = chip->blocks[i].layout;
        if (address < layout->base || address - layout->base >= 4 * CHIP_BLOCK_WORDS) continue;
        *found = find_register(layout, address - layout->base);
        if (*found) return &chip->blocks[i];
    }
    chip_complain(chip, RULE_MODELLED, "a register at 0x%08X", (unsigned)address);
    return NULL;
}

static bool is_spi(const struct chip_block *block)
{
    return block->layout == chip_spi_layouts[CHIP_F405] || block->layout == chip_spi_layouts[CHIP_F103];
}

static void check_width(struct chip *chip, const struct chip_block *block, uint32_t offset, unsigned width_b)
{
    const unsigned least_b = block->layout == &chip_dma_layout ? 4 : is_spi(block) ? 2 : 1;

    if (width_b < least_b)
        chip_complain(chip, RULE_WIDTH, "%s: %u bytes at once", block->layout->name, width_b);
    else if (offset % 4 || (width_b < 4 && !is_spi(block)))
        chip_complain(chip, RULE_MODELLED, "%s: a part of a register", block->layout->name);
}

/* false: what is written goes nowhere, what is read is 0. */
static bool check_clock(struct chip *chip, struct chip_block *block)
{
    const unsigned delay_cycles = is_spi(block) ? 3 : 2; /* on a bus of half the rate: 1 and the bus' divider */

    if (block->on_since_ps == CHIP_NEVER) {
        chip_complain(chip, RULE_CLOCK_ON, "%s: its clock is off", block->layout->name);
        return false;
    }
    if (chip_rules[RULE_CLOCK_DELAY].source[chip->kind] && !block->on_is_read &&
        chip->now_ps - block->on_since_ps < delay_cycles * chip->clocks.cycle_ps)
        chip_complain(chip, RULE_CLOCK_DELAY, "%s", block->layout->name);
    block->on_is_read = true;
    return true;
}

uint32_t chip_read(struct chip *chip, uint32_t address, unsigned width_b)
{
    const struct chip_register *found = NULL;
    struct chip_block *block = find_block(chip, address, &found);

    if (!block || !check_clock(chip, block)) return 0;
    const uint32_t offset = address - block->layout->base;
    const uint32_t stored = chip_value(block, offset);
    check_width(chip, block, offset, width_b);
    return block->layout->read ? block->layout->read(chip, block, offset, stored) : stored;
}

void chip_write(struct chip *chip, uint32_t address, uint32_t value, unsigned width_b)
{
    const struct chip_register *found = NULL;
    struct chip_block *block = find_block(chip, address, &found);

    if (!block || !check_clock(chip, block)) return;
    const struct chip_layout *layout = block->layout;
    const uint32_t offset = address - layout->base;
    uint32_t *const stored = &block->values[offset / 4];
    const uint32_t before = *stored;
    check_width(chip, block, offset, width_b);
    if ((value ^ found->reset) & ~found->known)
        chip_complain(chip, RULE_RESERVED, "%s: 0x%08X is written at 0x%02X, whose reserved bits are 0x%08X",
                      layout->name, (unsigned)value, (unsigned)offset, (unsigned)(found->reset & ~found->known));
    if (layout->before_write) layout->before_write(chip, block, offset, value);
    *stored = (before & ~found->keeps) | (value & found->keeps);
    if (layout->after_write) layout->after_write(chip, block, offset, before, value);
}

/* -- What RCC does to all blocks -- */

void chip_switch_clocks(struct chip *chip, uint32_t rcc_word, uint32_t enabled)
{
    for (unsigned i = 0; i < chip->n_blocks; i++) {
        struct chip_block *block = &chip->blocks[i];
        if (block->layout->enable_word != rcc_word || !rcc_word) continue;
        const bool on = enabled >> block->layout->enable_bit & 1, was_on = block->on_since_ps != CHIP_NEVER;
        if (on == was_on) continue;
        if (was_on && is_spi(block)) spi_check_off(chip, "its clock stops");
        block->on_since_ps = on ? chip->now_ps : CHIP_NEVER;
        block->on_is_read = false;
    }
}

void chip_read_clocks(struct chip *chip, uint32_t rcc_word)
{
    for (unsigned i = 0; i < chip->n_blocks; i++)
        if (chip->blocks[i].layout->enable_word == rcc_word) chip->blocks[i].on_is_read = true;
}

void chip_reset_blocks(struct chip *chip, uint32_t rcc_word, uint32_t bits)
{
    for (unsigned i = 0; i < chip->n_blocks; i++) {
        struct chip_block *block = &chip->blocks[i];
        if (block->layout->reset_word != rcc_word || !rcc_word || !(bits >> block->layout->enable_bit & 1)) continue;
        if (is_spi(block)) dma_peripheral_stops(chip, "SPI1 is reset");
        reset_block(block);
        if (block->layout->restart) block->layout->restart(chip);
    }
}
