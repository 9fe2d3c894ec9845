/* SPDX-License-Identifier: MIT
 *
 * The emulated chip's parts among themselves. Every part has what it does before a write counts, what it does after,
 * and what a read tells beside the stored value. */
#ifndef SIM_EMULATORS_STM32_PARTS_H
#define SIM_EMULATORS_STM32_PARTS_H

#include "stm32_chip.h"

/* One register: what it holds after a reset, and which of its bits mean something. All others keep their reset value.
 * `keeps` are the bits that a write sets; the rest of `known` is set by the chip, or does something and is gone. */
struct chip_register {
    uint8_t offset;
    uint32_t reset, known, keeps;
};

struct chip_layout {
    const char *name;
    uint32_t base;
    uint8_t enable_word, enable_bit; /* RCC's register, and the bit that is its clock's; 0: it has one always */
    uint8_t reset_word;
    const struct chip_register *registers;
    unsigned n_registers;
    void (*before_write)(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t value);
    void (*after_write)(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t before, uint32_t value);
    uint32_t (*read)(struct chip *chip, struct chip_block *block, uint32_t offset, uint32_t stored);
    void (*restart)(struct chip *chip); /* RCC resets it */
};

/* `what` is completed as printf() does. */
void chip_complain(struct chip *chip, enum chip_rule rule, const char *what, ...) __attribute__((format(printf, 3, 4)));

struct chip_block *chip_find(struct chip *chip, const char *name);
static inline uint32_t chip_value(const struct chip_block *block, uint32_t offset)
{
    return block->values[offset / 4];
}

/* What RCC does to blocks, by the registers that it has for that. */
void chip_switch_clocks(struct chip *chip, uint32_t rcc_word, uint32_t enabled);
void chip_read_clocks(struct chip *chip, uint32_t rcc_word);
void chip_reset_blocks(struct chip *chip, uint32_t rcc_word, uint32_t bits);

/* Something happens by itself at that time. */
static inline void chip_wake(struct chip *chip, uint64_t at_ps)
{
    if (at_ps < chip->next_ps) chip->next_ps = at_ps;
}

/* stm32_chip_clocks.c */
extern const struct chip_layout *const chip_clock_layouts[CHIP_KINDS][4]; /* RCC, flash, regulator */
void clocks_start(struct chip *chip);
void clocks_run(struct chip *chip);
void clocks_check_settled(struct chip *chip); /* before somebody counts by them */

/* stm32_chip_pins.c */
extern const struct chip_layout *const chip_pin_layouts[CHIP_KINDS][8];
void pins_before_byte(struct chip *chip); /* what must be so when a byte is sent */
void pins_for_spi(struct chip *chip);     /* what must be so when the SPI is enabled */
void pins_update(struct chip *chip);      /* levels that changed are told */

/* stm32_chip_spi.c */
extern const struct chip_layout *const chip_spi_layouts[CHIP_KINDS];
void spi_start(struct chip *chip);
void spi_run(struct chip *chip);
void spi_take(struct chip *chip, uint16_t value); /* a write to its data register, from wherever */
bool spi_is_idle(const struct chip *chip);
bool spi_end_is_read(const struct chip *chip); /* the program knows that it is */
bool spi_asks(const struct chip *chip);        /* for DMA */
void spi_check_off(struct chip *chip, const char *why);

/* stm32_chip_dma.c */
extern const struct chip_layout chip_dma_layout;
void dma_start(struct chip *chip);
void dma_run(struct chip *chip);
bool dma_is_idle(const struct chip *chip);
void dma_asked(struct chip *chip); /* SPI1 asks for an item */
void dma_peripheral_stops(struct chip *chip, const char *why);

#endif
