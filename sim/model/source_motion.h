/* SPDX-License-Identifier: MIT
 *
 * The reference's own word for what moves: a file's nodes with the keys that it has for them, and where a node is at a
 * time by these, in doubles. It has no arithmetic in common with what makes a model's keys. Times of jumps are met to
 * 1/100 of a millisecond, for decimals are float32 in files. */
#ifndef SIM_SOURCE_MOTION_H
#define SIM_SOURCE_MOTION_H

#include <stdbool.h>
#include <stddef.h>

enum source_joined { JOINED_EVENLY, JOINED_BY_STEPS, JOINED_BY_SPLINES };
enum source_part { SOURCE_AT, SOURCE_TURN, SOURCE_SCALE, SOURCE_PARTS };

/* Each key has `width` numbers; or, of splines, three times as many: tangent, value, tangent. */
struct source_keys {
    double *times_s, *numbers; /* owned */
    size_t count, width;
    enum source_joined joined;
};

struct source_node {
    size_t above; /* number of the node that it hangs on, from 1; 0: none */
    bool has_matrix;
    double matrix[16], parts[SOURCE_PARTS][4];
    bool kept[SOURCE_PARTS]; /* the part is what its keys keep it at, not the node's own */
    struct source_keys keys[SOURCE_PARTS];
};

struct source_motion {
    struct source_node *nodes; /* all of the file's, by number */
    size_t count;
    double end_s; /* of the longest animation, after which all begins again */
};

void source_motion_free(struct source_motion *motion);

/* Whether keys ever say anything else than their first one does. */
bool source_keys_vary(const struct source_keys *keys);

/* What keys say at a time. */
void source_keys_at(const struct source_keys *keys, double time_s, double out[4]);

/* A vector out of a node's coordinates into the scene's, at a time; at rest, if time_s is NaN. */
void source_motion_leave(const struct source_motion *motion, size_t node, double time_s, bool is_point, double v[3]);

#endif
