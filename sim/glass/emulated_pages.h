/* SPDX-License-Identifier: MIT
 *
 * Monochrome controllers whose memory is pages, with their glass, emulated from the datasheets: bytes, D/C, reset and
 * waits in; what is on the glass, and complaints about the protocol, out. They share no table with hal/. */
#ifndef SIM_EMULATED_PAGES_H
#define SIM_EMULATED_PAGES_H

#include "glass/emulated_port.h"
#include "glass/glass.h"

enum { EMULATED_PAGES_MAX_W_PX = 132, EMULATED_PAGES_MAX_H_PX = 64, EMULATED_PAGES_MAX_ARGS = 6 };

struct emulated_pages_kind;

/* All kinds, ends with NULL; NULL: there is none of that name. */
extern const struct emulated_pages_kind *const emulated_pages_kinds[];
const struct emulated_pages_kind *emulated_pages_kind_find(const char *name);

/* All of it may be read. */
struct emulated_pages {
    struct emulated_port port; /* for a driver's configuration */
    unsigned complaints;       /* all */
    char complaint[160];       /* text of the last */

    const struct emulated_pages_kind *kind;
    struct glass glass;
    uint64_t ready_us; /* when it listens after a reset */

    /* Registers, and the command under way. */
    uint8_t command, n_args, args_due, args[EMULATED_PAGES_MAX_ARGS]; /* a command that waits for arguments */
    uint8_t page, column;
    bool on, inverted, all_on, columns_flipped, lines_flipped, extended, asleep;
    uint8_t power;                    /* parts of the supply that are on */
    uint64_t power_us;                /* since when */
    uint8_t lines, shift, start_line; /* in use; the first output less; memory's line that the scan starts with */
    uint8_t wiring;                   /* of outputs to sides, as DAh has it */
    bool told_wiring, has_reference;
    uint8_t ratio, level;         /* of the glass's voltage: 20h to 27h or 30h to 33h, and 81h or a PCD8544's Vop */
    uint8_t mode;                 /* how memory is addressed, by its number at an SSD1306 */
    uint8_t columns[2], pages[2]; /* of a window: first and last */
    bool window_full;             /* the last byte went to their end */
    uint8_t memory[EMULATED_PAGES_MAX_H_PX / 8][EMULATED_PAGES_MAX_W_PX]; /* by the glass's wires, not by address */
};

/* Power on: registers at their defaults, memory full of noise. */
void emulated_pages_init(struct emulated_pages *chip, const struct glass *glass);

/* Whether a pixel of the upright glass is bright: false in the dark. */
bool emulated_pages_is_bright(const struct emulated_pages *chip, unsigned x, unsigned y);

/* The voltage that the chip makes for its glass at 25 degrees, by the datasheet; 0: that is not modelled. */
unsigned emulated_pages_supply_mv(const struct emulated_pages *chip);

#endif
