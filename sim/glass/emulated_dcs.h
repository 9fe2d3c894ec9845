/* SPDX-License-Identifier: MIT
 *
 * A controller of the MIPI Display Command Set with its glass, emulated from the datasheets: it takes bytes, pin levels
 * and waits as a port passes them on, keeps its own memory and registers, and shows what a viewer of
 * the glass would see. What a driver does against the protocol is complained about, counted
 * and described; the chip then carries on as well as a real one might. It knows nothing of hal/'s
 * tables, so that neither can hide the other's mistakes. */
#ifndef SIM_EMULATED_DCS_H
#define SIM_EMULATED_DCS_H

#include "glass/emulated_port.h"
#include "glass/glass.h"

enum { EMULATED_MAX_W_PX = 320, EMULATED_MAX_H_PX = 480, EMULATED_MAX_ARGS = 16 };

/* A command beyond the standard's. */
struct emulated_register {
    uint8_t code, n_args;
};

/* What the chips differ in. */
struct emulated_kind {
    const char *name;
    uint16_t w_px, h_px;     /* memory, with MADCTL = 0 */
    bool takes_12, takes_16; /* bits a pixel on SPI; all take 18 in three bytes */
    bool is_round;           /* glass that shows the inscribed ellipse alone */
    uint8_t scan_register;   /* sets which way outputs are scanned; 0: none does */
    uint8_t lock_register;   /* takes two keys before it lets others be written; 0: nothing is locked */
    const struct emulated_register *registers; /* ends with code 0 */
};

/* All kinds, ends with NULL; NULL: there is none of that name. */
extern const struct emulated_kind *const emulated_kinds[];
const struct emulated_kind *emulated_kind_find(const char *name);

enum emulated_complaint {
    EMULATED_UNKNOWN_COMMAND, /* not in the datasheet, or not modelled here */
    EMULATED_ARGS_SHORT,      /* D/C went low before the command had all its arguments */
    EMULATED_ARGS_EXTRA,      /* data after the last argument: also pixels without RAMWR */
    EMULATED_ARGS_VALUE,      /* an argument that the command does not define */
    EMULATED_RANGE,           /* column or row beyond memory, or start after end */
    EMULATED_PIXELS_OUTSIDE,  /* pixels beyond the window's last, or with no valid window */
    EMULATED_PIXEL_SPLIT,     /* a command came between the bytes of a pixel */
    EMULATED_ASLEEP,          /* display switched on or pixels sent before sleep was left */
    EMULATED_TOO_SOON,        /* less than the required time after reset, SLPIN or SLPOUT */
    EMULATED_TEARING,         /* waited for the refresh, which was not switched on to be told */
    EMULATED_RESET,           /* reset pulse under 10 us, or bytes sent while reset is low */
    EMULATED_COMPLAINTS
};

struct emulated_dcs;

struct emulated_command {
    uint8_t code;
    uint8_t n_args;
    const char *name;
    void (*run)(struct emulated_dcs *chip); /* when its last argument has come; NULL: no visible effect */
};

struct emulated_pixel {
    uint32_t raw;   /* as written: 12, 16 or 24 bits, the first on the bus highest */
    uint8_t rgb[3]; /* its colour, before inversion and BGR */
};

/* About 1.2 MB: place it in static memory or on the heap. All of it may be read. */
struct emulated_dcs {
    /* To be set after init, if wanted. */
    void (*on_complaint)(void *ctx, const char *text); /* called for each complaint */
    void *on_complaint_ctx;
    struct emulated_port port; /* for a driver's configuration */

    unsigned complaints;                         /* all */
    unsigned complaints_of[EMULATED_COMPLAINTS]; /* of each kind */
    char complaint[160];                         /* text of the last */
    uint32_t frame_writes;                       /* RAMWR commands */

    /* Module, and when it may be told what. */
    struct glass glass;
    uint64_t ready_us, sleep_in_from_us, sleep_out_from_us;

    /* Registers, and the command under way. */
    bool asleep, display_on, inverted;
    bool tells_refresh;  /* TEON */
    uint64_t refresh_us; /* between two refreshes: 60 Hz, to be set */
    uint8_t madctl, bits_a_pixel;
    uint8_t scan; /* the second argument of kind->scan_register */
    uint8_t keys; /* of kind->lock_register that have come */
    const struct emulated_kind *kind;
    struct emulated_command vendor; /* a command that only this kind has, while it is received */
    char vendor_name[16];
    uint16_t columns[2], rows[2];           /* CASET and RASET: first and last */
    const struct emulated_command *command; /* being received, or receiving pixels; NULL: none */
    uint8_t args[EMULATED_MAX_ARGS];
    uint16_t n_args;
    bool writing, ignore_data; /* the command takes pixels; its data were complained about already */
    bool address_valid, window_full;
    uint16_t x, y;      /* address counter */
    uint16_t first_row; /* of memory, that the last window wrote first */
    uint32_t bits;      /* bits of the pixel under way */
    uint8_t n_bits;
    struct emulated_pixel memory[EMULATED_MAX_H_PX][EMULATED_MAX_W_PX]; /* the upper left corner is used */
};

/* Power on: registers at their defaults, memory full of noise. */
void emulated_dcs_init(struct emulated_dcs *chip, const struct glass *glass);

/* Whether the last window was begun where a refresh of the glass begins: at its first line, or its last (ML). */
bool emulated_dcs_follows_refresh(const struct emulated_dcs *chip);

/* What is on the glass, for a picture that was turned clockwise by `quarter_turns` (0..3) and whose
 * viewer has turned the module back by as much: w x h pixels, rows from the top left; w and h are
 * the glass's, swapped for odd turns. rgb (3 bytes a pixel) is what the eye sees, black when the
 * display is off, asleep or unlit; raw is what was written. Either may be NULL. */
void emulated_dcs_show(const struct emulated_dcs *chip, unsigned quarter_turns, uint8_t *rgb, uint32_t *raw);

#endif
