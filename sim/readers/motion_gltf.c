/* SPDX-License-Identifier: MIT */
#include "readers/motion_gltf.h"

#include "gltf/gltf_file.h"
#include "gltf/gltf_numbers.h"

#include <stdlib.h>
#include <string.h>

static const struct property {
    const char *name; /* of a node's member, and of what a channel moves */
    unsigned width;
} PROPERTIES[PART_COUNT] = {[PART_AT] = {"translation", 3}, [PART_TURN] = {"rotation", 4}, [PART_SCALE] = {"scale", 3}};

struct reading {
    const char *path;
    const struct gltf_file *file;
    const struct node_transforms *transforms;
    struct gltf_buffers buffers;
    struct node_motions *out;
    struct error *err;
    size_t animation; /* from 1 */
};

static bool fail(struct reading *work, const char *what)
{
    const json_t *own = gltf_element(work->file, "animations", work->animation - 1);
    const char *name = json_string_value(json_object_get(own, "name"));
    return error_set(work->err, "%s: animation %zu%s%s%s: %s; --movers off draws all where the file has it", work->path,
                     work->animation, name ? " '" : "", name ? name : "", name ? "'" : "", what);
}

/* Tracks ------------------------------------------------------------------------------------- */

static bool join_of(const json_t *sampler, enum track_join *out)
{
    static const char *const names[] = {
        [TRACK_LINEAR] = "LINEAR", [TRACK_STEP] = "STEP", [TRACK_CUBIC] = "CUBICSPLINE"};
    const char *name = json_string_value(json_object_get(sampler, "interpolation"));
    *out = TRACK_LINEAR;
    for (size_t i = 0; name && i < sizeof names / sizeof *names; i++)
        if (strcmp(name, names[i]) == 0) {
            *out = (enum track_join)i;
            return true;
        }
    return !name;
}

/* Without times there is no key, whatever values there are. */
static bool fill_track(struct reading *work, const struct gltf_array *times, const struct gltf_array *values,
                       unsigned width, enum track_join join, struct track *out)
{
    *out = (struct track){0};
    if (!times->count) return true;
    if (values->count != times->count * (join == TRACK_CUBIC ? 3 : 1))
        return fail(work, "it has another number of values than its times want");
    *out = track_make(times->count, width, join);
    memcpy(out->times_s, times->values, times->count * sizeof *times->values);
    memcpy(out->values, values->values, values->count * width * sizeof *values->values);
    if (track_is_sound(out)) return true;
    track_free(out);
    return fail(work, "its times do not ascend from 0, or a key is no number");
}

static bool read_track(struct reading *work, const json_t *sampler, unsigned width, struct track *out)
{
    struct gltf_array times = {0}, values = {0};
    enum track_join join;
    size_t input, output;
    if (!join_of(sampler, &join)) return fail(work, "its keys are joined in a way that glTF 2.0 does not have");
    bool ok = gltf_index(sampler, "input", &input) && gltf_index(sampler, "output", &output) &&
              gltf_array_read(work->file, &work->buffers, input, 1, &times) &&
              gltf_array_read(work->file, &work->buffers, output, width, &values);
    if (!ok)
        fail(work, "its keys lead out of the file's buffers, or are of another type than what they move");
    else
        ok = fill_track(work, &times, &values, width, join, out);
    free(times.values);
    free(values.values);
    return ok;
}

/* Nodes -------------------------------------------------------------------------------------- */

/* The parts as the file has them, so that a mirroring stays where it is said; of a matrix, what they can be. */
static void set_own(struct node_motion *motion, const json_t *node, const struct node_transforms *transforms)
{
    if (json_object_get(node, "matrix")) {
        const struct node_transform transform = node_transform_of(transforms, motion->node);
        node_motion_take_apart(motion, &transform);
        return;
    }
    for (int part = 0; part < PART_COUNT; part++)
        gltf_numbers(node, PROPERTIES[part].name, PROPERTIES[part].width, motion->own[part]);
}

static bool add_channel(struct reading *work, const json_t *animation, const json_t *channel)
{
    const json_t *target = json_object_get(channel, "target");
    const char *path = json_string_value(json_object_get(target, "path"));
    size_t number, sampler, part = 0;
    struct track track;
    while (part < PART_COUNT && !(path && strcmp(path, PROPERTIES[part].name) == 0))
        part++;
    if (part == PART_COUNT && path && strcmp(path, "weights") == 0) {
        work->out->morph_weights++;
        return true;
    }
    if (part == PART_COUNT || !gltf_index(target, "node", &number)) {
        work->out->other++;
        return true;
    }
    const struct aiNode *node = node_transforms_node(work->transforms, number);
    if (!node) return true;
    if (!gltf_index(channel, "sampler", &sampler)) return fail(work, "a channel of it has no sampler");
    const json_t *from = json_array_get(json_object_get(animation, "samplers"), sampler);
    if (!read_track(work, from, PROPERTIES[part].width, &track)) return false;
    const bool is_new = !node_motions_of(work->out, node);
    struct node_motion *motion = node_motions_make(work->out, node);
    if (is_new) set_own(motion, gltf_element(work->file, "nodes", number), work->transforms);
    node_motion_take(work->out, motion, (enum node_part)part, &track,
                     json_string_value(json_object_get(animation, "name")));
    return true;
}

static bool add_animations(struct reading *work)
{
    size_t i, k;
    json_t *animation, *channel;
    json_array_foreach(json_object_get(work->file->root, "animations"), i, animation)
    {
        work->animation = i + 1;
        json_array_foreach(json_object_get(animation, "channels"), k, channel)
        {
            if (!add_channel(work, animation, channel)) return false;
        }
        node_motions_settle(work->out);
    }
    return true;
}

static void mark_joints(struct reading *work)
{
    size_t i, k;
    json_t *skin, *joint;
    json_array_foreach(json_object_get(work->file->root, "skins"), i, skin)
    {
        json_array_foreach(json_object_get(skin, "joints"), k, joint)
        {
            if (!json_is_integer(joint) || json_integer_value(joint) < 0) continue;
            const struct aiNode *node = node_transforms_node(work->transforms, (size_t)json_integer_value(joint));
            struct node_motion *motion = node ? node_motions_of(work->out, node) : NULL;
            if (motion) motion->is_skin = true;
        }
    }
}

bool motion_gltf_read(const char *path, const struct node_transforms *transforms, struct node_motions *out,
                      struct error *err)
{
    struct gltf_file file;
    if (!gltf_file_read(path, &file, err)) return false;
    struct reading work = {.path = path, .file = &file, .transforms = transforms, .out = out, .err = err};
    bool ok = true;
    if (json_array_size(json_object_get(file.root, "animations"))) {
        ok = gltf_buffers_read(path, &file, &work.buffers, err) && add_animations(&work);
        mark_joints(&work);
        gltf_buffers_free(&work.buffers);
    }
    gltf_file_free(&file);
    return ok;
}
