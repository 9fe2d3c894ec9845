/* SPDX-License-Identifier: MIT
 *
 * Which of many things on the screen may reach into a pixel's neighbourhood: lists of them for tiles of the screen, so
 * that not all have to be asked. */
#ifndef SIM_NEAR_TILES_H
#define SIM_NEAR_TILES_H

#include <stddef.h>
#include <stdint.h>

struct pixel_rect {
    int x0, y0, x1, y1; /* inclusive */
};

enum { NEAR_TILES_PX = 2 }; /* how far beyond its bounds a thing is near */

struct near_tiles {
    unsigned tile_px, columns, rows;
    uint32_t *starts;  /* of each tile's list in `numbers`, then of what is near to most tiles, then the end */
    uint32_t *numbers; /* ascending in each list */
};

/* Numbers, of bounds[]. */
struct near_list {
    const uint32_t *numbers;
    size_t count;
};

enum { NEAR_LISTS = 2 };

/* Of things with bounds[0 .. count) on a screen of this size. `tiles`: zeroed, or set before. */
void near_tiles_set(struct near_tiles *tiles, unsigned w_px, unsigned h_px, const struct pixel_rect *bounds,
                    size_t count);
void near_tiles_free(struct near_tiles *tiles);

/* What may be near to a pixel, and more: the tile's own, and what is near to most. Nothing is in both. */
void near_tiles_at(const struct near_tiles *tiles, unsigned x_px, unsigned y_px, struct near_list lists[NEAR_LISTS]);

#endif
