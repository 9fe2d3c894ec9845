/* SPDX-License-Identifier: MIT */
#include "readers/node_motion.h"

#include "base/grow.h"
#include "model/pose.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static const double SHEAR_MAX = 1e-4; /* cosine between axes */

struct node_motion *node_motions_of(const struct node_motions *motions, const struct aiNode *node)
{
    const uint32_t *place = map_find(&motions->places, (uintptr_t)node);
    return place ? &motions->items[*place - 1] : NULL;
}

struct node_motion *node_motions_make(struct node_motions *motions, const struct aiNode *node)
{
    uint32_t *place = map_at(&motions->places, (uintptr_t)node, 0);
    if (*place) return &motions->items[*place - 1];
    motions->items = grow(motions->items, motions->count, &motions->capacity, sizeof *motions->items);
    *place = (uint32_t)++motions->count;
    struct node_motion *made = &motions->items[*place - 1];
    *made = (struct node_motion){.node = node, .own = {{0}, {0, 0, 0, 1}, {1, 1, 1}}};
    return made;
}

void node_motions_free(struct node_motions *motions)
{
    for (size_t i = 0; i < motions->count; i++)
        for (int part = 0; part < PART_COUNT; part++) {
            track_free(&motions->items[i].tracks[part]);
            track_free(&motions->items[i].others[part]);
        }
    free(motions->items);
    map_free(&motions->places);
    *motions = (struct node_motions){0};
}

/* Tracks that stay at the same value agree. */
static bool agree(const struct track *a, const struct track *b)
{
    return a->width == b->width && !track_changes(a, 0) && !track_changes(b, 0) &&
           memcmp(track_key(a, 0), track_key(b, 0), a->width * sizeof *a->values) == 0;
}

/* Blender's FBX has an animation for each object and each action: of an object's those that others have given it are
 * there, too. Its own is "Name|NameAction". */
static bool is_named_after(const char *animation, const struct aiNode *node)
{
    static const char action[] = "Action"; /* a second one is "NameAction.001" */
    const char *name = node->mName.data;
    const size_t length = strlen(name);
    return animation && length && strncmp(animation, name, length) == 0 && animation[length] == '|' &&
           strncmp(animation + length + 1, name, length) == 0 &&
           strncmp(animation + 2 * length + 1, action, sizeof action - 1) == 0;
}

void node_motion_take(struct node_motions *motions, struct node_motion *motion, enum node_part part,
                      struct track *track, const char *animation)
{
    struct track *had = &motion->others[part];
    if (track->count) motions->end_s = fmax(motions->end_s, track->times_s[track->count - 1]);
    motion->others_are_own = is_named_after(animation, motion->node);
    if (had->count && track->count) motion->is_twice |= !agree(had, track);
    if (!had->count || (!track_changes(had, 0) && track_changes(track, 0))) {
        const struct track first = *had;
        *had = *track;
        *track = first;
    }
    track_free(track);
}

static bool tracks_move(const struct track tracks[PART_COUNT])
{
    bool moves = false;
    for (int part = 0; part < PART_COUNT; part++)
        moves |= tracks[part].count && track_changes(&tracks[part], 0);
    return moves;
}

/* What only one of two animations says anything of is the other's as well. */
static bool take_beside(struct node_motion *motion)
{
    for (int part = 0; part < PART_COUNT; part++)
        if (motion->tracks[part].count && motion->others[part].count) return false;
    motion->is_own |= motion->others_are_own;
    for (int part = 0; part < PART_COUNT; part++) {
        if (!motion->others[part].count) continue;
        track_free(&motion->tracks[part]);
        motion->tracks[part] = motion->others[part];
        motion->others[part] = (struct track){0};
    }
    return true;
}

static void choose(struct node_motion *motion)
{
    if (take_beside(motion)) return;
    const bool moved = tracks_move(motion->tracks), moves = tracks_move(motion->others);
    bool is_other = moved && moves;
    for (int part = 0; part < PART_COUNT; part++)
        is_other |= motion->tracks[part].count && motion->others[part].count && !moved && !moves &&
                    !agree(&motion->tracks[part], &motion->others[part]);
    motion->is_twice |= is_other;
    const bool counts = moves && (!moved || (motion->others_are_own && !motion->is_own));
    if (counts) motion->is_own = motion->others_are_own;
    for (int part = 0; part < PART_COUNT; part++) {
        struct track *loser = counts ? &motion->tracks[part] : &motion->others[part];
        track_free(loser);
        if (counts) motion->tracks[part] = motion->others[part];
        motion->others[part] = (struct track){0};
    }
}

void node_motions_settle(struct node_motions *motions)
{
    for (size_t i = 0; i < motions->count; i++) {
        choose(&motions->items[i]);
        motions->items[i].others_are_own = false;
    }
}

/* What mirrors is told by the scale: all of it, if there is a choice. */
void node_motion_take_apart(struct node_motion *motion, const struct node_transform *transform)
{
    const double(*m)[4] = transform->m;
    double axes[3][3], *scale = motion->own[PART_SCALE];
    const double handed = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                          m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                          m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    for (int i = 0; i < 3; i++) {
        motion->own[PART_AT][i] = m[i][3];
        scale[i] = sqrt(m[0][i] * m[0][i] + m[1][i] * m[1][i] + m[2][i] * m[2][i]) * (handed < 0 ? -1 : 1);
        for (int k = 0; k < 3; k++)
            axes[i][k] = scale[i] != 0 ? m[k][i] / scale[i] : i == k;
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        const double cosine = axes[i][0] * axes[j][0] + axes[i][1] * axes[j][1] + axes[i][2] * axes[j][2];
        motion->is_sheared |= !(fabs(cosine) <= SHEAR_MAX);
    }
    if (!motion->is_sheared) pose_turn_from_axes(motion->own[PART_TURN], axes);
}

struct node_transform node_motion_at(const struct node_motion *motion, double time_s, double within_s)
{
    double parts[PART_COUNT][4];
    struct node_transform out;
    memcpy(parts, motion->own, sizeof parts);
    for (int part = 0; part < PART_COUNT; part++)
        if (motion->tracks[part].count) track_at(&motion->tracks[part], time_s, within_s, parts[part]);
    node_transform_rotate(parts[PART_TURN], &out);
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++)
            out.m[row][column] *= parts[PART_SCALE][column];
        out.m[row][3] = parts[PART_AT][row];
    }
    return out;
}
