/* SPDX-License-Identifier: MIT
 *
 * A node's own transform is translation, rotation and scale; keys replace the first two. Above it are parents, which
 * stand still, so the motion in the scene is that of the keys, moved and turned by them. Positions and orientations
 * have keys of their own in the file: a mover gets one at the time of either, and one at the end of the longest
 * animation, so that all repeat together. Of several animations a node takes its positions from the first that has
 * some, and its orientations likewise. */
#include "readers/import_motion.h"

#include "base/grow.h"
#include "base/vec3.h"
#include "formats/float_step.h"
#include "model/pose.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double SHEAR_MAX = 1e-4; /* cosine between axes, and how uneven scales may be */

enum { LIMIT_MOVERS = 1024 };

struct placement {
    double axes[3][3]; /* columns: where the axes go */
    double at[3];
};

struct motions {
    const char *path;
    const struct aiScene *scene;
    const struct node_transforms *transforms;
    double *step_m;
    struct model *model;
    const struct aiNode **nodes;
    size_t mover_capacity, key_capacity, node_capacity;
    struct error *err;
};

static struct placement placement_of(const struct motions *work, const struct aiNode *node)
{
    const struct node_transform transform = node_transform_of(work->transforms, node);
    struct placement out;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            out.axes[k][i] = transform.m[i][k];
        out.at[i] = transform.m[i][3];
    }
    return out;
}

static void placement_apply(const struct placement *placement, const double v[3], bool is_point, double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = (is_point ? placement->at[i] : 0) + placement->axes[0][i] * v[0] + placement->axes[1][i] * v[1] +
                 placement->axes[2][i] * v[2];
}

static struct placement placement_times(const struct placement *a, const struct placement *b)
{
    struct placement out;
    for (int i = 0; i < 3; i++)
        placement_apply(a, b->axes[i], false, out.axes[i]);
    placement_apply(a, b->at, true, out.at);
    return out;
}

/* Takes the scales out of the axes. false: what is left is no rotation. */
static bool rotation_of(const struct placement *placement, double axes[3][3], double scales[3])
{
    for (int i = 0; i < 3; i++) {
        scales[i] = sqrt(vec3_dot(placement->axes[i], placement->axes[i]));
        if (!(scales[i] > 0)) return false;
        for (int k = 0; k < 3; k++)
            axes[i][k] = placement->axes[i][k] / scales[i];
    }
    double handed = 0;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        if (fabs(vec3_dot(axes[i], axes[j])) > SHEAR_MAX) return false;
        handed += axes[0][i] * (axes[1][j] * axes[2][k] - axes[1][k] * axes[2][j]);
    }
    return handed > 0;
}

static bool is_even(const double scales[3])
{
    return fabs(scales[0] - scales[1]) <= SHEAR_MAX * scales[0] && fabs(scales[0] - scales[2]) <= SHEAR_MAX * scales[0];
}

static struct model_pose pose_of(const struct placement *placement, double axes[3][3])
{
    struct model_pose pose;
    memcpy(pose.at_m, placement->at, sizeof pose.at_m);
    pose_turn_from_axes(pose.turn, axes);
    return pose;
}

/* Keys --------------------------------------------------------------------------------------- */

/* Where one kind of a node's keys is. */
struct track {
    const struct aiNodeAnim *anim;
    double ticks_per_s;
};

/* What moves a node, of all animations, with the values that they leave open. */
struct channel {
    struct track position, turn;
    bool has_keys, is_twice;
    struct model_pose rest; /* of the node below its parents */
};

/* Between which keys a time lies: the part t of the way from key `from` to key `to`, which are one beyond the ends. */
struct stretch {
    unsigned from, to;
    double t;
};

/* Keys of either kind begin with their time; they lie stride_b apart. */
static double key_time(const void *keys, size_t stride_b, unsigned i)
{
    return *(const double *)((const char *)keys + i * stride_b);
}

static struct stretch stretch_at(const void *keys, size_t stride_b, unsigned count, double ticks)
{
    unsigned i = 0;
    while (i + 1 < count && key_time(keys, stride_b, i + 1) <= ticks)
        i++;
    const double from = key_time(keys, stride_b, i);
    const unsigned next = i + 1 < count && ticks > from ? i + 1 : i;
    const double span = key_time(keys, stride_b, next) - from;
    return (struct stretch){i, next, span > 0 ? (ticks - from) / span : 0};
}

static void position_at(const struct channel *channel, double time_s, double out[3])
{
    const struct track *track = &channel->position;
    const struct aiVectorKey *keys = track->anim->mPositionKeys;
    const unsigned count = track->anim->mNumPositionKeys;
    memcpy(out, channel->rest.at_m, 3 * sizeof *out);
    if (!count) return;
    const struct stretch s = stretch_at(&keys->mTime, sizeof *keys, count, time_s * track->ticks_per_s);
    const struct aiVector3D *a = &keys[s.from].mValue, *b = &keys[s.to].mValue;
    out[0] = a->x + s.t * ((double)b->x - a->x);
    out[1] = a->y + s.t * ((double)b->y - a->y);
    out[2] = a->z + s.t * ((double)b->z - a->z);
}

static void turn_of(const struct aiQuaternion *q, double out[4])
{
    const double parts[4] = {q->x, q->y, q->z, q->w};
    double length = 0;
    for (int i = 0; i < 4; i++)
        length = hypot(length, parts[i]);
    for (int i = 0; i < 4; i++)
        out[i] = length > 0 ? parts[i] / length : i == 3;
}

static void turn_at(const struct channel *channel, double time_s, double out[4])
{
    const struct track *track = &channel->turn;
    const struct aiQuatKey *keys = track->anim->mRotationKeys;
    const unsigned count = track->anim->mNumRotationKeys;
    memcpy(out, channel->rest.turn, 4 * sizeof *out);
    if (!count) return;
    const struct stretch s = stretch_at(&keys->mTime, sizeof *keys, count, time_s * track->ticks_per_s);
    double a[4], b[4];
    turn_of(&keys[s.from].mValue, a);
    turn_of(&keys[s.to].mValue, b);
    pose_turn_between(a, b, s.t, out);
}

static int by_value(const void *a, const void *b)
{
    const double left = *(const double *)a, right = *(const double *)b;
    return (left > right) - (left < right);
}

/* The times of a channel's keys, and the end of all; each once. */
static size_t key_times(const struct channel *channel, double end_s, double *times_s)
{
    const struct track *position = &channel->position, *turn = &channel->turn;
    size_t count = 0, kept = 1;
    for (unsigned i = 0; i < position->anim->mNumPositionKeys; i++)
        times_s[count++] = position->anim->mPositionKeys[i].mTime / position->ticks_per_s;
    for (unsigned i = 0; i < turn->anim->mNumRotationKeys; i++)
        times_s[count++] = turn->anim->mRotationKeys[i].mTime / turn->ticks_per_s;
    times_s[count++] = end_s;
    qsort(times_s, count, sizeof *times_s, by_value);
    for (size_t i = 1; i < count; i++)
        if (times_s[i] >= times_s[kept - 1] + 0.0005) times_s[kept++] = times_s[i]; /* tables count milliseconds */
    return kept;
}

static void note_step(struct motions *work, const struct channel *channel, const struct placement *parent,
                      const double at_m[3])
{
    if (!channel->position.anim->mNumPositionKeys) return;
    for (int axis = 0; axis < 3; axis++) {
        double step_m = 0;
        for (int i = 0; i < 3; i++)
            step_m += fabs(parent->axes[i][axis]) * float_step_at(fabs(at_m[i]));
        *work->step_m = fmax(*work->step_m, step_m);
    }
}

static bool add_keys(struct motions *work, const struct channel *channel, const struct placement *parent,
                     const double parent_turn[3][3], double end_s, struct model_mover *mover)
{
    struct model *model = work->model;
    const size_t most = channel->position.anim->mNumPositionKeys + (size_t)channel->turn.anim->mNumRotationKeys + 1;
    double *times_s = grow_zeroed(most, sizeof *times_s);
    const size_t count = key_times(channel, end_s, times_s);
    bool ok = true;
    mover->first_key = (uint32_t)model->key_count;
    for (size_t i = 0; ok && i < count; i++) {
        struct model_pose own;
        double axes[3][3], turned[3][3];
        position_at(channel, times_s[i], own.at_m);
        note_step(work, channel, parent, own.at_m);
        turn_at(channel, times_s[i], own.turn);
        pose_axes(&own, axes);
        for (int k = 0; k < 3; k++)
            for (int m = 0; m < 3; m++)
                turned[k][m] =
                    parent_turn[0][m] * axes[k][0] + parent_turn[1][m] * axes[k][1] + parent_turn[2][m] * axes[k][2];
        model->keys = grow(model->keys, model->key_count, &work->key_capacity, sizeof *model->keys);
        struct model_key *key = &model->keys[model->key_count++];
        key->time_s = times_s[i];
        placement_apply(parent, own.at_m, true, key->pose.at_m);
        pose_turn_from_axes(key->pose.turn, turned);
        for (int k = 0; k < 3; k++)
            ok = ok && isfinite(key->pose.at_m[k]);
        ok = ok && isfinite(key->time_s) && key->time_s >= 0 && isfinite(key->pose.turn[0] + key->pose.turn[3]);
    }
    free(times_s);
    mover->key_count = (uint32_t)count;
    return ok ||
           error_set(work->err, "%s: node '%s': its animation has a key that is no number", work->path, mover->name);
}

/* Nodes -------------------------------------------------------------------------------------- */

static double ticks_per_s_of(const struct aiAnimation *animation)
{
    return animation->mTicksPerSecond > 0 ? animation->mTicksPerSecond : 25.0;
}

static bool moves(const struct aiNodeAnim *anim, const struct aiNode *node)
{
    return strcmp(anim->mNodeName.data, node->mName.data) == 0;
}

/* The first one that has keys to move between stays. The library makes up a key where a file has none, so one is as
 * good as none. true: both have. */
static bool take(struct track *track, unsigned track_keys, const struct track *found, unsigned found_keys)
{
    if (!track->anim || (track_keys < 2 && found_keys > 1)) {
        *track = *found;
        return false;
    }
    return found_keys > 1;
}

static void take_keys(struct channel *channel, const struct track *found)
{
    const struct aiNodeAnim *anim = found->anim, *position = channel->position.anim, *turn = channel->turn.anim;
    const bool moved_twice =
        take(&channel->position, position ? position->mNumPositionKeys : 0, found, anim->mNumPositionKeys);
    const bool turned_twice = take(&channel->turn, turn ? turn->mNumRotationKeys : 0, found, anim->mNumRotationKeys);
    channel->is_twice |= moved_twice || turned_twice;
    channel->has_keys |= anim->mNumPositionKeys > 1 || anim->mNumRotationKeys > 1 || anim->mNumScalingKeys > 1;
}

/* false: nothing names the node. */
static bool find_channel(const struct aiScene *scene, const struct aiNode *node, struct channel *channel)
{
    *channel = (struct channel){.has_keys = false};
    for (unsigned i = 0; i < scene->mNumAnimations; i++) {
        const struct aiAnimation *animation = scene->mAnimations[i];
        for (unsigned k = 0; k < animation->mNumChannels; k++) {
            const struct track found = {animation->mChannels[k], ticks_per_s_of(animation)};
            if (moves(found.anim, node)) take_keys(channel, &found);
        }
    }
    return channel->position.anim != NULL;
}

/* Animations know nodes by name. Counts no farther than two. */
static unsigned count_namesakes(const struct aiNode *node, const struct aiNode *of)
{
    unsigned count = strcmp(node->mName.data, of->mName.data) == 0;
    for (unsigned i = 0; count < 2 && i < node->mNumChildren; i++)
        count += count_namesakes(node->mChildren[i], of);
    return count;
}

static bool has_mesh(const struct aiNode *node)
{
    bool has = node->mNumMeshes > 0;
    for (unsigned i = 0; !has && i < node->mNumChildren; i++)
        has = has_mesh(node->mChildren[i]);
    return has;
}

/* Keys of a scale that does not change, and is the node's own, say nothing. */
static bool keeps_scale(const struct aiNodeAnim *anim, const double scales[3])
{
    for (unsigned i = 0; i < anim->mNumScalingKeys; i++) {
        const struct aiVector3D *s = &anim->mScalingKeys[i].mValue;
        if (!(fabs(s->x - scales[0]) <= 1e-3 * scales[0] && fabs(s->y - scales[1]) <= 1e-3 * scales[1] &&
              fabs(s->z - scales[2]) <= 1e-3 * scales[2]))
            return false;
    }
    return true;
}

static bool all_keep_scale(const struct aiScene *scene, const struct aiNode *node, const double scales[3])
{
    for (unsigned i = 0; i < scene->mNumAnimations; i++) {
        const struct aiAnimation *animation = scene->mAnimations[i];
        for (unsigned k = 0; k < animation->mNumChannels; k++)
            if (moves(animation->mChannels[k], node) && !keeps_scale(animation->mChannels[k], scales)) return false;
    }
    return true;
}

/* Names a node of which something is left out, and why. */
static void note(struct motions *work, const struct aiNode *node, const char *text)
{
    model_note(work->model, "node '%s'%s", node->mName.data, text);
}

static bool refuse(struct motions *work, const struct aiNode *node, const char *reason)
{
    return error_set(work->err, "%s: node '%s': %s", work->path, node->mName.data, reason);
}

static bool add_mover(struct motions *work, const struct aiNode *node, const struct placement *parent,
                      struct channel *channel, double end_s)
{
    struct model *model = work->model;
    const struct placement own = placement_of(work, node), here = placement_times(parent, &own);
    double parent_axes[3][3], own_axes[3][3], axes[3][3], scales[3], own_scales[3];
    if (!rotation_of(parent, parent_axes, scales) || !is_even(scales))
        return refuse(work, node, "it is animated, but its parents mirror or shear it");
    if (!rotation_of(&own, own_axes, own_scales) || !rotation_of(&here, axes, scales))
        return refuse(work, node, "it is animated, but mirrored or sheared");
    if (!all_keep_scale(work->scene, node, own_scales))
        return refuse(work, node, "its animation scales it; only rigid motion can be drawn");
    if (channel->is_twice) note(work, node, ": several animations move it; the first one counts");
    channel->rest = pose_of(&own, own_axes);
    work->nodes = grow(work->nodes, model->mover_count, &work->node_capacity, sizeof *work->nodes);
    work->nodes[model->mover_count] = node;
    model->movers = grow(model->movers, model->mover_count, &work->mover_capacity, sizeof *model->movers);
    struct model_mover *mover = &model->movers[model->mover_count++];
    *mover = (struct model_mover){.rest = pose_of(&here, axes)};
    snprintf(mover->name, sizeof mover->name, "%.*s", MODEL_NAME_B - 1, node->mName.data);
    return add_keys(work, channel, parent, (const double(*)[3])parent_axes, end_s, mover);
}

static bool walk(struct motions *work, const struct aiNode *node, const struct placement *parent,
                 const struct aiNode *above, double end_s)
{
    const struct placement own = placement_of(work, node), here = placement_times(parent, &own);
    struct channel channel;
    const bool is_named = find_channel(work->scene, node, &channel);
    if (channel.has_keys && count_namesakes(work->scene->mRootNode, node) > 1)
        return refuse(work, node, "it is animated, but another node has the same name");
    if (is_named && !has_mesh(node)) {
        note(work, node, " stands still: it is animated, but has no mesh");
    } else if (is_named && !channel.has_keys) {
        note(work, node, " stands still: its animation has no keys to move between");
    } else if (is_named) {
        if (above) return refuse(work, node, "it is animated below a node that is animated too");
        if (work->model->mover_count == LIMIT_MOVERS) return refuse(work, node, "more than 1024 animated nodes");
        if (!add_mover(work, node, parent, &channel, end_s)) return false;
        above = node;
    }
    for (unsigned i = 0; i < node->mNumChildren; i++)
        if (!walk(work, node->mChildren[i], &here, above, end_s)) return false;
    return true;
}

static double end_of(const struct aiScene *scene)
{
    double end_s = 0;
    for (unsigned i = 0; i < scene->mNumAnimations; i++) {
        const struct aiAnimation *animation = scene->mAnimations[i];
        const double ticks_per_s = ticks_per_s_of(animation);
        for (unsigned k = 0; k < animation->mNumChannels; k++) {
            const struct aiNodeAnim *anim = animation->mChannels[k];
            if (anim->mNumPositionKeys)
                end_s = fmax(end_s, anim->mPositionKeys[anim->mNumPositionKeys - 1].mTime / ticks_per_s);
            if (anim->mNumRotationKeys)
                end_s = fmax(end_s, anim->mRotationKeys[anim->mNumRotationKeys - 1].mTime / ticks_per_s);
        }
    }
    return end_s;
}

bool import_motions(const char *path, const struct aiScene *scene, const struct node_transforms *transforms,
                    struct model *model, const struct aiNode ***nodes, double *step_m, struct error *err)
{
    static const struct placement world = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
    struct motions work = {
        .path = path, .scene = scene, .transforms = transforms, .model = model, .step_m = step_m, .err = err};
    const bool ok = !scene->mNumAnimations || walk(&work, scene->mRootNode, &world, NULL, end_of(scene));
    *nodes = work.nodes;
    return ok;
}
