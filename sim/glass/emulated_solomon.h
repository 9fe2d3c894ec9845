/* SPDX-License-Identifier: MIT
 *
 * Solomon Systech's OLED controllers with windows, and their glass, emulated from the datasheets: bytes, D/C, reset and
 * waits in; what is on the glass, and complaints about the protocol, out. They share no table with hal/. */
#ifndef SIM_EMULATED_SOLOMON_H
#define SIM_EMULATED_SOLOMON_H

#include "glass/emulated_port.h"
#include "glass/glass.h"

enum { EMULATED_SOLOMON_MAX_PX = 128, EMULATED_SOLOMON_MAX_ARGS = 64 };

struct emulated_solomon_kind;

/* All kinds, ends with NULL; NULL: there is none of that name. */
extern const struct emulated_solomon_kind *const emulated_solomon_kinds[];
const struct emulated_solomon_kind *emulated_solomon_kind_find(const char *name);

/* All of it may be read. */
struct emulated_solomon {
    struct emulated_port port; /* for a driver's configuration */
    unsigned complaints;       /* all */
    char complaint[160];       /* text of the last */

    const struct emulated_solomon_kind *kind;
    struct glass glass;

    /* Registers, and the command under way. */
    uint8_t command, n_args, args_due;
    uint8_t args[EMULATED_SOLOMON_MAX_ARGS];
    bool unlocked;       /* also the commands that are locked at reset */
    bool awake, writing; /* glass on; memory takes pixels */
    uint8_t remap, first_line, shift, lines, shown;
    uint8_t contrast, range;                  /* 81h; and 84h to 86h, quarter, half and full current */
    uint8_t columns[2], rows[2], column, row; /* the window, and where the next pixel goes */
    bool window_full;
    uint32_t bits; /* of the pixel under way */
    uint8_t n_bits;
    uint32_t memory[EMULATED_SOLOMON_MAX_PX][EMULATED_SOLOMON_MAX_PX]; /* by line and the glass's wire: raw */
    bool wide[EMULATED_SOLOMON_MAX_PX][EMULATED_SOLOMON_MAX_PX];       /* written as three bytes */
};

/* Power on: registers at their defaults, memory full of noise. */
void emulated_solomon_init(struct emulated_solomon *chip, const struct glass *glass);

/* The current that an SSD0323's glass gets, in thousandths of the most that the chip gives; of others 0: not modelled.
 */
unsigned emulated_solomon_current_permille(const struct emulated_solomon *chip);

/* What the eye sees at a pixel of the upright glass: red, green, blue; black in the dark. */
void emulated_solomon_see(const struct emulated_solomon *chip, unsigned x, unsigned y, uint8_t rgb[3]);

#endif
