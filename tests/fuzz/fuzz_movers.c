/* SPDX-License-Identifier: MIT
 *
 * Two forged objects in a forged scene, in up to four places: turned by angles or by keys between which a time lies,
 * finer, bending, entering by their centres, lit; with little room for pieces or much. Two frames by two sets of means,
 * which have the same memory, for how much of it there is decides what goes by its centre. */
#include "fuzz_scene.h"
#include "fuzz_show.h"
#include "fuzz_view.h"
#include "scene/lim_check.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { OBJECTS = 2, INSTANCES_MAX = 4, KEYS_MAX = 4, ENTRIES_MAX = 256, AT_END_Q8 = 1 << 24 };

struct moving_part {
    struct fuzz_scene object;
    struct lim_motion_key keys[KEYS_MAX];
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
        instance->by_centre = flags & 8;
        if (flags & 16) {
            for (int i = 0; i < 3; i++)
                instance->at_q8[i] = position_q8(bytes);
            lim_instance_turn(instance, fuzz_u32(bytes), fuzz_u32(bytes), fuzz_u32(bytes));
        }
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
    limits->entries = (uint16_t)(limits->instances + fuzz_below(bytes, ENTRIES_MAX));
    for (int i = 0; i < OBJECTS; i++)
        if (movers->parts[i].object.scene.limits.depth > limits->depth)
            limits->depth = movers->parts[i].object.scene.limits.depth;
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
    for (int i = 0; i < OBJECTS; i++)
        if (movers->parts[i].object.scene.limits.layers && !world->limits.layers) world->limits.layers = 1;
    subject->scene = world;
}

static const char *run(const uint8_t *input, size_t size_b)
{
    static struct movers movers;
    struct fuzz_bytes bytes = {input, size_b};
    struct fuzz_subject subject = {0};
    struct fuzz_means means[2];
    struct error err;

    const struct fuzz_look look = fuzz_look_from(&bytes);
    fuzz_means_both_from(&bytes, means);
    means[1].memory = means[0].memory;
    fuzz_view_from(&bytes, &subject);
    for (int i = 0; i < OBJECTS; i++)
        make_part(&movers.parts[i], &bytes);
    fuzz_scene_make(&movers.world, &bytes);
    if (fuzz_below(&bytes, 2)) fuzz_scene_add_extras(&movers.world, &bytes);
    if (!lim_check(&movers.world.scene, &err)) return "a valid scene was refused";
    make(&movers, &bytes, &subject);
    return fuzz_show_both(&subject, &look, means);
}

const struct fuzz_target fuzz_movers = {"movers", run, NULL};
