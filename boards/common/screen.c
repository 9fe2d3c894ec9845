/* SPDX-License-Identifier: MIT
 *
 * A panel as the renderer's target.
 * In: pieces of lines, from the renderer. Out: windows and pixels, to the panel. Memory: the
 * caller's lines. A line whose pixels may still be on their way is never lent: with two lines, a
 * panel that accepts the second has finished with the first; with one, done() waits. */
#include "screen.h"

#include "colour.h"

enum { SCREEN_NO_LINE = 0xFFFF }; /* nothing is gathered yet */

/* Before whatever may wait for the bus. No work begins when so little is left that the bus would have to wait for it,
 * as far as one can tell: an eighth of what goes out together. */
static void screen_meanwhile(struct screen *screen)
{
#if SCREEN_STREAMS
    if (!screen->work) return;
    while (bus_left_b(&screen->bus) > screen->spare_b && screen->work(screen->work_ctx))
        ;
#else
    (void)screen;
#endif
}

static int screen_flush(struct screen *screen)
{
    screen_meanwhile(screen);
    return panel_flush(screen->panel);
}

/* Of a picture every line is found at its own place; else they take turns. */
static uint8_t *screen_line(const struct screen *screen, uint16_t y_px)
{
    uint16_t index = screen->is_whole ? y_px : screen->lent_line;
    return screen->mem + (size_t)index * screen->line_b;
}

static void *screen_lend(void *ctx, uint16_t y_px)
{
    struct screen *screen = ctx;
    if (!LIM_HAS_LINES || y_px >= screen->target.h_px || screen->n_lines == 0) return NULL;
    if (screen->lent_line_sent) {
        screen->lent_line = screen->lent_line + 1u < screen->n_lines ? (uint16_t)(screen->lent_line + 1u) : 0;
        screen->lent_line_sent = false;
    }
    return screen_line(screen, y_px) + screen->head_b;
}

static int screen_open_window(struct screen *screen, uint16_t x_px, uint16_t y_px, uint16_t w_px, uint16_t h_px)
{
    screen_meanwhile(screen);
    int err = panel_window(screen->panel, x_px, y_px, w_px, h_px);
    screen->window_open = !err;
    screen->window_given = false;
    screen->half_byte = false;
    screen->window_x0_px = x_px;
    screen->window_x1_px = (uint16_t)(x_px + w_px);
    screen->window_end_y_px = (uint16_t)(y_px + h_px);
    screen->next_x_px = x_px;
    screen->next_y_px = y_px;
    return err;
}

/* The next pixel that is sent will be this one. From a line's start a window takes all the lines below as well, from
 * its middle only the rest of the line: what follows usually fits, and a window need not be filled. */
static int screen_reach(struct screen *screen, uint16_t y_px, uint16_t x_px)
{
    const bool continues =
        screen->window_open && screen->next_x_px == x_px && screen->next_y_px == y_px && !screen->half_byte;

    if (continues) return 0;
    return screen_open_window(screen, x_px, y_px, (uint16_t)(screen->target.w_px - x_px),
                              x_px == 0 ? (uint16_t)(screen->target.h_px - y_px) : screen->panel->step_y_px);
}

static void screen_advance(struct screen *screen, uint16_t n_px)
{
    screen->next_x_px = (uint16_t)(screen->next_x_px + n_px);
    if (screen->next_x_px < screen->window_x1_px) return;
    screen->next_x_px = screen->window_x0_px;
    screen->next_y_px = (uint16_t)(screen->next_y_px + screen->panel->step_y_px);
    if (screen->next_y_px == screen->window_end_y_px) screen->window_open = false;
}

/* In place: what is left of a piece has been packed or is not seen, and a packed pixel lies before where it was. */
static const uint8_t *screen_pack(const struct screen *screen, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    const enum panel_format format = screen->panel->format;
    uint8_t *line = screen_line(screen, y_px);
    uint8_t *to = line + pixels_b(format, x_px); /* behind what may still be on its way */

    pixels_pack(format, to, line + screen->head_b + pixels_b(PANEL_RGB565, x_px), x_px, y_px, n_px);
    return to;
}

#if SCREEN_STREAMS
/* Lines that wait, together. While they are on their way lines of the other half are lent. */
static int screen_send_waiting(struct screen *screen)
{
    const uint16_t n_lines = screen->waiting_lines;

    screen->waiting_lines = 0;
    if (n_lines == 0) return 0;
    int err = screen_reach(screen, screen->waiting_y_px, 0);
    if (err) return err;
    screen_meanwhile(screen);
    err = panel_pixels(screen->panel, screen->mem + (size_t)screen->waiting_line * screen->line_b,
                       (size_t)n_lines * screen->target.w_px);
    if (err) return err;
    screen->next_y_px = (uint16_t)(screen->next_y_px + n_lines);
    if (screen->next_y_px == screen->window_end_y_px) screen->window_open = false;
    return 0;
}

/* A whole line waits for a bus that is free, or for the last one of its half. */
static int screen_wait(struct screen *screen, uint16_t y_px)
{
    const bool goes_on = y_px == screen->waiting_y_px + screen->waiting_lines;
    int err = goes_on ? 0 : screen_send_waiting(screen);

    if (err) return err;
    if (screen->waiting_lines++ == 0) {
        screen->waiting_line = screen->lent_line;
        screen->waiting_y_px = y_px;
    }
    screen->lent_line_sent = true;
    const bool is_last = (screen->lent_line + 1u) % screen->block_lines == 0;
    return is_last || bus_left_b(&screen->bus) == 0 ? screen_send_waiting(screen) : 0;
}
#else
static int screen_send_waiting(struct screen *screen)
{
    (void)screen;
    return 0;
}
#endif

/* A piece of a line, or one that can be sent alone only. */
static int screen_send_piece(struct screen *screen, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    int err = screen_send_waiting(screen);
    if (!err) err = screen_reach(screen, y_px, x_px);
    if (err) return err;
    screen->lent_line_sent = true;
    screen->half_byte = screen->panel->format == PANEL_RGB444 && n_px % 2;
    screen_meanwhile(screen);
    err = panel_pixels(screen->panel, screen_pack(screen, y_px, x_px, n_px), n_px);
    if (err) return err;
    screen_advance(screen, n_px);
    return screen->n_lines == 1 ? screen_flush(screen) : 0;
}

static int screen_send(struct screen *screen, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
#if SCREEN_STREAMS
    if (screen->block_lines > 1 && n_px == screen->target.w_px) return screen_wait(screen, y_px);
#endif
    return screen_send_piece(screen, y_px, x_px, n_px);
}

/* Another page, black at first, and not where something may still be on its way. */
static void screen_begin_gathering(struct screen *screen, uint16_t y_px)
{
    if (screen->gathered_sent && screen->n_gathered > 1) screen->second_gathered = !screen->second_gathered;
    screen->gathered_sent = false;
    screen->gathered_y_px = y_px;
    uint8_t *byte = screen->gathered + (screen->second_gathered ? screen->gathered_b : 0);
    for (uint8_t *const end = byte + screen->gathered_b; byte < end;)
        *byte++ = 0;
}

/* How many columns from x_px on are of whole steps. */
static uint16_t screen_whole_px(uint16_t x_px, uint16_t step_px)
{
    if (step_px == 1) return x_px;
    return (uint16_t)(x_px / step_px * step_px);
}

/* What lines from gathered_y_px on have in common, as far as all that is above and on the left of it is done. */
static int screen_send_gathered(struct screen *screen, const uint8_t *gathered, uint16_t x0_px, uint16_t x1_px)
{
    struct panel *panel = screen->panel;
    const uint16_t from_px = screen_whole_px(x0_px, panel->step_x_px);
    const uint16_t whole_px = (uint16_t)(screen_whole_px(x1_px, panel->step_x_px) - from_px);

    if (whole_px == 0) return 0;
    int err = screen_reach(screen, screen->gathered_y_px, from_px);
    if (err) return err;
    screen->gathered_sent = true;
    screen_meanwhile(screen);
    err = panel_pixels(panel, gathered + pixels_b(panel->format, (size_t)from_px * panel->step_y_px),
                       (size_t)whole_px * panel->step_y_px);
    if (err) return err;
    screen_advance(screen, whole_px);
    return screen->n_gathered == 1 ? screen_flush(screen) : 0;
}

/* Where lines are gathered, line y_px among them. */
static uint8_t *screen_gathering(struct screen *screen, uint16_t y_px)
{
    const uint16_t step_y_px = screen->panel->step_y_px;
    const bool goes_on = y_px >= screen->gathered_y_px && y_px - screen->gathered_y_px < step_y_px;

    if (!goes_on) screen_begin_gathering(screen, (uint16_t)(y_px - y_px % step_y_px));
    return screen->gathered + (screen->second_gathered ? screen->gathered_b : 0);
}

/* Where pixels share bytes, what lines have in common is gathered apart, and goes out with the last of these lines.
 * Without lines it is there already, filled by runs. */
static int screen_gather(struct screen *screen, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    const struct panel *panel = screen->panel;
    uint8_t *gathered = screen_gathering(screen, y_px);

    if (LIM_HAS_LINES && screen->n_lines)
        pixels_gather(panel->format, gathered, screen_line(screen, y_px) + pixels_b(PANEL_RGB565, x_px), x_px, y_px,
                      n_px);
    screen->lent_line_sent = true;
    if (y_px - screen->gathered_y_px + 1 < panel->step_y_px) return 0;
    return screen_send_gathered(screen, gathered, x_px, (uint16_t)(x_px + n_px));
}

#if LIM_HAS_FILL && LIM_HAS_CONVEX
/* Into a page. A line's first piece is its background: where that is black, it is so already. */
static void screen_fill_page(void *of_look, uint16_t x0_px, uint16_t x1_px)
{
    const struct lim_piece_look *look = of_look;
    struct screen *screen = look->ctx;

    if (look->y_px != screen->filled_y_px) {
        screen->filled_y_px = look->y_px;
        screen->filled = screen_gathering(screen, look->y_px);
        if (look->colour == 0) return;
    }
    pixels_fill(screen->panel->format, screen->filled, lim_memory_colour(look->colour), x0_px, look->y_px,
                (uint16_t)(x1_px - x0_px));
}
#endif

static void screen_visible(void *ctx, uint16_t y_px, uint16_t *x0_px, uint16_t *x1_px)
{
    const struct screen *screen = ctx;
    panel_visible(screen->panel, y_px, x0_px, x1_px);
}

#if LIM_HAS_DELTA
static int screen_window(void *ctx, const struct lim_rect *window)
{
    struct screen *screen = ctx;
    int err = screen_send_waiting(screen);
    if (err) return err;
    if (!window) {
        screen->window_open = screen->window_open && !screen->window_given;
        screen->window_given = false;
        return 0;
    }
    err = screen_open_window(screen, window->x0, window->y0, (uint16_t)(window->x1 - window->x0),
                             (uint16_t)(window->y1 - window->y0));
    screen->window_given = true;
    return err;
}

/* In RGB444 two pixels share a byte, which only windows that begin between others need to know. Where an open window
 * goes on with the next page, and another costs more than a page, pages that have changed go out whole. */
static uint16_t screen_align_px(const struct panel *panel)
{
    if (panel->runs_on && panel->window_b > pixels_b(panel->format, (size_t)panel->w_px * panel->step_y_px))
        return panel->w_px;
    return panel->format == PANEL_RGB444 ? 2 : panel->step_x_px;
}

/* Eight columns of a step have as many bytes as one has bits. */
static struct lim_target_costs screen_costs(const struct panel *panel)
{
    return (struct lim_target_costs){
        .window_b = panel->window_b,
        .pixel_bits = (uint8_t)pixels_b(panel->format, (size_t)8u * panel->step_y_px),
        .page_px = (uint8_t)panel->step_y_px,
        .x_align_px = screen_align_px(panel),
    };
}
#endif

static int screen_done(void *ctx, uint16_t y_px, uint16_t x_px, uint16_t n_px)
{
    struct screen *screen = ctx;
    LIM_DEBUG_ASSERT(y_px < screen->target.h_px && x_px <= screen->target.w_px && n_px <= screen->target.w_px - x_px);
    uint16_t x0_px, x1_px, end_px = (uint16_t)(x_px + n_px);
    screen_visible(screen, y_px, &x0_px, &x1_px);
    if (x0_px < x_px || screen->window_given) x0_px = x_px;
    if (x1_px > end_px || screen->window_given) x1_px = end_px;
    if (x0_px >= x1_px) return 0;
    const uint16_t seen_px = (uint16_t)(x1_px - x0_px);
    int err = !LIM_HAS_LINES || screen->gathered ? screen_gather(screen, y_px, x0_px, seen_px)
                                                 : screen_send(screen, y_px, x0_px, seen_px);
    if (err) screen->window_open = false;
    return err;
}

#if SCREEN_KEEPS_FRAME
static void screen_fill_greys(void *of_look, uint16_t x0_px, uint16_t x1_px)
{
    const struct lim_piece_look *look = of_look;
    struct greys *greys = &((struct screen *)look->ctx)->greys;

    if (look->colour != greys->colour) greys_set(greys, look->colour);
    greys_fill(greys, look->y_px, x0_px, x1_px);
}

static int screen_show(void *ctx)
{
    struct screen *screen = ctx;
    const uint16_t w_px = screen->target.w_px, h_px = screen->target.h_px;

    int err = panel_window(screen->panel, 0, 0, w_px, h_px);
    return err ? err : panel_pixels(screen->panel, screen->greys.picture, (size_t)w_px * h_px);
}

int screen_set_frame(struct screen *screen, void *frame, size_t frame_b)
{
    const struct panel *panel = screen->panel;

    if (panel->format != PANEL_GREY4 || panel->w_px % 8 || panel->visible) return PANEL_ERR_UNSUPPORTED;
    if (frame_b < SCREEN_FRAME_MEM_B(panel->w_px, panel->h_px)) return LIM_ERR_MEMORY;
    screen->greys = (struct greys){.picture = frame, .line_b = panel->w_px / 2};
    greys_set(&screen->greys, 0);
    screen->target.fill = screen_fill_greys;
    screen->target.show = screen_show;
    return 0;
}
#endif

/* 4-byte aligned, as lines are. */
static uint16_t screen_gathered_b(const struct panel *panel)
{
    if (panel->step_x_px == 1 && panel->step_y_px == 1) return 0;
    return (uint16_t)((pixels_b(panel->format, (size_t)panel->w_px * panel->step_y_px) + 3u) / 4u * 4u);
}

static uint16_t screen_most_lines(const struct panel *panel, bool is_whole)
{
    if (is_whole) return panel->h_px;
    return SCREEN_USED_LINES(panel->format, panel->w_px, panel->visible != NULL, UINT16_MAX - 1);
}

static inline void screen_init_stream(struct screen *screen)
{
#if SCREEN_STREAMS
    const bool takes_turns = !screen->is_whole && screen->n_lines > 1;
    screen->block_lines = takes_turns ? screen->n_lines / 2 : 1;
    if (takes_turns) screen->n_lines = (uint16_t)(2 * screen->block_lines);
    screen->spare_b = (screen->gathered ? screen->gathered_b : (size_t)screen->block_lines * screen->line_b) / 8;
#else
    (void)screen;
#endif
}

static int screen_init_lines(struct screen *screen, struct panel *panel, enum lim_method method, bool is_whole,
                             void *mem, size_t mem_b)
{
    const uint16_t head_b = (uint16_t)((pixels_head_b(panel->format, panel->w_px) + 3u) / 4u * 4u);
    uint16_t line_b = (uint16_t)(head_b + SCREEN_LINE_B(panel->w_px));
    const uint16_t most_lines = screen_most_lines(panel, is_whole);
    const uint16_t gathered_b = screen_gathered_b(panel);
    const bool takes_runs = LIM_HAS_FILL && method == LIM_CONVEX && gathered_b && mem_b >= gathered_b;
    const size_t pages_b = mem_b < 2u * gathered_b + line_b ? gathered_b : 2u * gathered_b;
    const size_t n_lines = mem_b < pages_b ? 0 : (mem_b - pages_b) / line_b;
    if ((n_lines == 0 && !takes_runs) || (is_whole && n_lines < panel->h_px)) return LIM_ERR_MEMORY;

    *screen = (struct screen){.panel = panel, .mem = mem, .line_b = line_b, .head_b = head_b, .gathered_b = gathered_b};
    screen->is_whole = is_whole;
    screen->n_lines = n_lines < most_lines ? (uint16_t)n_lines : most_lines;
    if (gathered_b) screen->gathered = screen->mem + (size_t)screen->n_lines * line_b;
    screen->n_gathered = pages_b > gathered_b ? 2 : 1;
    screen->target = (struct lim_target)
    {
        .w_px = panel->w_px, .h_px = panel->h_px, .format = LIM_RGB565, .method = method, .ctx = screen,
        .lend = screen_lend, .done = screen_done,
#if LIM_HAS_FILL && LIM_HAS_CONVEX
        .fill = n_lines ? NULL : screen_fill_page,
#endif
#if LIM_HAS_ROUND
        .visible = panel->visible ? screen_visible : NULL,
#endif
#if LIM_HAS_DELTA
        .window = screen_window, .costs = screen_costs(panel),
#endif
    };
    screen_init_stream(screen);
    return 0;
}

int screen_init(struct screen *screen, struct panel *panel, enum lim_method method, void *mem, size_t mem_b)
{
    return screen_init_lines(screen, panel, method, method == LIM_PAINTER, mem, mem_b);
}

#if LIM_HAS_FRAMEBUFFER
int screen_init_framebuffer(struct screen *screen, struct panel *panel, enum lim_method method, void *mem, size_t mem_b)
{
    const int err = screen_init_lines(screen, panel, method, true, mem, mem_b);

    if (!err) screen->target.framebuffer = (struct lim_framebuffer){screen->mem + screen->head_b, screen->line_b / 2};
    return err;
}
#endif

int screen_begin_frame(struct screen *screen)
{
    screen->window_open = false;
#if SCREEN_STREAMS
    screen->waiting_lines = 0;
#endif
    screen->gathered_y_px = screen->filled_y_px = SCREEN_NO_LINE;
    return panel_begin_frame(screen->panel);
}

int screen_end_frame(struct screen *screen)
{
    const int err = screen_send_waiting(screen);
    return err ? err : screen_flush(screen);
}

#if SCREEN_STREAMS
void screen_set_bus(struct screen *screen, const struct bus *bus, screen_work *work, void *ctx)
{
    screen->bus = *bus;
    screen->work = work;
    screen->work_ctx = ctx;
}
#endif

void screen_turn_camera(struct lim_camera *camera, enum panel_rotation rotation)
{
    const uint32_t tan_x_q28 = camera->tan_x_q28;

    camera->roll -= (uint32_t)rotation << 30;
    if (rotation != PANEL_TURNED_90 && rotation != PANEL_TURNED_270) return;
    camera->tan_x_q28 = camera->tan_y_q28;
    camera->tan_y_q28 = tan_x_q28;
}
