/* SPDX-License-Identifier: MIT
 *
 * A panel: a display's controller chip behind one interface, whatever the chip and the port.
 * Open a window, send its pixels row by row; everything else is optional comfort.
 * All functions return 0, an enum panel_error, or the port's negative code unchanged. After an
 * error the window is closed; the next panel_window(), or panel_init() when the chip itself may
 * have lost its state, starts afresh. */
#ifndef HAL_PANEL_H
#define HAL_PANEL_H

#include "pixels.h"

enum panel_error {
    PANEL_ERR_CONFIG = -2001,     /* the configuration does not fit the chip */
    PANEL_ERR_WINDOW = -2002,     /* outside the panel, or more pixels than the window has left */
    PANEL_ERR_UNSUPPORTED = -2003 /* this panel cannot do it, or the pin is not wired */
};

/* Quarter turns of the picture on the glass, clockwise. */
enum panel_rotation { PANEL_UPRIGHT, PANEL_TURNED_90, PANEL_TURNED_180, PANEL_TURNED_270 };

struct panel_ops;

/* Filled by the chip's setup function, which also says what memory must outlive it. */
struct panel {
    const struct panel_ops *ops;
    void *chip;               /* the driver's own state */
    uint16_t w_px, h_px;      /* size of the picture, after rotation */
    uint16_t step_x_px;       /* windows begin and end at multiples of these, 1 unless pixels share bytes: */
    uint16_t step_y_px;       /* 2 x 1 for two pixels a byte, 1 x 8 for pages, w_px x 1 where lines go out whole */
    enum panel_format format; /* what panel_pixels() takes */
    /* Round glass: panel_visible(). NULL: all is seen. */
    void (*visible)(const struct panel *panel, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px);
    bool runs_on;          /* pages: the next one of a window as wide as the picture takes no more than its bytes */
    uint16_t window_b;     /* what panel_window() costs: bytes, or as many as would take the port as long */
    uint32_t missed_edges; /* frames that were not held for the glass's refresh: it did not tell its start in time */
};

/* What a chip's driver implements. The first four are required; NULL elsewhere: unsupported. */
struct panel_ops {
    int (*init)(struct panel *panel);
    int (*window)(struct panel *panel, uint16_t x_px, uint16_t y_px, uint16_t w_px, uint16_t h_px);
    int (*pixels)(struct panel *panel, const void *data, size_t n_px);
    int (*flush)(struct panel *panel);
    int (*begin_frame)(struct panel *panel); /* NULL: nothing to do */
    int (*keep)(struct panel *panel);        /* NULL: nothing to do */
    int (*sleep)(struct panel *panel, bool asleep);
    int (*blank)(struct panel *panel, bool blank);
    int (*set_rotation)(struct panel *panel, enum panel_rotation rotation);
    int (*set_inverted)(struct panel *panel, bool inverted);
    int (*set_backlight)(struct panel *panel, bool lit);
};

/* Resets and configures the chip, from any state, and lights the panel; what it then shows until
 * the first frame is whatever its memory held. Takes up to half a second. */
HAL_MUST_CHECK static inline int panel_init(struct panel *panel)
{
    return panel->ops->init(panel);
}

/* Before a frame's first window: holds it until it will not tear, where the chip can tell; a bounded time. */
HAL_MUST_CHECK static inline int panel_begin_frame(struct panel *panel)
{
    return panel->ops->begin_frame ? panel->ops->begin_frame(panel) : 0;
}

/* While no frames are sent, once a second at least: what some glass needs to last (hal/sharp.h); elsewhere nothing. */
HAL_MUST_CHECK static inline int panel_keep(struct panel *panel)
{
    return panel->ops->keep ? panel->ops->keep(panel) : 0;
}

/* The next pixels fill this rectangle of the picture, row by row from the top left. */
HAL_MUST_CHECK static inline int panel_window(struct panel *panel, uint16_t x_px, uint16_t y_px, uint16_t w_px,
                                              uint16_t h_px)
{
    return panel->ops->window(panel, x_px, y_px, w_px, h_px);
}

/* Sends the window's next n_px pixels, packed in the panel's format; their bytes fit a size_t. Where pixels share bytes
 * n_px is even, but for the window's last ones. The data must stay as it is until the next call has returned (see
 * struct bus). */
HAL_MUST_CHECK static inline int panel_pixels(struct panel *panel, const void *data, size_t n_px)
{
    return panel->ops->pixels(panel, data, n_px);
}

/* Waits until all pixels have left, and reports what went wrong on their way. */
HAL_MUST_CHECK static inline int panel_flush(struct panel *panel)
{
    return panel->ops->flush(panel);
}

/* Least power; the chip's memory is kept. Frames are sent to a panel that is awake. */
HAL_MUST_CHECK static inline int panel_sleep(struct panel *panel, bool asleep)
{
    return panel->ops->sleep ? panel->ops->sleep(panel, asleep) : PANEL_ERR_UNSUPPORTED;
}

/* Hides the picture and puts the backlight out, or shows it again; frames may be sent meanwhile. */
HAL_MUST_CHECK static inline int panel_blank(struct panel *panel, bool blank)
{
    return panel->ops->blank ? panel->ops->blank(panel, blank) : PANEL_ERR_UNSUPPORTED;
}

/* Blank and asleep, for good. Not every chip can do both; one of them darkens it. */
HAL_MUST_CHECK static inline int panel_darken(struct panel *panel)
{
    const int blank = panel_blank(panel, true), asleep = panel_sleep(panel, true);
    if (blank && blank != PANEL_ERR_UNSUPPORTED) return blank;
    return asleep == PANEL_ERR_UNSUPPORTED ? blank : asleep;
}

/* Changes panel->w_px and h_px. What the panel shows is wrong until the next whole frame. */
HAL_MUST_CHECK static inline int panel_set_rotation(struct panel *panel, enum panel_rotation rotation)
{
    return panel->ops->set_rotation ? panel->ops->set_rotation(panel, rotation) : PANEL_ERR_UNSUPPORTED;
}

/* true: shows the negative of the picture. */
HAL_MUST_CHECK static inline int panel_set_inverted(struct panel *panel, bool inverted)
{
    return panel->ops->set_inverted ? panel->ops->set_inverted(panel, inverted) : PANEL_ERR_UNSUPPORTED;
}

HAL_MUST_CHECK static inline int panel_set_backlight(struct panel *panel, bool lit)
{
    return panel->ops->set_backlight ? panel->ops->set_backlight(panel, lit) : PANEL_ERR_UNSUPPORTED;
}

/* Whether a rectangle has pixels, lies within the picture, and keeps to the steps. No sum is formed that could exceed
 * 16 bits. */
static inline bool panel_holds(const struct panel *panel, uint16_t x_px, uint16_t y_px, uint16_t w_px, uint16_t h_px)
{
    return w_px && x_px < panel->w_px && w_px <= panel->w_px - x_px && h_px && y_px < panel->h_px &&
           h_px <= panel->h_px - y_px && x_px % panel->step_x_px == 0 && w_px % panel->step_x_px == 0 &&
           y_px % panel->step_y_px == 0 && h_px % panel->step_y_px == 0;
}

/* Which pixels x0_px <= x < x1_px of a line the glass shows: all, unless it is round. None: x0_px == x1_px. */
static inline void panel_visible(const struct panel *panel, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px)
{
    *x0_px = 0;
    *x1_px = panel->w_px;
    if (panel->visible) panel->visible(panel, y_px, x0_px, x1_px);
}

#endif
