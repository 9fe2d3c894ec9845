/* SPDX-License-Identifier: MIT
 *
 * Two forged objects in a forged scene, in up to four places: turned by angles or by keys between which a time lies,
 * finer, bending, lit. Two frames by two sets of means.
 *
 * The world of fuzz_long_movers has many scales: the eye, the keys and the places are near its vertices or anywhere,
 * and units of objects are 2^-8 to 2^14 of its own, or what is none. */
#include "fuzz_scene.h"
#include "fuzz_show.h"
#include "fuzz_view.h"
#include "scene/lim_check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { OBJECTS = 2, INSTANCES_MAX = 4, KEYS_MAX = 4, AT_END_Q8 = 1 << 24 };
enum { FAR_FINER_BITS = 8, FAR_COARSER_BITS = 14 };

struct moving_part {
    struct fuzz_scene object;
    struct lim_motion_key keys[KEYS_MAX];
    struct lim_long_vertex origins[KEYS_MAX];
    struct lim_moved moved;
};

struct movers {
    struct fuzz_scene world;
    struct moving_part parts[OBJECTS];
    struct lim_instance instances[FUZZ_FRAMES][INSTANCES_MAX];
};

/* Of length 1, within rounding; within a quarter turn of the one before, as q and -q are one orientation. */
static void make_turn(struct fuzz_bytes *bytes, double q[4], const double before[4])
{
    double length = 0, cosine = 0;

    for (int i = 0; i < 4; i++) {
        q[i] = (int16_t)fuzz_u16(bytes);
        length = hypot(length, q[i]);
    }
    if (length == 0) q[3] = length = 1;
    for (int i = 0; i < 4; i++) {
        q[i] /= length;
        cosine += q[i] * before[i];
    }
    for (int i = 0; i < 4 && cosine < 0; i++)
        q[i] = -q[i];
}

static uint16_t arc_between(const double a[4], const double b[4])
{
    const double turn = 6.283185307179586;
    double cosine = 0;

    for (int i = 0; i < 4; i++)
        cosine += a[i] * b[i];
    const long arc = lround(acos(fmin(fabs(cosine), 1)) / turn * 65536);
    return (uint16_t)(arc < 16383 ? arc : 16383);
}

static int32_t position_q8(struct fuzz_bytes *bytes)
{
    return (int32_t)fuzz_u32(bytes) % AT_END_Q8 / (1 << fuzz_below(bytes, 24));
}

static void make_keys(struct moving_part *part, struct fuzz_bytes *bytes)
{
    double before[4] = {0, 0, 0, 1};
    uint32_t time_ms = fuzz_u16(bytes);

    part->moved.motion = (struct lim_motion){.keys = part->keys, .count = (uint16_t)(1 + fuzz_below(bytes, KEYS_MAX))};
    part->moved.motion.repeats = fuzz_below(bytes, 2);
    for (uint16_t k = 0; k < part->moved.motion.count; k++) {
        struct lim_motion_key *key = &part->keys[k];
        double q[4];
        make_turn(bytes, q, before);
        key->time_ms = time_ms;
        for (int i = 0; i < 3; i++)
            key->at_q8[i] = position_q8(bytes);
        for (int i = 0; i < 4; i++)
            key->turn_q15[i] = (int16_t)lround(fmin(fmax(q[i], -1), 1) * 32767);
        if (k) key[-1].arc = arc_between(before, q);
        memcpy(before, q, sizeof before);
        time_ms += 1u + fuzz_u16(bytes);
    }
}

static void make_part(struct moving_part *part, struct fuzz_bytes *bytes)
{
    memset(part, 0, sizeof *part);
    fuzz_scene_make(&part->object, bytes);
    if (fuzz_below(bytes, 2)) fuzz_scene_add_extras(&part->object, bytes);
    part->moved.object = &part->object.scene;
    part->moved.finer_bits = fuzz_below(bytes, 4);
    make_keys(part, bytes);
}

/* Near a vertex of the world, or anywhere; a few are beyond what is legal. */
static void make_origin(int32_t origin[3], const struct fuzz_scene *world, struct fuzz_bytes *bytes)
{
    const uint8_t kind = fuzz_below(bytes, 8);
    const lim_index vertex = fuzz_below(bytes, world->scene.vertex_count);

    for (int i = 0; i < 3; i++) {
        const int32_t away = (int32_t)fuzz_u32(bytes) >> fuzz_below(bytes, 32);
        const int64_t at = kind ? (int64_t)world->long_vertices[vertex].at[i] + away : away;
        origin[i] = (int32_t)(at < INT32_MIN ? INT32_MIN : at > INT32_MAX ? INT32_MAX : at);
    }
}

/* Most are legal. */
static void make_scale(uint8_t *finer_bits, uint8_t *coarser_bits, struct fuzz_bytes *bytes)
{
    const uint8_t kind = fuzz_below(bytes, 16);

    *finer_bits = kind < 8 ? fuzz_below(bytes, FAR_FINER_BITS + 1) : kind == 8 ? fuzz_u8(bytes) : 0;
    *coarser_bits = kind > 8 && kind < 15 ? fuzz_below(bytes, FAR_COARSER_BITS + 1) : kind == 15 ? fuzz_u8(bytes) : 0;
    if (kind == 7) *coarser_bits = fuzz_below(bytes, FAR_COARSER_BITS + 1);
}

/* What a part has beside, where it moves in a long world. */
static void make_far_part(struct moving_part *part, const struct fuzz_scene *world, struct fuzz_bytes *bytes)
{
    make_scale(&part->moved.finer_bits, part->moved.coarser_bits, bytes);
    if (!fuzz_below(bytes, 4)) return;
    *part->moved.motion.origins = part->origins;
    for (int k = 0; k < KEYS_MAX; k++)
        make_origin(part->origins[k].at, world, bytes);
}

static void make_far_instance(struct lim_instance *instance, const struct fuzz_scene *world, struct fuzz_bytes *bytes)
{
    const uint8_t flags = fuzz_u8(bytes);

    if (flags & 1) make_scale(&instance->finer_bits, instance->coarser_bits, bytes);
    if (flags & 2) make_origin(instance->origin, world, bytes);
}

/* One instance in both frames. */
static void make_instance(struct movers *movers, uint16_t index, struct fuzz_bytes *bytes)
{
    const uint8_t flags = fuzz_u8(bytes);
    const struct moving_part *part = &movers->parts[flags & 1];
    uint32_t time_ms = fuzz_u16(bytes);

    for (int frame = 0; frame < FUZZ_FRAMES; frame++) {
        struct lim_instance *instance = &movers->instances[frame][index];
        *instance = (struct lim_instance){.deforms = (flags & 6) == 6};
        lim_moved_at(&part->moved, 1, time_ms, instance);
        if (flags & 16) {
            for (int i = 0; i < 3; i++)
                instance->at_q8[i] = position_q8(bytes);
            lim_instance_turn(instance, fuzz_u32(bytes), fuzz_u32(bytes), fuzz_u32(bytes));
        }
        if (lim_scene_long(&movers->world.scene)) make_far_instance(instance, &movers->world, bytes);
        if (flags & 32) time_ms += fuzz_u16(bytes);
        if ((flags & 0xC0) == 0xC0) instance->object = NULL;
    }
}

static struct lim_light make_light(struct fuzz_bytes *bytes)
{
    struct lim_light light = {.on = fuzz_below(bytes, 2), .middle_q8 = fuzz_u8(bytes)};
    const double yaw = fuzz_u8(bytes) / 40.0, pitch = fuzz_u8(bytes) / 40.0;

    light.swing_q8 = fuzz_below(bytes, 257u - light.middle_q8 < 256 ? 257u - light.middle_q8 : 256);
    light.to_q14[0] = (int16_t)lround(cos(yaw) * cos(pitch) * 16384);
    light.to_q14[1] = (int16_t)lround(sin(pitch) * 16384);
    light.to_q14[2] = (int16_t)lround(sin(yaw) * cos(pitch) * 16384);
    return light;
}

static void make_limits(const struct movers *movers, struct fuzz_bytes *bytes, struct fuzz_subject *subject)
{
    struct lim_movers_limits *limits = &subject->limits;

    limits->instances = (uint16_t)(1 + fuzz_below(bytes, INSTANCES_MAX));
    (void)fuzz_u8(bytes); /* the corpus has a byte here, of what is no longer asked for */
    for (int i = 0; i < OBJECTS; i++)
        if (movers->parts[i].object.scene.limits.depth > limits->depth)
            limits->depth = movers->parts[i].object.scene.limits.depth;
}

/* Then it is drawn with them. */
static void share_textures(struct fuzz_scene *object, const struct lim_scene *world, struct fuzz_bytes *bytes)
{
    if (!fuzz_below(bytes, 2) || !object->scene.texture_count || object->scene.texture_count > world->texture_count)
        return;
    object->scene.textures = world->textures;
    object->scene.palettes = world->palettes;
    object->scene.texels = world->texels;
    object->scene.texture_count = world->texture_count;
    object->scene.texel_blocks = world->texel_blocks;
    for (uint16_t i = 0; i < object->scene.texture_count; i++)
        object->textures[i] = world->textures[i];
    for (uint16_t i = 0; i < object->scene.mapping_count; i++) {
        object->mappings[i].uv[0][0] = 1;
        object->mappings[i].uv[0][1] = 0;
    }
    fuzz_scene_mask(object);
}

static void make(struct movers *movers, struct fuzz_bytes *bytes, struct fuzz_subject *subject)
{
    struct lim_scene *world = &movers->world.scene;

    make_limits(movers, bytes, subject);
    subject->light = make_light(bytes);
    subject->instance_count = (uint16_t)(1 + fuzz_below(bytes, INSTANCES_MAX));
    for (uint16_t i = 0; i < subject->instance_count; i++)
        make_instance(movers, i, bytes);
    for (int frame = 0; frame < FUZZ_FRAMES; frame++)
        subject->instances[frame] = movers->instances[frame];
    fuzz_scene_add_kinds(&movers->world, bytes);
    for (int i = 0; i < OBJECTS; i++) {
        share_textures(&movers->parts[i].object, world, bytes);
        if (movers->parts[i].object.scene.limits.layers && !world->limits.layers) world->limits.layers = 1;
    }
    subject->scene = world;
}

/* The world of both targets, and where it is seen from. */
static void make_world(struct movers *movers, struct fuzz_bytes *bytes, struct fuzz_subject *subject, bool is_long)
{
    struct fuzz_scene *world = &movers->world;

    if (is_long)
        fuzz_scene_make_long(world, bytes);
    else
        fuzz_scene_make(world, bytes);
    if (fuzz_below(bytes, 2)) fuzz_scene_add_extras(world, bytes);
    if (!is_long) return;
    fuzz_view_move_origin(&subject->cameras[0], world, bytes);
    memcpy(subject->cameras[1].origin, subject->cameras[0].origin, sizeof subject->cameras[0].origin);
    if (fuzz_below(bytes, 2)) fuzz_view_move_origin(&subject->cameras[1], world, bytes);
    for (int i = 0; i < OBJECTS; i++)
        make_far_part(&movers->parts[i], world, bytes);
}

static const char *run_in(const uint8_t *input, size_t size_b, bool is_long)
{
    static struct movers movers;
    struct fuzz_bytes bytes = {input, size_b};
    struct fuzz_subject subject = {0};
    struct fuzz_means means[2];
    struct error err;

    struct fuzz_look look = fuzz_look_from(&bytes);
    if (is_long && look.method >= LIM_DEPTH) /* which long scenes are not for */
        look.method = look.method == LIM_DEPTH ? LIM_NEAREST_FIRST : LIM_SCANLINE;
    fuzz_means_both_from(&bytes, means);
    means[1].memory = means[0].memory; /* a scene whose planes are not its polygons' has no order that bands keep */
    fuzz_view_from(&bytes, &subject);
    for (int i = 0; i < OBJECTS; i++)
        make_part(&movers.parts[i], &bytes);
    make_world(&movers, &bytes, &subject, is_long);
    if (!lim_check(&movers.world.scene, &err)) return "a valid scene was refused";
    make(&movers, &bytes, &subject);
    return fuzz_show_both(&subject, &look, means);
}

static const char *run(const uint8_t *input, size_t size_b)
{
    return run_in(input, size_b, false);
}

const struct fuzz_target fuzz_movers = {"movers", run, NULL};

static const char *run_long(const uint8_t *input, size_t size_b)
{
    return run_in(input, size_b, true);
}

const struct fuzz_target fuzz_long_movers = {"long_movers", run_long, NULL};
