/* SPDX-License-Identifier: MIT
 *
 * How a turned picture runs over a chip's memory, for chips that can count its columns and rows backwards and exchange
 * the two: axes are exchanged first, then memory columns and rows are reversed, whatever came before. */
#ifndef HAL_TURN_H
#define HAL_TURN_H

#include "panel.h"

/* The bits are those of MADCTL, MIPI DCS's register for it. */
enum turn { TURN_ROWS = 0x80, TURN_COLUMNS = 0x40, TURN_EXCHANGE = 0x20 };

/* A picture turned clockwise by 90 degrees runs down the glass from its right edge: its x is the memory's row, its y
 * the reversed column; and so on round. A mirrored picture runs its x backwards, which is along rows when columns and
 * rows are exchanged. */
static inline uint8_t turn_of(enum panel_rotation rotation, bool mirror)
{
    static const uint8_t turned[] = {0, TURN_EXCHANGE | TURN_COLUMNS, TURN_COLUMNS | TURN_ROWS,
                                     TURN_EXCHANGE | TURN_ROWS};
    const unsigned turn = turned[rotation];
    const unsigned along_x = turn & TURN_EXCHANGE ? TURN_ROWS : TURN_COLUMNS;

    return (uint8_t)(mirror ? turn ^ along_x : turn);
}

/* The picture's size, of glass that is w_px x h_px upright. */
static inline void turn_size(struct panel *panel, enum panel_rotation rotation, uint16_t w_px, uint16_t h_px)
{
    const bool exchanges = turn_of(rotation, false) & TURN_EXCHANGE;

    panel->w_px = exchanges ? h_px : w_px;
    panel->h_px = exchanges ? w_px : h_px;
}

#endif
