/* SPDX-License-Identifier: MIT
 *
 * An STM32F405 or STM32F103 without its processor: clocks, flash's wait states, pins, SPI1 and, in the F405, DMA2, as
 * far as a program uses them that sends to a display. Registers behave as the reference manual says, take their time,
 * and whoever breaks one of its rules (stm32_rules.h) is told on. What is not modelled complains, too: nothing is
 * ignored in silence.
 *
 * The chip has no clock of its own: who runs the processor says how far time goes on, then reads and writes. */
#ifndef SIM_EMULATORS_STM32_CHIP_H
#define SIM_EMULATORS_STM32_CHIP_H

#include "stm32_rules.h"

#include <stdbool.h>
#include <stdint.h>

#define CHIP_NEVER UINT64_MAX

enum { CHIP_BLOCKS = 20, CHIP_BLOCK_WORDS = 64, CHIP_WIRES = 8, CHIP_STREAMS = 8, CHIP_FIFO = 16 };

/* What the chip is joined to. */
struct chip_world {
    void *ctx;
    void (*complain)(void *ctx, enum chip_rule rule, const char *what);
    void (*byte)(void *ctx, uint8_t byte);                       /* its last bit has left MOSI */
    void (*level)(void *ctx, unsigned wire, bool high);          /* of a wire that is driven, and changed */
    bool (*memory)(void *ctx, uint32_t address, uint8_t *value); /* false: nothing is there */
};

/* A wire at a pin. */
struct chip_wire {
    uint32_t port; /* base address of its GPIO */
    uint8_t bit;
    bool is_display; /* D/C, select or reset: moves only while the SPI rests */
    bool is_needed;  /* D/C or select: is driven before a byte is sent */
    bool driven, high;
};

/* How the chip is built in; 0 for what is usual. */
struct chip_setting {
    uint32_t hse_hz;     /* crystal; 0: there is none, or it does not start */
    bool pll_fails;      /* the PLL never locks */
    uint32_t panel_hz;   /* the fastest clock that the display takes; 0: not known */
    uint64_t stop_after; /* bytes, after which the SPI stops; 0: never */
    uint32_t stop_for;   /* starts of the SPI that do not help */
};

struct chip_block {
    const struct chip_layout *layout;
    uint32_t values[CHIP_BLOCK_WORDS];
    uint64_t on_since_ps; /* its clock; CHIP_NEVER: it is off */
    bool on_is_read;      /* its clock's bit was read back */
};

struct chip_clocks {
    uint64_t hse_ready_ps, pll_ready_ps; /* CHIP_NEVER: not by itself */
    uint64_t hsi_stops_ps, hse_stops_ps, pll_stops_ps;
    uint32_t sysclk_hz, hclk_hz, apb1_hz, apb2_hz, pll_hz;
    unsigned source; /* SWS */
    uint64_t switch_ps;
    bool switch_is_read, wait_states_are_read;
    uint64_t cycle_ps;
};

struct chip_spi {
    bool full; /* the data register has a value: TXE is 0 */
    uint16_t data, shifting;
    bool busy;                       /* BSY */
    bool request;                    /* of DMA, until it is acknowledged */
    bool rxne, ovr;                  /* what is received nobody reads */
    bool empty_is_read, end_is_read; /* SR told TXE since the last data, and then that BSY is 0 */
    uint64_t load_ps;                /* the data register's value goes to the shift register; CHIP_NEVER: does not */
    uint64_t end_ps;                 /* the last bit has left */
    uint64_t bytes;                  /* that have left */
    uint32_t hz;                     /* SCK's rate */
    bool stopped;                    /* and does not go on */
    uint32_t restarts;               /* since it stopped */
};

struct chip_stream {
    bool ending;          /* EN was cleared by the program, and is 1 still */
    bool off_is_read;     /* EN was read as 0 since it was 1 */
    uint64_t off_ps;      /* when EN becomes 0 */
    uint64_t serve_ps;    /* when the request is served */
    uint32_t count, left; /* items: at the start, and not yet read from memory */
    uint32_t from;        /* the next item in memory */
    uint8_t fifo[CHIP_FIFO];
    uint8_t fifo_first, fifo_n, fifo_depth;
};

struct chip {
    enum chip_kind kind;
    struct chip_setting setting;
    struct chip_world world;
    uint64_t now_ps, next_ps; /* nothing happens by itself before next_ps */
    unsigned n_blocks, n_wires;
    struct chip_block blocks[CHIP_BLOCKS];
    struct chip_wire wires[CHIP_WIRES];
    struct chip_clocks clocks;
    struct chip_spi spi;
    struct chip_stream streams[CHIP_STREAMS];
    uint64_t tick_from_ps; /* SysTick was 0 */
};

/* After power on. The caller adds wires. */
void chip_init(struct chip *chip, enum chip_kind kind, const struct chip_setting *setting,
               const struct chip_world *world);

/* Further names are refused: false. */
bool chip_add_wire(struct chip *chip, const struct chip_wire *wire);

/* The processor runs for so many cycles. */
void chip_run(struct chip *chip, uint32_t cycles);

/* Of width_b bytes: 1, 2 or 4. */
uint32_t chip_read(struct chip *chip, uint32_t address, unsigned width_b);
void chip_write(struct chip *chip, uint32_t address, uint32_t value, unsigned width_b);

#endif
