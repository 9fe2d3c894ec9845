/* SPDX-License-Identifier: MIT
 *
 * What the maker's manuals ask of a program that sets registers of an STM32F405 or STM32F103: one name a rule, with
 * where it is written. The emulated chip (stm32_chip.h) looks; here is what it says. */
#ifndef SIM_EMULATORS_STM32_RULES_H
#define SIM_EMULATORS_STM32_RULES_H

enum chip_kind { CHIP_F405, CHIP_F103, CHIP_KINDS };

enum chip_rule {
    RULE_MODELLED,
    RULE_WIDTH,
    RULE_RESERVED,
    RULE_CLOCK_ON,
    RULE_CLOCK_DELAY,
    RULE_CRYSTAL,
    RULE_PLL_STOPPED,
    RULE_PLL_SOURCE,
    RULE_PLL_RANGE,
    RULE_SWITCH_READY,
    RULE_SWITCH_READ,
    RULE_STOP_UNUSED,
    RULE_WAIT_STATES,
    RULE_WAIT_STATES_READ,
    RULE_PREFETCH,
    RULE_BUS_RATE,
    RULE_VOLTAGE,
    RULE_DEBUG_PINS,
    RULE_PIN_IDLE,
    RULE_END_READ,
    RULE_PIN_DRIVEN,
    RULE_SPI_PINS,
    RULE_SPI_EDGES,
    RULE_SPI_RATE,
    RULE_SPI_ORDER,
    RULE_SPI_SELECTED,
    RULE_SPI_DIRECTION,
    RULE_SPI_ENABLED,
    RULE_SPI_EMPTY,
    RULE_SPI_IDLE,
    RULE_DMA_STOPPED,
    RULE_DMA_READ,
    RULE_DMA_FLAGS,
    RULE_DMA_REQUEST,
    RULE_DMA_COUNT,
    RULE_DMA_WIDTH,
    RULE_DMA_TARGET,
    RULE_DMA_MEMORY,
    RULE_DMA_FIRST,
    RULES
};

struct chip_rule_text {
    const char *source[CHIP_KINDS]; /* manual and section; NULL: this chip has nothing to which it applies */
    const char *text;               /* what is asked */
};

extern const struct chip_rule_text chip_rules[RULES];

#endif
