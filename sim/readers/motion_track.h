/* SPDX-License-Identifier: MIT
 *
 * Keys of one property of a node, and what lies between them, in doubles. */
#ifndef SIM_MOTION_TRACK_H
#define SIM_MOTION_TRACK_H

#include <stdbool.h>
#include <stddef.h>

/* How keys are joined. A cubic key is three values: the tangent towards it, its own, and the tangent behind it. */
enum track_join { TRACK_LINEAR, TRACK_STEP, TRACK_CUBIC };

struct track {
    double *times_s; /* ascending */
    double *values;  /* both arrays are owned */
    size_t count;    /* 0: nothing is said of the property */
    unsigned width;  /* 3 numbers a value; or 4: a quaternion x, y, z, w */
    enum track_join join;
};

/* Makes room for so many keys, all zero. */
struct track track_make(size_t count, unsigned width, enum track_join join);
void track_free(struct track *track);

/* Where the value of a key begins; the tangents of a cubic one are `width` before and behind it. */
double *track_key(const struct track *track, size_t key);

/* At a time, between the keys about `within_s`: where the value jumps, that tells which side is meant. Before the first
 * key and after the last one there are these. Quaternions come out of length 1. */
void track_at(const struct track *track, double time_s, double within_s, double *out);

/* Whether the value is not the same at all times: is more than `most` away from the first, in any of its numbers. A
 * tangent that is not 0 is a change. */
bool track_changes(const struct track *track, double most);

/* Whether times ascend from 0 and all is numbers. */
bool track_is_sound(const struct track *track);

#endif
