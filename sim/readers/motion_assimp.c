/* SPDX-License-Identifier: MIT */
#include "readers/motion_assimp.h"

#include <string.h>

struct reading {
    const char *path;
    const struct aiScene *scene;
    const struct node_transforms *transforms;
    struct node_motions *out;
    struct error *err;
};

/* Of that name, first in the tree; *count tells how many there are. */
static const struct aiNode *find_node(const struct aiNode *node, const char *name, size_t *count)
{
    const struct aiNode *found = strcmp(node->mName.data, name) == 0 ? node : NULL;
    *count += found != NULL;
    for (unsigned i = 0; i < node->mNumChildren; i++) {
        const struct aiNode *below = find_node(node->mChildren[i], name, count);
        if (!found) found = below;
    }
    return found;
}

static struct track vector_track(const struct aiVectorKey *keys, unsigned count, double ticks_per_s)
{
    struct track track = track_make(count, 3, TRACK_LINEAR);
    for (unsigned i = 0; i < count; i++) {
        const double value[3] = {keys[i].mValue.x, keys[i].mValue.y, keys[i].mValue.z};
        track.times_s[i] = keys[i].mTime / ticks_per_s;
        memcpy(track_key(&track, i), value, sizeof value);
    }
    return track;
}

static struct track turn_track(const struct aiQuatKey *keys, unsigned count, double ticks_per_s)
{
    struct track track = track_make(count, 4, TRACK_LINEAR);
    for (unsigned i = 0; i < count; i++) {
        const struct aiQuaternion *q = &keys[i].mValue;
        const double value[4] = {q->x, q->y, q->z, q->w};
        track.times_s[i] = keys[i].mTime / ticks_per_s;
        memcpy(track_key(&track, i), value, sizeof value);
    }
    return track;
}

static bool add_channel(struct reading *work, const struct aiNodeAnim *anim, double ticks_per_s, const char *name)
{
    size_t namesakes = 0;
    const struct aiNode *node = find_node(work->scene->mRootNode, anim->mNodeName.data, &namesakes);
    if (!node) return true;
    if (namesakes > 1)
        return error_set(work->err,
                         "%s: node '%s': it is animated, but another node has the same name; another name for one of "
                         "them helps, or --movers off",
                         work->path, node->mName.data);
    const bool is_new = !node_motions_of(work->out, node);
    struct node_motion *motion = node_motions_make(work->out, node);
    const struct node_transform own = node_transform_of(work->transforms, node);
    if (is_new) node_motion_take_apart(motion, &own);
    struct track tracks[PART_COUNT] = {
        [PART_AT] = vector_track(anim->mPositionKeys, anim->mNumPositionKeys, ticks_per_s),
        [PART_TURN] = turn_track(anim->mRotationKeys, anim->mNumRotationKeys, ticks_per_s),
        [PART_SCALE] = vector_track(anim->mScalingKeys, anim->mNumScalingKeys, ticks_per_s)};
    bool ok = true;
    for (int part = 0; part < PART_COUNT; part++) {
        ok &= track_is_sound(&tracks[part]);
        node_motion_take(work->out, motion, (enum node_part)part, &tracks[part], name);
    }
    return ok || error_set(work->err,
                           "%s: node '%s': its animation has a key that is no number, or times that do not ascend from "
                           "0; --movers off draws it where the file has it",
                           work->path, node->mName.data);
}

static bool add_animation(struct reading *work, const struct aiAnimation *animation)
{
    const double ticks_per_s = animation->mTicksPerSecond > 0 ? animation->mTicksPerSecond : 25.0;
    work->out->morph_weights += animation->mNumMorphMeshChannels;
    for (unsigned i = 0; i < animation->mNumChannels; i++)
        if (!add_channel(work, animation->mChannels[i], ticks_per_s, animation->mName.data)) return false;
    node_motions_settle(work->out);
    return true;
}

static void mark_bones(struct reading *work)
{
    for (unsigned i = 0; i < work->scene->mNumMeshes; i++) {
        const struct aiMesh *mesh = work->scene->mMeshes[i];
        for (unsigned k = 0; k < mesh->mNumBones; k++) {
            size_t count = 0;
            const struct aiNode *node = find_node(work->scene->mRootNode, mesh->mBones[k]->mName.data, &count);
            struct node_motion *motion = node ? node_motions_of(work->out, node) : NULL;
            if (motion) motion->is_skin = true;
        }
    }
}

bool motion_assimp_read(const char *path, const struct aiScene *scene, const struct node_transforms *transforms,
                        struct node_motions *out, struct error *err)
{
    struct reading work = {path, scene, transforms, out, err};
    for (unsigned i = 0; i < scene->mNumAnimations; i++)
        if (!add_animation(&work, scene->mAnimations[i])) return false;
    mark_bones(&work);
    return true;
}
