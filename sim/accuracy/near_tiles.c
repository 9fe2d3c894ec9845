/* SPDX-License-Identifier: MIT
 *
 * Counted first, then filled in. What covers more than a quarter of the tiles is kept once. */
#include "accuracy/near_tiles.h"

#include "base/grow.h"

#include <stdlib.h>

enum { LEAST_TILE_PX = 16, TILES_A_SIDE = 16 };

/* Tiles, inclusive; none: x0 > x1 or y0 > y1. */
static struct pixel_rect tiles_of(const struct near_tiles *tiles, const struct pixel_rect *bounds)
{
    const int tile_px = (int)tiles->tile_px, columns = (int)tiles->columns, rows = (int)tiles->rows;
    const int x0 = bounds->x0 - NEAR_TILES_PX, x1 = (bounds->x1 + NEAR_TILES_PX) / tile_px;
    const int y0 = bounds->y0 - NEAR_TILES_PX, y1 = (bounds->y1 + NEAR_TILES_PX) / tile_px;
    return (struct pixel_rect){x0 < 0 ? 0 : x0 / tile_px, y0 < 0 ? 0 : y0 / tile_px, x1 < columns ? x1 : columns - 1,
                               y1 < rows ? y1 : rows - 1};
}

/* Calls for each list that a thing belongs to. */
static void each_list(const struct near_tiles *tiles, const struct pixel_rect *bounds, uint32_t number,
                      void (*take)(uint32_t *at, uint32_t number, uint32_t *numbers), uint32_t *at, uint32_t *numbers)
{
    const struct pixel_rect in = tiles_of(tiles, bounds);
    const unsigned all = tiles->columns * tiles->rows;
    if (in.x0 > in.x1 || in.y0 > in.y1) return;
    if ((unsigned)((in.x1 - in.x0 + 1) * (in.y1 - in.y0 + 1)) > all / 4) {
        take(&at[all], number, numbers);
        return;
    }
    for (int y = in.y0; y <= in.y1; y++)
        for (int x = in.x0; x <= in.x1; x++)
            take(&at[(unsigned)y * tiles->columns + (unsigned)x], number, numbers);
}

static void count_one(uint32_t *at, uint32_t number, uint32_t *numbers)
{
    (void)number, (void)numbers;
    ++*at;
}

static void put_one(uint32_t *at, uint32_t number, uint32_t *numbers)
{
    numbers[(*at)++] = number;
}

void near_tiles_set(struct near_tiles *tiles, unsigned w_px, unsigned h_px, const struct pixel_rect *bounds,
                    size_t count)
{
    const unsigned side_px = w_px > h_px ? w_px : h_px;
    const unsigned tile_px = (side_px + TILES_A_SIDE - 1) / TILES_A_SIDE;
    near_tiles_free(tiles);
    tiles->tile_px = tile_px > LEAST_TILE_PX ? tile_px : LEAST_TILE_PX;
    tiles->columns = (w_px + tiles->tile_px - 1) / tiles->tile_px;
    tiles->rows = (h_px + tiles->tile_px - 1) / tiles->tile_px;
    const size_t lists = (size_t)tiles->columns * tiles->rows + 1;
    uint32_t *ends = grow_zeroed(lists, sizeof *ends);
    tiles->starts = grow_zeroed(lists + 1, sizeof *tiles->starts);
    for (size_t i = 0; i < count; i++)
        each_list(tiles, &bounds[i], (uint32_t)i, count_one, &tiles->starts[1], NULL);
    for (size_t list = 0; list < lists; list++) {
        ends[list] = tiles->starts[list];
        tiles->starts[list + 1] += tiles->starts[list];
    }
    tiles->numbers = grow_zeroed(tiles->starts[lists], sizeof *tiles->numbers);
    for (size_t i = 0; i < count; i++)
        each_list(tiles, &bounds[i], (uint32_t)i, put_one, ends, tiles->numbers);
    free(ends);
}

void near_tiles_free(struct near_tiles *tiles)
{
    free(tiles->starts);
    free(tiles->numbers);
    *tiles = (struct near_tiles){0};
}

static struct near_list list_at(const struct near_tiles *tiles, size_t list)
{
    return (struct near_list){&tiles->numbers[tiles->starts[list]], tiles->starts[list + 1] - tiles->starts[list]};
}

void near_tiles_at(const struct near_tiles *tiles, unsigned x_px, unsigned y_px, struct near_list lists[NEAR_LISTS])
{
    lists[0] = list_at(tiles, (size_t)(y_px / tiles->tile_px) * tiles->columns + x_px / tiles->tile_px);
    lists[1] = list_at(tiles, (size_t)tiles->columns * tiles->rows);
}
