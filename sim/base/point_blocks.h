/* SPDX-License-Identifier: MIT
 *
 * Points in blocks of neighbours, each within a sphere: a question to all points is asked of a block's sphere first. */
#ifndef SIM_POINT_BLOCKS_H
#define SIM_POINT_BLOCKS_H

#include <stddef.h>

struct point_block {
    double centre[3], radius;
    double (*points)[3];
    size_t count;
};

struct point_blocks {
    double (*points)[3]; /* copies, block after block; owned */
    struct point_block *blocks;
    size_t count;
};

void point_blocks_build(struct point_blocks *out, double (*points)[3], size_t count);
void point_blocks_free(struct point_blocks *blocks);

#endif
