/* SPDX-License-Identifier: MIT
 *
 * What of an emulated chip's memory is on its glass, and how the eye sees it. */
#include "glass/emulated_dcs.h"

#include <string.h>

enum { REFRESH_UP = 0x10, BLUE_FIRST = 0x08 };            /* of MADCTL */
enum { SCAN_ROWS_BACK = 0x40, SCAN_COLUMNS_BACK = 0x20 }; /* of the register for scanning */

static void see(const struct emulated_dcs *chip, const struct emulated_pixel *pixel, uint8_t rgb[3])
{
    bool lit = chip->display_on && !chip->asleep && !chip->port.reset_low && !chip->port.backlight_low;
    bool negative = chip->inverted != chip->glass.negative;
    bool swapped = ((chip->madctl & BLUE_FIRST) != 0) != chip->glass.blue_first;
    for (unsigned i = 0; i < 3; i++) {
        uint8_t c = pixel->rgb[swapped ? 2 - i : i];
        rgb[i] = !lit ? 0 : negative ? (uint8_t)(255 - c) : c;
    }
}

/* The glass's own x and y. A pixel is seen if its centre is inside of the ellipse. */
static bool is_on_glass(const struct emulated_dcs *chip, unsigned x, unsigned y)
{
    const struct glass *glass = &chip->glass;
    const double dx = (2.0 * x + 1.0 - glass->w_px) / glass->w_px, dy = (2.0 * y + 1.0 - glass->h_px) / glass->h_px;

    return !chip->kind->is_round || dx * dx + dy * dy <= 1.0;
}

/* Memory is scanned from its first row on, whichever end of the glass shows it. */
bool emulated_dcs_follows_refresh(const struct emulated_dcs *chip)
{
    const struct glass *glass = &chip->glass;
    const unsigned from = glass->lines_back ? glass->line + 1u - glass->h_px : glass->line;

    return chip->first_row == (chip->madctl & REFRESH_UP ? from + glass->h_px - 1u : from);
}

/* What of memory drives the glass's pixel: scanned backwards, each output gets what the opposite one would. */
static const struct emulated_pixel *pixel_at(const struct emulated_dcs *chip, unsigned x, unsigned y)
{
    const struct glass *glass = &chip->glass;
    const unsigned column = glass_column(glass, x), row = glass_line(glass, y);

    return &chip->memory[chip->scan & SCAN_ROWS_BACK ? glass->mem_h_px - 1u - row : row]
                        [chip->scan & SCAN_COLUMNS_BACK ? glass->mem_w_px - 1u - column : column];
}

void emulated_dcs_show(const struct emulated_dcs *chip, unsigned quarter_turns, uint8_t *rgb, uint32_t *raw)
{
    const struct glass *glass = &chip->glass;
    unsigned w_px = quarter_turns % 2 ? glass->h_px : glass->w_px;
    unsigned h_px = quarter_turns % 2 ? glass->w_px : glass->h_px;
    for (unsigned i = 0; i < w_px * h_px; i++) {
        unsigned x = i % w_px;
        unsigned y = i / w_px;
        unsigned right = w_px - 1 - x;
        unsigned below = h_px - 1 - y;
        const unsigned column[] = {x, below, right, y};
        const unsigned row[] = {y, x, below, right};
        const unsigned glass_x = column[quarter_turns % 4], glass_y = row[quarter_turns % 4];
        const struct emulated_pixel *pixel = pixel_at(chip, glass_x, glass_y);
        if (rgb) see(chip, pixel, &rgb[(size_t)3 * i]);
        if (rgb && !is_on_glass(chip, glass_x, glass_y)) memset(&rgb[(size_t)3 * i], 0, 3);
        if (raw) raw[i] = pixel->raw;
    }
}
