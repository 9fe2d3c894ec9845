/* SPDX-License-Identifier: MIT
 *
 * Microchip's MCP2210, a USB-HID bridge to SPI, emulated from its datasheet (DS22288A): a report of 64 bytes in, its
 * answer out, and on the other side SPI bytes and pin levels for an emulated display. What the datasheet does not allow
 * is complained about, counted and described. It knows nothing of hal/hid/'s tables. Not modelled: EEPROM, NVRAM, the
 * event counter of GP6, and the hand-over of the bus to another master but for its refusals. */
#ifndef SIM_EMULATED_MCP2210_H
#define SIM_EMULATED_MCP2210_H

#include "bus.h"

enum { EMULATED_MCP2210_PINS = 9, EMULATED_MCP2210_REPORT_B = 64, EMULATED_MCP2210_UNWIRED = 255 };

enum emulated_mcp2210_complaint {
    BRIDGE_UNKNOWN_COMMAND, /* not in the datasheet, or not modelled here */
    BRIDGE_RESERVED,        /* a reserved byte is not zero */
    BRIDGE_NVRAM,           /* what outlives a power-down was to be written */
    BRIDGE_VALUE,           /* a setting out of its range */
    BRIDGE_TOO_LONG,        /* more than 60 bytes in a report */
    BRIDGE_TRANSACTION,     /* more bytes than the transaction has left, or none to begin it with */
    BRIDGE_BUSY,            /* settings or pins changed while a transaction is under way */
    BRIDGE_NOT_GPIO,        /* a level for a pin with another function */
    BRIDGE_NOT_OUTPUT,      /* a level for an input */
    BRIDGE_NOT_SELECTED,    /* bytes that no display takes, because chip select is not low */
    BRIDGE_COMPLAINTS
};

struct emulated_mcp2210 {
    /* How it is wired, to be filled in after init. */
    struct bus spi;                         /* gets what is sent */
    struct pin pins[EMULATED_MCP2210_PINS]; /* what GPn drives; those that drive nothing: zero */
    uint8_t select;                         /* the display's chip select; EMULATED_MCP2210_UNWIRED: always low */

    /* Moods. */
    unsigned busy_every; /* each so many-th transfer is refused with 0xF8; 0: none */
    bool bus_taken;      /* another master has the bus: transfers are refused with 0xF7 */

    /* To be read: registers. */
    uint8_t functions[EMULATED_MCP2210_PINS]; /* 0 GPIO, 1 chip select, 2 dedicated */
    uint16_t levels, inputs;                  /* a bit a pin */
    uint8_t other_settings;
    uint32_t bit_rate_hz;
    uint16_t idle_selects, active_selects;
    uint16_t delays[3];     /* chip select to data, data to chip select, between data; in 100 us */
    uint16_t transaction_b; /* bytes between two edges of chip select */
    uint8_t mode;

    /* To be read: what happens. */
    bool running;        /* a transaction: from its first bytes to the answer that tells its end */
    uint16_t left_b;     /* of it */
    uint8_t received_b;  /* for the next answer */
    uint16_t driven;     /* pins that drive something, */
    uint16_t driven_low; /* and low */
    unsigned long commands[256], transfers, transactions;
    uint64_t bus_b;
    unsigned complaints, complaints_of[BRIDGE_COMPLAINTS];
    char complaint[96]; /* the last one */
};

/* As it is after power-up, set up for something else: all pins have dedicated functions. Nothing is wired. */
void emulated_mcp2210_init(struct emulated_mcp2210 *chip);

/* The same chip with its wires and moods, after another power-up. */
void emulated_mcp2210_power_up(struct emulated_mcp2210 *chip);

/* One report without its number, and the answer to it, which there always is; both of EMULATED_MCP2210_REPORT_B bytes.
 */
bool emulated_mcp2210_answer(void *chip, const uint8_t *report, uint8_t *answer);

#endif
