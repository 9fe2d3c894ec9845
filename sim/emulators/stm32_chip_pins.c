/* SPDX-License-Identifier: MIT
 *
 * Ports: which pins are driven, and by whom. RM0090 8.4, RM0008 9.2. */
#include "stm32_parts.h"

#include <stddef.h>

enum pin_use { PIN_OTHER, PIN_OUTPUT, PIN_ALTERNATE };

struct pin_state {
    enum pin_use use;
    unsigned function; /* AF0 .. AF15; an F103's pin has one alone */
    uint32_t most_hz;
};

enum { F4_MODER = 0x00, F4_OSPEEDR = 0x08, F4_ODR = 0x14, F4_BSRR = 0x18, F4_AFRL = 0x20 };
enum { F1_CRL = 0x00, F1_ODR = 0x0C, F1_BSRR = 0x10, F1_BRR = 0x14 };
enum { SPI1_FUNCTION = 5 };

/* DS8626 5.3.16: at 2.7 V and more. */
static struct pin_state f405_state(const struct chip_block *port, unsigned bit)
{
    static const uint32_t most_hz[4] = {4000000, 25000000, 50000000, 100000000};
    const uint32_t mode = chip_value(port, F4_MODER) >> 2 * bit & 3;
    const uint32_t function = chip_value(port, F4_AFRL + bit / 8 * 4) >> bit % 8 * 4 & 15;

    return (struct pin_state){.use = mode == 1   ? PIN_OUTPUT
                                     : mode == 2 ? PIN_ALTERNATE
                                                 : PIN_OTHER,
                              .function = function,
                              .most_hz = most_hz[chip_value(port, F4_OSPEEDR) >> 2 * bit & 3]};
}

/* RM0008 9.2.1: MODE is 0 of an input, else the edges; CNF 2 and 3 are a peripheral's. */
static struct pin_state f103_state(const struct chip_block *port, unsigned bit)
{
    static const uint32_t most_hz[4] = {0, 10000000, 2000000, 50000000};
    const uint32_t bits = chip_value(port, F1_CRL + bit / 8 * 4) >> bit % 8 * 4 & 15;

    return (struct pin_state){.use = !(bits & 3) ? PIN_OTHER
                                     : bits >> 3 ? PIN_ALTERNATE
                                                 : PIN_OUTPUT,
                              .function = SPI1_FUNCTION,
                              .most_hz = most_hz[bits & 3]};
}

static struct chip_block *find_port(struct chip *chip, uint32_t base)
{
    for (unsigned i = 0; i < chip->n_blocks; i++)
        if (chip->blocks[i].layout->base == base) return &chip->blocks[i];
    return NULL;
}

static struct pin_state state_of(struct chip *chip, const struct chip_block *port, unsigned bit)
{
    return chip->kind == CHIP_F405 ? f405_state(port, bit) : f103_state(port, bit);
}

/* -- The display's wires -- */

static void check_rest(struct chip *chip, const struct chip_block *port, unsigned bit)
{
    if (!spi_is_idle(chip) || !dma_is_idle(chip))
        chip_complain(chip, RULE_PIN_IDLE, "%s bit %u", port->layout->name, bit);
    else if (!spi_end_is_read(chip))
        chip_complain(chip, RULE_END_READ, "%s bit %u", port->layout->name, bit);
}

static void update_wire(struct chip *chip, unsigned index)
{
    struct chip_wire *wire = &chip->wires[index];
    const struct chip_block *port = find_port(chip, wire->port);
    const bool driven = port && state_of(chip, port, wire->bit).use == PIN_OUTPUT;
    const bool high = port && chip_value(port, chip->kind == CHIP_F405 ? F4_ODR : F1_ODR) >> wire->bit & 1;

    if (driven && (high != wire->high || !wire->driven)) {
        if (wire->driven && wire->is_display) check_rest(chip, port, wire->bit);
        chip->world.level(chip->world.ctx, index, high);
    }
    wire->driven = driven;
    wire->high = high;
}

void pins_update(struct chip *chip)
{
    for (unsigned i = 0; i < chip->n_wires; i++)
        update_wire(chip, i);
}

void pins_before_byte(struct chip *chip)
{
    for (unsigned i = 0; i < chip->n_wires; i++)
        if (chip->wires[i].is_needed && !chip->wires[i].driven)
            chip_complain(chip, RULE_PIN_DRIVEN, "port 0x%08X bit %u", (unsigned)chip->wires[i].port,
                          chip->wires[i].bit);
}

/* -- The SPI's pins -- */

/* Either of two pins, of which an F103 has the first, unless it is mapped anew. */
static void check_spi_pin(struct chip *chip, const char *name, unsigned bit_a, unsigned bit_b, uint32_t hz)
{
    struct chip_block *const ports[2] = {chip_find(chip, "GPIOA"), chip_find(chip, "GPIOB")};
    const unsigned bits[2] = {bit_a, bit_b};

    for (unsigned i = 0; i < (chip->kind == CHIP_F405 ? 2 : 1); i++) {
        const struct pin_state state = state_of(chip, ports[i], bits[i]);
        if (state.use != PIN_ALTERNATE || state.function != SPI1_FUNCTION) continue;
        if (hz > state.most_hz)
            chip_complain(chip, RULE_SPI_EDGES, "%s has %u Hz, its pin %u at most", name, (unsigned)hz,
                          (unsigned)state.most_hz);
        return;
    }
    chip_complain(chip, RULE_SPI_PINS, "no pin is %s", name);
}

/* The data line changes once a bit, SCK twice. */
void pins_for_spi(struct chip *chip)
{
    check_spi_pin(chip, "SCK", 5, 3, chip->spi.hz);
    check_spi_pin(chip, "MOSI", 7, 5, chip->spi.hz / 2);
}

/* -- Registers -- */

static void set_and_reset(struct chip_block *block, uint32_t odr, uint32_t set, uint32_t reset)
{
    block->values[odr / 4] = (block->values[odr / 4] & ~reset) | set;
}

static void f405_after_write(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t before,
                             uint32_t value)
{
    (void)before;
    if (offset == F4_BSRR) set_and_reset(block, F4_ODR, value & 0xFFFF, value >> 16);
    if (block->layout->base == 0x40020000 && offset == F4_MODER && (value >> 26 & 15) != 10)
        chip_complain(chip, RULE_DEBUG_PINS, "PA13 or PA14 is no longer the debug port's");
    pins_update(chip);
}

static void f103_after_write(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t before,
                             uint32_t value)
{
    (void)before;
    if (offset == F1_BSRR) set_and_reset(block, F1_ODR, value & 0xFFFF, value >> 16);
    if (offset == F1_BRR) set_and_reset(block, F1_ODR, 0, value & 0xFFFF);
    pins_update(chip);
}

static void restart(struct chip *chip)
{
    pins_update(chip);
}

#define F405_PORT_REGISTERS(moder, ospeedr, pupdr)                                                                     \
    {                                                                                                                  \
        {0x00, (moder), UINT32_MAX, UINT32_MAX}, {0x04, 0, 0xFFFF, 0xFFFF}, {0x08, (ospeedr), UINT32_MAX, UINT32_MAX}, \
            {0x0C, (pupdr), UINT32_MAX, UINT32_MAX}, {0x10, 0, 0xFFFF, 0}, {0x14, 0, 0xFFFF, 0xFFFF},                  \
            {0x18, 0, UINT32_MAX, 0}, {0x20, 0, UINT32_MAX, UINT32_MAX},                                               \
        {                                                                                                              \
            0x24, 0, UINT32_MAX, UINT32_MAX                                                                            \
        }                                                                                                              \
    }
#define PORT(letter, at, table, enable, reset, bit, after)                                                             \
    {                                                                                                                  \
        .name = "GPIO" letter, .base = (at), .enable_word = (enable), .reset_word = (reset), .enable_bit = (bit),      \
        .registers = (table), .n_registers = sizeof(table) / sizeof(table)[0], .after_write = (after),                 \
        .restart = restart                                                                                             \
    }

/* RM0090 8.4.1 to 8.4.4: pins of the debug port are its own after a reset. */
static const struct chip_register f405_port_a[] = F405_PORT_REGISTERS(0xA8000000, 0x0C000000, 0x64000000);
static const struct chip_register f405_port_b[] = F405_PORT_REGISTERS(0x00000280, 0x000000C0, 0x00000100);
static const struct chip_register f405_port[] = F405_PORT_REGISTERS(0, 0, 0);
static const struct chip_register f103_port[] = {
    {0x00, 0x44444444, UINT32_MAX, UINT32_MAX},
    {0x04, 0x44444444, UINT32_MAX, UINT32_MAX},
    {0x08, 0, 0xFFFF, 0},
    {0x0C, 0, 0xFFFF, 0xFFFF},
    {0x10, 0, UINT32_MAX, 0},
    {0x14, 0, 0xFFFF, 0},
};

static const struct chip_layout f405_ports[] = {
    PORT("A", 0x40020000, f405_port_a, 0x30, 0x10, 0, f405_after_write),
    PORT("B", 0x40020400, f405_port_b, 0x30, 0x10, 1, f405_after_write),
    PORT("C", 0x40020800, f405_port, 0x30, 0x10, 2, f405_after_write),
    PORT("D", 0x40020C00, f405_port, 0x30, 0x10, 3, f405_after_write),
    PORT("E", 0x40021000, f405_port, 0x30, 0x10, 4, f405_after_write),
};
static const struct chip_layout f103_ports[] = {
    PORT("A", 0x40010800, f103_port, 0x18, 0x0C, 2, f103_after_write),
    PORT("B", 0x40010C00, f103_port, 0x18, 0x0C, 3, f103_after_write),
    PORT("C", 0x40011000, f103_port, 0x18, 0x0C, 4, f103_after_write),
    PORT("D", 0x40011400, f103_port, 0x18, 0x0C, 5, f103_after_write),
};

const struct chip_layout *const chip_pin_layouts[CHIP_KINDS][8] = {
    [CHIP_F405] = {&f405_ports[0], &f405_ports[1], &f405_ports[2], &f405_ports[3], &f405_ports[4]},
    [CHIP_F103] = {&f103_ports[0], &f103_ports[1], &f103_ports[2], &f103_ports[3]},
};
