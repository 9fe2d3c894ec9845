/* SPDX-License-Identifier: MIT
 *
 * A picture of an extreme for its page: the frame of profile fast that shows most faces, each face in a colour of its
 * own, darker the farther it is, and pixels that show another face than the reference in red. Pictures are made only
 * where EXTREMES_PICTURES names a folder in the environment. */
#ifndef TESTS_EXTREME_PICTURE_H
#define TESTS_EXTREME_PICTURE_H

#include "accuracy/reference.h"

struct extreme_best {
    size_t distinct;  /* faces that the frame kept shows; 0: none is kept yet */
    unsigned *rgb888; /* of that frame; NULL: none */
};

/* Keeps a frame if it shows more faces than the one kept. `depths_m` and `truth` may be NULL: then nothing is shaded,
 * and nothing red. */
void extreme_picture_consider(struct extreme_best *best, const uint32_t *faces, const double *depths_m,
                              const uint32_t *truth, unsigned w_px, unsigned h_px);

/* Writes the frame kept as NAME.png, enlarged or made smaller to some 160 pixels; a slash in the name is left out. Does
 * nothing without a frame. */
void extreme_picture_write(const struct extreme_best *best, const char *name, unsigned w_px, unsigned h_px);

bool extreme_picture_is_wanted(void);
void extreme_picture_free(struct extreme_best *best);

#endif
