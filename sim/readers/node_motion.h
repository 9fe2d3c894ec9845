/* SPDX-License-Identifier: MIT
 *
 * What a file's animations say of its nodes, whoever reads them (motion_gltf.c, motion_assimp.c): tracks of
 * translation, rotation and scale. A node's own transform is translation * rotation * scale; tracks replace these, one
 * by one. All animations run at once. Of those that say something of the same property of a node one counts, with all
 * that it says of it, as a mixture would be nobody's motion: the first that moves the node, or one that is named after
 * it. */
#ifndef SIM_NODE_MOTION_H
#define SIM_NODE_MOTION_H

#include "readers/motion_track.h"
#include "readers/node_transforms.h"

enum node_part { PART_AT, PART_TURN, PART_SCALE, PART_COUNT };

struct node_motion {
    const struct aiNode *node;
    double own[PART_COUNT][4];       /* of the node where the file has it */
    struct track tracks[PART_COUNT]; /* of one animation */
    struct track others[PART_COUNT]; /* of the animation that is being read, until it is settled which of them counts */
    bool is_own, others_are_own;     /* the animation has the node's name */
    bool is_sheared;                 /* its own transform has no such parts */
    bool is_twice;                   /* several animations move it, or say different things of one part */
    bool is_skin;                    /* a skin hangs on the node */
};

struct node_motions {
    struct node_motion *items;
    size_t count, capacity;
    struct map places;    /* from a node's address to its place among them, from 1 */
    double end_s;         /* of the longest animation */
    size_t other;         /* channels of what is no node's place: lights, materials, cameras */
    size_t morph_weights; /* nodes whose morph targets' weights are animated */
};

/* Those of a node; NULL: nothing is said of it. */
struct node_motion *node_motions_of(const struct node_motions *motions, const struct aiNode *node);

/* The same, made if it is not there: `own` is the node's identity, until it is set. It holds until the next is made. */
struct node_motion *node_motions_make(struct node_motions *motions, const struct aiNode *node);
void node_motions_free(struct node_motions *motions);

/* Takes the track, or frees it. `animation`: its name, or NULL. */
void node_motion_take(struct node_motions *motions, struct node_motion *motion, enum node_part part,
                      struct track *track, const char *animation);

/* After each animation. */
void node_motions_settle(struct node_motions *motions);

/* Takes a transform apart into motion->own, or sets is_sheared. */
void node_motion_take_apart(struct node_motion *motion, const struct node_transform *transform);

/* The parts put together again, at a time; within_s as track_at() has it. Parts without a track are the node's own. */
struct node_transform node_motion_at(const struct node_motion *motion, double time_s, double within_s);

#endif
