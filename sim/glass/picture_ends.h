/* SPDX-License-Identifier: MIT
 *
 * Where a picture ends, of a board whose light nobody captured: a picture is all pixels of the glass, stored line by
 * line from one corner to the opposite one. What is stored from elsewhere on, as where a capture begins in the middle
 * of a picture, is none. Who sends only what changes stores no such pictures; there pauses tell. */
#ifndef SIM_PICTURE_ENDS_H
#define SIM_PICTURE_ENDS_H

#include "displays/module_choice.h"
#include "glass/emulated_port.h"

struct picture_ends {
    unsigned w_px, h_px; /* of the glass, upright */
    bool is_round;
    uint64_t whole_px; /* pixels that the glass shows */
    struct emulated_place first, last;
    bool has_begun;
    uint64_t stored_px; /* of this picture */
};

/* Asks the module's driver which pixels round glass shows. */
bool picture_ends_init(struct picture_ends *ends, const struct module_choice *choice, struct error *err);

/* The chip stored there. true: the picture is whole with it, and in order. */
bool picture_ends_store(struct picture_ends *ends, struct emulated_place place);

/* A command comes, or the capture ends. true: the picture was whole before. */
bool picture_ends_command(struct picture_ends *ends);

#endif
