/* SPDX-License-Identifier: MIT
 *
 * Looks rows up. */
#include "glass.h"

#include <string.h>

const struct glass *glass_find(const char *chip, unsigned w_px, unsigned h_px)
{
    for (const struct glass *row = glass_rows; row->chip; row++)
        if (strcmp(row->chip, chip) == 0 && (!w_px || (row->w_px == w_px && row->h_px == h_px))) return row;
    return NULL;
}
