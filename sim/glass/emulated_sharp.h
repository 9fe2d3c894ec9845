/* SPDX-License-Identifier: MIT
 *
 * Sharp's memory LCDs, emulated from the datasheets: bytes, select, EXTCOMIN, DISP and waits in; what is on the glass,
 * and complaints about the protocol, out. They share no table with hal/. DISP is the port's backlight. */
#ifndef SIM_EMULATED_SHARP_H
#define SIM_EMULATED_SHARP_H

#include "glass/emulated_port.h"

enum { EMULATED_SHARP_MAX_W_PX = 400, EMULATED_SHARP_MAX_H_PX = 240 };

struct emulated_sharp_kind {
    const char *name;
    uint16_t w_px, h_px;
    uint8_t setup_us, hold_us; /* of select, before and after the bits */
    uint8_t low_us, pulse_us;  /* the least time that select is low, and that EXTCOMIN is high */
};

/* All kinds, ends with NULL; NULL: there is none of that name. */
extern const struct emulated_sharp_kind *const emulated_sharp_kinds[];
const struct emulated_sharp_kind *emulated_sharp_kind_find(const char *name);

/* All of it may be read. */
struct emulated_sharp {
    struct emulated_port port; /* for a driver's configuration */
    unsigned complaints;       /* all */
    char complaint[160];       /* text of the last */

    const struct emulated_sharp_kind *kind;
    bool by_pin; /* EXTMODE is high: the sign is EXTCOMIN's, not the commands' */
    bool selected, pin_high;
    uint64_t select_us, byte_us; /* when select rose, and when the last byte came */
    uint64_t rise_us, fall_us;   /* when select may rise again, and EXTCOMIN may fall */
    uint32_t n_b;                /* bytes since then */
    uint8_t command, number;     /* the first of them; that of the line that comes in */
    uint8_t line[EMULATED_SHARP_MAX_W_PX / 8];
    bool positive;                                                        /* the voltage's sign */
    uint64_t sign_us;                                                     /* since when */
    uint32_t signs;                                                       /* how often it changed */
    uint8_t memory[EMULATED_SHARP_MAX_H_PX][EMULATED_SHARP_MAX_W_PX / 8]; /* the left pixel in the highest bit */
};

/* Power on: memory full of noise. */
void emulated_sharp_init(struct emulated_sharp *chip, const struct emulated_sharp_kind *kind, bool by_pin);

/* EXTCOMIN. */
struct pin emulated_sharp_alternate(struct emulated_sharp *chip);

/* Whether the eye sees white. */
bool emulated_sharp_is_white(const struct emulated_sharp *chip, unsigned x, unsigned y);

#endif
