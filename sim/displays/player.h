/* SPDX-License-Identifier: MIT
 *
 * Frame after frame on a real panel, until a signal or so many of them: a frame that fails is told once, the panel set
 * up anew and the frame drawn again; what fails too often in a row is given up. */
#ifndef SIM_PLAYER_H
#define SIM_PLAYER_H

#include "base/error.h"
#include "panel.h"
#include "port.h"

enum { PLAYER_FAILURES_MAX = 10, PLAYER_GONE_MAX = 300 }; /* in a row; where the port is unplugged: a minute */

struct player {
    /* To be set by the caller. */
    struct port *port; /* of the panel; its `error` and clock are used */
    struct panel *panel;
    int (*draw)(void *ctx, uint64_t frame); /* sends a whole frame: 0 or a negative code */
    void *ctx;
    uint64_t frames;   /* 0: until a signal */
    uint32_t pause_us; /* after each frame */

    struct bus bus;         /* what the driver is to be given: port->bus, counted */
    uint64_t sent_b;        /* on it, and of that */
    uint64_t drawn_b;       /* in frames that were drawn whole */
    uint64_t drawn;         /* frames */
    uint64_t failed;        /* attempts at frames */
    unsigned in_a_row;      /* of these, the last; */
    unsigned gone_in_a_row; /* of which the port was unplugged */
    double began_s, took_s; /* the frames */
};

/* Counts bytes from now on. Of the port, only what is wired must be there yet. */
void player_init(struct player *player, struct port *port);

/* Lights the panel, plays, and blanks it again, whatever happened. A signal is no error: interrupt_signal() tells. */
bool player_run(struct player *player, struct error *err);

/* What has been played, in one line. */
void player_print(const struct player *player);

#endif
