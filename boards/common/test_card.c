/* SPDX-License-Identifier: MIT */
#include "test_card.h"

static unsigned corner_side_px(unsigned w_px, unsigned h_px)
{
    return (w_px < h_px ? w_px : h_px) / 4;
}

bool test_card_corner(unsigned x_px, unsigned y_px, unsigned w_px, unsigned h_px, uint16_t *rgb565)
{
    const unsigned side_px = corner_side_px(w_px, h_px);
    const bool left = x_px < side_px, right = x_px >= w_px - side_px;
    const bool top = y_px < side_px, bottom = y_px >= h_px - side_px;
    if (!(left || right) || !(top || bottom)) return false;
    if (top)
        *rgb565 = left ? TEST_CARD_RED : TEST_CARD_GREEN;
    else
        *rgb565 = left ? TEST_CARD_GREY : TEST_CARD_BLUE;
    return true;
}

uint16_t test_card_px(unsigned x_px, unsigned y_px, unsigned w_px, unsigned h_px)
{
    const unsigned side_px = corner_side_px(w_px, h_px);
    uint16_t rgb565;
    if (test_card_corner(x_px, y_px, w_px, h_px, &rgb565)) {
        if (rgb565 != TEST_CARD_GREY) return rgb565;
        const unsigned grey = side_px > 1 ? 63 * x_px / (side_px - 1) : 63; /* of 6 bits */
        return (uint16_t)(grey >> 1 << 11 | grey << 5 | grey >> 1);
    }
    const bool is_edge = x_px == 0 || y_px == 0 || x_px + 1 == w_px || y_px + 1 == h_px;
    return is_edge ? 0xFFFF : 0;
}
