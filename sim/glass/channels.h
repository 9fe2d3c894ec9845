/* SPDX-License-Identifier: MIT
 *
 * Which channel of a logic analyser is which wire of a display: as `--wires dc=D0,sck=D1` says, else by the names that
 * such wires usually have, in capitals or not. */
#ifndef SIM_CHANNELS_H
#define SIM_CHANNELS_H

#include "base/error.h"

#include <stddef.h>

enum capture_wire {
    CAPTURE_DC,
    CAPTURE_SCK,
    CAPTURE_MOSI,
    CAPTURE_CS,
    CAPTURE_RESET,
    CAPTURE_SELECT, /* a memory LCD's, high: selected */
    CAPTURE_BACKLIGHT,
    CAPTURE_LED, /* the board's own light, which ends frames */
    CAPTURE_WIRES
};

/* As the options call it. */
extern const char *const capture_wire_names[CAPTURE_WIRES];

/* A signal of a capture: one bit, or several that have numbers, the first written first. */
struct channel {
    char *path;          /* with the scopes that it is in: top.spi.sck */
    char *id;            /* what the file calls it */
    unsigned bits;       /* 1: a wire */
    int first_bit_index; /* of several: sck[7:0] begins with 7 */
    bool counts_down;
};

struct channels {
    struct channel *items; /* the caller's, with all their strings */
    size_t count, capacity;
};

/* Takes ownership of the strings. */
void channels_add(struct channels *channels, struct channel channel);
void channels_free(struct channels *channels);

/* Where a wire is found: a channel and which of its bits, from the first written. */
struct channel_bit {
    const struct channel *channel; /* NULL: the wire was not captured */
    unsigned bit;
};

/* What --wires says: per wire the name of its channel; NULL: the usual ones. */
struct wire_names {
    char *text; /* owned; the names point into it */
    const char *of[CAPTURE_WIRES];
};

/* NAME=CHANNEL,...; NAME=- says that there is none. NULL: nothing was said. */
bool wire_names_parse(struct wire_names *names, const char *text, struct error *err);
void wire_names_free(struct wire_names *names);

/* Finds the wires. Of a display that is selected by a pin of its own (selects) that is what may be called CS, and there
 * is neither D/C nor reset. An error: a channel that was named is missing, or in several scopes; or a display cannot do
 * without one that is not there. `path`: the capture's, for errors. */
bool wires_find(struct channel_bit out[CAPTURE_WIRES], const struct wire_names *names, const struct channels *channels,
                bool selects, const char *path, struct error *err);

#endif
