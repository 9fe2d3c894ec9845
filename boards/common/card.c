/* SPDX-License-Identifier: MIT
 *
 * Line by line, through the renderer's own target: into a line's memory, or in runs where there is none. */
#include "card.h"

#include "colour.h"
#include "test_card.h"

/* Where the viewer has what lies at x, y of the glass. */
static uint16_t card_px(const struct lim_target *target, enum panel_rotation turn, uint16_t x_px, uint16_t y_px)
{
    const uint16_t w_px = target->w_px, h_px = target->h_px;

    switch (turn) {
    case PANEL_TURNED_90:
        return test_card_px(y_px, w_px - 1u - x_px, h_px, w_px);
    case PANEL_TURNED_180:
        return test_card_px(w_px - 1u - x_px, h_px - 1u - y_px, w_px, h_px);
    case PANEL_TURNED_270:
        return test_card_px(h_px - 1u - y_px, x_px, h_px, w_px);
    default:
        return test_card_px(x_px, y_px, w_px, h_px);
    }
}

#if LIM_HAS_FILL
static void card_fill(const struct lim_target *target, uint16_t y_px, uint16_t x0_px, uint16_t x1_px, uint16_t rgb565)
{
    struct lim_piece_look look = {target->ctx, lim_memory_colour(rgb565), y_px};

    target->fill(&look, x0_px, x1_px);
}

/* As the renderer has them: the background from end to end, then what lies on it. */
static void card_fill_line(const struct lim_target *target, enum panel_rotation turn, uint16_t y_px)
{
    uint16_t from_px = 0, run = card_px(target, turn, 0, y_px);

    card_fill(target, y_px, 0, target->w_px, 0);
    for (uint16_t x_px = 1; x_px <= target->w_px; x_px++) {
        const uint16_t rgb565 = x_px < target->w_px ? card_px(target, turn, x_px, y_px) : 0;
        if (x_px < target->w_px && rgb565 == run) continue;
        if (run) card_fill(target, y_px, from_px, x_px, run);
        from_px = x_px;
        run = rgb565;
    }
}
#endif

/* Into the memory that the screen lends. */
static int card_put_line(const struct lim_target *target, enum panel_rotation turn, uint16_t y_px)
{
    uint8_t *byte = target->lend(target->ctx, y_px);

    if (!byte) return LIM_ERR_TARGET;
    for (uint16_t x_px = 0; x_px < target->w_px; x_px++) {
        const uint16_t rgb565 = card_px(target, turn, x_px, y_px);
        *byte++ = (uint8_t)(rgb565 >> 8);
        *byte++ = (uint8_t)rgb565;
    }
    return 0;
}

/* A screen that keeps the whole picture gets the card by lines, as others do. */
static int card_draw_line(const struct lim_target *target, enum panel_rotation turn, uint16_t y_px)
{
#if LIM_HAS_FILL && SCREEN_KEEPS_FRAME
    const bool fills = target->fill && !target->show;
#elif LIM_HAS_FILL
    const bool fills = target->fill != NULL;
#endif
#if LIM_HAS_FILL
    if (fills) {
        card_fill_line(target, turn, y_px);
        return 0;
    }
#endif
    return card_put_line(target, turn, y_px);
}

int card_draw(struct screen *screen, enum panel_rotation turn)
{
    const struct lim_target *target = &screen->target;
    int err = screen_begin_frame(screen);

    for (uint16_t y_px = 0; y_px < target->h_px && !err; y_px++) {
        err = card_draw_line(target, turn, y_px);
        if (!err) err = target->done(target->ctx, y_px, 0, target->w_px);
    }
    return err ? err : screen_end_frame(screen);
}
