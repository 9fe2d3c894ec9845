/* SPDX-License-Identifier: MIT */
#include "card.h"

#include "test_card.h"

int card_draw(struct screen *screen)
{
    const struct lim_target *target = &screen->target;

    int err = screen_begin_frame(screen);
    for (uint16_t y_px = 0; y_px < target->h_px && !err; y_px++) {
        uint8_t *line = target->lend(target->ctx, y_px);
        for (unsigned x_px = 0; x_px < target->w_px; x_px++) {
            const uint16_t rgb565 = test_card_px(x_px, y_px, target->w_px, target->h_px);
            line[2 * x_px] = (uint8_t)(rgb565 >> 8);
            line[2 * x_px + 1] = (uint8_t)rgb565;
        }
        err = target->done(target->ctx, y_px, 0, target->w_px);
    }
    return err ? err : screen_end_frame(screen);
}
