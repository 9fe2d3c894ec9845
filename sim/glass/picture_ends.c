/* SPDX-License-Identifier: MIT
 *
 * From a picture's last place in memory to the next one's first it is further than any two places are that follow each
 * other within a picture, whichever way pictures run over memory. */
#include "glass/picture_ends.h"

#include "displays/idle_port.h"

#include <stdlib.h>

static uint64_t visible_px(const struct panel *panel)
{
    uint64_t sum_px = 0;
    for (uint16_t y_px = 0; y_px < panel->h_px; y_px++) {
        uint16_t x0_px, x1_px;
        panel_visible(panel, y_px, &x0_px, &x1_px);
        sum_px += (uint64_t)(x1_px - x0_px);
    }
    return sum_px;
}

bool picture_ends_init(struct picture_ends *ends, const struct module_choice *choice, struct error *err)
{
    struct display display;
    *ends = (struct picture_ends){.w_px = choice->module.w_px, .h_px = choice->module.h_px};
    if (!idle_display_setup(&display, choice, err)) return false;
    ends->is_round = display.panel->visible;
    ends->whole_px = visible_px(display.panel);
    return true;
}

/* From one corner of the glass to the opposite one. In two rows of places, as of eight lines each, only upwards. */
static bool is_across(const struct picture_ends *ends, const struct emulated_place *from,
                      const struct emulated_place *to)
{
    const unsigned dx_px = (unsigned)abs(to->x_px - from->x_px), dy_px = (unsigned)abs(to->y_px - from->y_px);
    const bool is_width = dx_px + to->w_px >= ends->w_px, is_height = dy_px + to->h_px >= ends->h_px;
    if (ends->is_round) return (is_width && dy_px > 1) || (is_height && dx_px > 1);
    return is_width && is_height && (ends->h_px > 2u * to->h_px || to->y_px < from->y_px);
}

bool picture_ends_store(struct picture_ends *ends, struct emulated_place place)
{
    if (!ends->has_begun || is_across(ends, &ends->last, &place)) {
        ends->first = place;
        ends->stored_px = 0;
    }
    ends->has_begun = true;
    ends->last = place;
    ends->stored_px += (uint64_t)place.w_px * place.h_px;
    if (ends->stored_px < ends->whole_px || !is_across(ends, &place, &ends->first)) return false;
    ends->has_begun = false;
    return true;
}

bool picture_ends_command(struct picture_ends *ends)
{
    if (!ends->has_begun || ends->stored_px < ends->whole_px) return false;
    ends->has_begun = false;
    return true;
}
