/* SPDX-License-Identifier: MIT
 *
 * What all colour controllers that speak the MIPI Display Command Set on SPI share: windows,
 * pixels, rotation, offsets, sleep, reset. A chip is a constant struct dcs_chip; a module is a
 * struct dcs_config: how a piece of glass is joined to the chip, and the chip to the host.
 * No allocation, no globals: all state is in the caller's struct dcs. */
#ifndef HAL_DCS_H
#define HAL_DCS_H

#include "panel.h"
#include "wire.h"

HAL_C_BEGIN

/* Commands of MIPI DCS, by the names that the chips' datasheets use; a chip's setup list needs them. */
enum dcs_command {
    DCS_SWRESET = 0x01,
    DCS_SLPIN = 0x10,
    DCS_SLPOUT = 0x11,
    DCS_NORON = 0x13,
    DCS_INVOFF = 0x20,
    DCS_INVON = 0x21,
    DCS_DISPOFF = 0x28,
    DCS_DISPON = 0x29,
    DCS_CASET = 0x2A,
    DCS_RASET = 0x2B,
    DCS_RAMWR = 0x2C,
    DCS_TEON = 0x35,
    DCS_MADCTL = 0x36,
    DCS_COLMOD = 0x3A
};

/* How a chip differs from the others. */
struct dcs_chip {
    const char *name;            /* lower case */
    uint8_t formats;             /* 1 << enum panel_format, of all that it takes on SPI */
    enum panel_format format;    /* of these, the usual one */
    bool is_round;               /* of its glass only the inscribed ellipse is seen */
    uint16_t mem_w_px, mem_h_px; /* size of its memory with MADCTL = 0 */
    uint8_t reversed;            /* enum turn (hal/turn.h): what usual glass shows the other way round */
    bool wakes_last;             /* its set-up list goes before SLPOUT, and not behind it */
    const uint8_t *setup;        /* command, number of arguments, arguments; repeated */
    size_t setup_b;              /* length of the list */
};

/* How a module is made and wired. All zero but the required fields is an upright RGB module at
 * the memory's corner, without reset and backlight pins. */
struct dcs_config {
    struct bus bus;               /* required */
    struct pin dc;                /* data (high) or command (low); required */
    struct pin reset;             /* active low; not wired: reset by command */
    struct pin backlight;         /* high: lit; not wired: always lit */
    struct edge tearing;          /* the chip's TE output, which tells the start of a refresh; see below */
    struct clock clock;           /* required */
    uint16_t w_px, h_px;          /* size of the glass, upright: 1 .. the memory's; 0 is refused */
    uint16_t mem_w_px, mem_h_px;  /* memory that the module's mode pins leave: 1 .. the chip's; 0: the chip's */
    uint16_t ox_px, oy_px;        /* memory column and row of the glass's top left pixel; offset + size <= memory's */
    enum panel_rotation rotation; /* of the picture at start; 0: upright */
    bool mirror;                  /* left and right of the picture swapped, for a view in a mirror */
    bool flip_columns, flip_rows; /* glass that shows memory the other way round than the usual module does */
    bool bgr;                     /* glass whose red and blue come out swapped without it */
    bool invert;                  /* glass whose colours come out negative without it, as IPS glass does */
    enum panel_format format;     /* one that the chip takes */
};

/* With TE wired, panel_begin_frame() waits for the blanking before a refresh, 72 ms at most, two frames at 28 Hz; a
 * frame whose edge does not come is sent all the same, and counted in panel.missed_edges. What follows tears nowhere if
 * it stays before the refresh, sent faster than that; sent slower, it must stay behind: within two refreshes, and begun
 * when the blanking ends, at the fall of TE, which an edge can tell as well. Both want lines in the refresh's order. An
 * upright picture's are, and those of one that stands on its head, for which the refresh is turned too; mirrored or
 * not. Turned by a quarter, a picture's lines are columns of the glass, across the refresh: it tears, along a diagonal
 * that stands still. */

/* State of one panel; private but for `panel`. */
struct dcs {
    struct panel panel; /* what the application uses */
    const struct dcs_chip *chip;
    struct dcs_config config;
    enum panel_rotation rotation;
    bool inverted;    /* the negative is asked for */
    struct wire wire; /* to the chip */
};

/* Fills *dcs without touching the hardware; panel_init() does. The configuration is copied; chip and
 * the ports' contexts must outlive *dcs, which must not move. PANEL_ERR_CONFIG: a required
 * function is missing, the glass leaves the memory or the chip does not take the format. */
HAL_MUST_CHECK int dcs_setup(struct dcs *dcs, const struct dcs_chip *chip, const struct dcs_config *config);

HAL_C_END

#endif
