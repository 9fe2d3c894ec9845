/* SPDX-License-Identifier: MIT
 *
 * A mover is a node that an animation moves, with what is below it as far as nothing below moves by itself: that is a
 * mover of its own, on whose way all above it have a part. What an animation keeps at one value moves nothing. */
#include "readers/import_motion.h"

#include "base/grow.h"
#include "base/vec3.h"
#include "formats/float_step.h"
#include "readers/motion_assimp.h"
#include "readers/motion_gltf.h"
#include "readers/motion_keys.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Of a scale, in parts of it: as much as a key may be wrong in all, of a mover's size (motion_keys.c). */
static const double SCALE_CHANGE_MAX = 1e-3;

enum { LIMIT_MOVERS = 1024 };

static bool are_left_out;

void motions_leave_out(bool leave_out)
{
    are_left_out = leave_out;
}

bool motions_are_left_out(void)
{
    return are_left_out;
}

static bool refuse(const struct motions *work, const struct aiNode *node, const char *reason, struct error *err)
{
    return error_set(err, "%s: node '%s': %s", work->path, node->mName.data, reason);
}

/* Parts that stay at one value -------------------------------------------------------------- */

static double most_of(const struct track *track, enum node_part part)
{
    double most = 0;
    for (unsigned i = 0; i < track->width && part == PART_SCALE && track->count; i++)
        most = fmax(most, SCALE_CHANGE_MAX * fabs(track_key(track, 0)[i]));
    return most;
}

/* Whether the node, above all of it, does not stay where it is. */
static bool moves(const struct node_motion *motion)
{
    return motion &&
           (motion->tracks[PART_AT].count || motion->tracks[PART_TURN].count || motion->tracks[PART_SCALE].count);
}

/* A decimal that became a float32 is still the decimal. */
static bool differs(const double own[4], const double kept[4], unsigned width)
{
    double apart = 0, most = 0;
    for (unsigned i = 0; i < width; i++) {
        apart = fmax(apart, fabs(kept[i] - own[i]));
        most = fmax(most, fabs(kept[i]));
    }
    return apart > 2e-7 * most;
}

/* Such tracks become the node's own parts. What is left of tracks changes. */
static void settle(struct node_motion *motion, struct node_transforms *transforms)
{
    bool is_set = false;
    for (int part = 0; part < PART_COUNT; part++) {
        struct track *track = &motion->tracks[part];
        if (!track->count || track_changes(track, most_of(track, (enum node_part)part))) continue;
        double kept[4] = {0};
        track_at(track, 0, 0, kept);
        if (differs(motion->own[part], kept, track->width)) {
            memcpy(motion->own[part], kept, sizeof kept);
            is_set = true;
        }
        track_free(track);
    }
    if (!is_set || motion->is_sheared) return;
    struct node_motion still = *motion;
    memset(still.tracks, 0, sizeof still.tracks);
    const struct node_transform own = node_motion_at(&still, 0, 0);
    node_transform_set(transforms, motion->node, &own);
}

/* Movers ------------------------------------------------------------------------------------- */

static bool has_mesh(const struct aiNode *node)
{
    bool has = node->mNumMeshes > 0;
    for (unsigned i = 0; !has && i < node->mNumChildren; i++)
        has = has_mesh(node->mChildren[i]);
    return has;
}

/* Whether it moves a mesh that nothing below it moves by itself. */
static bool has_own_mesh(const struct motions *work, const struct aiNode *node)
{
    bool has = node->mNumMeshes > 0;
    for (unsigned i = 0; !has && i < node->mNumChildren; i++) {
        const struct aiNode *child = node->mChildren[i];
        has = !moves(node_motions_of(&work->nodes, child)) && has_own_mesh(work, child);
    }
    return has;
}

static bool keeps_scale(const struct motions *work, const struct node_motion *motion, struct error *err)
{
    const struct track *track = &motion->tracks[PART_SCALE];
    if (!track->count) return true;
    const double *from = track_key(track, 0), *to = from;
    double most = -1;
    for (size_t key = 0; key < track->count; key++) {
        const double apart = vec3_distance2(track_key(track, key), from);
        if (apart > most) most = apart, to = track_key(track, key);
    }
    return error_set(
        err,
        "%s: node '%s': its animation changes its scale, from %g %g %g to %g %g %g, and what moves keeps its "
        "size; --movers off draws it where the file has it",
        work->path, motion->node->mName.data, from[0], from[1], from[2], to[0], to[1], to[2]);
}

static bool check(const struct motions *work, const struct node_motion *motion, struct error *err)
{
    if (!keeps_scale(work, motion, err)) return false;
    return !motion->is_sheared || refuse(work, motion->node,
                                         "its own transform shears it, and its animation cannot; apply the transform "
                                         "in the program that it was made with, or --movers off",
                                         err);
}

static bool add_mover(struct motions *work, const struct aiNode *node, struct error *err)
{
    struct model *model = work->model;
    if (model->mover_count == LIMIT_MOVERS)
        return error_set(err, "%s: more than %d animated nodes; --movers off draws them where the file has them",
                         work->path, LIMIT_MOVERS);
    work->movers = grow(work->movers, model->mover_count, &work->node_capacity, sizeof *work->movers);
    work->movers[model->mover_count] = node;
    model->movers = grow(model->movers, model->mover_count, &work->mover_capacity, sizeof *model->movers);
    struct model_mover *mover = &model->movers[model->mover_count++];
    *mover = (struct model_mover){.node = node_transforms_number(work->transforms, node)};
    snprintf(mover->name, sizeof mover->name, "%.*s", MODEL_NAME_B - 1, node->mName.data);
    *map_at(&work->places, (uintptr_t)node, 0) = (uint32_t)model->mover_count;
    return true;
}

static bool walk(struct motions *work, const struct aiNode *node, struct error *err)
{
    const struct node_motion *motion = node_motions_of(&work->nodes, node);
    if (moves(motion) && has_mesh(node)) {
        if (!check(work, motion, err)) return false;
        if (has_own_mesh(work, node) && !add_mover(work, node, err)) return false;
    }
    for (unsigned i = 0; i < node->mNumChildren; i++)
        if (!walk(work, node->mChildren[i], err)) return false;
    return true;
}

uint16_t motions_mover_of(const struct motions *motions, const struct aiNode *node)
{
    const uint32_t *place = map_find(&motions->places, (uintptr_t)node);
    return place ? (uint16_t)*place : 0;
}

/* What is told ------------------------------------------------------------------------------- */

/* Nodes of a kind, and the first of them. */
struct tally {
    size_t count;
    const char *first;
};

static void count(struct tally *tally, const struct node_motion *motion)
{
    if (!tally->count++) tally->first = motion->node->mName.data;
}

static void tell(struct model *model, const struct tally *tally, const char *one, const char *several)
{
    if (tally->count == 1) model_note(model, "node '%s' %s", tally->first, one);
    if (tally->count > 1) model_note(model, "%zu nodes, '%s' the first, %s", tally->count, tally->first, several);
}

static void tell_channels(struct model *model, const struct node_motions *nodes)
{
    if (nodes->morph_weights)
        model_note(model, "%zu %s: drawn with the weights that the file has at rest", nodes->morph_weights,
                   nodes->morph_weights == 1 ? "animation of morph targets' weights is not run"
                                             : "animations of morph targets' weights are not run");
    if (nodes->other)
        model_note(model, "%zu animation channel%s something else than a node's place: %s not run", nodes->other,
                   nodes->other == 1 ? " changes" : "s change", nodes->other == 1 ? "it is" : "they are");
}

static bool has_keys(const struct node_motion *motion)
{
    return motion->tracks[PART_AT].count || motion->tracks[PART_TURN].count || motion->tracks[PART_SCALE].count;
}

/* Before settle(), which takes the tracks away that move nothing. */
static void tell_nodes(struct motions *work)
{
    struct tally empty = {0}, bare = {0}, joints = {0}, twice = {0};
    for (size_t i = 0; i < work->nodes.count; i++) {
        const struct node_motion *motion = &work->nodes.items[i];
        const bool shows = has_mesh(motion->node);
        if (!has_keys(motion))
            count(&empty, motion);
        else if (motion->is_skin)
            count(&joints, motion);
        else if (!shows)
            count(&bare, motion);
        if (shows && motion->is_twice) count(&twice, motion);
    }
    tell(work->model, &empty, "stands still: its animation has no keys", "stand still: their animations have no keys");
    tell(work->model, &joints, "is animated and moves a skin: that is drawn at rest",
         "are animated and move skins: these are drawn at rest");
    tell(work->model, &bare,
         "is animated, but has no mesh, nor anything below it: nothing moves, and cameras stay where they are",
         "are animated, but have no mesh, nor anything below them: nothing moves, and cameras stay where they are");
    tell(work->model, &twice,
         "is moved by several animations: the first that moves it is drawn, or that named after it; a file with one "
         "helps: of Blender's FBX without All Actions and NLA Strips",
         "are moved by several animations: the first that moves each is drawn, or that named after it; a file with one "
         "helps: of Blender's FBX without All Actions and NLA Strips");
    tell_channels(work->model, &work->nodes);
}

/* Reading ------------------------------------------------------------------------------------ */

bool motions_find(const char *path, const struct aiScene *scene, struct node_transforms *transforms,
                  struct model *model, struct motions *out, struct error *err)
{
    *out = (struct motions){.path = path, .transforms = transforms, .model = model};
    if (are_left_out) {
        model->is_stopped = scene->mNumAnimations > 0;
        return true;
    }
    if (!(transforms->are_double ? motion_gltf_read(path, transforms, &out->nodes, err)
                                 : motion_assimp_read(path, scene, transforms, &out->nodes, err)))
        return false;
    tell_nodes(out);
    for (size_t i = 0; i < out->nodes.count; i++)
        settle(&out->nodes.items[i], transforms);
    return walk(out, scene->mRootNode, err);
}

bool motions_set_keys(struct motions *motions, double *step_m, struct error *err)
{
    const struct motion_keys from = {motions->path, motions->transforms, &motions->nodes, motions->model, step_m};
    for (size_t i = 0; i < motions->model->mover_count; i++)
        if (!motion_keys_set(&from, motions->movers[i], i, err)) return false;
    return true;
}

void motions_free(struct motions *motions)
{
    node_motions_free(&motions->nodes);
    map_free(&motions->places);
    free(motions->movers);
}
