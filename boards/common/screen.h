/* SPDX-License-Identifier: MIT
 *
 * Joins the renderer and a panel: a lim_target whose finished pixels go to the panel at once.
 * Lines that come whole and in order travel in one window a frame; a piece that does not continue
 * where the last one ended opens a window of its own. So does, where pixels share bytes (PANEL_RGB444), what follows an
 * odd number of them; and each line on round glass, of which only what is seen is sent. With memory for two lines one
 * is painted while the other is on its way (DMA). With more, SCREEN_STREAMS, and a port that tells what is on its way,
 * lines wait for the bus and not the other way round: all that are complete go out together when it is free
 * (screen_set_bus()).
 *
 *     static uint32_t mem[SCREEN_MEM_B(240, 2) / 4];
 *     int err = screen_init(&screen, &display.panel, LIM_NEAREST_FIRST, mem, sizeof mem);
 *     ...lim_init(&lim, &scene, &screen.target, ...)...
 *     err = screen_begin_frame(&screen);
 *     if (!err) err = lim_frame(&lim, &camera);
 *     if (!err) err = screen_end_frame(&screen); */
#ifndef BOARDS_SCREEN_H
#define BOARDS_SCREEN_H

#include "bus.h"
#include "camera.h"
#include "greys.h"
#include "panel.h"
#include "screen_work.h"
#include "target.h"

/* Bytes for n_lines of w_px pixels, each line 4-byte aligned. Lines: 1, slow on a bus that works alone; 2; an even
 * number more for lines that are sent together, which nearest first uses in PANEL_RGB565 where w_px is even and the
 * glass not round; the panel's h_px for the painter. A line is packed into the panel's format where it is, which takes
 * more room only if a pixel does: SCREEN_WIDE_... for PANEL_RGB666. */
#define SCREEN_LINE_B(w_px) (((w_px)*2u + 3u) / 4u * 4u)
#define SCREEN_WIDE_LINE_B(w_px) (((w_px) + 3u) / 4u * 4u + SCREEN_LINE_B(w_px))
#define SCREEN_MEM_B(w_px, n_lines) ((size_t)SCREEN_LINE_B(w_px) * (n_lines))
#define SCREEN_WIDE_MEM_B(w_px, n_lines) ((size_t)SCREEN_WIDE_LINE_B(w_px) * (n_lines))
/* For formats whose pixels share bytes (PANEL_MONO_..., PANEL_GREY4): beside the lines two pages, or less, of which one
 * is gathered while the other is on its way; beside a single line one page. Pieces of a line must come from left to
 * right, and all of them. For a single convex solid (LIM_CONVEX, LIM_HAS_FILL) 0 lines will do: its runs are put into
 * the page at once, which takes less time as well. */
#define SCREEN_PAGE_B(w_px) (((w_px) + 3u) / 4u * 4u)
#define SCREEN_PAGES_MEM_B(w_px, n_lines)                                                                              \
    (SCREEN_MEM_B(w_px, n_lines) + ((n_lines) < 2 ? 1u : 2u) * SCREEN_PAGE_B(w_px))

/* 1: screen_set_bus() is there, and room for what it takes. The same for all files of an image. */
#ifndef SCREEN_STREAMS
#define SCREEN_STREAMS 0
#endif

/* Whether lines can be sent together, and how many of n_lines have a use. */
#define SCREEN_JOINS(format, w_px, is_round)                                                                           \
    (SCREEN_STREAMS && (format) == PANEL_RGB565 && (w_px) % 2 == 0 && !(is_round))
#define SCREEN_USED_LINES(format, w_px, is_round, n_lines)                                                             \
    (SCREEN_JOINS(format, w_px, is_round) || (n_lines) < 2 ? (n_lines) : 2)

/* For screen_set_frame(), in PANEL_GREY4. */
#define SCREEN_FRAME_MEM_B(w_px, h_px) ((size_t)(((w_px) + 7u) / 8u * 4u) * (h_px))

/* Whether a screen may keep the whole picture: what LIM_NEAREST_FIRST fills. */
#define SCREEN_KEEPS_FRAME (LIM_HAS_FILL && LIM_HAS_NEAREST)

/* Private but for `target`. */
struct screen {
    struct lim_target target; /* what the renderer paints into */
    struct panel *panel;
    uint8_t *mem;
    uint16_t line_b, n_lines; /* length of a line in mem, and how many are used */
    bool is_whole;            /* all lines of the picture, each at its own place */
    uint16_t head_b;          /* of a line, before what the renderer paints into */
    uint8_t *gathered;        /* n_gathered of gathered_b bytes, or NULL */
    uint16_t gathered_b;
    uint8_t n_gathered;     /* 1 or 2 */
    uint16_t gathered_y_px; /* which lines are being gathered, or none of this frame */
    uint8_t *filled;        /* where lines are gathered without lines of their own */
    uint16_t filled_y_px;   /* of the last run, or none of this frame */
    bool second_gathered;   /* in the second of them */
    bool gathered_sent;     /* some of it went to the panel, and may still be on its way */
    uint16_t lent_line;     /* nearest first: index of the line lent last */
    bool lent_line_sent;    /* some of it went to the panel, and may still be on its way */
    bool window_open;       /* pixels can follow at next_x_px, next_y_px */
    bool window_given;      /* by the renderer, which sends just what fills it */
    uint16_t window_x0_px, window_x1_px;
    uint16_t window_end_y_px; /* first line below the window */
    uint16_t next_x_px, next_y_px;
    bool half_byte; /* the window's last pixel ends within a byte, which is filled up */
#if SCREEN_STREAMS
    struct bus bus; /* the panel's, if it was told */
    screen_work *work;
    void *work_ctx;
    size_t spare_b;         /* as long as more than that is to be sent, work is done */
    uint16_t block_lines;   /* half of the lines, or 1: how many can be sent together */
    uint16_t waiting_lines; /* complete, one below the other, and not sent yet */
    uint16_t waiting_line;  /* the index of the first of them */
    uint16_t waiting_y_px;
#endif
#if SCREEN_KEEPS_FRAME
    struct greys greys; /* the picture, if there is memory for it */
#endif
};

HAL_C_BEGIN

/* Prepares *screen, which must not move, for the panel's present size: call it again after a
 * change of rotation. mem is 4-byte aligned; it and the panel must outlive *screen.
 * LIM_ERR_MEMORY: mem_b holds no line, or for the painter not all. */
LIM_MUST_CHECK int screen_init(struct screen *screen, struct panel *panel, enum lim_method method, void *mem,
                               size_t mem_b);

#if LIM_HAS_FRAMEBUFFER
/* The same with memory for all of the panel's lines, into which LIM_NEAREST_FIRST and LIM_PAINTER paint each polygon as
 * it comes. */
LIM_MUST_CHECK int screen_init_framebuffer(struct screen *screen, struct panel *panel, enum lim_method method,
                                           void *mem, size_t mem_b);
#endif

#if SCREEN_KEEPS_FRAME
/* Lends memory for the whole picture, 4-byte aligned, which must outlive *screen: frames that the renderer can fill
 * come there and go out in one piece. PANEL_ERR_UNSUPPORTED: the panel's pixels are not PANEL_GREY4, or lines of them
 * do not take whole words; LIM_ERR_MEMORY. */
LIM_MUST_CHECK int screen_set_frame(struct screen *screen, void *frame, size_t frame_b);
#endif

#if SCREEN_STREAMS
/* Tells the port that the panel is on (struct bus), of which left_b() is asked, and what to do instead of waiting for
 * it: work() does a little, which needs nothing of the screen, and returns whether there is more. NULL: nothing. */
void screen_set_bus(struct screen *screen, const struct bus *bus, screen_work *work, void *ctx);
#endif

/* Before each frame: whatever was sent to the panel meanwhile, the frame starts with a window; it is held until the
 * panel is ready for it (panel_begin_frame()). 0 or the panel's negative code. */
LIM_MUST_CHECK int screen_begin_frame(struct screen *screen);

/* For panels that cannot turn by a quarter: the camera of a picture that is to stand so many quarters clockwise on the
 * glass, for a target of the glass's own size. */
void screen_turn_camera(struct lim_camera *camera, enum panel_rotation rotation);

/* After each frame: waits until it has left. 0 or the panel's negative code. */
LIM_MUST_CHECK int screen_end_frame(struct screen *screen);

HAL_C_END

#endif
