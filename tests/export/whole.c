/* SPDX-License-Identifier: MIT
 *
 * The display of an exported example, for its first FRAMES frames, a turn and a little more: whether all of the scene
 * is in each picture, which shows the background along its border, and whether it is large enough to be looked at. Says
 * how much of the picture's sides it takes, in percent. -DFRAMES_DIFFER: whether pictures differ. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

int display_send(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px);

enum { FRAMES = 130, LEAST_PERCENT = 60 };

static struct {
    uint32_t sum, last_sum; /* of a picture's pixels, in their order */
    unsigned different, frame, least_x, most_x, least_y, most_y;
    uint16_t background;
} seen = {.least_x = W_PX, .least_y = H_PX};

static void note(unsigned x, unsigned y)
{
    if (x < seen.least_x) seen.least_x = x;
    if (x > seen.most_x) seen.most_x = x;
    if (y < seen.least_y) seen.least_y = y;
    if (y > seen.most_y) seen.most_y = y;
}

static void judge(void)
{
#ifdef FRAMES_DIFFER
    printf("%u sums of pictures differ from the one before\n", seen.different);
    exit(seen.different < FRAMES / 4);
#endif
    const unsigned across = (seen.most_x + 1 - seen.least_x) * 100 / W_PX,
                   up = (seen.most_y + 1 - seen.least_y) * 100 / H_PX;
    const int is_cut = !seen.least_x || !seen.least_y || seen.most_x == W_PX - 1 || seen.most_y == H_PX - 1;
    printf("%u %% across, %u %% up%s\n", across, up, is_cut ? ", cut off" : "");
    exit(is_cut || (across < LEAST_PERCENT && up < LEAST_PERCENT));
}

int display_send(void *ctx, uint16_t y_px, const uint16_t *pixels, uint16_t x_px, uint16_t n_px)
{
    (void)ctx;
    if (!seen.frame && !y_px && !x_px) seen.background = pixels[0];
    for (unsigned i = 0; i < n_px; i++)
        seen.sum = seen.sum * 31 + pixels[i];
    if (y_px == H_PX - 1 && x_px + n_px == W_PX) {
        seen.different += seen.sum != seen.last_sum;
        seen.last_sum = seen.sum, seen.sum = 0;
    }
    for (unsigned i = 0; i < n_px; i++)
        if (pixels[i] != seen.background) note(x_px + i, y_px);
    if (y_px == H_PX - 1 && x_px + n_px == W_PX && ++seen.frame == FRAMES) judge();
    return 0;
}
