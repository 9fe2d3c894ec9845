/* SPDX-License-Identifier: MIT
 *
 * A display of the user's choice: a chip by its name, the module that it is part of, the port that it hangs on, and of
 * all these the driver. Chips come in families, of one driver each: a family is one section of display.c, and one of
 * emulated_display.c. */
#ifndef SIM_DISPLAY_H
#define SIM_DISPLAY_H

#include "base/error.h"
#include "panels.h"
#include "port.h"
#include "target.h"

#include <stdio.h>

struct display_family;

/* A chip as the command line sees it, and what it is sent. */
struct panel_choice {
    const struct display_family *family; /* NULL: none was chosen */
    const void *chip;                    /* of the family's own kind */
    const char *name;
    uint16_t mem_w_px, mem_h_px;   /* of its memory: the largest glass */
    uint16_t w_step_px, h_step_px; /* the sides of its glass and its offsets are multiples of these */
    bool has_converter;            /* of the glass's voltage, of its own */
    bool has_mode_pins;            /* by which a module may leave less of its memory */
    bool has_wiring;               /* it is told how the lines of its glass are wired */
    bool exchanges;                /* it can turn a picture by a quarter; for others the camera does */
    bool flips;                    /* it can show memory's columns and rows from their other ends */
    uint8_t contrast_max;          /* 0: it has no contrast */
    uint16_t start_lines;          /* lines of memory that the glass may begin with; 0: the first alone */
    uint8_t formats;               /* 1 << enum panel_format, of all that it takes */
    enum panel_format format;
    enum panel_rotation rotation; /* of the picture on the glass of `limner render`; a module has its own */
};

/* The glass, and how it is joined to the chip. */
struct display_module {
    uint16_t w_px, h_px;          /* upright */
    uint16_t mem_w_px, mem_h_px;  /* memory that mode pins leave; 0: the chip's */
    uint16_t ox_px, oy_px;        /* memory column and row of its top left pixel */
    enum panel_rotation rotation; /* of the picture */
    bool mirror, bgr, invert;     /* as in struct dcs_config */
    bool flip_columns, flip_rows;
    uint8_t contrast, start_line; /* as in struct pages_config */
    enum pages_wiring wiring;     /* likewise */
    bool internal_reference;      /* likewise */
    bool converter;               /* as in struct solomon_config */
    uint8_t shift, shift_turned;  /* likewise, the first also as in struct pages_config */
};

/* A driver; must not move. */
struct display {
    struct panel *panel;
    enum panel_rotation camera_turn; /* what the chip cannot turn: screen_turn_camera() does */
    union {
        struct dcs dcs;
        struct pages pages;
        struct solomon solomon;
        struct sharp sharp;
    } driver; /* the family's */
};

/* What a family is. */
struct display_family {
    /* Its chips, counted from 0, with their usual format. false: there are no more. */
    bool (*chip)(size_t index, struct panel_choice *out);
    /* Fills display->driver and display->panel. 0, or what the driver says. */
    int (*setup)(struct display *display, const struct panel_choice *choice, const struct display_module *module,
                 const struct port *port);
    const char *driver; /* name of its struct, and with _setup and _config of what setup() calls and fills in */
    /* That configuration as C, with the pins of `board`: a line a field. */
    void (*write)(FILE *file, const struct panel_choice *choice, const struct display_module *module);
    bool has_rows;      /* its glass may begin in any row of memory: module->oy_px */
    bool tells_refresh; /* its drivers wait for port->tearing */
    bool selects;       /* its drivers set port->select: the bus does not */
};

extern const struct display_family display_dcs, display_pages, display_solomon, display_sharp;

/* Every chip of every family, counted from 0. false: there are no more. */
bool panel_choice_at(size_t index, struct panel_choice *out);

/* --panel NAME or NAME:FORMAT; an unknown one is refused with the list of those there are. `also`: what else the option
 * takes, for that list, or NULL. */
bool panel_choice_parse(const char *text, const char *also, struct panel_choice *out, struct error *err);

/* --rotate DEG: the picture, clockwise. */
bool panel_rotation_parse(const char *text, enum panel_rotation *out, struct error *err);

/* Whether such a picture lies on upright glass, or stands on glass that lies: its sides are exchanged. */
bool panel_rotation_exchanges(enum panel_rotation rotation);

/* Whether its pixels are black or white. */
bool panel_choice_is_mono(const struct panel_choice *choice);

/* How outlines show best on it, which have no colours to be told by. On pages a pixel that is set is a line: it glows
 * on an OLED and is ink on an LCD. A memory LCD is light by itself: lines are black. Else the polygons' own colours. */
struct lim_wireframe panel_choice_outlines(const struct panel_choice *choice);

/* Whether the glass fits into the chip's memory; an error says why not. */
bool display_module_check(const struct panel_choice *choice, const struct display_module *module, struct error *err);

/* Sets a driver up, without touching the hardware: panel_init(display->panel) does. Of the port bus, pins and clock are
 * copied; their contexts must outlive *display. */
bool display_setup(struct display *display, const struct panel_choice *choice, const struct display_module *module,
                   const struct port *port, struct error *err);

#endif
