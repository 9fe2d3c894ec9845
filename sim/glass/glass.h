/* SPDX-License-Identifier: MIT
 *
 * Modules as they are sold: how a piece of glass is joined to its chip. The table is for the emulated glass alone. It
 * shares nothing with the drivers of hal/ nor with the usual modules of module_choice.c: its rows were found by reading
 * what other projects' drivers send for an upright picture, and each names those drivers. So a driver's default that is
 * wrong shows on emulated glass, as it would on real one; tests/unit/sim/test_glass_rows.c looks.
 *
 * Rows hold facts about the module, not bytes for registers: which of the chip's columns and lines lies behind the
 * glass's upper left pixel, and which way they run from there. Upright is what the named drivers call so. None of the
 * rows was tried on hardware. */
#ifndef SIM_GLASS_H
#define SIM_GLASS_H

#include <stdbool.h>
#include <stdint.h>

enum { GLASS_SOURCES = 5 };

/* How the outputs for lines of an OLED chip with 64 of them are led to the glass (the chip is told by DAh). */
enum glass_wiring {
    GLASS_IN_ORDER,   /* one output after the other, from one side */
    GLASS_ALTERNATING /* even lines from one side, odd ones from the other, as modules of 128x64 are */
};

struct glass {
    const char *chip;            /* lower case, as for --panel */
    const char *module;          /* what it is known as */
    uint16_t w_px, h_px;         /* upright */
    uint16_t mem_w_px, mem_h_px; /* columns and lines of the chip, less those that the module's mode pins take away */
    /* What lies behind the upper left pixel. A column of memory is counted as the chip addresses it after a reset, when
     * nothing is exchanged or mirrored. A line is a row of memory of chips that always show all of it (MIPI DCS); else
     * the output for lines (COM) that drives it, or of memory LCDs its number less 1. */
    uint16_t column, line;
    bool columns_back, lines_back; /* they count down from there, to the right or to the bottom */
    bool told_lines;               /* the chip is told how many lines to scan, and counts back from the last of these */
    bool blue_first;               /* true colours need the chip's exchange of red and blue */
    bool negative;                 /* as the chip is after a reset, colours come out negative, as on IPS glass */
    enum glass_wiring wiring;      /* of SSD1306 and SH1106 */
    bool needs_reference;          /* no resistor sets the current: the chip's own reference must (ADh 30h) */
    uint16_t least_mv, most_mv;    /* the glass's voltage at 25 degrees, as others' drivers set it; 0: not known */
    uint16_t current_permille; /* of OLEDs, of what the chip can give, as the module's maker sets it; 0: not known */
    const char *sources[GLASS_SOURCES]; /* repository and path, two at least */
};

/* All rows, a chip's usual module before its others; the last is followed by one without a chip. */
extern const struct glass glass_rows[];

/* The chip's row of that size, or with w_px 0 its first. NULL: there is none. */
const struct glass *glass_find(const char *chip, unsigned w_px, unsigned h_px);

/* Glass like that of the chip's usual module, but so large; a picture that is upright on it begins at ox_px, oy_px by
 * the addresses that it is written to, as other projects' drivers have it. Of chips that scan as many lines as they are
 * told, the glass has the first, and oy_px is 0. There is a row of the chip, and the glass fits. */
struct glass glass_like(const char *chip, unsigned w_px, unsigned h_px, unsigned ox_px, unsigned oy_px);

/* What lies behind a pixel of the upright glass. Outputs for lines may begin anywhere, and go on from the last to the
 * first. */
unsigned glass_column(const struct glass *glass, unsigned x);
unsigned glass_line(const struct glass *glass, unsigned y);

/* Whether the chip has a column and a line for each of its pixels. */
bool glass_fits(const struct glass *glass);

#endif
