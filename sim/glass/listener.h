/* SPDX-License-Identifier: MIT
 *
 * A display at the end of wires that somebody recorded: takes what went over them, in order, and counts the frames.
 * A frame ends when the board's LED changes after pixels came; a change before any is none, so neither the LED's first
 * level nor its blinking after an error makes one. */
#ifndef SIM_LISTENER_H
#define SIM_LISTENER_H

#include "displays/module_choice.h"
#include "glass/emulated_display.h"

enum listener_pin {
    LISTENER_DC,
    LISTENER_RESET,
    LISTENER_SELECT,
    LISTENER_BACKLIGHT,
    LISTENER_CS,
    LISTENER_LED,
    LISTENER_PINS
};

/* All of it may be read. Large, and must not move: place it on the heap. */
struct listener {
    struct emulated_display display;
    struct port port; /* of the display's chip */
    struct display_module module;
    bool is_high[LISTENER_PINS];  /* levels; low until they are told */
    uint64_t frames;              /* that have ended */
    uint64_t frame_bus_b;         /* bytes that the last of them took, with all that came before it */
    uint64_t last_b, last_stores; /* the port's counts when it ended */
    uint64_t other_b;             /* bytes while cs was high: for somebody else on the bus */
};

/* Power on. Until listener_time() is called nobody knows how long anything takes, and no wait is too short. */
void listener_init(struct listener *listener, const struct module_choice *choice);

void listener_bytes(struct listener *listener, const uint8_t *bytes, size_t n_b);

/* A frame ends here, if pixels came since the last one did, although the LED has not changed. */
void listener_end_frame(struct listener *listener);

/* The level of a wire, changed or not. */
void listener_level(struct listener *listener, enum listener_pin pin, bool high);

/* Since power on. false: it goes back. */
bool listener_time(struct listener *listener, uint64_t now_ns);

/* A wire by its name: dc, reset, select, backlight, cs or led; others are refused. */
bool listener_find_pin(const char *name, size_t length, enum listener_pin *pin, struct error *err);

/* What the viewer sees, turned as the module is: RGB565 numbers. `rgb`: room for 3 bytes a pixel. */
void listener_read(const struct listener *listener, uint8_t *rgb, uint16_t *pixels);

#endif
