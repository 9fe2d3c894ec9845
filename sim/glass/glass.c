/* SPDX-License-Identifier: MIT
 *
 * Looks rows up, and makes others after them. */
#include "glass/glass.h"

#include <assert.h>
#include <string.h>

const struct glass *glass_find(const char *chip, unsigned w_px, unsigned h_px)
{
    for (const struct glass *row = glass_rows; row->chip; row++)
        if (strcmp(row->chip, chip) == 0 && (!w_px || (row->w_px == w_px && row->h_px == h_px))) return row;
    return NULL;
}

static uint16_t counted(bool back, unsigned all, unsigned at)
{
    return (uint16_t)(back ? all - 1 - at : at);
}

struct glass glass_like(const char *chip, unsigned w_px, unsigned h_px, unsigned ox_px, unsigned oy_px)
{
    const struct glass *usual = glass_find(chip, 0, 0);
    assert(usual);
    struct glass glass = *usual;
    glass.w_px = (uint16_t)w_px;
    glass.h_px = (uint16_t)h_px;
    glass.column = counted(usual->columns_back, usual->mem_w_px, ox_px);
    glass.line = counted(usual->lines_back, usual->told_lines ? h_px : usual->mem_h_px, oy_px);
    return glass;
}

unsigned glass_column(const struct glass *glass, unsigned x)
{
    return glass->columns_back ? glass->column - x : glass->column + x;
}

unsigned glass_line(const struct glass *glass, unsigned y)
{
    return (glass->lines_back ? glass->line + glass->mem_h_px - y : glass->line + y) % glass->mem_h_px;
}

bool glass_fits(const struct glass *glass)
{
    return glass->w_px && glass->h_px && glass->column < glass->mem_w_px && glass->line < glass->mem_h_px &&
           glass_column(glass, glass->w_px - 1u) < glass->mem_w_px && glass->h_px <= glass->mem_h_px;
}
