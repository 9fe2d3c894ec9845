/* SPDX-License-Identifier: MIT
 *
 * What monochrome controllers share whose memory is pages: bytes of eight pixels one above the other, the lowest bit on
 * top. A chip is a constant struct pages_chip, a module a struct pages_config. The format is PANEL_MONO_PAGES: windows
 * begin and end on pages, and each page is sent from left to right. Some chips can turn a picture by half a turn and
 * mirror it; none by a quarter, which is the camera's: screen_turn_camera().
 * No allocation, no globals: all state is in the caller's struct pages. */
#ifndef HAL_PAGES_H
#define HAL_PAGES_H

#include "panel.h"
#include "wire.h"

HAL_C_BEGIN

enum { PAGES_SETUP_MAX_B = 32, PAGES_ADDRESS_MAX_B = 8 };

struct pages_config;

/* How the lines of OLED glass hang on the chip's outputs: one after the other, or on both sides in turn, as is usual.
 * An SSD1306's of 128x32 and 96x16 are sequential. */
enum pages_wiring { PAGES_WIRING_USUAL, PAGES_WIRING_SEQUENTIAL, PAGES_WIRING_ALTERNATIVE };

/* How a chip differs from the others. Its functions write commands, which all go out with D/C low, arguments too, and
 * return how many bytes. */
struct pages_chip {
    const char *name;               /* lower case */
    uint16_t mem_w_px, mem_h_px;    /* h is a multiple of 8 */
    uint8_t contrast_max, contrast; /* what it takes, and the usual one */
    uint32_t reset_us;              /* after the pulse, until it listens */
    uint32_t wake_us;               /* after each byte of `wake`, which raise its voltages */
    uint8_t wake[3], wake_b;
    bool scans_all;     /* it scans lines of all its outputs, however many the glass has */
    uint8_t start_line; /* command, of which the lower bits are the line; 0: it has none */
    bool is_oled;       /* `shift`, `wiring` and `internal_reference` mean something */
    uint8_t (*setup)(uint8_t commands[PAGES_SETUP_MAX_B], const struct pages_config *config, uint8_t contrast);
    uint8_t (*look)(uint8_t commands[2], bool on, bool inverted);
    uint8_t (*flip)(uint8_t commands[2], bool columns, bool rows); /* left and right, top and bottom; NULL: it cannot */
    /* Where the next byte goes, and those that follow on its page. */
    uint8_t (*address)(uint8_t commands[PAGES_ADDRESS_MAX_B], uint8_t page, uint8_t column);
    bool runs_on; /* from memory's last column to the next page's first, without an address */
    /* A window's first and last column and page, on which the chip goes from page to page by itself. Its commands take
     * two arguments each, at most. NULL: the chip knows no windows. Used where messages cost more than bytes. */
    uint8_t (*window)(uint8_t commands[PAGES_ADDRESS_MAX_B], const uint8_t columns[2], const uint8_t pages[2]);
};

/* How a module is made and wired. All zero but the required fields is an upright module of the usual kind. */
struct pages_config {
    struct bus bus;               /* required */
    struct pin dc;                /* data (high) or command (low); required */
    struct pin reset;             /* active low; not wired: the chip is as it was left, and set up all the same */
    struct pin backlight;         /* high: lit; not wired: always lit */
    struct clock clock;           /* required */
    uint16_t w_px, h_px;          /* size of the glass, upright: 1 .. the memory's, h a multiple of 8 */
    uint16_t ox_px;               /* memory columns before the glass's left edge; offset + size <= memory's */
    enum panel_rotation rotation; /* upright; or by half a turn, where the chip flips */
    bool mirror;                  /* left and right swapped, where the chip flips */
    bool flip_columns, flip_rows; /* glass that shows memory the other way round than the usual module does */
    bool invert;                  /* glass that comes out negative without it */
    uint8_t contrast;             /* 1 .. the chip's most; 0: its usual one; modules vary */
    uint8_t start_line;           /* memory line that the glass begins with, upright: 0 .. the memory's less 1 */
    uint8_t shift;            /* of OLED glass: lines before its first on the outputs (D3h), upright: as start_line */
    enum pages_wiring wiring; /* of OLED glass */
    bool internal_reference;  /* OLED glass whose current the chip itself sets, as of 72x40 pixels */
};

/* State of one panel; private but for `panel`. */
struct pages {
    struct panel panel; /* what the application uses */
    const struct pages_chip *chip;
    struct pages_config config;
    struct wire wire;
    enum panel_rotation rotation;
    bool on, inverted;
    uint16_t x_px, end_x_px, at_x_px; /* the window's columns, and where the next byte goes */
    uint8_t page, end_page;           /* equal: no window */
    bool whole;                       /* the chip finds the window's next page by itself */
};

/* What most of the chips have in common, for their tables. */
uint8_t pages_put(uint8_t *commands, const uint8_t *list, uint8_t n_b);
uint8_t pages_setup_oled(uint8_t commands[PAGES_SETUP_MAX_B], const struct pages_config *config, uint8_t contrast,
                         const uint8_t *supply, uint8_t supply_b, uint8_t precharge);
uint8_t pages_look_ae(uint8_t commands[2], bool on, bool inverted);
/* For glass that usually shows the last column and line first. */
uint8_t pages_flip_a0(uint8_t commands[2], bool columns, bool rows);
uint8_t pages_address_b0(uint8_t commands[PAGES_ADDRESS_MAX_B], uint8_t page, uint8_t column);

/* Fills *pages without touching the hardware; panel_init() does. The configuration is copied; chip and the ports'
 * contexts must outlive *pages, which must not move. PANEL_ERR_CONFIG: a required function is missing, the glass leaves
 * the memory, or the chip cannot turn or mirror it so. */
HAL_MUST_CHECK int pages_setup(struct pages *pages, const struct pages_chip *chip, const struct pages_config *config);

HAL_C_END

#endif
