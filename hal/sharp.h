/* SPDX-License-Identifier: MIT
 *
 * Sharp's memory LCDs: glass that keeps a bit for each pixel, 1 white, and takes whole lines by their numbers. It has
 * no command beside, cannot turn, mirror or invert a picture, and has no D/C; chip select is high while it listens, and
 * the driver's own, so the port must not drive one. Turns are the camera's: screen_turn_camera().
 *
 * The voltage across the glass must change its sign, or the glass is spoiled: at least once a second, at most 60 times.
 * Every frame does so (panel_begin_frame(), and at the latest its panel_flush()), panel_keep() does it between frames:
 * call it once a second at least while there are none. Where EXTMODE is tied high the pin EXTCOMIN does it instead of a
 * bit of the commands: wire it here, or to an oscillator, and leave `alternate` out.
 * No allocation, no globals: all state is in the caller's struct sharp. */
#ifndef HAL_SHARP_H
#define HAL_SHARP_H

#include "panel.h"

HAL_C_BEGIN

/* How the parts differ. */
struct sharp_chip {
    const char *name;    /* lower case */
    uint16_t w_px, h_px; /* of the glass: w a multiple of 8, h below 256 */
};

/* How a module is wired. */
struct sharp_config {
    struct bus bus;       /* required */
    struct pin select;    /* SCS, high while the glass listens; required */
    struct pin shown;     /* DISP: high shows memory, low white; not wired: always shown, and panel_blank() cannot */
    struct pin alternate; /* EXTCOMIN: a rise changes the sign; not wired: a bit of each command tells it */
    struct clock clock;   /* required */
};

/* State of one panel; private but for `panel`. */
struct sharp {
    struct panel panel; /* what the application uses */
    struct sharp_config config;
    uint8_t select;          /* its level, as far as known */
    bool positive, told;     /* the sign, and whether the glass knows it */
    uint8_t head[2];         /* before a line's pixels; stays as it is while they travel */
    uint16_t y_px, end_y_px; /* the window's next line, and the first below; equal: no window */
};

/* Fills *sharp without touching the hardware; panel_init() does. The configuration is copied; chip and the ports'
 * contexts must outlive *sharp, which must not move. PANEL_ERR_CONFIG: a required function is missing. */
HAL_MUST_CHECK int sharp_setup(struct sharp *sharp, const struct sharp_chip *chip, const struct sharp_config *config);

HAL_C_END

#endif
