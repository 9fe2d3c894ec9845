/* SPDX-License-Identifier: MIT
 *
 * How far a rendered picture, given as face numbers, is from the reference picture. */
#ifndef SIM_COMPARE_H
#define SIM_COMPARE_H

#include "accuracy/reference.h"

struct compare_counts {
    size_t pixels;
    size_t wrong;  /* another face than the reference's */
    size_t beyond; /* wrong, and none of the reference's 3x3 pixels around has the face either: no
                      edge shifted by a pixel explains it */
    size_t holes;  /* beyond, and farther than all of those 3x3 pixels, or background where none of
                      them is, and the reference does not see the face anywhere within a pixel,
                      between the pixels either: one sees through a surface */
    size_t order;  /* of the holes, those that show another face and not the background: what is behind
                      was painted in front */
};

/* What is the matter with a pixel, each worse than the one before; the last two are holes: the background, or
 * another face, shows through. */
enum compare_verdict { COMPARE_RIGHT, COMPARE_WRONG, COMPARE_BEYOND, COMPARE_OPEN, COMPARE_ORDER };

struct comparison {
    struct compare_counts total;
    struct compare_counts worst; /* the frame with the most wrong pixels */
    size_t frames, worst_frame;
    struct compare_counts faultiest; /* the one with the most holes; of several, with the most wrong pixels */
    size_t faultiest_frame;
};

/* Compares a picture of the reference's size with the frame the reference drew last. Farther
 * means by more than 8 grid units and 0.1 %. `groups` maps face numbers to those that count as
 * one (mesh.merged_into), NULL: each for itself. */
struct compare_counts compare_picture(const uint32_t *rendered, const struct reference *reference,
                                      const uint32_t *groups, double unit_m);

/* The same, but what is wrong is not looked at: all other counts are 0. */
struct compare_counts compare_wrong(const uint32_t *rendered, const struct reference *reference,
                                    const uint32_t *groups);

/* Adds 1 to the count of the face that is seen, and to that of the one that should be, for each wrong pixel; by the
 * numbers that `groups` gives them. */
void compare_count_faces(const uint32_t *rendered, const struct reference *reference, const uint32_t *groups,
                         uint32_t *wrong_of_face);

/* compare_picture() for one pixel. */
enum compare_verdict compare_pixel(const uint32_t *rendered, const struct reference *reference, const uint32_t *groups,
                                   double unit_m, size_t pixel);

/* Whether a has more holes than b, or as many and more wrong pixels. */
bool compare_is_faultier(const struct compare_counts *a, const struct compare_counts *b);

/* Adds a frame to the sum over a camera path. */
void comparison_add(struct comparison *comparison, const struct compare_counts *frame);

double compare_wrong_percent(const struct compare_counts *counts);
double compare_beyond_ppm(const struct compare_counts *counts);

#endif
