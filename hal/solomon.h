/* SPDX-License-Identifier: MIT
 *
 * What Solomon Systech's OLED controllers with windows share: 15h and 75h open one, A0h maps memory to the glass, A2h
 * shifts its lines. Of colours they can exchange columns and rows, of grey not, as two pixels share a byte: a quarter
 * turn is the camera's then, screen_turn_camera(). Half turns and mirrors they can all.
 * No allocation, no globals: all state is in the caller's struct solomon. */
#ifndef HAL_SOLOMON_H
#define HAL_SOLOMON_H

#include "panel.h"
#include "wire.h"

HAL_C_BEGIN

/* How a chip differs from the others. Of A0h's value, upright on the usual module, bits are reversed. */
struct solomon_chip {
    const char *name;            /* lower case */
    uint8_t formats;             /* 1 << enum panel_format, of all that it takes on SPI */
    enum panel_format format;    /* of these, the usual one */
    uint16_t mem_w_px, mem_h_px; /* size of its memory */
    bool args_low;               /* D/C low for arguments too */
    uint8_t column_px;           /* pixels that a column address stands for */
    uint8_t lines;               /* command that takes the number of lines in use, less 1 */
    bool scans_all;  /* all of memory's lines are in use, of which the glass has the first; else those of the glass */
    bool counts_all; /* backwards it counts lines from the last of all outputs; else from the last of those in use */
    uint8_t write;   /* command before pixels; 0: none is needed */
    uint8_t as_is, negative, all_off;                 /* commands: what of memory is shown */
    uint8_t contrast_command, contrast_max, contrast; /* with what it takes, and the usual one */
    uint8_t converter;          /* command for its own converter of the glass's voltage; 0: it has none */
    uint8_t external, internal; /* with it: the voltage comes from outside, or from there */
    uint8_t remap;              /* A0h, and in the order of enum turn's bits what to reverse */
    uint8_t remap_rows, remap_columns, remap_exchange; /* ...exchange 0: it cannot */
    uint8_t remap_bgr;                                 /* 0: there are no colours */
    uint8_t remap_wide;                                /* for three bytes a pixel */
    const uint8_t *setup; /* sent after a reset: command, number of arguments, arguments; repeated */
    size_t setup_b;       /* length of the list */
};

/* How a module is made and wired. All zero but the required fields is an upright module of the usual kind. */
struct solomon_config {
    struct bus bus;               /* required */
    struct pin dc;                /* data (high) or command (low); required */
    struct pin reset;             /* active low; not wired: the chip is as it was left, and set up all the same */
    struct pin backlight;         /* the glass's supply, if a pin switches it; high: on */
    struct clock clock;           /* required */
    uint16_t w_px, h_px;          /* size of the glass, upright: 1 .. the memory's; w a multiple of column_px */
    uint16_t ox_px;               /* memory columns before the glass's left edge, a multiple of column_px */
    uint8_t shift;                /* A2h, where the maker gives one, upright */
    uint8_t shift_turned;         /* and with lines counted from below; 0: as follows from `shift` */
    uint8_t start_line;           /* memory line that the glass begins with, upright: 0 .. the memory's less 1 */
    enum panel_rotation rotation; /* of the picture at start; by quarters where the chip exchanges columns and rows */
    bool mirror;                  /* left and right of the picture swapped */
    bool flip_columns, flip_rows; /* glass that shows memory the other way round than the usual module does */
    bool bgr;                     /* glass whose red and blue come out swapped without it */
    bool invert;                  /* glass that comes out negative without it */
    uint8_t contrast;             /* 1 .. the chip's most; 0: its usual one */
    bool converter;               /* the module has the parts for the chip's own converter of the glass's voltage */
    enum panel_format format;     /* one that the chip takes */
};

/* State of one panel; private but for `panel`. */
struct solomon {
    struct panel panel; /* what the application uses */
    const struct solomon_chip *chip;
    struct solomon_config config;
    struct wire wire;
    enum panel_rotation rotation;
    bool blank, inverted;
};

/* Fills *solomon without touching the hardware; panel_init() does. The configuration is copied; chip and the ports'
 * contexts must outlive *solomon, which must not move. PANEL_ERR_CONFIG: a required function is missing, the glass
 * leaves the memory or divides a byte, or the chip does not take the format or turn the picture so. */
HAL_MUST_CHECK int solomon_setup(struct solomon *solomon, const struct solomon_chip *chip,
                                 const struct solomon_config *config);

HAL_C_END

#endif
